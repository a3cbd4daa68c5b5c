#include "validate/region.h"

namespace yarte::validate {

const char* name(Cause cause) {
    switch (cause) {
    case Cause::unknown: break;
    case Cause::brightness: return "brightness";
    case Cause::camera: return "camera";
    case Cause::background: return "background";
    case Cause::light: return "light";
    case Cause::body: return "body";
    case Cause::shading: return "shading";
    case Cause::reflection: return "reflection";
    case Cause::refraction: return "refraction";
    case Cause::silhouette: return "silhouette";
    case Cause::shadowEdge: return "shadow-edge";
    }
    return "unknown";
}

} // namespace yarte::validate
