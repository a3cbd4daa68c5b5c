// One diagnostic as one JSON object.
#pragma once

#include "yarte/base/diagnostic.h"

#include <string>

namespace yarte {

std::string formatJson(const Diagnostic&, const Sources&);

} // namespace yarte
