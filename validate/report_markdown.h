// The report as a short Markdown table, for a CI job's summary page.
#pragma once

#include "validate/report.h"

#include <string>

namespace yarte::validate {

std::string markdownReport(const Report&);

} // namespace yarte::validate
