// A run: all cases that the options ask for, side by side, and what they make of a baseline.
#pragma once

#include "validate/options.h"
#include "validate/renderers.h"
#include "validate/report.h"
#include "validate/stop_signal.h"

#include <functional>
#include <string>
#include <vector>

namespace yarte::validate {

struct RunResult {
    Report report;
    std::vector<std::string> removed; ///< references whose scenes are gone
};

/// `tell` gets each case once it and all before it are done, in the order of the scenes. Throws Interrupted,
/// FileError, and what the standard library throws where a folder cannot be made.
RunResult runCases(const Options&, const Programs&, const StopSignal&,
                   const std::function<void(const CaseReport&)>& tell);

} // namespace yarte::validate
