// Tessellation: what triangles for curved shapes cost, in time and in error.
#pragma once

#include "validate/speed/speed_report.h"
#include "validate/speed/speed_settings.h"
#include "validate/workshop.h"
#include "yarte/scene/scene.h"

#include <filesystem>

namespace yarte::validate {

/// The largest radius of the scene's curved shapes; 0 if there is none.
double largestRadius(const Scene&);

/// Of `scene`, a file that renderWithYarte takes, which reads as `content`. Throws CaseError.
Tessellation measureTessellation(Workshop&, const SpeedSettings&, const std::filesystem::path& scene,
                                 const Scene& content);

} // namespace yarte::validate
