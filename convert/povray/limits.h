// Where POV-Ray cannot follow YARTE to the last bit: found here, and said in the ledger.
#pragma once

#include "convert/ledger.h"
#include "yarte/scene/scene.h"

#include <cstddef>

namespace yarte::convert::povray {

void reportScene(const Scene&, Ledger&);
void reportPolygon(const Polygon&, std::size_t body, Ledger&);
/// POV-Ray's planes end.
void reportPlane(const Scene&, std::size_t body, Ledger&);
/// `plain`: as --plain-textures writes it.
void reportMesh(const Scene&, const Mesh&, bool plain, std::size_t body, Ledger&);

} // namespace yarte::convert::povray
