// The speed report as JSON: speed.schema.json says what is in it.
#pragma once

#include "validate/speed/speed_report.h"

#include <string>

namespace yarte::validate {

std::string speedJson(const SpeedReport&);

} // namespace yarte::validate
