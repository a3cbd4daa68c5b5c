// Random: POV-Ray's numbers of seed() and rand().
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace yarte::convert::povray::sdl {

/// Streams of x' = 1812433253 x + 12345 modulo 2^32, shown divided by 2^32 - 1: found by comparing with what
/// POV-Ray prints.
class Random {
public:
    /// A new stream; its number.
    std::size_t seed(std::int32_t value) {
        streams_.push_back(static_cast<std::uint32_t>(value));
        return streams_.size() - 1;
    }
    bool has(double stream) const { return stream >= 0 && stream < static_cast<double>(streams_.size()); }
    /// In [0, 1].
    double next(std::size_t stream) {
        streams_[stream] = streams_[stream] * 1812433253u + 12345u;
        return streams_[stream] / 4294967295.0;
    }
    std::size_t count() const { return streams_.size(); }

private:
    std::vector<std::uint32_t> streams_;
};

} // namespace yarte::convert::povray::sdl
