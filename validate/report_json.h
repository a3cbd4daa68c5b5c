// The report as JSON (schema 1: INTERFACES in the README), and reading numbers that other programs wrote as
// JSON.
#pragma once

#include "validate/report.h"

#include <optional>
#include <string>
#include <string_view>

namespace yarte::validate {

std::string jsonReport(const Report&);

/// The number called `key` in the object `json`; nothing if there is none, or no object.
std::optional<double> numberInJson(std::string_view json, std::string_view key);

} // namespace yarte::validate
