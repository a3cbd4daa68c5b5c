#include "yarte/engine/render_job.h"

namespace yarte {

bool renderSerial(const RenderJob& job) {
    while (job.renderNext(0))
        if (!job.report()) return false;
    return true;
}

} // namespace yarte
