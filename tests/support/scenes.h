// Scenes for tests, made in a line.
#pragma once

#include "yarte/scene/scene.h"

#include <random>
#include <utility>

namespace yarte::test {

inline Material matt(Colour diffuse) { return {{}, diffuse, {}, 1, 0, 0, 0}; }
inline Material mirror(double reflection) { return {{}, {}, {}, 1, reflection, 0, 0}; }
inline Material glass(double transmission, double index) { return {{}, {}, {}, 1, 0, transmission, index}; }

/// A scene seen from (0, 0, 10) down the z axis, without lights or bodies.
inline Scene emptyScene() {
    Scene scene;
    scene.camera.position = {0, 0, 10};
    return scene;
}

/// Adds a body with a material of its own.
inline Body& add(Scene& scene, Shape shape, const Material& material) {
    scene.materials.push_back(material);
    scene.bodies.push_back(
        {std::move(shape), {static_cast<std::uint32_t>(scene.materials.size() - 1)}, {}, {}, {}});
    return scene.bodies.back();
}

/// Adds `data` as a mesh placed as it is.
inline Body& addMesh(Scene& scene, MeshData data, const Material& material) {
    scene.meshes.push_back(std::move(data));
    const MeshId id{static_cast<std::uint32_t>(scene.meshes.size() - 1)};
    return add(scene, Mesh{id, 1, {{1, 0, 0}, {0, 1, 0}, Vec3{0, 0, 1}}, {}}, material);
}

class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }
    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }
    Vec3 inCube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
    Vec3 direction() {
        for (;;)
            if (const Vec3 v = inCube(1); dot(v, v) <= 1 && dot(v, v) > 1e-4) return normalised(v);
    }
    /// Axes as a person would write them: two perpendicular versors.
    Referential referential() {
        const Vec3 x = direction(), y = normalised(cross(x, direction()));
        return {x, y, {}};
    }

private:
    std::mt19937_64 engine_;
};

/// Bounded shapes of all kinds, some transmissive with different ct, some overlapping; those of even seeds
/// with tints, too.
inline Scene mixedScene(int count, unsigned seed) {
    Random random(seed);
    Scene scene = emptyScene();
    MeshData tetrahedron;
    tetrahedron.vertices = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    tetrahedron.corners = {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
    tetrahedron.faceStarts = {0, 3, 6, 9, 12};
    scene.meshes.push_back(tetrahedron);
    for (int i = 0; i < count; ++i) {
        Material material = matt({random.between(0, 1), random.between(0, 1), random.between(0, 1)});
        material.ambient = material.diffuse * 0.1;
        material.specular = {0.3, 0.2, random.between(0, 1)};
        material.exponent = random.between(1, 200);
        if (i % 4 == 0) material.reflection = random.between(0.1, 0.9);
        if (i % 3 == 0) material.transmission = random.between(0.3, 1), material.index = random.between(1, 2);
        if (seed % 2 == 0 && i % 6 == 0)
            material.tint = {random.between(0, 1), i % 12 == 0 ? 0 : random.between(0, 1), 1};
        const Vec3 c = random.inCube(10);
        const double s = random.between(0.1, 1.5);
        const auto turned = [&](Shape shape) {
            add(scene, std::move(shape), material).referential = random.referential();
        };
        switch (i % 10) {
        case 0: add(scene, Sphere{c, s}, material); break;
        case 1: turned(Box{c, {s, 2 * s, s}}); break;
        case 2: turned(Cone{c, s, 2 * s}); break;
        case 3: turned(TruncatedCone{c, s, 3 * s, s}); break;
        case 4: turned(Disc{c, s}); break;
        case 5:
            add(scene, Polygon{{c, c + Vec3{s, 0, 0}, c + Vec3{s, s, 0}, c + Vec3{0, s, 0}}}, material);
            break;
        case 6: turned(Cylinder{c, s, 2 * s}); break;
        case 7: turned(OpenCylinder{c, s, 2 * s}); break;
        case 8: turned(Frustum{c, s, s * random.between(0.2, 3), 2 * s}); break;
        default: {
            Referential axes = random.referential();
            axes.z = Vec3{};
            add(scene, Mesh{{0}, s, axes, c}, material);
        }
        }
    }
    return scene;
}

/// Spheres, boxes and triangles that leave room between them; a third is transmissive.
inline Scene smallBodies(int count, unsigned seed) {
    Random random(seed);
    Scene scene = emptyScene();
    for (int i = 0; i < count; ++i) {
        Material material = matt({random.between(0, 1), random.between(0, 1), random.between(0, 1)});
        if (i % 5 == 0) material.reflection = 0.5;
        if (i % 3 == 0) material.transmission = i % 2 ? 0.5 : 0.8, material.index = 1.2;
        const Vec3 c = random.inCube(10);
        const double s = random.between(0.05, 0.3);
        if (i % 4 == 1)
            add(scene, Box{c, {s, 2 * s, s}}, material).referential = random.referential();
        else if (i % 4 == 2)
            add(scene, Polygon{{c, c + s * random.direction(), c + s * random.direction()}}, material);
        else
            add(scene, Sphere{c, s}, material);
    }
    return scene;
}

/// Adds planes, far and near, every other one transmissive; between the bodies of the file if it can.
inline void addPlanes(Scene& scene, int count, unsigned seed) {
    Random random(seed);
    for (int i = 0; i < count; ++i) {
        Material material = matt({random.between(0, 1), random.between(0, 1), random.between(0, 1)});
        if (i % 2 == 0) material.transmission = random.between(0.6, 1), material.index = random.between(1, 2);
        if (i % 3 == 0) material.reflection = random.between(0.1, 0.6);
        add(scene, Plane{random.direction() * random.between(0.1, 9), random.between(-12, 12)}, material)
            .back = BackColours{{0.1, 0, 0}, {0, random.between(0, 1), 0}, {}};
        const auto last = scene.bodies.size() - 1;
        std::swap(scene.bodies[last],
                  scene.bodies[static_cast<std::size_t>(random.below(static_cast<int>(last + 1)))]);
    }
}

} // namespace yarte::test
