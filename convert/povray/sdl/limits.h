// Limits: what bounds a program that comes from a stranger. Far above what scenes need; reaching one is an
// error.
#pragma once

#include <cstddef>
#include <cstdint>

namespace yarte::convert::povray::sdl {

struct Limits {
    std::uint64_t tokens = 1'000'000'000; ///< read, again in every round of a loop: about half a minute
    std::size_t frames = 1000;            ///< macros and includes within one another
    int nesting = 500;                    ///< of braces, brackets and parentheses: each takes stack
    std::size_t elements = 20'000'000;    ///< of all arrays that are there at a time
    std::size_t stringLength = 1'000'000;
    std::size_t strings = std::size_t{2} << 30; ///< bytes, of all that are made
    std::size_t written = 256u << 20;           ///< bytes, by #write
    /// That are made, and that the scene has: a union that is used twice counts twice. A texture's layers
    /// beyond the first count as objects, too.
    std::size_t objects = 5'000'000;
    std::size_t layers = 1000; ///< of one texture
    /// Operands of a function, or levels of functions that call each other: their evaluation takes stack.
    int functionSize = 2000;
    std::uint64_t functionSteps = 10'000'000; ///< operands in a call of a function, with all that it calls
};

} // namespace yarte::convert::povray::sdl
