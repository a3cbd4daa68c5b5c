#include "convert/gltf/exact.h"

#include "convert/gltf/exact_store.h"
#include "convert/gltf/exact_text.h"
#include "convert/gltf/write_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace yarte::convert::gltf {
namespace {

/// Two roundings to float32, which is what a chain of tools leaves of a position; relative to the farthest
/// coordinate.
constexpr double positionTolerance = 0x1p-22;
/// Of directions, lengths of axes, and factors: float32 quaternions, products of matrices and units of other
/// tools (degrees, watts) stay below, and nobody sees it.
constexpr double tolerance = 1e-5;
/// Of factors near 0.
constexpr double smallest = 1e-6;

bool isNear(double a, double b) {
    return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b)) + smallest;
}

double largest(Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// An element's "yarte" object, if it is of the kind asked for.
class Record {
public:
    Record(const Json* extras, const char* kind) {
        const Json* found = extras ? extras->find("yarte") : nullptr;
        const Json* index = found ? found->find(kind) : nullptr;
        if (index == nullptr || index->number() == nullptr) return;
        json_ = found;
        found->markAll(Fate::inExtras);
        order_ = wholeNumber(kind);
    }

    bool exists() const { return json_ != nullptr; }
    std::optional<std::size_t> order() const { return order_; }
    const Json* find(const char* name) const { return json_->find(name); }

    std::string text(const char* name) const {
        const Json* value = find(name);
        return value && value->text() ? *value->text() : "";
    }
    double number(const char* name) const {
        const Json* value = find(name);
        return value && value->number() ? *value->number() : std::nan("");
    }
    std::optional<std::size_t> wholeNumber(const char* name) const {
        const double value = number(name);
        constexpr double most = 1e9; // far more than there can be
        if (!(value >= 0 && value <= most) || value != std::floor(value)) return std::nullopt;
        return static_cast<std::size_t>(value);
    }
    /// Not a number where there is none.
    Vec3 vector(const char* name, std::size_t first = 0) const {
        const Json* value = find(name);
        const auto items = value ? value->items() : std::span<const Json>();
        const auto at = [&](std::size_t i) {
            return first + i < items.size() && items[first + i].number() ? *items[first + i].number()
                                                                         : std::nan("");
        };
        return {at(0), at(1), at(2)};
    }
    Transform transform(const char* name) const {
        return {vector(name, 0), vector(name, 3), vector(name, 6), vector(name, 9)};
    }

private:
    const Json* json_ = nullptr;
    std::optional<std::size_t> order_;
};

/// The part of reading that all kinds share: `compare` tells what has changed, if anything, and `take` the
/// value from what the lines say.
template <class T, class Compare, class Take>
Exact<T> readRecord(const Record& record, const Compare& compare, const Take& take) {
    if (!record.exists()) return {};
    Exact<T> result{Stored::unreadable, {}, record.order(), {}};
    std::optional<Scene> scene = sceneOf(record.text("text"), result.why);
    if (!scene || !take(*scene, result.value)) {
        if (result.why.empty()) result.why = "not what this element can hold";
        return result;
    }
    result.why = compare(result.value);
    result.state = result.why.empty() ? Stored::valid : Stored::changed;
    return result;
}

/// Negated comparisons: what is not a number is never near.
bool isMoved(Vec3 now, Vec3 then, double slack) {
    return !(largest(now - then) <= positionTolerance * std::max(largest(now), largest(then)) + slack);
}

bool isTurned(const Transform& now, const Transform& then) {
    const double size = std::max({length(then.x), length(then.y), length(then.z)});
    return !(std::max({largest(now.x - then.x), largest(now.y - then.y), largest(now.z - then.z)}) <=
             tolerance * size);
}

Vec3 direction(Vec3 v) { return v == Vec3{} ? v : normalised(v); }

} // namespace

