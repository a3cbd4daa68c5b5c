#include "yarte/progress.h"

#include <fmt/format.h>

#include <optional>

namespace yarte {

namespace {

double fraction(RenderProgress progress) {
    return static_cast<double>(progress.done) / static_cast<double>(progress.total);
}

/// As if the tiles left were like those done.
std::optional<double> secondsLeft(RenderProgress progress, double elapsed) {
    if (progress.done == 0) return std::nullopt;
    return elapsed * static_cast<double>(progress.total - progress.done) / static_cast<double>(progress.done);
}

} // namespace

std::string progressBar(RenderProgress progress, double elapsed) {
    constexpr int width = 20;
    const int full = static_cast<int>(width * fraction(progress));
    const int percent = static_cast<int>(100 * fraction(progress));
    const auto left = secondsLeft(progress, elapsed);
    return fmt::format("\r[{:-<{}}] {:3} %  {:.1f} s{}\x1b[K",
                       std::string(static_cast<std::size_t>(full), '#'), width, percent, elapsed,
                       left ? fmt::format(", {:.1f} s left", *left) : "");
}

std::string progressJson(RenderProgress progress, double elapsed) {
    const auto left = secondsLeft(progress, elapsed);
    return fmt::format("{{\"done\": {}, \"total\": {}, \"elapsed_s\": {:.3f}, \"eta_s\": {}}}\n",
                       progress.done, progress.total, elapsed, left ? fmt::format("{:.3f}", *left) : "null");
}

} // namespace yarte
