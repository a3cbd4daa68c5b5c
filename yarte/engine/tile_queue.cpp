#include "yarte/engine/tile_queue.h"

#include <algorithm>
#include <memory>
#include <new>

namespace yarte {

TileQueue::TileQueue(TileList tiles)
    : tiles_(tiles), memory_(mapSharedMemory(sizeof(Counters) + tiles.size() * sizeof(Slot))),
      counters_(new (memory_.get()) Counters{}), slots_(reinterpret_cast<Slot*>(counters_ + 1)) {
    static_assert(sizeof(Counters) % alignof(Slot) == 0);
    std::uninitialized_value_construct_n(slots_, tiles_.size());
}

bool TileQueue::take(std::size_t tile, int worker) {
    std::uint32_t expected = waiting;
    return slots_[tile].state.compare_exchange_strong(expected, static_cast<std::uint32_t>(worker) + 1);
}

std::optional<std::size_t> TileQueue::claim(int worker) {
    for (std::size_t tile = counters_->next++; tile < tiles_.size(); tile = counters_->next++)
        if (take(tile, worker)) return tile;
    // Every tile was dealt once. One that waits now came back from a dead worker, or its worker died between
    // moving the counter and taking it.
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
        if (take(tile, worker)) return tile;
    return std::nullopt;
}

void TileQueue::finish(std::size_t tile, const TileCosts& costs) {
    slots_[tile].costs = costs;
    slots_[tile].state.store(finished); // publishes the costs and the tile's pixels
    ++counters_->finished;
}

std::optional<std::size_t> TileQueue::putBack(int worker) {
    const std::uint32_t holder = static_cast<std::uint32_t>(worker) + 1;
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
        if (slots_[tile].state.load() == holder) {
            slots_[tile].state.store(waiting);
            return tile;
        }
    return std::nullopt;
}

std::optional<TileCosts> TileQueue::costsOf(std::size_t tile) const {
    if (slots_[tile].state.load() != finished) return std::nullopt;
    return slots_[tile].costs;
}

std::size_t TileQueue::dealtCount() const { return std::min(counters_->next.load(), tiles_.size()); }

std::size_t TileQueue::finishedCount() const { return counters_->finished.load(); }

TileCosts TileQueue::costs() const {
    TileCosts sum;
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile)
        if (const auto costs = costsOf(tile)) sum += *costs;
    return sum;
}

} // namespace yarte
