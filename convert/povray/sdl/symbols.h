// Symbols: the names of an SDL program. Every included file and every macro's run has names of its own
// (#local); a name is looked for from the innermost outwards, through all that are running.
#pragma once

#include "convert/povray/sdl/value.h"

#include <string_view>
#include <unordered_map>
#include <vector>

namespace yarte::convert::povray::sdl {

class Symbols {
public:
    Symbols() { enter(); }

    void enter() { scopes_.emplace_back(); }
    void leave();
    std::size_t depth() const { return scopes_.size(); }

    /// The innermost one; null if there is none.
    SymbolPtr find(std::string_view name) const;
    /// True if the innermost one is of the innermost scope.
    bool isLocal(std::string_view name) const;

    SymbolPtr addGlobal(std::string_view name);
    /// In the scope of the given depth, which may be left before the innermost ones.
    SymbolPtr addLocal(std::string_view name, std::size_t depth);
    SymbolPtr addLocal(std::string_view name) { return addLocal(name, depth()); }
    /// Another name, in the innermost scope, for a symbol.
    void bindLocal(std::string_view name, SymbolPtr);
    /// Takes the innermost one away; does nothing if there is none.
    void remove(std::string_view name);

private:
    struct Entry {
        std::size_t depth;
        SymbolPtr symbol;
    };
    struct Hash {
        using is_transparent = void;
        std::size_t operator()(std::string_view s) const { return std::hash<std::string_view>()(s); }
    };
    /// The stack of `name`, made if it is not there.
    std::vector<Entry>& stackOf(std::string_view name);

    /// Per name, by depth; empty where all scopes that had it have been left.
    std::unordered_map<std::string, std::vector<Entry>, Hash, std::equal_to<>> names_;
    std::vector<std::vector<std::string>> scopes_; ///< the names of each
};

} // namespace yarte::convert::povray::sdl
