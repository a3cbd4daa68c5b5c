// Models made in a line, and what is built of them.
#pragma once

#include "convert/povray/sdl/build_scene.h"

#include <random>

namespace yarte::convert::povray::sdl::test {

inline Texture plain(Rgbft colour, double ambient = 0.1, double diffuse = 0.6) {
    Texture texture;
    texture.pigment.colour = colour;
    texture.finish.ambient = {ambient, ambient, ambient};
    texture.finish.diffuse = diffuse;
    return texture;
}

inline Object object(ObjectShape shape, Affine transform = {}) {
    Object result;
    result.shape = std::move(shape);
    result.transform = transform;
    return result;
}

inline ObjectPtr shared(Object o) { return std::make_shared<const Object>(std::move(o)); }

/// Right-handed, so that nothing is mirrored.
inline CameraModel camera() {
    CameraModel result;
    result.location = {0, 0, 10};
    result.direction = {0, 0, -1};
    return result;
}

inline Model model(std::vector<Object> objects) {
    Model result;
    result.camera = camera();
    result.languageVersion = 3.7;
    for (Object& o : objects) result.objects.push_back(shared(std::move(o)));
    return result;
}

struct BuiltScene {
    Sources sources;
    Diagnostics diagnostics;
    Ledger ledger;
    std::optional<Scene> scene;

    explicit BuiltScene(const Model& m, const BuildOptions& options = {}) {
        scene = buildScene(m, options, sources, diagnostics, ledger);
    }
    /// The lossy rows as "where: property: action", one a line.
    std::string losses() const {
        std::string text;
        for (const LedgerRow& row : ledger.rows())
            if (isLoss(row.action))
                text += row.where + ": " + row.property + ": " + std::string(name(row.action)) + "\n";
        return text;
    }
    template <class S>
    const S& shape(std::size_t body = 0) const {
        return std::get<S>(scene->bodies.at(body).shape);
    }
};

class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double between(double low, double high) { return std::uniform_real_distribution(low, high)(engine_); }
    Vec3 inCube(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
    /// Moves, turns and scales evenly.
    Affine similarity() {
        const double s = between(0.1, 5);
        return then(then(rotation(inCube(180)), scaling({s, s, s})), translation(inCube(9)));
    }
    /// Shears and mirrors as well.
    Affine affine() {
        for (;;) {
            const Affine a{inCube(2), inCube(2), inCube(2), inCube(9)};
            if (std::abs(determinant(a)) > 0.2) return a;
        }
    }

private:
    std::mt19937_64 engine_;
};

} // namespace yarte::convert::povray::sdl::test
