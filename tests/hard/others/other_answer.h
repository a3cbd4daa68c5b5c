// What another program says of a ray.
#pragma once

#include "tests/hard/numbers.h"
#include "yarte/base/vec3.h"

#include <cstddef>
#include <optional>

namespace yarte::hard {

struct OtherHit {
    std::size_t body = 0; ///< in the order of the file
    Real t;
    Vec3 normal; ///< unit, on either side
};

struct OtherAnswer {
    bool wasAsked = true;        ///< false: the case is outside what the program can be asked
    std::optional<OtherHit> hit; ///< none: a miss
};

} // namespace yarte::hard
