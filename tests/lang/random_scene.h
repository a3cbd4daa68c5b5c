// Random good scenes, in everything that a text can say.
#pragma once

#include "tests/support/scenes.h"

#include <cmath>

namespace yarte::test {

class SceneMaker {
public:
    explicit SceneMaker(unsigned seed) : random_(seed) {}

    Scene make() {
        Scene scene;
        scene.resolution = {1 + random_.below(5000), 1 + random_.below(5000)};
        scene.camera = {random_.inCube(9), random_.inCube(9), random_.direction(), random_.between(1, 89),
                        random_.between(1, 89)};
        scene.background = colour();
        scene.maxRecursion = random_.below(256);
        scene.gamma = positive();
        for (int i = random_.below(4); i > 0; --i) scene.lights.push_back({vector(), colour()});
        for (int i = random_.below(3); i > 0; --i) scene.lights.push_back({vector(), grey()});
        for (int i = 1 + random_.below(5); i > 0; --i) {
            scene.materials.push_back(material());
            for (int j = random_.below(4); j > 0; --j) scene.bodies.push_back(body(scene));
        }
        return scene;
    }

private:
    bool maybe() { return random_.below(2) == 0; }
    /// Any sign and size, -0 among them.
    double number() {
        return maybe() ? random_.between(-9, 9) * std::pow(10, random_.below(61) - 30) : small();
    }
    double small() { return maybe() ? -0.0 : random_.below(19) - 9; }
    double positive() { return random_.between(0.1, 9) * std::pow(10, random_.below(21) - 10); }
    double notNegative() { return maybe() ? positive() : maybe() ? 0.0 : -0.0; }
    Vec3 vector() { return {number(), number(), random_.between(1, 2)}; }
    Colour colour() { return {notNegative(), notNegative(), notNegative()}; }
    Colour grey() {
        const double b = notNegative();
        return {b, b, b};
    }
    Material material() {
        const double transmission = notNegative();
        return {colour(),
                colour(),
                colour(),
                notNegative(),
                notNegative(),
                transmission,
                transmission > 0 ? positive() : number(),
                maybe() ? colour() : Colour{1, 1, 1}};
    }
    Referential axes(bool withZ) {
        Referential axes = random_.referential();
        if (withZ) axes.z = maybe() ? Vec3{} : cross(axes.x, axes.y);
        return axes;
    }
    Polygon polygon() { // on a circle
        const Referential plane = random_.referential();
        const Vec3 centre = random_.inCube(9);
        Polygon result;
        const int count = 3 + random_.below(6);
        for (int i = 0; i < count; ++i)
            result.vertices.push_back(centre + plane.x * std::cos(i * 6.28 / count) +
                                      plane.y * std::sin(i * 6.28 / count));
        return result;
    }
    Shape shape() {
        switch (random_.below(10)) {
        case 0: return Sphere{vector(), positive()};
        case 1: return Box{vector(), {positive(), positive(), positive()}};
        case 2: return Cone{vector(), positive(), positive()};
        case 3: {
            const double height = positive();
            return TruncatedCone{vector(), positive(), height, height * random_.between(0.1, 1)};
        }
        case 4: return Disc{vector(), positive()};
        case 5: return Cylinder{vector(), positive(), positive()};
        case 6: return OpenCylinder{vector(), positive(), positive()};
        case 7: return Frustum{vector(), positive(), positive(), positive()};
        case 8: return Plane{vector(), number()};
        default: return polygon();
        }
    }
    Body body(const Scene& scene) {
        Body body{shape(), {static_cast<std::uint32_t>(scene.materials.size() - 1)}, {}, {}, {}};
        if (takesBackColours(body.shape) && maybe()) body.back = BackColours{colour(), colour(), colour()};
        if (takesReferential(body.shape) && maybe()) body.referential = axes(maybe());
        return body;
    }

    Random random_;
};

} // namespace yarte::test
