// One case from beginning to end: render or read two pictures, compare, and put what remains into the
// report's folder.
#pragma once

#include "validate/baseline.h"
#include "validate/image_file.h"
#include "validate/renderers.h"
#include "validate/report.h"
#include "validate/stop_signal.h"

#include <filesystem>
#include <optional>
#include <string>

namespace yarte::validate {

struct CaseSettings {
    RenderSettings render;
    std::filesystem::path tolerance;       ///< a file; empty: each scene's own
    double timeLimit = 600;                ///< seconds for each program
    std::filesystem::path temporaryFolder; ///< where the workshops are made
    std::filesystem::path output;          ///< the report's folder
    std::size_t pageLimit = 1 << 20;       ///< bytes of pictures that the page may hold of each case
    const Baseline* baseline = nullptr;    ///< compare with these pictures and not with POV-Ray's
    bool updateBaseline = false;           ///< and then put the new pictures there
};

/// Renders `scene`, in any format that yarte-convert reads, with YARTE, and compares with POV-Ray's picture
/// or the baseline's. What goes wrong with the case is in its report; throws Interrupted, and FileError if
/// the report's or the baseline's folder cannot be written.
CaseReport validateScene(const std::string& name, const std::filesystem::path& scene, const CaseSettings&,
                         const StopSignal&);

/// Compares two image files; integers are read as `integers` says. Errors as above.
CaseReport validateImages(const std::filesystem::path& a, const std::filesystem::path& b, Encoding integers,
                          const CaseSettings&);

} // namespace yarte::validate
