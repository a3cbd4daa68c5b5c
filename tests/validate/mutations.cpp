#include "tests/validate/mutations.h"

#include <cmath>
#include <limits>
#include <vector>

namespace yarte::validate::test {

namespace {

using yarte::test::Random;

class Mutator {
public:
    Mutator(const Scene& scene, Random& random) : random_(random) { mutation_.scene = scene; }

    std::optional<Mutation> make(MutationKind kind) {
        mutation_.kind = kind;
        if (!change(kind)) return std::nullopt;
        return mutation_;
    }

private:
    bool change(MutationKind);
    bool changeBody(MutationKind);
    bool changeMaterial(MutationKind, Body&, Material&);
    bool changeLight(MutationKind);

    /// Up or down by a factor that can be seen.
    double factor() { return random_.below(2) == 0 ? random_.between(0.6, 0.9) : random_.between(1.1, 1.6); }
    Colour factors() { return {factor(), factor(), factor()}; }
    /// Another value in [0, 1], apart from `value` by at least 0.1.
    double otherPart(double value) {
        for (;;)
            if (const double other = random_.between(0, 1); std::abs(other - value) > 0.1) return other;
    }
    Colour otherColour(Colour c) { return {otherPart(c.r), otherPart(c.g), otherPart(c.b)}; }

    /// The number of a random body for which `fits` holds; -1 if there is none.
    template <class Fits>
    int pick(Fits fits) {
        std::vector<int> numbers;
        for (std::size_t i = 0; i < mutation_.scene.bodies.size(); ++i)
            if (fits(mutation_.scene.bodies[i])) numbers.push_back(static_cast<int>(i));
        return numbers.empty()
                   ? -1
                   : numbers[static_cast<std::size_t>(random_.below(static_cast<int>(numbers.size())))];
    }
    const Material& materialOf(const Body& body) const {
        return mutation_.scene.materials[body.material.index];
    }

