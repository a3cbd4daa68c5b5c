// Colour: linear RGB, unclamped; 1 is the display's white.
#pragma once

#include <algorithm>

namespace yarte {

struct Colour {
    double r = 0, g = 0, b = 0;

    friend constexpr bool operator==(const Colour&, const Colour&) = default;

    constexpr Colour& operator+=(Colour c) { return *this = {r + c.r, g + c.g, b + c.b}; }
};

constexpr Colour operator+(Colour a, Colour b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
constexpr Colour operator*(Colour a, Colour b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
constexpr Colour operator*(Colour a, double s) { return {a.r * s, a.g * s, a.b * s}; }
constexpr Colour operator*(double s, Colour a) { return a * s; }

constexpr bool isBlack(Colour c) { return c.r == 0 && c.g == 0 && c.b == 0; }
constexpr double maxComponent(Colour c) { return std::max({c.r, c.g, c.b}); }

} // namespace yarte
