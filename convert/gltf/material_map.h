// glTF's metallic-roughness material as YARTE's Phong material, and back. convert/README.md derives the
// formulas. The two directions are inverses wherever the other side can say the same; glTF 2.0 section 3.9
// and the extensions KHR_materials_ior, _specular, _transmission, _volume, _emissive_strength, _unlit give
// the meaning of the values.
#pragma once

#include "yarte/scene/scene.h"

namespace yarte::convert::gltf {

/// Factors with textures averaged in; the defaults are glTF's. Colours are linear.
struct PbrMaterial {
    Colour base{1, 1, 1};
    double metallic = 1;
    double roughness = 1;
    Colour emissive; ///< strength multiplied in: may exceed 1
    double ior = 1.5;
    double specular = 1; ///< factor of the dielectric's reflectance
    Colour specularColour{1, 1, 1};
    double transmission = 0;
    double thickness = 0; ///< 0: a thin wall, which does not refract (KHR_materials_volume)
    double alpha = 1;     ///< coverage where alphaMode is BLEND; 1 otherwise
    bool unlit = false;
};

/// Light from all around, which viewers have and YARTE has not: this part of the base colour.
inline constexpr double ambientShare = 0.1;
/// Of a highlight, where roughness is 0: glTF then shows a point light not at all, YARTE as a small dot.
inline constexpr double maxExponent = 10000;

Material toPhong(const PbrMaterial&);
PbrMaterial toPbr(const Material&);

/// [Karis13]'s n = 2/a^2 - 2 with a = roughness^2 is Blinn's exponent; Phong's, about the mirror direction,
/// is a quarter of it.
double phongExponent(double roughness);
double roughnessOf(double phongExponent);

} // namespace yarte::convert::gltf
