// World: what rays meet. Tables per kind of shape, resolved materials, lights and camera; immutable once
// built.
#pragma once

#include "yarte/scene/scene.h"
#include "yarte/trace/box.h"
#include "yarte/trace/camera.h"
#include "yarte/trace/cone.h"
#include "yarte/trace/disc.h"
#include "yarte/trace/face.h"
#include "yarte/trace/frustum.h"
#include "yarte/trace/light_buffer.h"
#include "yarte/trace/plane.h"
#include "yarte/trace/render_tile.h"
#include "yarte/trace/sphere.h"
#include "yarte/trace/tree.h"
#include "yarte/trace/truncated_cone.h"

#include <vector>

namespace yarte {

namespace trace {

/// How the world sees shapes: an open cylinder is a truncated cone, a closed one a frustum, without slope.
enum class Kind : std::uint8_t { sphere, box, cone, truncatedCone, frustum, disc, plane, face };

/// Where an element's shape lies: its kind's table and the row in it.
struct Element {
    Kind kind;
    std::uint32_t row;
};

/// Index into World::bodies, in the order of the scene's file.
struct BodyId {
    std::uint32_t index = 0;
    friend constexpr bool operator==(BodyId, BodyId) = default;
};

/// What the shading needs to know of a body.
struct BodyAppearance {
    Colour ambient[2], diffuse[2],
        specular[2]; ///< [0] front, [1] back: the same unless the body has back colours
    double exponent, reflection, index;
    Colour transmission;                 ///< of light that passes: ct times the tint
    double totalReflection;              ///< of light that is reflected totally: ct; 0 where none passes
    std::uint32_t transmissionLevel = 0; ///< place of `transmission` in World::transmissions
};

} // namespace trace

class World {
public:
    /// A world for float has its camera at the origin; see build_world.cpp.
    Precision precision = Precision::inDouble;
    trace::CameraRays camera;
    Colour background;
    int levels = 0; ///< secondary generations
    std::vector<Light> lights;
    std::vector<trace::BodyAppearance> bodies;

    std::vector<trace::Sphere> spheres;
    std::vector<trace::Box> boxes;
    std::vector<trace::Cone> cones;
    std::vector<trace::TruncatedCone> truncatedCones;
    std::vector<trace::Frustum> frustums;
    std::vector<trace::Disc> discs;
    std::vector<trace::Plane> planes;
    trace::FaceTable faces;

    std::vector<trace::Element> elements;   ///< by ElementId
    std::vector<trace::BodyId> elementBody; ///< by ElementId

    trace::Tree tree;                             ///< over the elements but planes; empty for few of them
    std::vector<trace::ElementId> unbounded;      ///< the planes: what the tree cannot hold
    std::vector<trace::LightBuffer> lightBuffers; ///< of each light, over what the tree holds
    /// The distinct transmissions of the bodies but black, in an order of their own; empty: nothing
    /// transmits.
    std::vector<Colour> transmissions;
    bool isTinted = false; ///< some body's transmission is not the same as its ct in all channels
    std::vector<trace::BodyId> cameraMedia; ///< transmissive closed bodies around the camera, outermost first

    trace::BodyId bodyOf(trace::ElementId id) const { return elementBody[id.index]; }
    const trace::BodyAppearance& appearanceOf(trace::ElementId id) const { return bodies[bodyOf(id).index]; }

    /// Calls `visitor` with the element's shape: the one place that selects by kind.
    template <class Visitor>
    decltype(auto) visit(trace::ElementId id, Visitor&& visitor) const {
        const auto [kind, row] = elements[id.index];
        switch (kind) {
        case trace::Kind::sphere: return visitor(spheres[row]);
        case trace::Kind::box: return visitor(boxes[row]);
        case trace::Kind::cone: return visitor(cones[row]);
        case trace::Kind::truncatedCone: return visitor(truncatedCones[row]);
        case trace::Kind::frustum: return visitor(frustums[row]);
        case trace::Kind::disc: return visitor(discs[row]);
        case trace::Kind::plane: return visitor(planes[row]);
        case trace::Kind::face: break;
        }
        return visitor(trace::FaceShape{faces, faces.faces[row]});
    }
};

} // namespace yarte
