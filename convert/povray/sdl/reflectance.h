// POV-Ray's highlights and angle-dependent reflections as the constants that YARTE's materials have.
#pragma once

namespace yarte::convert::povray::sdl {

/// Phong's exponent about the mirrored direction for POV-Ray's `specular`, (N.H)^(1/roughness): near the
/// highlight the half vector is half as far from the normal as the mirrored ray from the light, and
/// cos(a/2)^4 ~ cos(a).
double phongExponent(double roughness);

/// The mean over a ball's picture of (1 - cos)^falloff: by what part the reflection is the largest one.
double meanFalloff(double falloff);

/// The same for unpolarised light that meets a dielectric [Born & Wolf, Principles of Optics, 1.5.2].
double meanFresnel(double index);

} // namespace yarte::convert::povray::sdl
