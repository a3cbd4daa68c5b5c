// Pixels: time and image error of pictures at growing samples a pixel.
#pragma once

#include "validate/speed/speed_report.h"
#include "validate/speed/speed_settings.h"
#include "validate/workshop.h"

#include <filesystem>

namespace yarte::validate {

/// Of finite pictures of one size.
PictureError pictureError(const Picture&, const Picture& reference);

/// Fills in the case's size, exposure and curves. `scene`: as for renderWithYarte. What is compared runs in
/// turn, so that a machine whose speed drifts affects all alike. Throws CaseError.
void measurePixels(SpeedCase&, Workshop&, const SpeedSettings&, const std::filesystem::path& scene);

} // namespace yarte::validate
