// BlockSample: where the time of one block of pixels goes.
#pragma once

#include "yarte/trace/render_tile.h"

#include <chrono>
#include <cstddef>
#include <cstdint>

#include <sys/resource.h>

namespace yarte::trace {

/// Of a unit that is the same within a block of pixels: TraceTimes asks for no more. A packet takes about a
/// microsecond; the time stamp counter takes half of what the system's clock does.
inline std::uint64_t clockTicks() {
#if defined(__x86_64__)
    return __builtin_ia32_rdtsc();
#else
    return static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count());
#endif
}

/// Adds the time of a scope to a sum.
class PhaseTimer {
public:
    /// Without a sum it does nothing.
    explicit PhaseTimer(std::uint64_t* sum) : sum_(sum), begin_(sum ? clockTicks() : 0) {}
    ~PhaseTimer() {
        if (sum_) *sum_ += clockTicks() - begin_;
    }
    PhaseTimer(const PhaseTimer&) = delete;
    PhaseTimer& operator=(const PhaseTimer&) = delete;

private:
    std::uint64_t* sum_;
    std::uint64_t begin_;
};

/// Measures a block from its making to its end, if it is in the sample, and then adds to TraceTimes; unless
/// another program was given the core meanwhile: one such time would outweigh all others.
class BlockSample {
public:
    /// `number` counts a worker's blocks. Without `times` nothing is measured.
    BlockSample(std::size_t number, TraceTimes* times) {
        // Of every so many blocks, a prime number, so that the sample is in step with no row of tiles. Not
        // the first block, which meets cold memory.
        if (times && number % 41 == 1) times_ = times, switches_ = switches(), begin_ = clockTicks();
    }
    ~BlockSample() {
        if (!times_) return;
        block_.sampled = clockTicks() - begin_;
        if (switches() == switches_) *times_ += block_;
    }
    BlockSample(const BlockSample&) = delete;
    BlockSample& operator=(const BlockSample&) = delete;

    /// For PhaseTimer: null where nothing is measured.
    std::uint64_t* sum(std::uint64_t TraceTimes::*phase) { return times_ ? &(block_.*phase) : nullptr; }

private:
    /// How often the thread had to give up its core.
    static long switches() {
        rusage usage{};
        getrusage(RUSAGE_THREAD, &usage);
        return usage.ru_nivcsw;
    }

    TraceTimes* times_ = nullptr;
    TraceTimes block_;
    long switches_ = 0;
    std::uint64_t begin_ = 0;
};

} // namespace yarte::trace
