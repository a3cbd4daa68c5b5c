// The report for a terminal: a line per case, and one at the end.
#pragma once

#include "validate/report.h"

#include <string>

namespace yarte::validate {

/// "pass  paper  256x256  max 0.50/65535  0 px over  yarte 0.10 s  povray 0.25 s (2.5x)"; for an error its
/// message.
std::string caseLine(const CaseReport&);

/// "3 cases: 2 pass, 0 fail, 1 error".
std::string summaryLine(const Report&);

/// A difference in linear light: a small one in steps of a 16-bit file, "0.50/65535", a large one as it is,
/// "0.25".
std::string errorText(double value);

/// "0.10 s", below that "0.004 s", "?" if unknown.
std::string secondsText(const std::optional<double>&);

} // namespace yarte::validate
