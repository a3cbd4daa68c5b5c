// From linear light to the whole numbers of a display file.
#pragma once

#include <cmath>

namespace yarte {

/// `v` within [0, 1]; what is not a number is 0.
inline double clampToUnit(double v) { return v > 0 ? (v < 1 ? v : 1) : 0; }

/// floor(maximum * v^(1/gamma) + 1/2) of the clamped v: the gamma is applied in floating point, then rounded
/// once.
class Quantiser {
public:
    Quantiser(int maximum, double gamma) : maximum_(maximum), exponent_(1 / gamma) {}

    int operator()(double v) const {
        const double clamped = clampToUnit(v);
        const double displayed = exponent_ == 1 ? clamped : std::pow(clamped, exponent_);
        return static_cast<int>(maximum_ * displayed + 0.5); // not negative: truncation is floor
    }

private:
    double maximum_, exponent_;
};

} // namespace yarte
