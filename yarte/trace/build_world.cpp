// From a scene to what rays meet.
#include "yarte/base/huge_pages.h"
#include "yarte/scene/mesh_placement.h"
#include "yarte/scene/referential.h"
#include "yarte/trace/search.h"
#include "yarte/trace/world.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

namespace yarte {

using namespace trace;

namespace {

/// Three vertex normals this close in every component make a flat face (decision D8).
constexpr double flatNormals = 1e-5;

Frame frameOf(const Body& body) { return body.referential ? resolveReferential(*body.referential) : Frame{}; }

BodyAppearance appearance(const Material& m, const std::optional<BackColours>& back) {
    const BackColours b = back.value_or(BackColours{m.ambient, m.diffuse, m.specular});
    return {{m.ambient, b.ambient},
            {m.diffuse, b.diffuse},
            {m.specular, b.specular},
            m.exponent,
            m.reflection,
            m.index,
            transmittance(m),
            transmits(m) ? m.transmission : 0};
}

/// Below this many elements the tree alone is as fast as light buffers.
constexpr std::size_t minBufferedElements = 128;
/// With fewer pixels for each element, too few rays use them for their making to pay.
constexpr std::size_t pixelsPerBufferedElement = 16;

double largestOf(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

class Builder {
public:
    Builder(const Scene& scene, World& world) : scene_(scene), world_(world) {}

    /// Room for the faces of all bodies: growing step by step would copy a large mesh again and again.
    void reserveFaces() {
        std::size_t vertices = 0, normals = 0, faces = 0, corners = 0, smoothCorners = 0;
        for (const Body& body : scene_.bodies) {
            if (const auto* polygon = std::get_if<Polygon>(&body.shape)) {
                vertices += polygon->vertices.size(), corners += polygon->vertices.size(), ++faces;
            } else if (const auto* mesh = std::get_if<Mesh>(&body.shape)) {
                const MeshData& data = scene_.meshes[mesh->mesh.index];
                vertices += data.vertices.size(), normals += data.normals.size(), faces += data.faceCount();
                corners += data.corners.size();
                if (data.isSmooth()) smoothCorners = corners; // flat faces before it are passed over
            }
        }
        FaceTable& table = world_.faces;
        reserveWhole(table.vertices, vertices), reserveWhole(table.normals, normals);
        reserveWhole(table.corners, corners), reserveWhole(table.cornerNormals, smoothCorners);
        reserveWhole(table.faces, faces);
        reserveWhole(world_.elements, scene_.bodies.size() + faces);
        reserveWhole(world_.elementBody, scene_.bodies.size() + faces);
    }

    void addBody(const Body& body) {
        world_.bodies.push_back(appearance(scene_.materials[body.material.index], body.back));
        std::visit([&](const auto& shape) { add(shape, body); }, body.shape);
    }

private:
    void add(const yarte::Sphere& s, const Body&) { append(Kind::sphere, world_.spheres, trace::Sphere(s)); }
    void add(const yarte::Box& b, const Body& body) {
        append(Kind::box, world_.boxes, trace::Box(b, frameOf(body)));
    }
    void add(const yarte::Cone& c, const Body& body) {
        append(Kind::cone, world_.cones, trace::Cone(c, frameOf(body)));
    }
    void add(const yarte::TruncatedCone& c, const Body& body) {
        append(Kind::truncatedCone, world_.truncatedCones, trace::TruncatedCone(c, frameOf(body)));
    }
    void add(const yarte::Disc& d, const Body& body) {
        append(Kind::disc, world_.discs, trace::Disc(d, frameOf(body)));
    }
    void add(const yarte::Cylinder& c, const Body& body) {
        append(Kind::frustum, world_.frustums, trace::Frustum(c, frameOf(body)));
    }
    void add(const yarte::OpenCylinder& c, const Body& body) {
        append(Kind::truncatedCone, world_.truncatedCones, trace::TruncatedCone(c, frameOf(body)));
    }
    void add(const yarte::Frustum& f, const Body& body) {
        append(Kind::frustum, world_.frustums, trace::Frustum(f, frameOf(body)));
    }
    void add(const yarte::Plane& p, const Body&) {
        world_.unbounded.push_back({static_cast<std::uint32_t>(world_.elements.size())});
        append(Kind::plane, world_.planes, trace::Plane(p));
    }
    void add(const yarte::Polygon& p, const Body&) {
        const auto first = static_cast<std::uint32_t>(world_.faces.vertices.size());
        world_.faces.vertices.insert(world_.faces.vertices.end(), p.vertices.begin(), p.vertices.end());
        std::vector<std::uint32_t> corners(p.vertices.size());
        for (std::uint32_t i = 0; i < corners.size(); ++i) corners[i] = i;
        addFace(corners, first, {}, 0);
    }
    void add(const yarte::Mesh& m, const Body&) {
        const MeshData& data = scene_.meshes[m.mesh.index];
        const auto firstVertex = static_cast<std::uint32_t>(world_.faces.vertices.size());
        const auto firstNormal = static_cast<std::uint32_t>(world_.faces.normals.size());
        const MeshPlacement place(m);
        for (const Vec3 v : data.vertices) world_.faces.vertices.push_back(place(v));
        for (const Vec3 n : data.normals) world_.faces.normals.push_back(normalised(place.axes().toWorld(n)));
        for (std::size_t f = 0; f < data.faceCount(); ++f)
            addFace(data.face(f), firstVertex,
                    data.isSmooth() ? data.faceNormals(f) : std::span<const std::uint32_t>{}, firstNormal);
    }

    template <class Shape>
    void append(Kind kind, std::vector<Shape>& table, const Shape& shape) {
        addElement(kind, table.size());
        table.push_back(shape);
    }

    void addElement(Kind kind, std::size_t row) {
        world_.elements.push_back({kind, static_cast<std::uint32_t>(row)});
        world_.elementBody.push_back({static_cast<std::uint32_t>(world_.bodies.size() - 1)});
    }

    /// Faces without area have no normal and are left out: no ray can meet them.
    void addFace(std::span<const std::uint32_t> corners, std::uint32_t firstVertex,
                 std::span<const std::uint32_t> normals, std::uint32_t firstNormal) {
        FaceTable& table = world_.faces;
        Face face;
        face.firstCorner = static_cast<std::uint32_t>(table.corners.size());
        face.cornerCount = static_cast<std::uint32_t>(corners.size());
        for (const std::uint32_t corner : corners) table.corners.push_back(firstVertex + corner);
        const FacePlane plane = computePlane(table, face);
        if (!isFinite(plane.normal)) {
            table.corners.resize(face.firstCorner);
            return;
        }
        if (corners.size() > 3) {
            face.plane = static_cast<std::uint32_t>(table.planes.size());
            table.planes.push_back(plane);
        }
        if (!normals.empty()) {
            table.cornerNormals.resize(table.corners.size() - corners.size());
            for (const std::uint32_t normal : normals) table.cornerNormals.push_back(firstNormal + normal);
            face.isSmooth = !areEqual(normals, firstNormal);
        }
        addElement(Kind::face, table.faces.size());
        table.faces.push_back(face);
    }

    bool areEqual(std::span<const std::uint32_t> normals, std::uint32_t firstNormal) const {
        const auto at = [&](std::size_t i) { return world_.faces.normals[firstNormal + normals[i]]; };
        const auto close = [](Vec3 a, Vec3 b) {
            return std::abs(a.x - b.x) < flatNormals && std::abs(a.y - b.y) < flatNormals &&
                   std::abs(a.z - b.z) < flatNormals;
        };
        return close(at(0), at(1)) && close(at(0), at(2));
    }

    const Scene& scene_;
    World& world_;
};

/// Empty of planes, which have none.
Bounds boundsOf(const World& world, ElementId element) {
    return world.visit(element, []<class Shape>(const Shape& shape) -> Bounds {
        if constexpr (std::is_same_v<Shape, trace::Plane>)
            return {};
        else
            return bounds(shape);
    });
}

Bounds boundsOfAll(const World& world) {
    Bounds all;
    for (std::uint32_t i = 0; i < world.elements.size(); ++i) all.add(boundsOf(world, {i}));
    return all;
}

/// The largest coordinate of what is in a box, seen from `origin`.
double reachOf(const Bounds& box, Vec3 origin) {
    return box.isEmpty() ? 0 : std::max(largestOf(box.low - origin), largestOf(box.high - origin));
}

/// How far from a plane a point may be that lies in it: its coordinates, and the plane's, are sums and
/// products of a few numbers no larger than `largest`. In tilted walls of jittered triangles all of 4 million
/// starts are nearer than half of this to their neighbour's plane, all but 18 nearer than a sixteenth.
double roundingOf(double largest) { return 0x1p-46 * largest; }

/// What boxes are widened by for the rounding of lines in float.
double roomFor(Precision precision, double largest) {
    return precision == Precision::inFloat ? 0x1p-20 * largest : 0;
}

/// Whether float does for the picture: each number is rounded to 2^-24 of its distance from the camera, which
/// is to be less than a hundredth of a pixel's width; and products of four lengths must neither overflow nor
/// vanish.
bool suitsFloat(const World& world, const Bounds& all) {
    constexpr double narrowest = 0x1p-17, smallest = 0x1p-16, largest = 0x1p30, farthestLight = 0x1p60;
    const CameraRays& camera = world.camera;
    if (length(camera.right) / camera.width < narrowest || length(camera.up) / camera.height < narrowest)
        return false;
    for (const Light& light : world.lights)
        if (largestOf(light.position - camera.position) > farthestLight) return false;
    const double reach = reachOf(all, camera.position);
    return all.isEmpty() || (reach >= smallest && reach <= largest);
}

/// Moves the world so that the camera is at the origin: the nearer to the eye, the finer the numbers.
void moveToCamera(World& world) {
    const Vec3 origin = std::exchange(world.camera.position, Vec3{});
    const auto move = [origin](auto& shapes) {
        for (auto& shape : shapes) shape.centre = shape.centre - origin;
    };
    move(world.spheres), move(world.boxes), move(world.cones), move(world.truncatedCones);
    move(world.frustums), move(world.discs);
    for (trace::Plane& plane : world.planes) plane.distance -= dot(plane.normal, origin);
    for (Vec3& vertex : world.faces.vertices) vertex = vertex - origin;
    for (FacePlane& plane : world.faces.planes) plane.anchor = plane.anchor - origin;
    for (Light& light : world.lights) light.position = light.position - origin;
}

Tree treeOf(const World& world, const Bounds& all, double room) {
    if (world.elements.size() - world.unbounded.size() < minElementsForTree) return {};
    Tree tree = buildTree(
        all, world.elements.size(), [&](ElementId element) { return boundsOf(world, element); }, room);
    for (TreeEntry& entry : tree.entries) {
        const auto [kind, row] = world.elements[entry.element.index];
        if (kind != Kind::face || world.faces.faces[row].cornerCount != 3) continue;
        std::copy_n(&world.faces.corners[world.faces.faces[row].firstCorner], 3, entry.corners);
    }
    return tree;
}

/// Of all lights; empty ones where they would not pay.
std::vector<LightBuffer> lightBuffersOf(const World& world, Resolution resolution) {
    std::vector<LightBuffer> buffers(world.lights.size());
    const std::size_t count = world.tree.entries.size();
    const auto pixels =
        static_cast<std::size_t>(resolution.width) * static_cast<std::size_t>(resolution.height);
    if (count < minBufferedElements || count > pixels / pixelsPerBufferedElement) return buffers;
    // Roundings of 2^-52 and 2^-23 are then 2^-24 and, at most, 2^-17 of the tree's radius.
    const double farthest = world.precision == Precision::inDouble ? 0x1p28 : 0x1p6;
    std::vector<Bounds> boxes;
    reserveWhole(boxes, count);
    for (const TreeEntry& entry : world.tree.entries) boxes.push_back(boundsOf(world, entry.element));
    tbb::parallel_for(std::size_t{0}, buffers.size(), [&](std::size_t l) {
        buffers[l] = buildLightBuffer(world.tree, boxes, world.lights[l].position, farthest);
    });
    return buffers;
}

void listTransmissions(World& world) {
    std::vector<Colour>& list = world.transmissions;
    const auto precedes = [](Colour a, Colour b) {
        return std::tuple(a.r, a.g, a.b) < std::tuple(b.r, b.g, b.b);
    };
    for (const BodyAppearance& body : world.bodies)
        if (!isBlack(body.transmission)) {
            const double ct = body.totalReflection;
            world.isTinted |= body.transmission != Colour{ct, ct, ct};
            list.push_back(body.transmission);
        }
    std::sort(list.begin(), list.end(), precedes);
    list.erase(std::unique(list.begin(), list.end()), list.end());
    for (BodyAppearance& body : world.bodies)
        body.transmissionLevel = static_cast<std::uint32_t>(
            std::lower_bound(list.begin(), list.end(), body.transmission, precedes) - list.begin());
}

/// How often the view axis, followed in one direction, leaves each transmissive body more than it enters it,
/// and where first.
struct Leaving {
    std::vector<int> balance;
    std::vector<double> first;
};

Leaving leavingAlong(const World& world, Vec3 direction) {
    Leaving result{std::vector(world.bodies.size(), 0), std::vector(world.bodies.size(), Bounds::infinity)};
    const Ray axis{world.camera.position, direction, {}};
    for (std::uint32_t i = 0; i < world.elements.size(); ++i) {
        const std::uint32_t body = world.bodyOf({i}).index;
        if (isBlack(world.bodies[body].transmission)) continue;
        world.visit(ElementId{i}, [&]<class Shape>(const Shape& shape) {
            if constexpr (std::is_same_v<Shape, trace::Plane>) { // left in one direction at most: being in it
                                                                 // is enough
                if (heightAbove(shape, axis.origin) >= 0) return;
                ++result.balance[body];
                for (const Crossing& c : crossings(shape, axis))
                    if (c.t > 0) result.first[body] = c.t;
                return;
            }
            // Discs and truncated cones are open; faces count, since those of a mesh may close it.
            if constexpr (Shape::isClosed || std::is_same_v<Shape, FaceShape>)
                for (const Crossing& c : crossings(shape, axis)) {
                    if (c.t <= 0) continue;
                    result.balance[body] += c.entering ? -1 : 1;
                    if (!c.entering) result.first[body] = std::min(result.first[body], c.t);
                }
        });
    }
    return result;
}

/// The transmissive closed bodies around the camera; the one whose exit along the view axis is farthest comes
/// first. A body is around the camera if it is left both ahead and behind: that takes in closed meshes, but
/// no lone polygon.
std::vector<BodyId> mediaAround(const World& world) {
    const Leaving ahead = leavingAlong(world, world.camera.forward);
    const Leaving behind = leavingAlong(world, -world.camera.forward);
    std::vector<BodyId> result;
    for (std::uint32_t body = 0; body < world.bodies.size(); ++body)
        if (ahead.balance[body] > 0 && behind.balance[body] > 0) result.push_back({body});
    std::stable_sort(result.begin(), result.end(),
                     [&](BodyId a, BodyId b) { return ahead.first[a.index] > ahead.first[b.index]; });
    return result;
}

} // namespace

Precision precisionOf(const World& world) { return world.precision; }

WorldPtr buildWorld(const Scene& scene, Resolution resolution, Precision precision) {
    auto owned = std::make_unique<World>();
    World& world = *owned;
    world.camera = CameraRays(scene.camera, resolution);
    world.background = scene.background;
    world.levels = scene.maxRecursion;
    for (const Light& light : scene.lights)
        if (!isBlack(light.brightness)) world.lights.push_back(light);
    Builder builder(scene, world);
    builder.reserveFaces();
    for (const Body& body : scene.bodies) builder.addBody(body);
    Bounds all = boundsOfAll(world);
    if (precision == Precision::inFloat && suitsFloat(world, all)) {
        world.precision = precision;
        moveToCamera(world);
        all = boundsOfAll(world);
    }
    const double largest = std::max(largestOf(world.camera.position), reachOf(all, {}));
    world.faces.largest = largest, world.faces.rounding = roundingOf(largest);
    listTransmissions(world);
    if (!world.transmissions.empty()) world.cameraMedia = mediaAround(world);
    world.tree = treeOf(world, all, roomFor(world.precision, largest));
    world.lightBuffers = lightBuffersOf(world, resolution);
    return WorldPtr(owned.release());
}

void WorldDeleter::operator()(const World* world) const { delete world; }

} // namespace yarte
