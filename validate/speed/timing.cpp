#include "validate/speed/timing.h"

#include <algorithm>

namespace yarte::validate {

Seconds Timing::seconds() const {
    if (seconds_.empty()) return {};
    std::vector<double> sorted = seconds_;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t half = sorted.size() / 2;
    const double median = sorted.size() % 2 == 1 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
    return {median, sorted.front(), sorted.back()};
}

} // namespace yarte::validate
