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
    std::size_t elements = 20'000'000;    ///< of all arrays that are made
    std::size_t stringLength = 1'000'000;
    std::size_t written = 256u << 20; ///< bytes, by #write
    std::size_t objects = 5'000'000;
};

} // namespace yarte::convert::povray::sdl
