#include "convert/povray/sdl/interpreter.h"

#include <fmt/format.h>

#include <cmath>

namespace yarte::convert::povray::sdl {

Value Interpreter::copied(const Value& value, Span where, int depth) {
    const auto* array = std::get_if<ArrayPtr>(&value);
    if (!array) return value;
    const std::size_t count = (*array)->elements.size();
    if (count > *elementsLeft_ || depth > environment_.limits.nesting)
        fail("sdl.array",
             fmt::format("arrays of more than {} elements, or {} levels", environment_.limits.elements,
                         environment_.limits.nesting),
             where);
    takeSteps(count, where);
    auto copy = std::make_shared<Array>(Array{(*array)->sizes, {}, {elementsLeft_, count}});
    copy->elements.reserve(count);
    for (const Value& element : (*array)->elements)
        copy->elements.push_back(copied(element, where, depth + 1));
    return copy;
}

const Value* Interpreter::namedValue() {
    if (peek().kind != TokenKind::word || !peek().symbol || !peek().symbol->value()) return nullptr;
    Value* value = &std::get<Value>(peek().symbol->content);
    if (std::holds_alternative<ArrayPtr>(*value)) {
        Token name = next();
        if (peekTail().is('[')) {
            const SymbolPtr array = name.symbol;
            Value& found = element(name, std::get<Value>(array->content));
            name.symbol = std::make_shared<Symbol>(Symbol{std::string(name.text), found});
        }
        putBack(std::move(name));
        value = &std::get<Value>(ahead_.back().symbol->content);
    }
    return value;
}

Value& Interpreter::element(const Token& name, Value& value) {
    Value* found = &value;
    while (peekTail().is('[')) {
        const auto* array = std::get_if<ArrayPtr>(found);
        if (!array)
            fail("sdl.not-an-array", fmt::format("'{}' is {}, not an array", name.text, kindOf(*found)),
                 name.span);
        const ArrayPtr held = *array;
        std::size_t at = 0;
        for (std::size_t d = 0; d < held->sizes.size(); ++d) {
            const Token open = expect('[');
            const double index = std::trunc(number());
            expect(']');
            if (!(index >= 0 && index < held->sizes[d]))
                fail("sdl.index",
                     fmt::format("index {} of '{}', which has {} elements", index, name.text, held->sizes[d]),
                     open.span);
            at = at * static_cast<std::size_t>(held->sizes[d]) + static_cast<std::size_t>(index);
        }
        found = &held->elements[at];
    }
    return *found;
}

Value Interpreter::arrayLiteral(const Token& word) {
    std::vector<int> sizes;
    accept("mixed");
    std::size_t count = 1;
    while (peekTail().is('[')) {
        next();
        const double size = std::trunc(number());
        expect(']');
        if (!(size >= 1 && size <= static_cast<double>(*elementsLeft_)) || sizes.size() == 5)
            fail("sdl.array", fmt::format("an array of {} elements, or of more than 5 dimensions", size),
                 word.span);
        sizes.push_back(static_cast<int>(size));
        if (count > *elementsLeft_ / static_cast<std::size_t>(size))
            fail("sdl.array", fmt::format("arrays of more than {} elements", environment_.limits.elements),
                 word.span);
        count *= static_cast<std::size_t>(size);
    }
    if (sizes.empty()) failExpected("'[' and the array's size");
    auto array = std::make_shared<Array>(Array{std::move(sizes), {}, {elementsLeft_, count}});
    array->elements.resize(count);
    std::size_t at = 0;
    if (peekTail().is('{')) fillArray(*array, 0, at);
    return array;
}

void Interpreter::fillArray(Array& array, std::size_t dimension, std::size_t& at) {
    const Nested nested(*this);
    const Token open = expect('{');
    std::size_t step = 1; // elements that one item of this dimension fills
    for (std::size_t d = dimension + 1; d < array.sizes.size(); ++d)
        step *= static_cast<std::size_t>(array.sizes[d]);
    const std::size_t first = at, last = at + step * static_cast<std::size_t>(array.sizes[dimension]);
    std::size_t item = first;
    for (; !peek().is('}'); item += step) {
        if (item >= last)
            fail("sdl.array",
                 fmt::format("more than the {} values that there is room for", array.sizes[dimension]),
                 peek().span);
        at = item;
        if (dimension + 1 < array.sizes.size())
            fillArray(array, dimension + 1, at);
        else
            array.elements[at] = value();
        comma();
    }
    expect('}');
}

} // namespace yarte::convert::povray::sdl
