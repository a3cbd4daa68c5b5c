// The functions that give strings.

#include "convert/povray/sdl/builtins.h"
#include "convert/povray/sdl/interpreter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unordered_map>

namespace yarte::convert::povray::sdl {
namespace {

/// As C's printf: `width` < 0 fills with zeros, `precision` < 0 means six digits.
std::string printed(double value, int width, int precision) {
    width = std::clamp(width, -1000, 1000), precision = std::clamp(precision, -1, 1000);
    std::string format = width < 0 ? "%0*" : "%*";
    format += precision < 0 ? "f" : ".*f";
    char text[2400]; // 309 digits before the point, 1000 after it, 1000 of filling
    const int size =
        precision < 0 ? std::snprintf(text, sizeof text, format.c_str(), std::abs(width), value)
                      : std::snprintf(text, sizeof text, format.c_str(), std::abs(width), precision, value);
    return std::string(text, static_cast<std::size_t>(std::max(size, 0)));
}

std::string checked(Interpreter& in, std::string text, Span where) {
    if (text.size() > in.environment().limits.stringLength)
        in.fail("sdl.string-too-long", fmt::format("a string of {} bytes", text.size()), where);
    return text;
}

std::string concat(Interpreter& in, const Token& name) {
    std::string text = in.string();
    while (in.accept(',')) text = checked(in, text + in.string(), name.span);
    return text;
}

std::string str(Interpreter& in, const Token&) {
    const double value = in.number();
    in.comma();
    const int width = in.integer();
    in.comma();
    return printed(value, width, in.integer());
}

std::string vstr(Interpreter& in, const Token& name) {
    const int count = in.integer();
    in.comma();
    const Vector v = in.expression().promoted(5);
    in.comma();
    const std::string separator = in.string();
    in.comma();
    const int width = in.integer();
    in.comma();
    const int precision = in.integer();
    if (count < 1 || count > 5) in.fail("sdl.arguments", "vstr shows 1 to 5 components", name.span);
    std::string text;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        text += (i > 0 ? separator : "") + printed(v.at[i], width, precision);
    return text;
}

std::string substr(Interpreter& in, const Token& name) {
    const std::string text = in.string();
    in.comma();
    const int position = in.integer();
    in.comma();
    const int size = in.integer();
    if (position < 1 || size < 0 ||
        static_cast<std::size_t>(position) + static_cast<std::size_t>(size) > text.size() + 1)
        in.fail("sdl.arguments", fmt::format("substr: the string has {} characters", text.size()), name.span);
    return text.substr(static_cast<std::size_t>(position - 1), static_cast<std::size_t>(size));
}

std::string inCase(Interpreter& in, char first, char last, int step) {
    std::string text = in.string();
    for (char& c : text)
        if (c >= first && c <= last) c = static_cast<char>(c + step);
    return text;
}

std::string chr(Interpreter& in, const Token&) {
    const int code = in.integer();
    return code > 0 && code < 256 ? std::string(1, static_cast<char>(code)) : std::string();
}

using Call = std::string (*)(Interpreter&, const Token&);

const std::unordered_map<std::string_view, Call>& calls() {
    static const std::unordered_map<std::string_view, Call> table{
        {"concat", concat},
        {"str", str},
        {"vstr", vstr},
        {"substr", substr},
        {"chr", chr},
        {"strlwr", [](Interpreter& in, const Token&) { return inCase(in, 'A', 'Z', 32); }},
        {"strupr", [](Interpreter& in, const Token&) { return inCase(in, 'a', 'z', -32); }},
        {"datetime",
         [](Interpreter& in, const Token&) { // the same for every run
             in.number();
             if (in.accept(',')) in.string();
             return std::string("2000-01-01 00:00:00Z");
         }},
    };
    return table;
}

} // namespace

bool isStringFunction(std::string_view name) { return name == "input_file_name" || calls().contains(name); }

std::string stringFunction(Interpreter& in, const Token& name) {
    if (name.text == "input_file_name") return in.environment().sources[in.sceneText()].name();
    in.expect('(');
    std::string text = calls().at(name.text)(in, name);
    in.expect(')');
    return text;
}

} // namespace yarte::convert::povray::sdl
