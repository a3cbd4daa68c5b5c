// The speed report as one HTML file that needs nothing else.
#pragma once

#include "validate/speed/speed_report.h"

#include <string>

namespace yarte::validate {

std::string speedHtml(const SpeedReport&);

} // namespace yarte::validate
