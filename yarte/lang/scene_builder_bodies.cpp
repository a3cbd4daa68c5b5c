// The part of SceneBuilder that adds lights, materials and bodies.
#include "yarte/lang/argument_reader.h"
#include "yarte/lang/scene_builder.h"

#include <fmt/format.h>

namespace yarte {
namespace {

Polygon polygon(ArgumentReader read) {
    Polygon result;
    result.vertices.resize(static_cast<std::size_t>(read.number()));
    for (Vec3& vertex : result.vertices) vertex = read.vec3();
    return result;
}

} // namespace

void SceneBuilder::addLight(const Statement& s) {
    Light light{{}, {}, s.whole};
    if (s.good) {
        ArgumentReader read(s);
        light.position = read.vec3();
        if (s.arguments.size() == 4) {
            const double brightness = read.number();
            light.brightness = {brightness, brightness, brightness};
        } else
            light.brightness = read.colour();
        report(check(light), s);
    }
    scene_.lights.push_back(light);
}

void SceneBuilder::addMaterial(const Statement& s) {
    Material material;
    if (s.good) {
        ArgumentReader read(s);
        material = {read.colour(), read.colour(), read.colour(), read.number(),
                    read.number(), read.number(), read.number()};
        report(check(material), s);
    }
    scene_.materials.push_back(material);
    tint_ = std::nullopt;
    isMaterialUsed_ = unknownTint_ = false;
}

void SceneBuilder::addTint(const Statement& s) {
    if (unknownTint_) return;
    if (isMaterialUsed_) {
        Diagnostic& error =
            diagnostics_.error("scene.no-preceding-material",
                               "tint must follow its material, before the first object", s.keyword);
        if (!scene_.bodies.empty())
            error.notes.push_back({"this object has the material already", scene_.bodies.back().span});
        return;
    }
    if (tint_) {
        diagnostics_
            .error("scene.duplicate-directive", "tint must be given only once for a material", s.whole)
            .notes.push_back({"first given here", *tint_});
        return;
    }
    tint_ = s.whole;
    if (s.good) report(checkTint(scene_.materials.back().tint = ArgumentReader(s).colour()), s);
}

Shape SceneBuilder::shapeOf(const Statement& s) {
    ArgumentReader read(s);
    switch (s.directive->keyword) {
    case Keyword::sphere: return s.good ? Sphere{read.vec3(), read.number()} : Sphere{};
    case Keyword::box: return s.good ? Box{read.vec3(), read.vec3()} : Box{};
    case Keyword::cone: return s.good ? Cone{read.vec3(), read.number(), read.number()} : Cone{};
    case Keyword::truncatedCone:
        return s.good ? TruncatedCone{read.vec3(), read.number(), read.number(), read.number()}
                      : TruncatedCone{};
    case Keyword::disc: return s.good ? Disc{read.vec3(), read.number()} : Disc{};
    case Keyword::polygon: return s.good ? polygon(read) : Polygon{};
    case Keyword::cylinder: return s.good ? Cylinder{read.vec3(), read.number(), read.number()} : Cylinder{};
    case Keyword::openCylinder:
        return s.good ? OpenCylinder{read.vec3(), read.number(), read.number()} : OpenCylinder{};
    case Keyword::frustum:
        return s.good ? Frustum{read.vec3(), read.number(), read.number(), read.number()} : Frustum{};
    case Keyword::plane: return s.good ? Plane{read.vec3(), read.number()} : Plane{};
    default: break;
    }
    if (!s.good) return Mesh{};
    const MeshId id = meshes_.find(s.fileName, s.fileNameSpan, scene_.meshes).value_or(MeshId{});
    return Mesh{id, read.number(), {read.vec3(), read.vec3(), read.vec3()}, read.vec3()};
}

void SceneBuilder::addBody(const Statement& s) {
    if (scene_.materials.empty() && !unknownMaterial_) {
        diagnostics_.error("scene.no-material", "a material must come before the first object", s.keyword);
        unknownMaterial_ = true;
    }
    const std::size_t last = scene_.materials.empty() ? 0 : scene_.materials.size() - 1;
    scene_.bodies.push_back({shapeOf(s), {static_cast<std::uint32_t>(last)}, {}, {}, s.whole});
    if (s.good) report(check(scene_.bodies.back().shape), s);
    back_ = referential_ = std::nullopt;
    isMaterialUsed_ = true;
    unknownBody_ = unknownTint_ = false;
}

Body* SceneBuilder::bodyFor(const Statement& s, bool (*takes)(const Shape&), std::optional<Span>& place) {
    if (unknownBody_) return nullptr;
    if (scene_.bodies.empty()) {
        diagnostics_.error("scene.no-preceding-object",
                           fmt::format("{} must follow the object it belongs to", s.directive->name),
                           s.keyword);
        return nullptr;
    }
    Body& body = scene_.bodies.back();
    if (!takes(body.shape)) {
        diagnostics_
            .error("scene.not-applicable", fmt::format("the object before takes no {}", s.directive->name),
                   s.keyword)
            .notes.push_back({"this is the object", body.span});
        return nullptr;
    }
    if (place) {
        diagnostics_
            .error("scene.duplicate-directive",
                   fmt::format("{} must be given only once for an object", s.directive->name), s.whole)
            .notes.push_back({"first given here", *place});
        return nullptr;
    }
    place = s.whole;
    return s.good ? &body : nullptr;
}

void SceneBuilder::addBackColours(const Statement& s) {
    Body* body = bodyFor(s, takesBackColours, back_);
    if (body == nullptr) return;
    ArgumentReader read(s);
    body->back = BackColours{read.colour(), read.colour(), read.colour()};
    report(check(*body->back), s);
}

void SceneBuilder::addReferential(const Statement& s) {
    Body* body = bodyFor(s, takesReferential, referential_);
    if (body == nullptr) return;
    ArgumentReader read(s);
    body->referential = Referential{read.vec3(), read.vec3(), {}};
    if (s.arguments.size() == 9) body->referential->z = read.vec3();
    report(check(*body->referential), s);
}

} // namespace yarte
