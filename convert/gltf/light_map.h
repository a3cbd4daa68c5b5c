// Brightness of light: glTF's photometric values (KHR_lights_punctual) and YARTE's.
//
// A white Lambertian surface that faces a light sends back E / pi under an illuminance of E lux, and YARTE's
// brightness B under a light B: so B = E / pi, and E = I / d^2 at a distance d from I candela.
#pragma once

#include <numbers>

namespace yarte::convert::gltf {

constexpr double brightnessOfLux(double lux) { return lux / std::numbers::pi; }
constexpr double brightnessOfCandela(double candela, double distance) {
    return brightnessOfLux(candela / (distance * distance));
}
constexpr double candelaOfBrightness(double brightness, double distance) {
    return brightness * std::numbers::pi * distance * distance;
}

} // namespace yarte::convert::gltf
