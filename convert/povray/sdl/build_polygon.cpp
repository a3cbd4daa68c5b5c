#include "convert/povray/sdl/build_polygon.h"

#include "convert/povray/sdl/stretch.h"
#include "yarte/scene/planarity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace yarte::convert::povray::sdl {
namespace {

/// POV-Ray does not show a polygon with a vertex farther than this from its plane, in the polygon's own
/// units.
constexpr double planeTolerance = 1e-10;

/// Without neighbours alike, the last and the first included.
std::vector<Vec3> distinct(std::vector<Vec3> contour) {
    contour.erase(std::unique(contour.begin(), contour.end()), contour.end());
    while (contour.size() > 1 && contour.front() == contour.back()) contour.pop_back();
    return contour;
}

/// One outline with the same inside: from the first contour's first vertex to every other contour and back.
/// The way there and back counts twice, that is not at all.
std::vector<Vec3> joined(const std::vector<std::vector<Vec3>>& contours) {
    std::vector<Vec3> outline;
    for (const std::vector<Vec3>& written : contours) {
        const std::vector<Vec3> contour = distinct(written);
        if (contour.size() < 3) continue;
        if (outline.empty()) {
            outline = contour;
            continue;
        }
        outline.push_back(outline.front());
        outline.insert(outline.end(), contour.begin(), contour.end());
        outline.push_back(contour.front());
    }
    return distinct(outline);
}

/// POV-Ray's front: of the first three vertices that are not in line, by the right-hand rule.
Vec3 frontOf(const std::vector<Vec3>& outline) {
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
        const Vec3 u = outline[i] - outline[0], v = outline[i + 1] - outline[0], n = cross(u, v);
        if (lengthOf(n) > 1e-10 * lengthOf(u) * lengthOf(v)) return unit(n);
    }
    return {};
}

Vec3 newell(const std::vector<Vec3>& outline) {
    Vec3 normal;
    for (std::size_t i = 1; i + 1 < outline.size(); ++i)
        normal += cross(outline[i] - outline[0], outline[i + 1] - outline[0]);
    return normal;
}

} // namespace

Built build(const PolygonShape& shape, const Affine& a) {
    const auto nothing = [](std::string why) { return Built{std::monostate(), {}, 0, std::move(why)}; };
    std::vector<Vec3> outline = joined(shape.contours);
    const Vec3 front = frontOf(outline);
    if (outline.size() < 3 || front == Vec3{}) return nothing("it has no area");
    double off = 0, size = 0;
    for (const Vec3 v : outline) {
        off = std::max(off, std::abs(dot(v - outline[0], front)));
        size = std::max(size, lengthOf(v - outline[0]));
    }
    // Rounding of the coordinates themselves is allowed for.
    if (off > planeTolerance + 1e-15 * size)
        return nothing(fmt::format("not plane (by {:.3g}): POV-Ray does not show it either", off));
    for (Vec3& v : outline) v = mapPoint(a, v);
    if (dot(newell(outline), mapNormal(a, front)) < 0) std::reverse(outline.begin() + 1, outline.end());
    if (!planarity(outline)) return nothing("it has no area");
    return {Shape(Polygon{std::move(outline)}), {}, 0, {}};
}

} // namespace yarte::convert::povray::sdl
