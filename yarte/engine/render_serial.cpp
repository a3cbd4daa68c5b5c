#include "yarte/engine/render_job.h"

namespace yarte {

bool renderSerial(const RenderJob& job) {
    std::vector<Colour> pixels;
    while (job.renderNext(0, pixels))
        if (!job.report()) return false;
    return true;
}

} // namespace yarte
