// Evidence: what the pixels that differ have to do with the things of the scene, as plain numbers.
#pragma once

#include "validate/aov.h"
#include "validate/difference.h"

#include <cstddef>
#include <vector>

namespace yarte::validate {

/// Pairs of neighbouring pixels on either side of an outline, where the step of colour between them is clear
/// in picture a. An outline that has moved takes its step with it; a change of light or material leaves one.
struct Outline {
    int pairs = 0;
    int vanished = 0; ///< whose step is gone in picture b

    double rate() const { return pairs == 0 ? 0 : static_cast<double>(vanished) / pairs; }
};

struct BodyEvidence {
    Outline outline;      ///< where the camera sees it against something farther
    Outline seen;         ///< where it is seen against another thing, both in one mirror or through one glass
    double unseen = 0;    ///< the part of the pixels that differ no ray of which met the body
    double unrelated = 0; ///< the part of those that do not lie in its shadow either
    double reach = 0;     ///< the part of the picture that sees it or lies in its shadow
    /// Picture b has one single colour wherever the camera sees the body in picture a.
    bool isUniform = true;

    /// Most of its outline is not where it was.
    bool isGone() const { return outline.vanished >= 3 && outline.rate() > 0.55; }
};

struct Evidence {
    std::vector<BodyEvidence> bodies;
    Outline outline, seen;               ///< of all bodies together
    std::size_t differingBackground = 0; ///< pixels that differ although they show nothing but background
    double differingPart = 0;            ///< of the pixels that show a body, the part that differs
    std::vector<double> litDiffering;    ///< by light: of the pixels that it lights, the part that differs
};

Evidence evidenceOf(const Difference&, const Aov&);

} // namespace yarte::validate
