// Whitted's sum over generations, a block of pixels at a time; see yarte/trace/whitted.h, whose order of
// additions this keeps for every pixel.
#if defined(YARTE_TRACE_LANES_WHITTED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_WHITTED_INL_H
#undef YARTE_TRACE_LANES_WHITTED_INL_H
#else
#define YARTE_TRACE_LANES_WHITTED_INL_H
#endif

#include "yarte/trace/lanes/ray_queue.h"
#include "yarte/trace/lanes/shading-inl.h"
#include "yarte/trace/whitted.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE {

class WhittedLanes {
public:
    WhittedLanes(const World& world, RayCounts& counts) : world_(world), counts_(counts) {}

    void render(Tile tile, Colour* pixels, std::size_t stride) {
        // Small enough for the queues of deep recursions to stay in the cache.
        constexpr int side = 16;
        for (int y = tile.y0; y < tile.y1; y += side)
            for (int x = tile.x0; x < tile.x1; x += side) {
                const Tile block{x, y, std::min(x + side, tile.x1), std::min(y + side, tile.y1)};
                renderBlock(block, pixels + static_cast<std::size_t>(y - tile.y0) * stride + (x - tile.x0),
                            stride);
            }
    }

private:
    void renderBlock(Tile block, Colour* pixels, std::size_t stride) {
        media_.assign(1, world_.cameraMedia);
        sums_.assign(static_cast<std::size_t>(block.width()) * static_cast<std::size_t>(block.height()),
                     Colour{});
        pushCameraRays(block);
        while (current_.size() > 0) {
            for (std::size_t first = 0; first < current_.size(); first += lanes) tracePacket(first);
            std::swap(current_, reflected_);
            current_.append(transmitted_);
            reflected_.clear(), transmitted_.clear();
        }
        for (int y = 0; y < block.height(); ++y)
            for (int x = 0; x < block.width(); ++x)
                pixels[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x)] =
                    sums_[static_cast<std::size_t>(y * block.width() + x)];
    }

    /// In small squares, so that the rays of a packet stay close together.
    void pushCameraRays(Tile block) {
        constexpr int square = 4;
        current_.clear();
        for (int y0 = block.y0; y0 < block.y1; y0 += square)
            for (int x0 = block.x0; x0 < block.x1; x0 += square)
                for (int y = y0; y < std::min(y0 + square, block.y1); ++y)
                    for (int x = x0; x < std::min(x0 + square, block.x1); ++x) {
                        const auto [o, d, from] = world_.camera.through(x, y);
                        const int pixel = (y - block.y0) * block.width() + (x - block.x0);
                        current_.push({o.x, o.y, o.z, d.x, d.y, d.z, noElement, 0, 1},
                                      static_cast<std::uint32_t>(pixel), world_.levels, 0);
                    }
        counts_.camera += current_.size();
    }

    /// Loads a packet; lanes beyond the queue's end repeat its last ray. Returns the number of real ones.
    std::size_t loadPacket(std::size_t first, RayPacket& rays) const {
        const std::size_t count = std::min(lanes, current_.size() - first);
        double* const to[] = {rays.ox, rays.oy, rays.oz, rays.dx, rays.dy, rays.dz, rays.from, rays.inside};
        for (std::size_t c = 0; c < std::size(to); ++c) {
            const double* from = current_.components[c].data() + first;
            for (std::size_t i = 0; i < lanes; ++i) to[c][i] = from[std::min(i, count - 1)];
        }
        return count;
    }

    void tracePacket(std::size_t first) {
        RayPacket rays, mirrors;
        HitPacket hits;
        PointPacket points{};
        ColourPacket colours;
        const std::size_t count = loadPacket(first, rays);
        nearestHits(world_, rays, hits);
        for (std::size_t i = count; i < lanes; ++i)
            hits.element[i] = noElement; // repeated lanes must not count
        describeHits(world_, rays, hits, points);
        for (std::size_t at = 0; at < lanes; at += half) {
            const V3 d = rays.direction(at), n = points.normal(at);
            mirrors.setDirection(at, normalised(d - n * (set(2) * dot(d, n))));
        }
        localColours(world_, hits, points, mirrors, colours, counts_.shadow);
        for (std::size_t i = 0; i < count; ++i) {
            const bool isHit = hits.element[i] != noElement;
            const Colour colour =
                isHit ? Colour{colours.r[i], colours.g[i], colours.b[i]} : world_.background;
            sums_[current_.pixels[first + i]] += current_.at(RayQueue::weight, first + i) * colour;
            if (isHit && current_.levelsLeft[first + i] > 0)
                pushSecondaries(first + i, i, rays, hits, points, mirrors);
        }
    }

    void pushSecondaries(std::size_t index, std::size_t lane, const RayPacket& rays, const HitPacket& hits,
                         const PointPacket& points, const RayPacket& mirrors) {
        const double weight = current_.at(RayQueue::weight, index);
        const double viewerInside = hits.entering[lane] != 0 ? 0 : 1;
        if (points.reflection[lane] > 0) {
            ++counts_.reflected;
            reflected_.push({points.px[lane], points.py[lane], points.pz[lane], mirrors.dx[lane],
                             mirrors.dy[lane], mirrors.dz[lane], hits.element[lane], viewerInside,
                             weight * points.reflection[lane]},
                            current_.pixels[index], current_.levelsLeft[index] - 1, current_.media[index]);
        }
        if (points.transmission[lane] > 0) pushTransmitted(index, lane, rays, hits, points, mirrors);
    }

    void pushTransmitted(std::size_t index, std::size_t lane, const RayPacket& rays, const HitPacket& hits,
                         const PointPacket& points, const RayPacket& mirrors) {
        const Vec3 direction{rays.dx[lane], rays.dy[lane], rays.dz[lane]};
        const Vec3 normal{points.nx[lane], points.ny[lane], points.nz[lane]};
        const Vec3 mirror{mirrors.dx[lane], mirrors.dy[lane], mirrors.dz[lane]};
        const ElementId element{static_cast<std::uint32_t>(hits.element[lane])};
        const Side viewer = hits.entering[lane] != 0 ? Side::outside : Side::inside;
        Transmission next = transmit(world_, media_[current_.media[index]], world_.bodyOf(element), direction,
                                     normal, mirror, viewer);
        MediaIndex medium = current_.media[index];
        if (next.isReflected) {
            ++counts_.reflected;
        } else {
            ++counts_.transmitted;
            medium = static_cast<MediaIndex>(media_.size());
            media_.push_back(std::move(next.media));
        }
        transmitted_.push(
            {points.px[lane], points.py[lane], points.pz[lane], next.direction.x, next.direction.y,
             next.direction.z, hits.element[lane], next.side == Side::inside ? 1.0 : 0.0,
             current_.at(RayQueue::weight, index) * points.transmission[lane]},
            current_.pixels[index], current_.levelsLeft[index] - (next.isContinued ? 0 : 1), medium);
    }

    const World& world_;
    RayCounts& counts_;
    std::vector<Colour> sums_; ///< of the block's pixels
    std::vector<MediaStack> media_;
    RayQueue current_, reflected_, transmitted_;
};

} // namespace yarte::trace::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
