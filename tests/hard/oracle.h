// The oracle: what a ray meets first, decided by exact signs; t to 100 digits and more. It shares no code
// with the tracer.
#pragma once

#include "tests/hard/numbers.h"
#include "yarte/scene/scene.h"

#include <cstddef>
#include <optional>
#include <string>

namespace yarte::hard {

/// A ray as the tracer gets it. The direction is of unit length up to rounding; the truth is about the line
/// along it as it is, and t counts it: a point is origin + t direction.
struct InputRay {
    Vec3 origin, direction;
};

struct TrueHit {
    std::size_t body = 0, face = 0; ///< in the order of the file; face: of a mesh
    bool entering = true;           ///< against the outward normal
    Real t;
    Vec<Real> normal; ///< unit, outward
    /// How sensitive t and the normal are to relative changes of the inputs: the sums of |dt/dx x| / |t| and
    /// of |dn/dx x|. The normal is that of a point that is known through t and rounded itself, so to its sum
    /// that for a given t is added, t being one of the inputs.
    double tCondition = 0, normalCondition = 0;
};

struct Truth {
    std::optional<TrueHit> hit; ///< none: the ray meets nothing
    /// The number whose sign decides this and that the rounding of inputs comes nearest to change, and how
    /// far half an ulp of each input may move it, all together.
    std::string deciding;
    Real value;
    double range = 0;
    /// No change of the inputs by up to half an ulp each makes another answer true.
    bool isDecidable = false;
};

/// What is true of the inputs as they are if they are decidable; else hit is what seems so.
Truth truthOf(const Scene&, const InputRay&);

/// What is true of the inputs exactly as they are, in rational arithmetic; of two at the same distance the
/// first in the file. Irrational axes count to 150 digits. Without the real numbers t, normal, conditions.
std::optional<TrueHit> exactTruthOf(const Scene&, const InputRay&);

} // namespace yarte::hard
