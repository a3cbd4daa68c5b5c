// A run of `yarte-validate speed`: all scenes, one after the other, since they are timed.
#pragma once

#include "validate/options.h"
#include "validate/renderers.h"
#include "validate/speed/speed_report.h"
#include "validate/stop_signal.h"

#include <functional>

namespace yarte::validate {

/// `tell` gets each case once it is done. Throws Interrupted, and what the standard library throws where a
/// folder cannot be made.
SpeedReport runSpeed(const Options&, const Programs&, const StopSignal&,
                     const std::function<void(const SpeedCase&)>& tell);

} // namespace yarte::validate
