// What an SDL file describes, after its program has run: objects with their transformations and textures,
// lights, camera, settings, in POV-Ray's own terms and units. build_scene.h makes YARTE's scene of it.
#pragma once

#include "convert/povray/sdl/affine.h"
#include "yarte/base/source.h"
#include "yarte/base/vec3.h"
#include "yarte/scene/scene.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace yarte::convert::povray::sdl {

/// POV-Ray's colour: `filter` lets light through tinted, `transmit` untinted.
struct Rgbft {
    double r = 0, g = 0, b = 0, filter = 0, transmit = 0;
    friend bool operator==(const Rgbft&, const Rgbft&) = default;
};

struct Pigment {
    Rgbft colour{};        ///< of a pattern: what stands for it (the mean of its colours)
    std::string pattern{}; ///< empty: one colour; else its name ("checker", "color_map of granite")
    friend bool operator==(const Pigment&, const Pigment&) = default;
};

/// Defaults are POV-Ray's.
struct Finish {
    Colour ambient{0.1, 0.1, 0.1}; ///< times pigment and the scene's ambient_light
    Colour emission{};             ///< times pigment
    double diffuse = 0.6, brilliance = 1;
    double phong = 0, phongSize = 40;
    double specular = 0, roughness = 0.05;
    double metallic = 0; ///< highlights tinted by the pigment
    Colour reflectionMin{}, reflectionMax{};
    double reflectionFalloff = 1, reflectionExponent = 1, reflectionMetallic = 0;
    bool reflectionFresnel = false, conserveEnergy = false;
    std::optional<double> index; ///< `ior` in a finish, as POV-Ray before 3.1 had it
    std::vector<std::string>
        ignored{}; ///< words that change the picture and have no part here: "crand", "irid"
    friend bool operator==(const Finish&, const Finish&) = default;
};

struct Texture {
    Pigment pigment;
    Finish finish;
    bool hasNormal = false; ///< bumps and the like
    std::string kind{};     ///< empty: plain; else what this texture stands for ("texture_map of wood")
    friend bool operator==(const Texture&, const Texture&) = default;
};

/// Layers from the bottom up, as SDL has them.
using Layers = std::vector<Texture>;

struct Interior {
    double index = 1;
    std::vector<std::string> ignored{}; ///< "media", "fade_distance", "dispersion"
    friend bool operator==(const Interior&, const Interior&) = default;
};

/// A material that one of the macros of YARTE's own .pov files made: its arguments.
struct ExactMaterial {
    MaterialId id; ///< into Model::exactMaterials
    std::optional<BackColours> back;
};

struct Appearance {
    std::optional<Layers> layers;     ///< none: the parent's, or the default texture
    std::optional<Layers> backLayers; ///< interior_texture
    std::optional<Interior> interior; ///< none: the parent's, or that of empty space
    std::optional<ExactMaterial> exact;
};

// Shapes. Lengths and places before the object's own transformation.

struct SphereShape {
    Vec3 centre;
    double radius = 1;
};
struct BoxShape {
    Vec3 a, b;
}; ///< two opposite corners, in any order
/// A cylinder where the radii are equal, a cone where one of them is 0.
struct ConeShape {
    Vec3 a;
    double radiusA = 1;
    Vec3 b;
    double radiusB = 0;
    bool open = false;
};
struct DiscShape {
    Vec3 centre, normal{0, 1, 0};
    double radius = 1, hole = 0;
};
struct TorusShape {
    double major = 1, minor = 0.25;
}; ///< around y
struct PlaneShape {
    Vec3 normal{0, 1, 0};
    double distance = 0;
}; ///< as written; POV-Ray divides n and not d by |n|
/// As written: points in space; a contour ends where its first point comes again (which is not repeated
/// here).
struct PolygonShape {
    std::vector<std::vector<Vec3>> contours;
};
/// One triangle, with normals if smooth. Its front is by the left-hand rule.
struct TriangleShape {
    std::array<Vec3, 3> corners;
    std::optional<std::array<Vec3, 3>> normals;
};

struct MeshShape {
    using Indices = std::array<std::uint32_t, 3>;
    std::vector<Vec3> vertices, normals;
    std::vector<Indices> faces;
    std::vector<Indices> faceNormals; ///< as `faces`, into `normals`; empty: flat
    std::vector<Layers> textures;     ///< of the mesh's own texture list
    /// As `faces`: index into `textures`, or `none`; empty: none has one.
    std::vector<std::uint32_t> faceTextures;
    static constexpr std::uint32_t none = 0xffffffff;
};

struct Object;
using ObjectPtr = std::shared_ptr<const Object>;

/// union, merge.
struct UnionShape {
    std::vector<ObjectPtr> parts;
    bool isMerge = false;
};

struct LightShape {
    Vec3 position;
    Colour colour;
    /// What makes it more than a point: "spotlight", "area_light", "parallel", "fade_distance", ...
    std::vector<std::string> kinds;
    bool isShadowless = false;
    ObjectPtr looksLike; ///< may be null
    /// Of "parallel" and "cylinder": the rays are parallel to the way from `position` to it.
    std::optional<Vec3> pointAt{};
};

/// What YARTE has no shape for: evaluated past. `kind` as written: "difference", "isosurface".
struct UnsupportedShape {
    std::string kind;
};

/// A shape that one of the macros of YARTE's own .pov files made, from its arguments: already in the scene's
/// units and without any transformation.
struct ExactShape {
    Shape shape;
}; ///< a mesh's id is into Model::exactMeshes

using ObjectShape = std::variant<SphereShape, BoxShape, ConeShape, DiscShape, TorusShape, PlaneShape,
                                 PolygonShape, TriangleShape, std::shared_ptr<const MeshShape>, UnionShape,
                                 LightShape, UnsupportedShape, ExactShape>;

struct Object {
    ObjectShape shape;
    Affine transform;
    Appearance appearance;
    /// Axes that a Yarte_Turn gave last, which are the rows of `transform`, and as the file has them written.
    std::optional<Referential> exactAxes;
    /// Modifiers that change the picture and have no part here: "clipped_by", "no_shadow", "no_image".
    std::vector<std::string> ignored;
    bool isHidden = false; ///< no_image: not in the picture, though it may be seen in mirrors
    Span span;             ///< its keyword
    std::size_t count = 1; ///< objects that it is made of, itself and each as often as it is used
    int depth = 1;         ///< of objects in each other
};

struct CameraModel {
    std::string kind = "perspective";
    Vec3 location, direction{0, 0, 1}, right{1.33, 0, 0}, up{0, 1, 0}; ///< after look_at, angle, ...
    std::vector<std::string> ignored;                                  ///< "focal_blur", "normal"
    std::optional<Camera> exact;                                       ///< by Yarte_Camera
    Span span;
};

struct Model {
    std::optional<CameraModel> camera;
    Colour background{};
    Colour ambientLight{1, 1, 1};
    int maxTraceLevel = 5;
    double languageVersion = 3.62;  ///< the last #version; below 3.7 some formulas of textures differ
    std::vector<ObjectPtr> objects; ///< lights among them; in the order of the file
    Texture defaultTexture;
    /// global_settings' assumed_gamma; none: not given.
    std::optional<double> assumedGamma;

    // From YARTE's own files.
    double unit = 1; ///< World_Scale: the length here of the scene's unit; a power of two
    std::optional<Resolution> resolution;
    std::optional<double> gamma;
    std::vector<Material> exactMaterials;
    std::vector<MeshData> exactMeshes;
};

} // namespace yarte::convert::povray::sdl
