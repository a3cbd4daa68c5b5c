// One case from beginning to end: render or read two pictures, compare, and put what remains into the
// report's folder.
#pragma once

#include "validate/image_file.h"
#include "validate/renderers.h"
#include "validate/report.h"
#include "validate/stop_signal.h"

#include <filesystem>
#include <string>

namespace yarte::validate {

struct CaseSettings {
    RenderSettings render;
    Tolerance tolerance;
    double timeLimit = 600;                ///< seconds for each program
    std::filesystem::path temporaryFolder; ///< where the workshops are made
    std::filesystem::path output;          ///< the report's folder
};

/// Renders `scene` with both programs. What goes wrong with the case is in its report; throws Interrupted,
/// and FileError if the report's folder cannot be written.
CaseReport validateScene(const std::string& name, const std::filesystem::path& scene, const CaseSettings&,
                         const StopSignal&);

/// Compares two image files; integers are read as `integers` says. Errors as above.
CaseReport validateImages(const std::filesystem::path& a, const std::filesystem::path& b, Encoding integers,
                          const CaseSettings&);

} // namespace yarte::validate
