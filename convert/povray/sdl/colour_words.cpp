#include "convert/povray/sdl/colour_words.h"

#include "convert/povray/sdl/interpreter.h"
#include "yarte/base/srgb.h"

namespace yarte::convert::povray::sdl {

int channel(std::string_view word) {
    if (word == "red") return 0;
    if (word == "green") return 1;
    if (word == "blue") return 2;
    if (word == "filter" || word == "alpha") return 3;
    if (word == "transmit") return 4;
    return -1;
}

bool isColourWord(std::string_view w) {
    return w == "rgb" || w == "rgbf" || w == "rgbt" || w == "rgbft" || w == "srgb" || w == "srgbf" ||
           w == "srgbt" || w == "srgbft" || w == "color" || w == "colour" || channel(w) >= 0;
}

Vector Interpreter::colourWords() {
    const Nested nested(*this);
    Vector colour{5, {}};
    if (accept("color") || accept("colour")) {
        const Token& token = peek();
        const bool more = token.kind == TokenKind::word && !token.symbol && isColourWord(token.text);
        if (!more) colour = sum().promoted(5);
    }
    for (;;) {
        const Token& token = peekTail();
        if (token.kind != TokenKind::word || token.symbol) return colour;
        if (const int part = channel(token.text); part >= 0) {
            next();
            colour.at[static_cast<std::size_t>(part)] = number();
            continue;
        }
        if (!isColourWord(token.text) || token.text == "color" || token.text == "colour") return colour;
        const Token word = next();
        std::string_view kind = word.text;
        const bool isSrgb = kind.front() == 's';
        if (isSrgb) kind.remove_prefix(1);
        const int size = kind == "rgb" ? 3 : kind == "rgbft" ? 5 : 4;
        const Vector v = sum().promoted(size);
        colour = {5, {v.at[0], v.at[1], v.at[2]}};
        if (isSrgb)
            for (std::size_t i = 0; i < 3; ++i) colour.at[i] = linearFromSrgb(colour.at[i]);
        if (kind == "rgbf" || kind == "rgbft") colour.at[3] = v.at[3];
        if (kind == "rgbt") colour.at[4] = v.at[3];
        if (kind == "rgbft") colour.at[4] = v.at[4];
    }
}

Rgbft Interpreter::colour() {
    const Token& token = peek();
    if (token.kind == TokenKind::word && !token.symbol && isColourWord(token.text)) {
        // Through the expressions: rgb <1, 1, 1> is followed by operators, too.
        return term().promoted(5).rgbft();
    }
    Vector colour = term().promoted(5);
    for (;;) { // "Red filter 0.5"
        const Token& part = peekTail();
        const int index = part.kind == TokenKind::word && !part.symbol ? channel(part.text) : -1;
        if (index < 0) return colour.rgbft();
        next();
        colour.at[static_cast<std::size_t>(index)] = number();
    }
}

} // namespace yarte::convert::povray::sdl
