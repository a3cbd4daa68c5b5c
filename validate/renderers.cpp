#include "validate/renderers.h"

#include "validate/digest.h"
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
constexpr const char* aovFile = "aov.exr";
constexpr const char* aovPictureFile = "aov.pfm"; // not the one that was compared: nothing may touch that
constexpr const char* hitsFile = "hits.csv";
constexpr const char* hitsPictureFile = "hits.pfm";
constexpr const char* ledgerFile = "ledger.json";
constexpr const char* povrayProgramFile = "rays.pov";
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

std::vector<std::string> yarteCommand(const RenderSettings& settings, const std::filesystem::path& scene,
                                      const std::vector<std::string>& outputs) {
    std::vector<std::string> command = {found(settings.programs.yarte, "yarte", "--yarte"), scene};
    command.insert(command.end(), outputs.begin(), outputs.end());
    command.insert(command.end(), {"--progress", "none"});
    if (!settings.size.empty()) command.insert(command.end(), {"--size", settings.size});
    if (settings.processes)
        command.insert(command.end(), {"--processes", std::to_string(*settings.processes)});
    if (settings.samples != 1) command.insert(command.end(), {"--samples", std::to_string(settings.samples)});
    if (settings.fast) command.insert(command.end(), {"--precision", "fast"});
    return command;
}

/// POV-Ray has threads where YARTE has processes. 0 processes is YARTE's reference in a single process.
int povrayThreads(const RenderSettings& settings) {
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    return std::max(1, settings.processes.value_or(cores));
}

std::vector<std::string> povrayCommand(const RenderSettings& settings, const std::filesystem::path& scene,
                                       int width, int height) {
    // 16-bit linear values, one ray through each pixel's centre, no console but errors and statistics in
    // files.
    std::vector<std::string> command = {found(settings.programs.povray, "povray", "--povray"),
                                        fmt::format("+I{}", scene.string()),
                                        fmt::format("+O{}", povrayPictureFile),
                                        "+FP16",
                                        fmt::format("+W{}", width),
                                        fmt::format("+H{}", height),
                                        "-D",
                                        "-A",
                                        "-P",
                                        fmt::format("+WT{}", povrayThreads(settings)),
                                        "+Q9",
                                        "File_Gamma=1",
                                        "-GA",
                                        fmt::format("+GF{}", povrayErrorFile),
                                        fmt::format("+GS{}", povrayStatisticsFile)};
    if (scene.is_absolute()) command.push_back(fmt::format("+L{}", scene.parent_path().string()));
    return command;
}

/// On a busy machine POV-Ray may give up before it begins, as its threads are late. That says nothing of the
/// scene: it is asked again.
bool neverBegan(const ProgramResult& result) {
    return !result.succeeded() &&
           result.errorText.find("waiting for worker thread startup") != std::string::npos;
}

/// What POV-Ray has to read for a stranger's scene: the scene's folder, itself, and the system's files, where
/// its library of scenes lies too. Not /proc, nor all of /etc: they tell of users and other programs.
std::vector<std::filesystem::path> readableWith(const std::filesystem::path& povray,
                                                const std::filesystem::path& scene) {
    return {scene.parent_path(),
            povray.parent_path(),
            "/usr",
            "/bin",
            "/lib",
            "/lib64",
            "/etc/ld.so.cache",
            "/etc/localtime",
            "/etc/povray",
            "/dev/null",
            "/sys/devices/system",
            "/dev/urandom"};
}

PovrayTimes runPovray(Workshop& workshop, const std::vector<std::string>& command,
                      const std::optional<std::vector<std::filesystem::path>>& readable = {}) {
    constexpr int attempts = 3;
    ProgramResult result = workshop.run(command, povrayMemoryLimit, readable);
    for (int i = 1; i < attempts && neverBegan(result); ++i)
        result = workshop.run(command, povrayMemoryLimit, readable);
    const std::string said = cleanText(textIfThere(workshop.file(povrayErrorFile)));
    demandSuccess("povray", result, said.empty() ? result.errorText : said);
    const std::string statistics = textIfThere(workshop.file(povrayStatisticsFile));
    return {povraySeconds(statistics, "Parse Time"), povraySeconds(statistics, "Trace Time"), result.seconds,
            false};
}

/// All that decides POV-Ray's picture of a scene that includes no other file: the program, its options, the
/// scene.
std::string cacheInput(const Workshop& workshop, const std::vector<std::string>& command) {
    const std::filesystem::path program = std::filesystem::canonical(command[0]);
    std::string input = fmt::format("{} {}\n", digest(readFile(program)), program.filename().string());
    for (std::size_t i = 1; i < command.size(); ++i) input += command[i] + "\n";
    return input + readFile(workshop.file(povraySceneFile));
}

} // namespace

bool isPovrayScene(const std::filesystem::path& scene) { return scene.extension() == ".pov"; }

