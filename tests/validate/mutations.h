// Mutations: scenes with one thing changed, and what a report should say of the change.
#pragma once

#include "tests/support/scenes.h"
#include "validate/region.h"

#include <optional>
#include <string>

namespace yarte::validate::test {

enum class MutationKind {
    moved,
    resized,
    removed,
    ambient,
    diffuse,
    specular,
    exponent,
    sidesSwapped,
    reflection,
    transmission,
    tint,
    index,
    lightMoved,
    lightColour,
    lightBrightness,
    background,
    aperture,
    cameraMoved,
    brightness,
};
inline constexpr int mutationKinds = 19;

const char* name(MutationKind);

struct Mutation {
    Scene scene;
    MutationKind kind{};
    Cause cause = Cause::unknown; ///< that a report should name
    int body = -1;                ///< and the body, or -1
    int light = -1;
};

/// The scene with one random change of that kind; nothing if it has nothing to change.
std::optional<Mutation> mutated(const Scene&, MutationKind, yarte::test::Random&);

/// A random room: a floor, a few bodies of all kinds and materials, two lights.
Scene roomScene(unsigned seed);

} // namespace yarte::validate::test
