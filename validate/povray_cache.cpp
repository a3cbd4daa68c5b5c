#include "validate/povray_cache.h"

#include "validate/digest.h"
#include "validate/report_json.h"
#include "yarte/base/file.h"
#include "yarte/base/number.h"

#include <fmt/format.h>

namespace yarte::validate {

namespace {

// A file: the digest of all that follows, a line with the times, and the picture.
constexpr std::size_t digestLength = 40;

std::string timesLine(const PovrayTimes& times) {
    const auto value = [](const std::optional<double>& v) { return v ? printNumber(*v) : "null"; };
    return fmt::format("{{\"parse_s\": {}, \"trace_s\": {}, \"wall_s\": {}}}", value(times.parse),
                       value(times.trace), value(times.wall));
}

std::optional<std::string> textOf(const std::filesystem::path& file) {
    try {
        return readFile(file);
    } catch (const FileError&) {
        return std::nullopt;
    }
}

} // namespace

std::filesystem::path PovrayCache::fileOf(const std::string& input) const {
    return folder_ / (digest(input) + ".povray");
}

std::optional<PovrayCache::Entry> PovrayCache::find(const std::string& input) const {
    const std::optional<std::string> text = textOf(fileOf(input));
    if (!text || text->size() < digestLength) return std::nullopt;
    const std::string_view stored(*text), body = stored.substr(digestLength);
    if (digest(body) != stored.substr(0, digestLength)) return std::nullopt;
    const std::size_t end = body.find('\n');
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view times = body.substr(0, end);
    Entry entry;
    entry.picture = body.substr(end + 1);
    entry.times = {numberInJson(times, "parse_s"), numberInJson(times, "trace_s"),
                   numberInJson(times, "wall_s"), true};
    return entry;
}

void PovrayCache::store(const std::string& input, const Entry& entry) const {
    const std::string body = timesLine(entry.times) + "\n" + entry.picture;
    std::filesystem::create_directories(folder_);
    writeFile(fileOf(input), digest(body) + body);
}

} // namespace yarte::validate