    Random& random_;
    Mutation mutation_;
};

double sizeOf(const Scene& scene, const Shape& shape) {
    struct Size {
        const Scene& scene;
        double operator()(const Sphere& s) const { return s.radius; }
        double operator()(const Box& b) const { return length(b.sides) / 2; }
        double operator()(const Cone& c) const { return std::max(c.radius, c.height / 2); }
        double operator()(const TruncatedCone& c) const { return std::max(c.radius, c.height / 2); }
        double operator()(const Disc& d) const { return d.radius; }
        double operator()(const Polygon& p) const { return reach(p.vertices); }
        double operator()(const Mesh& m) const {
            return m.scale * reach(scene.meshes[m.mesh.index].vertices);
        }
        double operator()(const Cylinder& c) const { return std::max(c.radius, c.height / 2); }
        double operator()(const OpenCylinder& c) const { return std::max(c.radius, c.height / 2); }
        double operator()(const Frustum& f) const {
            return std::max({f.baseRadius, f.topRadius, f.height / 2});
        }
        double operator()(const Plane&) const { return std::numeric_limits<double>::infinity(); }
        static double reach(const std::vector<Vec3>& points) {
            Vec3 mean;
            for (const Vec3& p : points) mean = mean + p / static_cast<double>(points.size());
            double largest = 0;
            for (const Vec3& p : points) largest = std::max(largest, length(p - mean));
            return largest;
        }
    };
    return std::visit(Size{scene}, shape);
}

void move(Shape& shape, Vec3 by) {
    struct Move {
        Vec3 by;
        void operator()(Sphere& s) const { s.centre = s.centre + by; }
        void operator()(Box& b) const { b.centre = b.centre + by; }
        void operator()(Cone& c) const { c.centre = c.centre + by; }
        void operator()(TruncatedCone& c) const { c.centre = c.centre + by; }
        void operator()(Disc& d) const { d.centre = d.centre + by; }
        void operator()(Polygon& p) const {
            for (Vec3& v : p.vertices) v = v + by;
        }
        void operator()(Mesh& m) const { m.translation = m.translation + by; }
        void operator()(Cylinder& c) const { c.centre = c.centre + by; }
        void operator()(OpenCylinder& c) const { c.centre = c.centre + by; }
        void operator()(Frustum& f) const { f.centre = f.centre + by; }
        void operator()(Plane& p) const { p.distance += dot(by, unitVector(p.normal)); }
    };
    std::visit(Move{by}, shape);
}

void resize(Shape& shape, double k) {
    struct Resize {
        double k;
        void operator()(Sphere& s) const { s.radius *= k; }
        void operator()(Box& b) const { b.sides = b.sides * k; }
        void operator()(Cone& c) const { c.radius *= k, c.height *= k; }
        void operator()(TruncatedCone& c) const { c.radius *= k, c.coneHeight *= k, c.height *= k; }
        void operator()(Disc& d) const { d.radius *= k; }
        void operator()(Polygon& p) const {
            Vec3 mean;
            for (const Vec3& v : p.vertices) mean = mean + v / static_cast<double>(p.vertices.size());
            for (Vec3& v : p.vertices) v = mean + (v - mean) * k;
        }
        void operator()(Mesh& m) const { m.scale *= k; }
        void operator()(Cylinder& c) const { c.radius *= k, c.height *= k; }
        void operator()(OpenCylinder& c) const { c.radius *= k, c.height *= k; }
        void operator()(Frustum& f) const { f.baseRadius *= k, f.topRadius *= k, f.height *= k; }
        void operator()(Plane& p) const { p.distance *= k; }
    };
    std::visit(Resize{k}, shape);
}

bool Mutator::changeMaterial(MutationKind kind, Body& body, Material& m) {
    mutation_.cause = Cause::shading;
    switch (kind) {
    case MutationKind::ambient: m.ambient = otherColour(m.ambient); return true;
    case MutationKind::diffuse: m.diffuse = otherColour(m.diffuse); return true;
    case MutationKind::specular: m.specular = otherColour(m.specular); return true;
    case MutationKind::exponent: m.exponent *= random_.below(2) == 0 ? 0.3 : 3; return true;
    case MutationKind::sidesSwapped: {
        const BackColours back = *body.back;
        body.back = BackColours{m.ambient, m.diffuse, m.specular};
        m.ambient = back.ambient, m.diffuse = back.diffuse, m.specular = back.specular;
        return true;
    }
    case MutationKind::reflection:
        mutation_.cause = Cause::reflection;
        m.reflection = otherPart(m.reflection);
        return true;
    case MutationKind::transmission:
        mutation_.cause = Cause::refraction;
        m.transmission = std::max(0.05, otherPart(m.transmission));
        return true;
    case MutationKind::tint:
        mutation_.cause = Cause::refraction;
        m.tint = otherColour(m.tint);
        return true;
    default: break;
    }
    mutation_.cause = Cause::refraction;
    m.index = m.index * (random_.below(2) == 0 ? random_.between(0.7, 0.95) : random_.between(1.05, 1.4));
    return true;
}

bool Mutator::changeBody(MutationKind kind) {
    Scene& scene = mutation_.scene;
    const int number = pick([&](const Body& body) {
        if (kind == MutationKind::exponent) return !isBlack(materialOf(body).specular);
        if (kind == MutationKind::sidesSwapped) return body.back.has_value();
        if (kind == MutationKind::transmission || kind == MutationKind::tint || kind == MutationKind::index)
            return transmits(materialOf(body));
        return true;
    });
    if (number < 0) return false;
    mutation_.body = number;
    mutation_.cause = Cause::body;
    Body& body = scene.bodies[static_cast<std::size_t>(number)];
    switch (kind) {
    case MutationKind::moved:
        // Floors and walls move less than their size.
        move(body.shape, random_.direction() * random_.between(0.1, 0.5) *
                             std::min(sizeOf(scene, body.shape),
                                      0.2 * length(scene.camera.position - scene.camera.focus)));
        return true;
    case MutationKind::resized: resize(body.shape, factor()); return true;
    // Not erased: the other bodies keep their numbers.
    case MutationKind::removed: move(body.shape, Vec3{0, 1e7, 0}); return true;
    default: break;
    }
    // The others of its material stay as they are.
    scene.materials.push_back(materialOf(body));
    body.material.index = static_cast<std::uint32_t>(scene.materials.size() - 1);
    return changeMaterial(kind, body, scene.materials.back());
}

bool Mutator::changeLight(MutationKind kind) {
    Scene& scene = mutation_.scene;
    if (scene.lights.empty()) return false;
    mutation_.light = random_.below(static_cast<int>(scene.lights.size()));
    mutation_.cause = Cause::light;
    Light& light = scene.lights[static_cast<std::size_t>(mutation_.light)];
    if (kind == MutationKind::lightMoved)
        light.position = light.position + random_.direction() * length(light.position - scene.camera.focus) *
                                              random_.between(0.05, 0.4);
    else if (kind == MutationKind::lightColour)
        light.brightness = light.brightness * factors();
    else
        light.brightness = light.brightness * factor();
    return true;
}

bool Mutator::change(MutationKind kind) {
    Scene& scene = mutation_.scene;
    Camera& camera = scene.camera;
    switch (kind) {
    case MutationKind::lightMoved:
    case MutationKind::lightColour:
    case MutationKind::lightBrightness: return changeLight(kind);
    case MutationKind::background:
        mutation_.cause = Cause::background;
        scene.background = otherColour(scene.background);
        return true;
    case MutationKind::aperture: {
        mutation_.cause = Cause::camera;
        const double k = random_.below(2) == 0 ? random_.between(0.85, 0.97) : random_.between(1.03, 1.15);
        camera.horizontalApertureDegrees *= k;
        camera.verticalApertureDegrees *= k;
        return true;
    }
    case MutationKind::cameraMoved:
        mutation_.cause = Cause::camera;
        camera.position = camera.position + random_.direction() * length(camera.position - camera.focus) *
                                                random_.between(0.01, 0.1);
        return true;
    case MutationKind::brightness: {
        mutation_.cause = Cause::brightness;
        const double k = factor();
        for (Light& light : scene.lights) light.brightness = light.brightness * k;
        for (Material& m : scene.materials) m.ambient = m.ambient * k;
        for (Body& body : scene.bodies)
            if (body.back) body.back->ambient = body.back->ambient * k;
        scene.background = scene.background * k;
        return true;
    }
    default: return changeBody(kind);
    }
}

} // namespace

const char* name(MutationKind kind) {
    constexpr const char* names[] = {
        "moved",      "resized",  "removed",       "ambient",      "diffuse",
        "specular",   "exponent", "sides swapped", "reflection",   "transmission",
        "tint",       "index",    "light moved",   "light colour", "light brightness",
        "background", "aperture", "camera moved",  "brightness"};
    static_assert(std::size(names) == mutationKinds);
    return names[static_cast<std::size_t>(kind)];
}

std::optional<Mutation> mutated(const Scene& scene, MutationKind kind, Random& random) {
    return Mutator(scene, random).make(kind);
}

Scene roomScene(unsigned seed) {
    Random random(seed);
    Scene scene;
    scene.resolution = {96, 72};
    scene.camera.position = {random.between(-2, 2), random.between(1.5, 4), 11};
    scene.camera.focus = {0, 0.3, 0};
    scene.camera.horizontalApertureDegrees = 26;
    scene.camera.verticalApertureDegrees = 20;
    scene.background = {random.between(0.05, 0.4), random.between(0.05, 0.4), random.between(0.05, 0.4)};
    scene.maxRecursion = 3;
    scene.lights = {{{random.between(3, 7), random.between(6, 9), random.between(3, 8)}, {0.7, 0.7, 0.7}},
                    {{random.between(-7, -3), random.between(5, 9), random.between(2, 7)}, {0.4, 0.35, 0.3}}};
    const auto part = [&](double high) { return random.between(0, high); };
    const auto material = [&](double reflection, double transmission) {
        return Material{{part(0.1), part(0.1), part(0.1)},
                        {part(0.7), part(0.7), part(0.7)},
                        {part(0.5), part(0.5), part(0.5)},
                        random.between(5, 100),
                        reflection,
                        transmission,
                        transmission > 0 ? random.between(1.1, 1.7) : 0};
    };
    using yarte::test::add;
    add(scene, Polygon{{{-9, -1.2, 8}, {9, -1.2, 8}, {9, -1.2, -9}, {-9, -1.2, -9}}},
        material(random.below(2) * 0.2, 0));
    for (int i = 0; i < 6; ++i) {
        const Vec3 centre{-3.5 + 1.4 * i + part(0.4), random.between(-0.3, 1.6), random.between(-2, 2)};
        const double size = random.between(0.5, 0.9);
        const bool isGlass = random.below(4) == 0, isMirror = random.below(3) == 0;
        const Material m =
            material(isMirror ? random.between(0.2, 0.7) : 0, isGlass ? random.between(0.5, 0.9) : 0);
        switch (random.below(5)) {
        case 0: add(scene, Sphere{centre, size}, m); break;
        case 1:
            add(scene, Box{centre, {size, 1.5 * size, size}}, m).referential = random.referential();
            break;
        case 2: add(scene, Cone{centre, size, 1.5 * size}, m).referential = random.referential(); break;
        case 3: {
            Body& body = add(scene, TruncatedCone{centre, size, 2 * size, size}, m);
            body.referential = random.referential();
            body.back = BackColours{{0, 0, 0.1}, {part(0.7), part(0.7), part(0.7)}, {}};
            break;
        }
        default: {
            Body& body = add(scene, Disc{centre, size}, m);
            body.referential = random.referential();
            body.back = BackColours{{0.1, 0, 0}, {part(0.7), part(0.7), part(0.7)}, {0.2, 0.2, 0.2}};
        }
        }
    }
    return scene;
}

} // namespace yarte::validate::test
