#include "convert/povray/sdl_text.h"

#include "yarte/base/number.h"

#include <fmt/format.h>

namespace yarte::convert::povray {

std::string sdl(Vec3 v) {
    return fmt::format("<{}, {}, {}>", printNumber(v.x), printNumber(v.y), printNumber(v.z));
}

std::string sdl(Colour c) { return sdl(Vec3{c.r, c.g, c.b}); }

std::string sdl(const Frame& f) { return fmt::format("{}, {}, {}", sdl(f.x), sdl(f.y), sdl(f.z)); }

std::string sdlGrey(Colour c) {
    const std::string r = printNumber(c.r); // as text: -0 is not 0
    return r == printNumber(c.g) && r == printNumber(c.b) ? r : sdl(c);
}

std::string stringLiteral(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + '"';
}

std::string placeOf(std::string_view kind, Span span, const Sources& sources) {
    if (!span.source.valid()) return std::string(kind);
    return fmt::format("{}, line {}", kind, sources[span.source].position(span.begin).line);
}

} // namespace yarte::convert::povray
