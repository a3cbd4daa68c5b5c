// Spline: points over a parameter, and curves through them.
#pragma once

#include "convert/povray/sdl/value.h"

#include <optional>
#include <vector>

namespace yarte::convert::povray::sdl {

class Interpreter;

enum class SplineKind { linear, quadratic, natural, cubic };

struct Spline {
    SplineKind kind = SplineKind::linear;
    struct Point {
        double at;
        Vector value;
    };
    std::vector<Point> points; ///< by `at`, which is there once
};

/// From the word `spline`, which comes next.
Value parseSpline(Interpreter&);
/// "linear_spline", ..., if it comes next: read.
std::optional<SplineKind> splineKind(Interpreter&);

/// Beyond its ends a spline stays where it ends.
Vector evaluate(const Spline&, double at, SplineKind);

} // namespace yarte::convert::povray::sdl
