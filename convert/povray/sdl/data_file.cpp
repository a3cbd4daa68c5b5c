#include "convert/povray/sdl/data_file.h"

#include <fmt/format.h>

namespace yarte::convert::povray::sdl {

std::optional<Value> DataReader::next() {
    const Token first = text_.next();
    atEnd_ = first.kind == TokenKind::end;
    if (atEnd_) return std::nullopt;
    Value value;
    if (first.kind == TokenKind::string)
        value = unescaped(first);
    else if (first.is('<'))
        value = vector();
    else
        value = Vector::number(number(first));
    atEnd_ = text_.next().kind == TokenKind::end;
    return value;
}

double DataReader::number(Token first) {
    const bool isNegative = first.is('-');
    if (isNegative || first.is('+')) first = text_.next();
    if (first.kind != TokenKind::number)
        throw SyntaxError("sdl.data", "expected a number, a vector or a string", first.span);
    return isNegative ? -first.number : first.number;
}

Vector DataReader::vector() {
    Vector v{0, {}};
    for (;;) {
        v.at[static_cast<std::size_t>(v.size++)] = number(text_.next());
        const Token after = text_.next();
        if (after.is('>') && v.size > 1) return v;
        if (!after.is(',') || v.size == 5)
            throw SyntaxError("sdl.data", "expected ',' and a number, or '>' after 2 to 5 of them",
                              after.span);
    }
}

std::string dataText(const Vector& v) {
    if (v.size == 1) return fmt::format("{:g}", v.at[0]);
    std::string text;
    for (std::size_t i = 0; i < static_cast<std::size_t>(v.size); ++i)
        text += fmt::format("{}{:g}", i == 0 ? '<' : ',', v.at[i]);
    return text + "> "; // with a blank, as POV-Ray has it
}

} // namespace yarte::convert::povray::sdl
