// Scene: what a person wrote, as plain values. No pointers; ids index the scene's own vectors.
#pragma once

#include "yarte/base/colour.h"
#include "yarte/base/source.h"
#include "yarte/base/vec3.h"
#include "yarte/scene/mesh_data.h"
#include "yarte/scene/shapes.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace yarte {

struct Resolution {
    int width = 256, height = 256; ///< pixels
    friend bool operator==(Resolution, Resolution) = default;
};

struct Camera {
    Vec3 position;
    Vec3 focus;       ///< the point looked at
    Vec3 up{0, 1, 0}; ///< need not be perpendicular to the view, must not be parallel to it
    double horizontalApertureDegrees = 45; ///< half-angle from the view axis, in (0, 90) (D1)
    double verticalApertureDegrees = 45;
    friend bool operator==(const Camera&, const Camera&) = default;
};

/// A point light without fall-off.
struct Light {
    Vec3 position;
    Colour brightness;
    Span span{}; ///< the directive; not part of the value
    friend bool operator==(const Light& a, const Light& b) {
        return a.position == b.position && a.brightness == b.brightness;
    }
};

struct Material {
    Colour ambient, diffuse, specular;
    double exponent = 1;     ///< Phong's n
    double reflection = 0;   ///< cr
    double transmission = 0; ///< ct
    double index = 0;        ///< of refraction; ignored where transmission is 0 (D6)
    Colour tint{1, 1, 1};    ///< of the light that passes through
    friend bool operator==(const Material&, const Material&) = default;
};

/// What a surface leaves of light that passes through it. Of light that it reflects totally, ct is left.
constexpr Colour transmittance(const Material& m) { return m.transmission * m.tint; }
constexpr bool transmits(const Material& m) { return !isBlack(transmittance(m)); }

struct BackColours {
    Colour ambient, diffuse, specular;
    friend bool operator==(const BackColours&, const BackColours&) = default;
};

/// Index into Scene::materials.
struct MaterialId {
    std::uint32_t index = 0;
    friend constexpr bool operator==(MaterialId, MaterialId) = default;
};

/// A shape with its appearance. The order of bodies matters: of two at equal distance the first wins (D10).
struct Body {
    Shape shape;
    MaterialId material;
    std::optional<Referential> referential; ///< of kinds that takesReferential holds for
    std::optional<BackColours> back;        ///< of kinds that takesBackColours holds for
    Span span{};                            ///< the shape's directive; not part of the value
    friend bool operator==(const Body& a, const Body& b) {
        return a.shape == b.shape && a.material == b.material && a.referential == b.referential &&
               a.back == b.back;
    }
};

struct Scene {
    Resolution resolution;
    Camera camera;
    Colour background;
    int maxRecursion = 2; ///< secondary generations; 0: primary rays only (D2)
    double gamma = 1;     ///< of display outputs
    std::vector<Light> lights;
    std::vector<Material> materials; ///< one per `material` directive, used or not
    std::vector<MeshData> meshes;    ///< one per file named
    std::vector<Body> bodies;
    friend bool operator==(const Scene&, const Scene&) = default;
};

/// True for the kinds that take an `instance_referential`.
constexpr bool takesReferential(const Shape& shape) {
    return std::holds_alternative<Box>(shape) || std::holds_alternative<Cone>(shape) ||
           std::holds_alternative<TruncatedCone>(shape) || std::holds_alternative<Disc>(shape) ||
           std::holds_alternative<Cylinder>(shape) || std::holds_alternative<OpenCylinder>(shape) ||
           std::holds_alternative<Frustum>(shape);
}

/// True for the kinds that take a `backface_colour`.
constexpr bool takesBackColours(const Shape& shape) {
    return std::holds_alternative<Disc>(shape) || std::holds_alternative<Polygon>(shape) ||
           std::holds_alternative<TruncatedCone>(shape) || std::holds_alternative<Mesh>(shape) ||
           std::holds_alternative<OpenCylinder>(shape) || std::holds_alternative<Plane>(shape);
}

} // namespace yarte
