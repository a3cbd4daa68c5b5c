// YARTE's scene from what an SDL file describes. How everything becomes YARTE's is in convert/README.md.
#pragma once

#include "convert/ledger.h"
#include "convert/povray/sdl/model.h"
#include "yarte/base/diagnostic.h"

#include <optional>

namespace yarte::convert::povray::sdl {

struct BuildOptions {
    /// How far triangles may be from surfaces that YARTE has no shape for, in the file's units; none: a part
    /// of their size.
    std::optional<double> chordError;
    Resolution resolution{640, 480}; ///< of a file that does not name one
};

/// Everything approximated, dropped or made up is in the ledger, with the place in the file. What YARTE
/// cannot represent at all (numbers that overflow) is an error: nothing then.
std::optional<Scene> buildScene(const Model&, const BuildOptions&, const Sources&, Diagnostics&, Ledger&);

} // namespace yarte::convert::povray::sdl
