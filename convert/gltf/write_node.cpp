#include "convert/gltf/write_node.h"

#include <array>
#include <cmath>

namespace yarte::convert::gltf {
namespace {

/// The unit quaternion x y z w of a rotation, from its largest component, which no rounding can spoil
/// [Shepperd78].
std::array<double, 4> quaternionOf(const Frame& f) {
    const double xx = f.x.x, yy = f.y.y, zz = f.z.z;
    std::array<double, 4> q{};
    if (xx + yy + zz > 0)
        q = {f.y.z - f.z.y, f.z.x - f.x.z, f.x.y - f.y.x, 1 + xx + yy + zz};
    else if (xx >= yy && xx >= zz)
        q = {1 + xx - yy - zz, f.x.y + f.y.x, f.z.x + f.x.z, f.y.z - f.z.y};
    else if (yy >= zz)
        q = {f.x.y + f.y.x, 1 - xx + yy - zz, f.y.z + f.z.y, f.z.x - f.x.z};
    else
        q = {f.z.x + f.x.z, f.y.z + f.z.y, 1 - xx - yy + zz, f.x.y - f.y.x};
    double size = 0;
    for (const double c : q) size += c * c;
    for (double& c : q) c /= std::sqrt(size);
    return q;
}

} // namespace

void setTransform(Json& node, const Frame& axes, double scale, Vec3 translation) {
    set(node, "translation", json(translation));
    if (axes != Frame{}) set(node, "rotation", json(std::span<const double>(quaternionOf(axes))));
    if (scale != 1) set(node, "scale", json({scale, scale, scale}));
}

} // namespace yarte::convert::gltf
