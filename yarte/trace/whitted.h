// Whitted's recursion: what a camera ray sees, reflections and refractions included.
#pragma once

#include "yarte/trace/media.h"
#include "yarte/trace/phong.h"

#include <vector>

namespace yarte::trace {

/// I = local + cr I(reflected) + ct tint I(transmitted) [Whitted80, eq. 2, with SCENE-LANGUAGE's rules],
/// summed without recursion: the rays of one generation after the other, each weighted by the product of the
/// coefficients on its way. All reflected rays of a generation come before all transmitted ones. Keeps its
/// queues between calls.
class Whitted {
public:
    explicit Whitted(const World& world) : world_(world) {}

    Colour colour(const Ray& cameraRay, RayCounts& counts);

private:
    struct Pending {
        Ray ray;
        Colour weight{1, 1, 1};
        int levelsLeft = 0;
        MediaStack media;
    };

    /// The ray's own share of the pixel; what it gives rise to goes to the queues.
    Colour trace(const Pending&, RayCounts& counts);
    void transmit(const Pending&, const SurfacePoint&, Vec3 mirrorDirection, RayCounts& counts);

    const World& world_;
    std::vector<Pending> current_, reflected_, transmitted_;
};

} // namespace yarte::trace
