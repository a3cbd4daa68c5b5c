// SpeedSettings: how `yarte-validate speed` measures.
#pragma once

#include "validate/renderers.h"

#include <filesystem>
#include <string>
#include <vector>

namespace yarte::validate {

struct SpeedSettings {
    RenderSettings render;
    double timeLimit = 600;                ///< seconds for each program
    std::filesystem::path temporaryFolder; ///< where the workshops are made
    std::vector<int> samples;              ///< N, ascending
    int referenceSamples = 16;
    int runs = 3;
    int rays = 4096;                 ///< at most, of those compared with the truth; 0: none
    std::string withoutPovray;       ///< why there are no curves of POV-Ray; empty: there are
    std::vector<double> chordErrors; ///< parts of the largest radius, descending; empty: no tessellation
};

} // namespace yarte::validate
