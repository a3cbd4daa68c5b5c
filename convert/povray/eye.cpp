#include "convert/povray/eye.h"

#include "yarte/scene/referential.h"

#include <cmath>
#include <numbers>

namespace yarte::convert::povray {
namespace {

/// The signed solid angle that a triangle fills, seen from the origin
/// [van Oosterom & Strackee, "The solid angle of a plane triangle", 1983].
double solidAngle(Vec3 a, Vec3 b, Vec3 c) {
    const double la = length(a), lb = length(b), lc = length(c);
    return 2 *
           std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(a, c) * lb + dot(b, c) * la);
}

} // namespace

bool wouldHoldEye(const Body& body, Vec3 eye) {
    const Frame axes = body.referential ? resolveReferential(*body.referential) : Frame{};
    if (const auto* disc = std::get_if<Disc>(&body.shape)) return dot(eye - disc->centre, axes.y) < 0;
    if (const auto* cylinder = std::get_if<OpenCylinder>(&body.shape)) {
        const Vec3 p = axes.toLocal(eye - cylinder->centre);
        return p.y >= 0 && p.y <= cylinder->height && std::hypot(p.x, p.z) <= cylinder->radius;
    }
    const auto* cone = std::get_if<TruncatedCone>(&body.shape);
    if (!cone) return false;
    const Vec3 p = axes.toLocal(eye - cone->centre);
    const double radius = cone->radius * (cone->coneHeight - p.y) / cone->coneHeight;
    return p.y >= 0 && p.y <= cone->height && std::hypot(p.x, p.z) <= radius;
}

bool isInside(const MeshData& mesh, const std::vector<Vec3>& placed, Vec3 eye) {
    if (!isClosed(mesh)) return false;
    double angle = 0; // of the whole sphere from inside, 0 from outside
    for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto face = mesh.face(f);
        for (std::size_t i = 1; i + 1 < face.size();
             ++i) // a concave face's fan: the signs take back what is too much
            angle += solidAngle(placed[face[0]] - eye, placed[face[i]] - eye, placed[face[i + 1]] - eye);
    }
    return std::abs(angle) > 2 * std::numbers::pi;
}

} // namespace yarte::convert::povray
