#include "validate/renderers.h"

#include "validate/image_file.h"
#include "validate/report_json.h"
#include "validate/text.h"
#include "yarte/base/file.h"
#include "yarte/base/number.h"

#include <algorithm>
#include <fmt/format.h>
#include <thread>

namespace yarte::validate {

namespace {

/// A scene for POV-Ray may come from a stranger: it must not take the machine's memory.
constexpr std::uint64_t povrayMemoryLimit = 8ull << 30;

constexpr const char* yarteStatisticsFile = "yarte.json";
constexpr const char* povrayStatisticsFile = "povray-statistics.txt";
constexpr const char* povrayErrorFile = "povray-error.txt";

const std::filesystem::path& found(const std::filesystem::path& program, const char* name,
                                   const char* option) {
    if (program.empty())
        throw CaseError(fmt::format("{0} not found: install it, or give its place with {1}", name, option));
    return program;
}

/// Throws CaseError with what the program said, unless it succeeded.
void demandSuccess(const char* name, const ProgramResult& result, std::string_view said) {
    if (result.succeeded()) return;
    const std::string_view text = trimmedEnd(said);
    throw CaseError(fmt::format("{}: {}{}{}", name, outcome(result), text.empty() ? "" : "\n", text));
}

/// The text of a file that a program may have written.
std::string textIfThere(const std::filesystem::path& file) {
    try {
        return readFile(file);
    } catch (const FileError&) {
        return {};
    }
}

Picture pictureOf(const Workshop& workshop, const char* name, const char* file) {
    if (!std::filesystem::exists(workshop.file(file)))
        throw CaseError(fmt::format("{} ended well but wrote no picture ({})", name, file));
    try {
        return readPicture(workshop.file(file));
    } catch (const ImageError& error) {
        throw CaseError(
            fmt::format("{} wrote a picture that cannot be read: {}", name, cleanText(error.what())));
    }
}

/// POV-Ray has threads where YARTE has processes. 0 processes is YARTE's reference in a single process.
int povrayThreads(const RenderSettings& settings) {
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    return std::max(1, settings.processes.value_or(cores));
}

} // namespace

Picture renderWithYarte(Workshop& workshop, const RenderSettings& settings,
                        const std::filesystem::path& scene, YarteTimes& times) {
    std::vector<std::string> command = {found(settings.programs.yarte, "yarte", "--yarte"),
                                        scene,
                                        "-o",
                                        yartePictureFile,
                                        "--progress",
                                        "none",
                                        "--stats",
                                        yarteStatisticsFile};
    if (!settings.size.empty()) command.insert(command.end(), {"--size", settings.size});
    if (settings.processes)
        command.insert(command.end(), {"--processes", std::to_string(*settings.processes)});
    const ProgramResult result = workshop.run(command);
    times.wall = result.seconds;
    demandSuccess("yarte", result, result.errorText);
    times.trace = numberInJson(textIfThere(workshop.file(yarteStatisticsFile)), "trace_s");
    return pictureOf(workshop, "yarte", yartePictureFile);
}

Picture renderWithPovray(Workshop& workshop, const RenderSettings& settings,
                         const std::filesystem::path& scene, double exposure, int width, int height,
                         PovrayTimes& times) {
    const std::string convert = found(settings.programs.convert, "yarte-convert", "--convert");
    const std::string povray = found(settings.programs.povray, "povray", "--povray");
    const ProgramResult conversion =
        workshop.run({convert, scene, povraySceneFile, "--exposure", printNumber(exposure)});
    demandSuccess("yarte-convert", conversion, conversion.errorText);

    // 16-bit linear values, one ray through each pixel's centre, no console but errors and statistics in
    // files.
    const ProgramResult result =
        workshop.run({povray, fmt::format("+I{}", povraySceneFile), fmt::format("+O{}", povrayPictureFile),
                      "+FP16", fmt::format("+W{}", width), fmt::format("+H{}", height), "-D", "-A", "-P",
                      fmt::format("+WT{}", povrayThreads(settings)), "+Q9", "File_Gamma=1", "-GA",
                      fmt::format("+GF{}", povrayErrorFile), fmt::format("+GS{}", povrayStatisticsFile)},
                     povrayMemoryLimit);
    times.wall = result.seconds;
    const std::string said = cleanText(textIfThere(workshop.file(povrayErrorFile)));
    demandSuccess("povray", result, said.empty() ? result.errorText : said);
    const std::string statistics = textIfThere(workshop.file(povrayStatisticsFile));
    times.parse = povraySeconds(statistics, "Parse Time");
    times.trace = povraySeconds(statistics, "Trace Time");
    return pictureOf(workshop, "povray", povrayPictureFile);
}

std::optional<double> povraySeconds(std::string_view statistics, std::string_view label) {
    const std::size_t at = statistics.find(label);
    if (at == std::string_view::npos) return std::nullopt;
    const std::string_view line = statistics.substr(at, statistics.find('\n', at) - at);
    const std::size_t open = line.find('('), end = line.find(" seconds)");
    if (open == std::string_view::npos || end == std::string_view::npos || end < open) return std::nullopt;
    const ParsedNumber seconds = parseNumber(line.substr(open + 1, end - open - 1));
    return seconds.error ? std::nullopt : std::optional(seconds.value);
}

} // namespace yarte::validate
