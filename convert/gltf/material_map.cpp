#include "convert/gltf/material_map.h"

#include <algorithm>
#include <cmath>

namespace yarte::convert::gltf {
namespace {

double mean(Colour c) { return (c.r + c.g + c.b) / 3; }

Colour mix(Colour a, Colour b, double weight) { return a * (1 - weight) + b * weight; }

Colour atLeastBlack(Colour c) { return {std::max(c.r, 0.0), std::max(c.g, 0.0), std::max(c.b, 0.0)}; }

Colour atMostWhite(Colour c) { return {std::min(c.r, 1.0), std::min(c.g, 1.0), std::min(c.b, 1.0)}; }

/// Scaled, so that its hue stays, to components of at most 1.
Colour bounded(Colour c) { return c * (1 / std::max(1.0, maxComponent(c))); }

/// Fresnel's reflectance at normal incidence.
double reflectance(double ior) {
    const double root = (ior - 1) / (ior + 1);
    return root * root;
}

/// Of what a metal reflects, the part that a ray can follow; the rest is blurred.
double mirrorShare(double roughness) { return (1 - roughness) * (1 - roughness); }

/// Of what a metal reflects, the part that is blurred so much that it looks diffuse.
double blurredShare(double roughness) { return roughness * roughness; }

/// Height of a highlight of unit reflectance: the lobe's integral over the hemisphere is kept.
double highlight(double roughness, double exponent) {
    return (1 - blurredShare(roughness)) * (exponent + 1) / 2;
}

Colour ambientOf(const PbrMaterial& m) {
    return m.base * (ambientShare * (1 - (1 - m.metallic) * m.transmission));
}

/// The tint of the brightest channel is 1, so that grey needs none.
void setTransmittance(Material& m, Colour passes) {
    const double most = maxComponent(passes);
    m.transmission = most;
    m.tint = most > 0 ? Colour{passes.r / most, passes.g / most, passes.b / most} : Colour{1, 1, 1};
}

/// Only a part `alpha` of the surface is there; the rest lets rays pass straight.
Material covered(Material phong, double alpha) {
    if (alpha == 1) return phong;
    phong.ambient = phong.ambient * alpha;
    phong.diffuse = phong.diffuse * alpha;
    phong.specular = phong.specular * alpha;
    phong.reflection *= alpha;
    setTransmittance(phong, alpha * transmittance(phong) + (1 - alpha) * Colour{1, 1, 1});
    phong.index = 1;
    return phong;
}

} // namespace

double phongExponent(double roughness) {
    const double alpha = roughness * roughness;
    return std::min(maxExponent, (1 / (alpha * alpha) - 1) / 2);
}

double roughnessOf(double phongExponent) { return std::pow(2 * phongExponent + 1, -0.25); }

Material toPhong(const PbrMaterial& m) {
    Material phong;
    if (m.unlit) {
        phong.ambient = m.base;
        return covered(phong, m.alpha);
    }
    const double dielectric = 1 - m.metallic;
    phong.ambient = m.emissive + ambientOf(m);
    phong.diffuse = m.base * (dielectric * (1 - m.transmission) + m.metallic * blurredShare(m.roughness));
    phong.exponent = phongExponent(m.roughness);
    const Colour f0 =
        mix(atMostWhite(m.specularColour * reflectance(m.ior)) * m.specular, m.base, m.metallic);
    phong.specular = bounded(f0 * highlight(m.roughness, phong.exponent));
    phong.reflection = m.metallic * mean(m.base) * mirrorShare(m.roughness);
    setTransmittance(phong, dielectric * m.transmission * m.base);
    if (phong.transmission > 0) phong.index = m.thickness > 0 ? std::max(m.ior, 1.0) : 1;
    return covered(phong, m.alpha);
}

PbrMaterial toPbr(const Material& phong) {
    PbrMaterial m;
    m.roughness = roughnessOf(phong.exponent);
    const double diffuse = mean(phong.diffuse);
    // The means of what is reflected by metal, transmitted and scattered; their sum is the base colour's.
    const double metal = std::min(1.0, phong.reflection / std::max(mirrorShare(m.roughness), 1e-3));
    const double scattered = std::max(0.0, diffuse - metal * blurredShare(m.roughness));
    const Colour passes = transmittance(phong);
    const double transmitted = mean(passes);
    const double sum = metal + transmitted + scattered;
    m.metallic = sum > 0 ? metal / sum : 0;
    m.transmission = transmitted > 0 ? transmitted / (transmitted + scattered) : 0;
    if (m.transmission > 0) {
        m.ior = std::max(1.0, phong.index);
        m.thickness = phong.index != 1;
    }
    const double specular = mean(phong.specular), body = diffuse + transmitted;
    const Colour hue = body > 0       ? (phong.diffuse + passes) * (1 / body)
                       : specular > 0 ? phong.specular * (1 / specular)
                                      : Colour{1, 1, 1};
    m.base = bounded(hue * sum);
    m.emissive = atLeastBlack(phong.ambient + ambientOf(m) * -1);

    const double height = highlight(m.roughness, phong.exponent), f0 = reflectance(m.ior);
    if (height > 0 && f0 > 0 && m.metallic < 1)
        m.specularColour = atLeastBlack(phong.specular * (1 / height) + m.base * -m.metallic) *
                           (1 / ((1 - m.metallic) * f0));
    return m;
}

} // namespace yarte::convert::gltf
