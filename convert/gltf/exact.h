// The exact values of a YARTE scene, kept in the extras of glTF elements: asked for by the reader.
//
// An element's extras have lines of the scene language and a record of what the element showed when they were
// written. The visible always wins: the lines count only while the element still shows that, within what the
// tools in between may do without being asked (rounding to float32, other forms of the same transform,
// another order or indexing of vertices). The schema and the tolerances are in convert/README.md.
#pragma once

#include "convert/gltf/geometry_print.h"
#include "convert/gltf/json.h"
#include "convert/gltf/material_map.h"
#include "convert/gltf/transform.h"
#include "yarte/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace yarte::convert::gltf {

enum class Stored {
    absent,     ///< the extras have nothing of ours
    valid,      ///< `value` is what was written, to the last bit
    changed,    ///< the element no longer shows it: use what it shows; `why` says what changed
    unreadable, ///< ours, but damaged; `why` says how
};

template <class T>
struct Exact {
    Stored state = Stored::absent;
    T value{};
    /// The element's index among the scene's bodies, lights or materials when it was written. Known also of
    /// changed elements, which keep their place: sort by it (stably), what has none last.
    std::optional<std::size_t> order;
    std::string why;
};

/// Extensions that some material of the document uses. What a document as a whole does not use, a tool that
/// does not know it has dropped: it is not compared. KHR_materials_transmission is always compared.
struct MaterialExtensions {
    bool ior = false, specular = false, volume = false;
};

/// Of a KHR_lights_punctual light.
struct ShownLight {
    Colour colour;
    double intensity = 1;
};

// `extras` is the element's extras, null if it has none; of nodes unless said otherwise. What of it is ours
// is marked as Fate::inExtras.

/// Of a node with a mesh of one primitive. `value.material` is not set
/// (the primitive's material tells it); in a Mesh, `mesh` is an index into ExactScene::meshes, which may have
/// been lost: compare with its size.
Exact<Body> exactBody(const Json* extras, const Transform& world, const GeometryPrint&);

/// `shown`: nothing if the document as a whole does not use KHR_lights_punctual (a tool has dropped it, or
/// left out lights but not their nodes): then only the place counts. A node with our extras and without a
/// light in a document that uses the extension is no light.
Exact<Light> exactLight(const Json* extras, Vec3 position, const std::optional<ShownLight>& shown);

/// `shown` as the perspective camera says: yfov in radians; aspectRatio, or nothing.
Exact<Camera> exactCamera(const Json* extras, const Transform& world, double yfov,
                          std::optional<double> aspectRatio);

/// Of a material's extras.
Exact<Material> exactMaterial(const Json* extras, const PbrMaterial& shown, const MaterialExtensions&);

struct ExactMesh {
    std::string path; ///< as MeshData::path
    /// Nothing: the primitive says it all, its vertices and triangles in their order, and its normals.
    std::optional<MeshData> data;
};

struct UnusedMaterial {
    std::size_t order = 0; ///< as Exact::order
    Material material;
};

/// What no element shows: of a scene's extras. Nothing visible can contradict it.
struct ExactScene {
    /// Only resolution, background, maxRecursion and gamma are set. Used as settings, all else comes from
    /// elements.
    Scene settings;
    std::size_t lightCount = 0; ///< 0: the scene had none, and must not be given one
    std::vector<UnusedMaterial> unusedMaterials;
    std::vector<ExactMesh> meshes; ///< becomes Scene::meshes, in this order
};

Exact<ExactScene> exactScene(const Json* extras);

} // namespace yarte::convert::gltf
