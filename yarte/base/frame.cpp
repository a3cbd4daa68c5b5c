#include "yarte/base/frame.h"

namespace yarte {
namespace {

double largest(Twofold3 v) {
    const Vec3 r = v.rounded();
    return std::max({std::abs(r.x), std::abs(r.y), std::abs(r.z)});
}

} // namespace

Frame closestRotation(Twofold3 x, Twofold3 y, Twofold3 z) {
    // Converges quadratically: axes 1e-3 off come near in two steps; eight cover any input.
    for (int step = 0; step < 8; ++step) {
        const Twofold3 yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
        const Twofold scale = Twofold(1) / dot(x, yz);
        const Twofold3 nextX = (x + yz * scale) * 0.5, nextY = (y + zx * scale) * 0.5,
                       nextZ = (z + xy * scale) * 0.5;
        const double change = std::max({largest(nextX - x), largest(nextY - y), largest(nextZ - z)});
        x = nextX, y = nextY, z = nextZ;
        if (change < 0x1p-40) break; // the next change would be its square
    }
    return {x.rounded(), y.rounded(), z.rounded()};
}

} // namespace yarte
