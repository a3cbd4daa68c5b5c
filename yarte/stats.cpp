#include "yarte/stats.h"

#include "yarte/base/json.h"
#include "yarte/version.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include <sys/resource.h>

namespace yarte {

namespace {

std::string_view modeName(RenderMode mode) {
    switch (mode) {
    case RenderMode::serial: return "serial";
    case RenderMode::processes: return "processes";
    case RenderMode::threads: return "threads";
    }
    return "";
}

/// Nothing is known of what was not sampled or is not there: NaN, which JSON has not.
std::string seconds(double value) { return std::isfinite(value) ? fmt::format("{:.6f}", value) : "null"; }

/// Where the time goes; PROFILE.md tells what is what.
std::string profile(const Stats& s) {
    const double camera = s.times.secondsOf(s.times.camera), shadow = s.times.secondsOf(s.times.shadow),
                 secondary = s.times.secondsOf(s.times.secondary);
    const auto perMillion = [](double time, std::uint64_t rays) {
        return seconds(time / (static_cast<double>(rays) / 1e6));
    };
    return fmt::format(
        "{{\"build_s\": {}, \"camera_s\": {}, \"shadow_s\": {}, \"secondary_s\": {}, \"shade_s\": {}, "
        "\"write_s\": {}, \"per_million_rays_s\": {{\"camera\": {}, \"shadow\": {}, \"secondary\": {}}}}}",
        seconds(s.buildSeconds), seconds(camera), seconds(shadow), seconds(secondary),
        seconds(s.times.seconds - camera - shadow - secondary), seconds(s.writeSeconds),
        perMillion(camera, s.rays.camera), perMillion(shadow, s.rays.shadow),
        perMillion(secondary, s.rays.reflected + s.rays.transmitted));
}

} // namespace

std::uint64_t peakRssBytes() {
    rusage self{}, children{};
    getrusage(RUSAGE_SELF, &self);
    getrusage(RUSAGE_CHILDREN, &children);
    return static_cast<std::uint64_t>(std::max(self.ru_maxrss, children.ru_maxrss)) *
           1024; // Linux counts KiB
}

std::string toJson(const Stats& s) {
    std::string json = "{\n";
    const auto add = [&json](std::string_view key, const std::string& value) {
        json += fmt::format("  \"{}\": {},\n", key, value);
    };
    add("version", jsonString(version));
    add("scene", jsonString(s.scene));
    add("width", fmt::to_string(s.width));
    add("height", fmt::to_string(s.height));
    add("mode", jsonString(modeName(s.mode)));
    add("workers", fmt::to_string(s.workers));
    add("precision", jsonString(s.precision == Precision::inDouble ? "double" : "fast"));
    add("parse_s", seconds(s.parseSeconds));
    add("build_s", seconds(s.buildSeconds));
    add("trace_s", seconds(s.traceSeconds));
    add("write_s", seconds(s.writeSeconds));
    add("wall_s", seconds(s.wallSeconds));
    add("peak_rss_bytes", fmt::to_string(s.peakRssBytes));
    add("profile", profile(s));
    return json + fmt::format(
                      "  \"rays\": {{\"camera\": {}, \"shadow\": {}, \"reflected\": {}, \"transmitted\": {}}}"
                      "\n}}\n",
                      s.rays.camera, s.rays.shadow, s.rays.reflected, s.rays.transmitted);
}

} // namespace yarte
