#include "convert/povray/sdl/symbols.h"

#include <algorithm>

namespace yarte::convert::povray::sdl {

std::vector<Symbols::Entry>& Symbols::stackOf(std::string_view name) {
    const auto found = names_.find(name);
    return found != names_.end() ? found->second : names_[std::string(name)];
}

void Symbols::leave() {
    const std::size_t depth = scopes_.size() - 1;
    for (const std::string& name : scopes_.back()) {
        std::vector<Entry>& stack = stackOf(name);
        std::erase_if(stack, [&](const Entry& e) { return e.depth == depth; });
    }
    scopes_.pop_back();
}

SymbolPtr Symbols::find(std::string_view name) const {
    const auto found = names_.find(name);
    return found == names_.end() || found->second.empty() ? nullptr : found->second.back().symbol;
}

bool Symbols::isLocal(std::string_view name) const {
    const auto found = names_.find(name);
    return found != names_.end() && !found->second.empty() && found->second.back().depth + 1 == depth();
}

SymbolPtr Symbols::addGlobal(std::string_view name) {
    std::vector<Entry>& stack = stackOf(name);
    if (!stack.empty() && stack.front().depth == 0) return stack.front().symbol;
    auto symbol = std::make_shared<Symbol>(Symbol{std::string(name), Value{}});
    stack.insert(stack.begin(), {0, symbol});
    return symbol;
}

SymbolPtr Symbols::addLocal(std::string_view name, std::size_t depth) {
    std::vector<Entry>& stack = stackOf(name);
    auto place = stack.end();
    while (place != stack.begin() && (place - 1)->depth + 1 > depth) --place;
    if (place != stack.begin() && (place - 1)->depth + 1 == depth) return (place - 1)->symbol;
    auto symbol = std::make_shared<Symbol>(Symbol{std::string(name), Value{}});
    stack.insert(place, {depth - 1, symbol});
    scopes_[depth - 1].emplace_back(name);
    return symbol;
}

void Symbols::bindLocal(std::string_view name, SymbolPtr symbol) {
    stackOf(name).push_back({depth() - 1, std::move(symbol)});
    scopes_.back().emplace_back(name);
}

void Symbols::remove(std::string_view name) {
    std::vector<Entry>& stack = stackOf(name);
    if (!stack.empty()) stack.pop_back();
}

} // namespace yarte::convert::povray::sdl
