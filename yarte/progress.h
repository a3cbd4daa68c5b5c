// How far a render is, for people and for programs.
#pragma once

#include "yarte/engine/render.h"

#include <string>

namespace yarte {

/// A bar that overwrites the last one on a terminal: "\r[#####---------------]  25 %  2.0 s, 6.0 s left".
std::string progressBar(RenderProgress, double elapsedSeconds);

/// What wipes the bar away.
inline constexpr const char* noProgressBar = "\r\x1b[K";

/// A line `{"done": 1, "total": 4, "elapsed_s": 2.000, "eta_s": 6.000}`; eta_s is null before the first tile
/// is done.
std::string progressJson(RenderProgress, double elapsedSeconds);

} // namespace yarte
