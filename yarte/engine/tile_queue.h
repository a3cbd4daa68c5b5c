// TileQueue: who renders which tile. Lies in shared memory and is never locked: a worker may die at any
// instruction.
#pragma once

#include "yarte/engine/shared_memory.h"
#include "yarte/engine/tile_costs.h"
#include "yarte/engine/tile_list.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace yarte {

/// A tile waits, is held by one worker, or is finished; each step is one atomic operation on the tile's own
/// state, so that what a dead worker held is known exactly.
class TileQueue {
public:
    /// All tiles wait. Throws std::bad_alloc.
    explicit TileQueue(TileList);

    const TileList& tiles() const { return tiles_; }

    /// A waiting tile, from now on held by `worker` (>= 0); nothing if none waits. Called by workers.
    std::optional<std::size_t> claim(int worker);

    /// The tile has been rendered, at these costs: by its holder, or earlier, before any worker starts.
    void finish(std::size_t tile, const TileCosts&);

    /// Of a finished tile; nothing if it is not.
    std::optional<TileCosts> costsOf(std::size_t tile) const;

    /// The tile that `worker` held when it died waits again; nothing if it held none. Called when it is
    /// surely dead.
    std::optional<std::size_t> putBack(int worker);

    /// Those before it were dealt at least once.
    std::size_t dealtCount() const;

    /// Tiles finished; while workers are being killed it may fall short by one for each.
    std::size_t finishedCount() const;

    /// The costs of all finished tiles: each tile counts once, however often it was begun.
    TileCosts costs() const;

private:
    struct Slot {
        std::atomic<std::uint32_t> state; ///< waiting, finished, or the holder's number + 1
        TileCosts costs;                  ///< valid once finished
    };
    struct Counters {
        std::atomic<std::size_t> next;     ///< tiles before it were dealt at least once
        std::atomic<std::size_t> finished; ///< for progress
    };
    static constexpr std::uint32_t waiting = 0, finished = 0xffffffff;
    // A lock in a dead process would stay closed for ever.
    static_assert(std::atomic<std::uint32_t>::is_always_lock_free &&
                  std::atomic<std::size_t>::is_always_lock_free);

    bool take(std::size_t tile, int worker);

    TileList tiles_;
    SharedMemory memory_; ///< the counters, then one slot a tile
    Counters* counters_;
    Slot* slots_;
};

} // namespace yarte
