// Whitted's sum over generations, a block of pixels at a time; see yarte/trace/whitted.h, whose order of
// additions this keeps for every pixel.
#if defined(YARTE_TRACE_LANES_WHITTED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef YARTE_TRACE_LANES_WHITTED_INL_H
#undef YARTE_TRACE_LANES_WHITTED_INL_H
#else
#define YARTE_TRACE_LANES_WHITTED_INL_H
#endif

#include "yarte/trace/lanes/camera-inl.h"
#include "yarte/trace/lanes/ray_queue.h"
#include "yarte/trace/lanes/shading-inl.h"

HWY_BEFORE_NAMESPACE();
namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION {

using RayQueue = RayQueueOf<Scalar>;

template <bool isTinted>
class WhittedLanes {
public:
    WhittedLanes(const World& world, Workspace<Scalar>& memory, RayCounts& counts, TraceTimes* times)
        : world_(world), counts_(counts), times_(times), media_(world), blockCount_(memory.blockCount),
          blockers_(memory.blockers), sums_(memory.sums), current_(memory.current),
          reflected_(memory.reflected), transmitted_(memory.transmitted) {
        for (RayQueue* queue : {&current_, &reflected_, &transmitted_}) queue->start(isTinted);
        blockers_.assign(world.lights.size(), {});
    }

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
        BlockSample sample(blockCount_++, times_);
        searchTicks_ = sample.sum(&TraceTimes::camera);
        shadowTicks_ = sample.sum(&TraceTimes::shadow);
        sums_.assign(static_cast<std::size_t>(block.width()) * static_cast<std::size_t>(block.height()),
                     Colour{});
        pushCameraRays(block);
        while (current_.size() > 0) {
            current_.pad(lanes);
            reflected_.clear(), transmitted_.clear();
            for (std::size_t first = 0; first < current_.size(); first += lanes) tracePacket(first);
            searchTicks_ = sample.sum(&TraceTimes::secondary);
            current_.swap(reflected_);
            current_.append(transmitted_);
        }
        for (int y = 0; y < block.height(); ++y)
            std::copy_n(&sums_[static_cast<std::size_t>(y * block.width())], block.width(),
                        pixels + static_cast<std::size_t>(y) * stride);
    }

    /// In small squares, so that the rays of a packet stay close together.
    void pushCameraRays(Tile block) {
        constexpr int square = 4;
        current_.clear();
        current_.reserve(sums_.size());
        Scalar *u = current_.end(RayQueue::dx), *v = current_.end(RayQueue::dy),
               *pixel = current_.end(RayQueue::pixel);
        for (int y0 = block.y0; y0 < block.y1; y0 += square)
            for (int x0 = block.x0; x0 < block.x1; x0 += square)
                for (int y = y0; y < std::min(y0 + square, block.y1); ++y)
                    for (int x = x0; x < std::min(x0 + square, block.x1); ++x) {
                        *u++ = static_cast<Scalar>(x), *v++ = static_cast<Scalar>(y);
                        *pixel++ = static_cast<Scalar>((y - block.y0) * block.width() + (x - block.x0));
                    }
        for (std::size_t i = 0; i < sums_.size(); i += half) aimCameraRays(i);
        current_.grow(sums_.size());
        counts_.camera += sums_.size();
    }

    /// For a vector of pixels, whose x and y stand where the direction goes.
    HWY_INLINE void aimCameraRays(std::size_t i) {
        const auto put = [&](RayQueue::Component c, V value) HWY_ATTR { store(value, current_.end(c) + i); };
        const CameraRays& camera = world_.camera;
        const V3 d = cameraDirections(camera, load(current_.end(RayQueue::dx) + i),
                                      load(current_.end(RayQueue::dy) + i));
        put(RayQueue::ox, set(camera.position.x)), put(RayQueue::oy, set(camera.position.y));
        put(RayQueue::oz, set(camera.position.z));
        put(RayQueue::dx, d.x), put(RayQueue::dy, d.y), put(RayQueue::dz, d.z);
        put(RayQueue::from, set(noElement)), put(RayQueue::inside, set(0));
        putWeight(passing<isTinted>(set(1)), put);
        put(RayQueue::levels, set(world_.levels)), put(RayQueue::media, set(0));
    }

    HWY_INLINE V queued(RayQueue::Component c, std::size_t i) const {
        return hn::LoadU(D(), current_.at(c, i));
    }
    HWY_INLINE Passing<isTinted> queuedWeight(std::size_t i) const {
        if constexpr (isTinted)
            return {queued(RayQueue::weight, i), queued(RayQueue::weightG, i), queued(RayQueue::weightB, i)};
        else
            return queued(RayQueue::weight, i);
    }
    template <class Put>
    HWY_INLINE static void putWeight(Passing<isTinted> weight, const Put& put) {
        if constexpr (isTinted)
            put(RayQueue::weight, weight.r), put(RayQueue::weightG, weight.g),
                put(RayQueue::weightB, weight.b);
        else
            put(RayQueue::weight, weight);
    }

    HWY_INLINE void loadPacket(std::size_t first, RayPacket& rays) const {
        Scalar* const to[] = {rays.ox, rays.oy, rays.oz, rays.dx, rays.dy, rays.dz, rays.from, rays.inside};
        for (int c = 0; c <= RayQueue::inside; ++c)
            for (std::size_t at = 0; at < lanes; at += half)
                store(queued(RayQueue::Component(c), first + at), to[c] + at);
    }

    void tracePacket(std::size_t first) {
        RayPacket rays, mirrors;
        HitPacket hits;
        PointPacket points;
        ColourPacket colours;
        const std::size_t count = std::min(lanes, current_.size() - first);
        loadPacket(first, rays);
        {
            const PhaseTimer timer(searchTicks_);
            nearestHits(world_, rays, hits);
        }
        for (std::size_t i = count; i < lanes; ++i)
            hits.element[i] = noElement; // repeated lanes must not count
        if (hits.isEmpty()) {
            addColours(first, count, hits, colours);
            return;
        }
        describeHits(world_, rays, hits, points);
        for (std::size_t at = 0; at < lanes; at += half) {
            const V3 d = rays.direction(at), n = points.normal(at);
            mirrors.setDirection(at, normalised(d - n * (set(2) * dot(d, n))));
        }
        localColours<isTinted>(world_, hits, points, mirrors, blockers_, colours, counts_.shadow,
                               shadowTicks_);
        addColours(first, count, hits, colours);
        if (world_.levels == 0) return;
        for (std::size_t at = 0; at < lanes; at += half) {
            const M goesOn = hn::And(load(hits.element + at) != set(noElement),
                                     queued(RayQueue::levels, first + at) > set(0));
            const M reflects = hn::And(goesOn, load(points.reflection + at) > set(0));
            if (any(reflects)) pushReflected(first + at, at, reflects, hits, points, mirrors);
            const M transmits = hn::And(goesOn, load(points.totalReflection + at) > set(0));
            if (any(transmits)) pushTransmitted(first + at, at, transmits, rays, hits, points, mirrors);
        }
    }

    void addColours(std::size_t first, std::size_t count, const HitPacket& hits, ColourPacket& colours) {
        for (std::size_t at = 0; at < lanes; at += half) {
            const M isHit = load(hits.element + at) != set(noElement);
            const C3 colour = select(isHit, colours.at(at), spread(world_.background));
            colours.set(at, colour * queuedWeight(first + at));
        }
        for (std::size_t i = 0; i < count; ++i)
            sums_[static_cast<std::size_t>(*current_.at(RayQueue::pixel, first + i))] +=
                Colour{colours.r[i], colours.g[i], colours.b[i]};
    }

    /// Appends the lanes of `mask` to `queue`; what stays as it was comes from the queue of this generation.
    HWY_INLINE void push(RayQueue& queue, M mask, std::size_t index, V3 origin, V3 direction, V from,
                         V inside, Passing<isTinted> weight, V levels, V media) {
        queue.reserve(half);
        alignas(64) LaneNumber order[half + 1];
        const std::size_t count = listLanes(mask, order);
        const auto indices = hn::SetTableIndices(D(), order);
        const auto put = [&](RayQueue::Component c, V value) HWY_ATTR {
            hn::StoreU(hn::TableLookupLanes(value, indices), D(), queue.end(c));
        };
        put(RayQueue::ox, origin.x), put(RayQueue::oy, origin.y), put(RayQueue::oz, origin.z);
        put(RayQueue::dx, direction.x), put(RayQueue::dy, direction.y), put(RayQueue::dz, direction.z);
        put(RayQueue::from, from), put(RayQueue::inside, inside);
        putWeight(weight, put);
        put(RayQueue::pixel, queued(RayQueue::pixel, index)), put(RayQueue::levels, levels);
        put(RayQueue::media, media);
        queue.grow(count);
    }

    HWY_INLINE void pushReflected(std::size_t index, std::size_t at, M mask, const HitPacket& hits,
                                  const PointPacket& points, const RayPacket& mirrors) {
        counts_.reflected += hn::CountTrue(D(), mask);
        const V viewerInside = flag(load(hits.entering + at) == set(0));
        push(reflected_, mask, index, points.position(at), mirrors.direction(at), load(hits.element + at),
             viewerInside, queuedWeight(index) * load(points.reflection + at),
             queued(RayQueue::levels, index) - set(1), queued(RayQueue::media, index));
    }

    /// `transmit` of yarte/trace/media.h, lane by lane the same bits.
    HWY_INLINE void pushTransmitted(std::size_t index, std::size_t at, M mask, const RayPacket& rays,
                                    const HitPacket& hits, const PointPacket& points,
                                    const RayPacket& mirrors) {
        alignas(64) Scalar lanesOn[half], ratios[half], continued[half], after[half];
        [[maybe_unused]] ColourPacket transmission; // of the lanes that are on, from 0
        store(flag(mask), lanesOn);
        for (std::size_t i = 0; i < half; ++i) {
            ratios[i] = 1, continued[i] = 0, after[i] = 0;
            if (lanesOn[i] == 0) continue;
            const ElementId element{idIn(hits.element[at + i])};
            const auto before = static_cast<MediaIndex>(*current_.at(RayQueue::media, index + i));
            const MediaPool::Transition& transition = media_.pass(before, world_.bodyOf(element));
            if constexpr (isTinted) transmission.set(i, world_.appearanceOf(element).transmission);
            ratios[i] = static_cast<Scalar>(transition.ratio), continued[i] = transition.isContinued;
            after[i] = static_cast<Scalar>(transition.after);
        }
        const V zero = set(0), one = set(1), ratio = load(ratios);
        const V3 d = rays.direction(at), n = points.normal(at);
        const V cosine = hn::Neg(dot(d, n));
        const V k = one - ratio * ratio * (one - cosine * cosine);
        const M straight = isSet(load(continued)), mirrored = hn::AndNot(straight, k < zero);
        const V3 refracted = normalised(d * ratio + n * (ratio * cosine - hn::Sqrt(greatest(k, zero))));
        const V3 direction = select(straight, d, select(mirrored, mirrors.direction(at), refracted));
        const V viewerInside = flag(load(hits.entering + at) == zero);
        Passing<isTinted> passes = passing<isTinted>(load(points.totalReflection + at));
        if constexpr (isTinted) passes = select(mirrored, passes, transmission.at(0));
        const std::size_t reflectedCount = hn::CountTrue(D(), hn::And(mask, mirrored));
        counts_.reflected += reflectedCount;
        counts_.transmitted += hn::CountTrue(D(), mask) - reflectedCount;
        push(transmitted_, mask, index, points.position(at), direction, load(hits.element + at),
             select(mirrored, viewerInside, one - viewerInside), queuedWeight(index) * passes,
             queued(RayQueue::levels, index) - select(straight, zero, one),
             select(mirrored, queued(RayQueue::media, index), load(after)));
    }

    const World& world_;
    RayCounts& counts_;
    TraceTimes* const times_; ///< null: not asked for
    // Null unless the block is in the sample.
    std::uint64_t *searchTicks_ = nullptr, ///< of the generation's rays
        *shadowTicks_ = nullptr;
    MediaPool media_;
    std::size_t& blockCount_;
    std::vector<ElementId>& blockers_; ///< of each light
    std::vector<Colour>& sums_;        ///< of the block's pixels
    RayQueue &current_, &reflected_, &transmitted_;
};

HWY_INLINE void renderTile(const World& world, Tile tile, Colour* pixels, std::size_t stride,
                           RayCounts& counts, TraceTimes* times) {
    thread_local Workspace<Scalar> memory;
    if (world.isTinted)
        WhittedLanes<true>(world, memory, counts, times).render(tile, pixels, stride);
    else
        WhittedLanes<false>(world, memory, counts, times).render(tile, pixels, stride);
}

} // namespace yarte::trace::HWY_NAMESPACE::YARTE_PRECISION
HWY_AFTER_NAMESPACE();

#endif
