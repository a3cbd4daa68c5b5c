// The speed report for a terminal, and the words that its page shares with it.
#pragma once

#include "validate/speed/speed_report.h"

#include <string>

namespace yarte::validate {

/// The median, "0.12 s", below a tenth "0.004 s"; "?" if unknown.
std::string secondsText(const Seconds&);

/// A case in a few lines: each curve's first and last point, rays, triangles; or why there is nothing.
std::string speedCaseText(const SpeedCase&);

} // namespace yarte::validate