std::filesystem::path importScene(Workshop& workshop, const RenderSettings& settings,
                                  const std::filesystem::path& scene) {
    if (scene.extension() == ".yarte") return scene;
    const std::string convert = found(settings.programs.convert, "yarte-convert", "--convert");
    std::vector<std::string> command{convert, scene, importedSceneFile};
    if (isPovrayScene(scene) && !settings.size.empty()) // it may ask for its picture's size
        command.insert(command.end(), {"--size", settings.size});
    const ProgramResult conversion = workshop.run(command);
    demandSuccess("yarte-convert", conversion, conversion.errorText);
    return importedSceneFile; // relative, so that reports of the same scene have the same text
}

Picture renderWithYarte(Workshop& workshop, const RenderSettings& settings,
                        const std::filesystem::path& scene, YarteTimes& times) {
    const std::vector<std::string> command =
        yarteCommand(settings, scene, {"-o", yartePictureFile, "--stats", yarteStatisticsFile});
    const ProgramResult result = workshop.run(command);
    times.wall = result.seconds;
    demandSuccess("yarte", result, result.errorText);
    const std::string statistics = textIfThere(workshop.file(yarteStatisticsFile));
    times.trace = numberInJson(statistics, "trace_s");
    times.build = numberInJson(statistics, "build_s");
    times.inDouble = textInJson(statistics, "precision") != "fast";
    return pictureOf(workshop, "yarte", yartePictureFile);
}

Layers renderAov(Workshop& workshop, const RenderSettings& settings, const std::filesystem::path& scene) {
    const ProgramResult result =
        workshop.run(yarteCommand(settings, scene, {"-o", aovPictureFile, "--aov", aovFile}));
    demandSuccess("yarte --aov", result, result.errorText);
    try {
        return readLayers(workshop.file(aovFile));
    } catch (const ImageError& error) {
        throw CaseError(cleanText(error.what()));
    }
}

std::string renderHits(Workshop& workshop, const RenderSettings& settings,
                       const std::filesystem::path& scene) {
    const ProgramResult result =
        workshop.run(yarteCommand(settings, scene, {"-o", hitsPictureFile, "--hits", hitsFile}));
    demandSuccess("yarte --hits", result, result.errorText);
    return textIfThere(workshop.file(hitsFile));
}

void canonicalScene(Workshop& workshop, const RenderSettings& settings, const std::filesystem::path& scene) {
    const ProgramResult result = workshop.run(
        {found(settings.programs.convert, "yarte-convert", "--convert"), scene, canonicalSceneFile});
    demandSuccess("yarte-convert", result, result.errorText);
}

Conversion tessellateScene(Workshop& workshop, const RenderSettings& settings,
                           const std::filesystem::path& scene, double chordError) {
    const ProgramResult result = workshop.run({found(settings.programs.convert, "yarte-convert", "--convert"),
                                               scene, tessellatedSceneFile, "--tessellate", "--chord-error",
                                               printNumber(chordError), "--report", ledgerFile});
    demandSuccess("yarte-convert --tessellate", result, result.errorText);
    const LedgerTotals totals = tessellationInLedger(textIfThere(workshop.file(ledgerFile)));
    return {result.seconds, totals.triangles, totals.deviation};
}

void convertForPovray(Workshop& workshop, const RenderSettings& settings, const std::filesystem::path& scene,
                      double exposure) {
    found(settings.programs.povray, "povray", "--povray"); // what is missing is said before anything is done
    const std::string convert = found(settings.programs.convert, "yarte-convert", "--convert");
    const ProgramResult conversion =
        workshop.run({convert, scene, povraySceneFile, "--exposure", printNumber(exposure)});
    demandSuccess("yarte-convert", conversion, conversion.errorText);
}

Picture renderWithPovray(Workshop& workshop, const RenderSettings& settings,
                         const std::filesystem::path& scene, int width, int height, PovrayTimes& times) {
    const std::vector<std::string> command = povrayCommand(settings, scene, width, height);
    const bool isStrangers = scene.is_absolute();
    if (!settings.cache || isStrangers) {
        times = isStrangers ? runPovray(workshop, command, readableWith(command[0], scene))
                            : runPovray(workshop, command);
        return pictureOf(workshop, "povray", povrayPictureFile);
    }
    const std::string input = cacheInput(workshop, command);
    if (const auto entry = settings.cache->find(input)) {
        writeFile(workshop.file(povrayPictureFile), entry->picture);
        workshop.record(command, "not run: its picture is in the cache");
        times = entry->times;
        return pictureOf(workshop, "povray", povrayPictureFile);
    }
    times = runPovray(workshop, command);
    Picture picture = pictureOf(workshop, "povray", povrayPictureFile); // before it is kept: it can be read
    settings.cache->store(input, {readFile(workshop.file(povrayPictureFile)), times});
    return picture;
}

std::string runPovrayProgram(Workshop& workshop, const RenderSettings& settings, const std::string& sdl) {
    writeFile(workshop.file(povrayProgramFile), sdl);
    runPovray(workshop, povrayCommand(settings, povrayProgramFile, 1, 1));
    return textIfThere(workshop.file(rayAnswersFile));
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
