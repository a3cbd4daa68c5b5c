// Media: the transmissive bodies a ray is in, as a stack (SCENE-LANGUAGE section 2, "Refraction"; POV-Ray's
// rule).
#pragma once

#include "yarte/trace/world.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace yarte::trace {

/// Outermost first. Does not allocate while empty.
using MediaStack = std::vector<BodyId>;

/// What meeting a transmissive body's surface does to a ray.
struct Passage {
    double ratio = 1;         ///< index before / index after
    bool isContinued = false; ///< between two media of one index: goes straight on and is no new level
    MediaStack after;
};

/// Entering a body that is not in the stack goes from the top's index (1 when empty) to its own; meeting the
/// top body leaves it, to the one below; one deeper in the stack is removed, without refraction.
inline Passage pass(const World& world, const MediaStack& before, BodyId body) {
    Passage result{1, false, before};
    const auto indexOfTop = [&](const MediaStack& stack) { return world.bodies[stack.back().index].index; };
    const auto found = std::find(before.begin(), before.end(), body);
    if (found == before.end()) {
        result.after.push_back(body);
    } else {
        result.after.erase(result.after.begin() + (found - before.begin()));
        if (found + 1 != before.end()) { // deeper than the top
            result.isContinued = true;
            return result;
        }
    }
    if (before.empty() || result.after.empty()) { // from or to the void: always a level of its own
        result.ratio =
            (before.empty() ? 1 : indexOfTop(before)) / (result.after.empty() ? 1 : indexOfTop(result.after));
        return result;
    }
    const double from = indexOfTop(before), to = indexOfTop(result.after);
    result.ratio = from / to;
    result.isContinued = from == to;
    return result;
}

/// The ray that carries the transmitted light.
struct Transmission {
    Vec3 direction;
    Side side;                ///< it leaves the surface to
    bool isReflected = false; ///< total reflection
    bool isContinued = false; ///< no new level
    MediaStack media;
};

/// Snell's law in vector form: with k = 1 - ratio^2 (1 - cos^2), the refracted direction is
/// ratio d + (ratio cos - sqrt(k)) N [Heckbert89]; k < 0 is total reflection, to the mirror direction.
/// `normal` faces the viewer, who is on `viewer`'s side.
inline Transmission transmit(const World& world, const MediaStack& before, BodyId body, Vec3 direction,
                             Vec3 normal, Vec3 mirror, Side viewer) {
    Passage passage = pass(world, before, body);
    if (passage.isContinued) return {direction, opposite(viewer), false, true, std::move(passage.after)};
    const double cosine = -dot(direction, normal);
    const double k = 1 - passage.ratio * passage.ratio * (1 - cosine * cosine);
    if (k < 0) return {mirror, viewer, true, false, before};
    const Vec3 refracted = passage.ratio * direction + (passage.ratio * cosine - std::sqrt(k)) * normal;
    return {normalised(refracted), opposite(viewer), false, false, std::move(passage.after)};
}

} // namespace yarte::trace
