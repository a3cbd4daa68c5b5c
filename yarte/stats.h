// Stats: what a run cost, for --stats.
#pragma once

#include "yarte/engine/render.h"

#include <cstdint>
#include <string>

namespace yarte {

struct Stats {
    std::string scene;         ///< as given
    int width = 0, height = 0; ///< pixels rendered
    RenderMode mode = RenderMode::serial;
    int workers = 0;
    Precision precision = Precision::inDouble; ///< of the computation, whatever was asked for
    double parseSeconds = 0, buildSeconds = 0, traceSeconds = 0, writeSeconds = 0, wallSeconds = 0;
    std::uint64_t peakRssBytes = 0;
    RayCounts rays;
    TraceTimes times; ///< of tracing, measured
};

/// The most memory that this process, or any one of its workers, has had resident.
std::uint64_t peakRssBytes();

/// One JSON object; its keys are an interface (README.md).
std::string toJson(const Stats&);

} // namespace yarte
