// Timing: repeated measurements.
#pragma once

#include "validate/speed/speed_report.h"

#include <optional>
#include <vector>

namespace yarte::validate {

/// Collects what runs took.
class Timing {
public:
    void add(const std::optional<double>& seconds) {
        if (seconds) seconds_.push_back(*seconds);
    }
    /// Empty if nothing was added. Of an even number the median is the mean of the middle two.
    Seconds seconds() const;

private:
    std::vector<double> seconds_;
};

} // namespace yarte::validate
