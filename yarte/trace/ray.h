// Rays, and the places where they cross a surface.
#pragma once

#include "yarte/base/vec3.h"

#include <cstdint>

namespace yarte::trace {

/// What a tree's leaf holds: a shape, or one face of a polygon or mesh. Numbered in the order of the scene's
/// file, so that of two at equal distance the lower one wins.
struct ElementId {
    static constexpr std::uint32_t noIndex = 0xffffffff;
    std::uint32_t index = noIndex;
    friend constexpr bool operator==(ElementId, ElementId) = default;
};

/// The sides of a surface by its own outward normal.
enum class Side : std::uint8_t { outside, inside };

constexpr Side opposite(Side side) { return side == Side::outside ? Side::inside : Side::outside; }

/// The surface a ray starts on, and the side it leaves to. This, not a distance, keeps a ray from meeting its
/// own start: a flat surface is never met again, a convex one only from the inside, at its other end.
struct Departure {
    ElementId element; ///< none: the ray starts in space
    Side side = Side::outside;
};

struct Ray {
    Vec3 origin;
    Vec3 direction; ///< unit length, renormalised at every bounce: an error in it would grow geometrically
    Departure from;

    Vec3 at(double t) const { return origin + direction * t; }
};

/// Where the line of a ray crosses a surface.
struct Crossing {
    double t = 0; ///< along the ray; any sign
    std::uint8_t part =
        0; ///< which part of the shape's surface (a box's face, a cone's base), as its own header says
    bool entering = true; ///< against the outward normal
};

/// All crossings of a line with one shape: none of ours has more than two.
struct Crossings {
    Crossing list[2];
    int count = 0;
    /// Rounding may have decided what is here, or blurred it.
    bool isDoubtful = false;

    void add(double t, std::uint8_t part, bool entering) { list[count++] = {t, part, entering}; }
    const Crossing* begin() const { return list; }
    const Crossing* end() const { return list + count; }
};

/// The crossings of a line with a shape. Every shape has two ways to them. `quickCrossings` computes in
/// doubles, for many rays at once in lanes; it knows of itself where its rounding might decide: next to
/// tangents, rims, edges, tips, and where the ray starts next to the surface. Only there, which is rare,
/// `carefulCrossings` computes the same again in twice the precision. That is right wherever the answer does
/// not hang on the rounding of the inputs themselves, and costs nothing elsewhere [the idea is that of
/// Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997].
template <class Shape>
Crossings crossings(const Shape& shape, const Ray& ray) {
    const Crossings quick = quickCrossings(shape, ray);
    return quick.isDoubtful ? carefulCrossings(shape, ray) : quick;
}

} // namespace yarte::trace
