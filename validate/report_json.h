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

/// The same for a text.
std::optional<std::string> textInJson(std::string_view json, std::string_view key);

/// What a ledger of `yarte-convert --tessellate` tells of all curved shapes together.
struct LedgerTotals {
    std::size_t triangles = 0;
    double deviation = 0; ///< the largest
};

/// Rows that are none of curved shapes count nothing.
LedgerTotals tessellationInLedger(std::string_view json);

} // namespace yarte::validate
