// The objects of an SDL file as bodies, lights as lights, in the order of the file.
#pragma once

#include "convert/povray/sdl/build_light.h"
#include "convert/povray/sdl/build_mesh.h"
#include "convert/povray/sdl/build_round.h"
#include "yarte/base/diagnostic.h"

namespace yarte::convert::povray::sdl {

struct BuiltObjects {
    std::vector<Body> bodies;
    std::vector<BuiltLight> lights;
    std::vector<Material> materials;
    std::vector<MeshData> meshes;
};

/// `isMirrored`: z becomes -z. Lengths become multiples of the model's unit. Numbers that are not finite are
/// errors, with their place.
BuiltObjects buildObjects(const Model&, bool isMirrored, Tolerance, Report&, Diagnostics&);

} // namespace yarte::convert::povray::sdl