Exact<Body> exactBody(const Json* extras, const Transform& world, const GeometryPrint& print) {
    const Record record(extras, "body");
    const auto change = [&](const Body&) -> std::string {
        if (record.text("geometry") != print.text()) return "its mesh was changed";
        const Transform then = record.transform("world");
        if (isTurned(world, then)) return "it was turned or scaled";
        const double size = std::max({length(then.x), length(then.y), length(then.z)}) * print.reach();
        if (isMoved(world.translation, then.translation, tolerance * size)) return "it was moved";
        return {};
    };
    return readRecord<Body>(record, change, [&](Scene& scene, Body& body) {
        if (scene.bodies.size() != 1) return false;
        body = std::move(scene.bodies[0]);
        body.span = {};
        auto* mesh = std::get_if<yarte::Mesh>(&body.shape);
        const auto index = record.wholeNumber("mesh");
        if (mesh && index) mesh->mesh.index = static_cast<std::uint32_t>(*index);
        return !mesh || index.has_value();
    });
}

Exact<Light> exactLight(const Json* extras, Vec3 position, const std::optional<ShownLight>& shown) {
    const Record record(extras, "light");
    const auto change = [&](const Light&) -> std::string {
        if (isMoved(position, record.vector("position"), 0)) return "it was moved";
        if (!shown) return {};
        const Vec3 colour = record.vector("colour");
        if (!isNear(shown->colour.r, colour.x) || !isNear(shown->colour.g, colour.y) ||
            !isNear(shown->colour.b, colour.z))
            return "its colour was changed";
        const double intensity = record.number("intensity");
        if (!(std::abs(shown->intensity - intensity) <= tolerance * intensity))
            return "its intensity was changed";
        return {};
    };
    return readRecord<Light>(record, change, [](Scene& scene, Light& light) {
        if (scene.lights.size() != 1) return false;
        light = scene.lights[0];
        light.span = {};
        return true;
    });
}

Exact<Camera> exactCamera(const Json* extras, const Transform& world, double yfov,
                          std::optional<double> aspectRatio) {
    const Record record(extras, "camera");
    const auto change = [&](const Camera& camera) -> std::string {
        const Transform then = record.transform("world");
        if (isMoved(world.translation, then.translation, tolerance * length(camera.focus - camera.position)))
            return "it was moved";
        // A camera is not scaled by its node.
        const Transform now{direction(world.x), direction(world.y), direction(world.z), {}};
        if (isTurned(now, {then.x, then.y, then.z, {}})) return "it was turned";
        if (!isNear(yfov, record.number("yfov")) ||
            !isNear(aspectRatio.value_or(0), record.number("aspectRatio")))
            return "its field of view was changed";
        return {};
    };
    return readRecord<Camera>(record, change, [](const Scene& scene, Camera& camera) {
        camera = scene.camera;
        return true;
    });
}

Exact<Material> exactMaterial(const Json* extras, const PbrMaterial& shown, const MaterialExtensions& used) {
    const Record record(extras, "material");
    const auto isCompared = [&](const std::string& name) {
        return (name != "ior" || used.ior) && (name != "thickness" || used.volume) &&
               (!name.starts_with("specular") || used.specular);
    };
    const auto isSame = [](const Json& now, const Json* then) {
        if (now.number()) return then && then->number() && isNear(*now.number(), *then->number());
        return then && std::ranges::equal(now.items(), then->items(), [](const Json& a, const Json& b) {
                   return a.number() && b.number() && isNear(*a.number(), *b.number());
               });
    };
    const auto change = [&](const Material&) -> std::string {
        const Json* then = record.find("shown");
        for (const auto& [name, now] : shownValues(shown))
            if (isCompared(name) && !isSame(now, then ? then->find(name) : nullptr))
                return fmt::format("its {} was changed", name);
        return {};
    };
    return readRecord<Material>(record, change, [](const Scene& scene, Material& material) {
        if (scene.materials.size() != 1) return false;
        material = scene.materials[0];
        return true;
    });
}

} // namespace yarte::convert::gltf
