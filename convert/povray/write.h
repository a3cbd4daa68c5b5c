// .pov: scenes for POV-Ray 3.7 as readable SDL that gives YARTE's picture. The recipe is explained in
// convert/README.md; facts about POV-Ray are from its documentation, its source at v3.7.0.10, and
// measurement.
#pragma once

#include "convert/format.h"

namespace yarte::convert::povray {

std::vector<OutputFile> writeScene(const Scene&, Conversion&);

} // namespace yarte::convert::povray
