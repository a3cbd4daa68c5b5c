// The report as JUnit XML, which CI systems show: a test case per case, "fail" as failure, "error" as error.
#pragma once

#include "validate/report.h"

#include <string>

namespace yarte::validate {

std::string junitReport(const Report&);

} // namespace yarte::validate
