// The report as one HTML file that needs nothing else: style, script, data and pictures are inside.
#pragma once

#include "validate/report.h"

#include <string>

namespace yarte::validate {

std::string htmlReport(const Report&);

} // namespace yarte::validate
