#include "convert/gltf/read_camera.h"

#include "convert/gltf/exact.h"
#include "yarte/scene/check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace yarte::convert::gltf {
namespace {

constexpr int longerSide = 640;            ///< pixels
constexpr double commonAspect = 4.0 / 3.0; ///< where the file leaves it to the window

Resolution resolutionOf(double aspect) {
    const auto shorter = [](double ratio) {
        return std::max(1, static_cast<int>(std::lround(longerSide * ratio)));
    };
    return aspect >= 1 ? Resolution{longerSide, shorter(1 / aspect)}
                       : Resolution{shorter(aspect), longerSide};
}

double degrees(double tangent) { return std::atan(tangent) * 180 / std::numbers::pi; }

class CameraReader {
public:
    CameraReader(Asset& asset, const Extent& extent, Ledger& ledger)
        : asset_(asset), extent_(extent), ledger_(ledger),
          definitions_(Object(asset.root(), asset.errors()).objects("cameras")) {}

    std::optional<ReadCamera> read() {
        const auto node = choose();
        if (!node) return std::nullopt;
        const Object& definition = definitionOf(*node);
        definition.text("type");
        const auto perspective = definition.object("perspective");
        auto camera =
            perspective ? readPerspective(*perspective, *node) : readOrthographic(definition, *node);
        if (!camera) return std::nullopt;
        Problems problems = check(camera->camera);
        for (Problem& problem :
             checkApertures(camera->camera.horizontalApertureDegrees, camera->camera.verticalApertureDegrees))
            problems.push_back(std::move(problem));
        for (const Problem& problem : problems)
            asset_.errors().report(problem.code, problem.message, definition.json());
        return camera;
    }

private:
    const Object& definitionOf(std::uint32_t node) const {
        return definitions_[*asset_.document().nodes[node].camera];
    }

    /// A camera need not be visible to be looked through.
    std::optional<std::uint32_t> choose() {
        std::optional<std::uint32_t> first;
        std::size_t others = 0;
        const Document& document = asset_.document();
        for (const std::uint32_t node : asset_.hierarchy().inScene()) {
            if (!document.nodes[node].camera) continue;
            const bool isBetter = !first || (!definitionOf(*first).json().find("perspective") &&
                                             definitionOf(node).json().find("perspective"));
            others += first.has_value();
            if (isBetter) first = node;
        }
        if (others > 0)
            ledger_.add({"cameras",
                         "further cameras",
                         Action::dropped,
                         fmt::format("{} besides that of /nodes/{}", others, *first),
                         {}});
        return first;
    }

    /// Along the node's -z, +y up, whatever its scale.
    Camera placed(const Transform& world, double distance) const {
        Camera camera;
        camera.position = world.translation;
        camera.focus =
            world.translation - (world.z == Vec3{} ? Vec3{0, 0, 1} : normalised(world.z)) * distance;
        camera.up = world.y == Vec3{} ? Vec3{0, 1, 0} : normalised(world.y);
        return camera;
    }

    /// To the plane through the scene's centre; the radius if that lies behind.
    double distanceToCentre(const Transform& world) const {
        const Vec3 back = world.z == Vec3{} ? Vec3{0, 0, 1} : normalised(world.z);
        const double distance = dot(world.translation - extent_.centre(), back);
        return distance > 0 ? distance : extent_.radius();
    }

    std::optional<ReadCamera> readPerspective(const Object& perspective, std::uint32_t id) {
        const Transform& world = asset_.hierarchy().world(id);
        perspective.require("yfov");
        const double yfov = perspective.number("yfov", 1, notNegative);
        std::optional<double> aspect;
        if (perspective.has("aspectRatio")) aspect = perspective.number("aspectRatio", 1, notNegative);
        if (aspect == 0.0 || !(yfov > 0 && yfov < std::numbers::pi)) {
            perspective.error("gltf.out-of-range", "yfov must be between 0 and pi, aspectRatio positive");
            return std::nullopt;
        }
        const Resolution resolution = resolutionOf(aspect.value_or(commonAspect));
        const Json* extras = asset_.document().nodes[id].json->find("extras");
        const Exact<Camera> exact = exactCamera(extras, world, yfov, aspect);
        if (exact.state == Stored::valid) return ReadCamera{exact.value, resolution};
        const std::string where = fmt::format("/nodes/{}", id);
        if (!exact.why.empty())
            ledger_.add({where, "exact camera in extras", Action::dropped, exact.why, {}});
        if (!aspect)
            ledger_.add({"camera", "aspect", Action::added, "4:3, the file leaves it to the window", {}});

        Camera camera = placed(world, distanceToCentre(world));
        const double tangent = std::tan(yfov / 2);
        camera.verticalApertureDegrees = yfov / 2 * 180 / std::numbers::pi;
        camera.horizontalApertureDegrees = degrees(tangent * aspect.value_or(commonAspect));
        return ReadCamera{camera, resolution};
    }

    std::optional<ReadCamera> readOrthographic(const Object& definition, std::uint32_t id) {
        const auto orthographic = definition.object("orthographic");
        if (!orthographic) {
            definition.error("gltf.missing", "a camera must be perspective or orthographic");
            return std::nullopt;
        }
        const double width = std::abs(orthographic->number("xmag", 0)),
                     height = std::abs(orthographic->number("ymag", 0));
        if (!(width > 0 && height > 0)) {
            orthographic->error("gltf.out-of-range", "xmag and ymag must not be 0");
            return std::nullopt;
        }
        const Transform& world = asset_.hierarchy().world(id);
        const double distance = distanceToCentre(world);
        Camera camera = placed(world, distance);
        camera.horizontalApertureDegrees = degrees(width / distance);
        camera.verticalApertureDegrees = degrees(height / distance);
        definition.json().change(Fate::read, Fate::approximated);
        return ReadCamera{camera, resolutionOf(width / height)};
    }

    Asset& asset_;
    const Extent& extent_;
    Ledger& ledger_;
    std::vector<Object> definitions_;
};

} // namespace

std::optional<ReadCamera> readCamera(Asset& asset, const Extent& extent, Ledger& ledger) {
    return CameraReader(asset, extent, ledger).read();
}

} // namespace yarte::convert::gltf
