// The diagrams of a case.
#pragma once

#include "validate/speed/log_plot.h"
#include "validate/speed/speed_report.h"

#include <string>
#include <vector>

namespace yarte::validate {

struct NamedPlot {
    std::string file; ///< in the report's folder, with '/'
    LogPlot plot;
};

/// In the order of the report: rays first, then pixels, then triangles. None without a point that can be
/// drawn.
std::vector<NamedPlot> plotsOf(const SpeedCase&);

} // namespace yarte::validate
