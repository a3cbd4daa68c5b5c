// yarte-validate: renders scenes with YARTE and POV-Ray, compares or measures, and reports.
#include "validate/baseline.h"
#include "validate/options.h"
#include "validate/report_annotations.h"
#include "validate/report_html.h"
#include "validate/report_json.h"
#include "validate/report_junit.h"
#include "validate/report_markdown.h"
#include "validate/report_text.h"
#include "validate/run.h"
#include "validate/speed/speed_html.h"
#include "validate/speed/speed_json.h"
#include "validate/speed/speed_plots.h"
#include "validate/speed/speed_run.h"
#include "validate/speed/speed_text.h"
#include "yarte/base/diagnostic.h"
#include "yarte/base/file.h"
#include "yarte/version.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <new>
#include <system_error>
#include <unistd.h>

namespace {

using namespace yarte;
using namespace yarte::validate;
namespace fs = std::filesystem;

constexpr int exitGood = 0, exitDiffers = 1, exitCouldNotRun = 3, exitSignal = 128;

void print(FILE* stream, const std::string& text) {
    fmt::print(stream, "{}", text);
    std::fflush(stream);
}

std::string environment(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? "" : value;
}

std::vector<fs::path> pathFolders() {
    std::vector<fs::path> folders;
    const std::string path = environment("PATH");
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find(':', begin), path.size());
        if (end > begin) folders.push_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    return folders;
}

/// The program a user named, or the one found, or nothing; absolute, because programs run in other folders.
fs::path locate(const fs::path& named, const std::string& name, const std::vector<fs::path>& folders) {
    const fs::path path = named.empty() ? findProgram(name, folders).value_or(fs::path()) : named;
    return path.empty() ? path : fs::absolute(path);
}

Programs locatePrograms(const Options& options) {
    const std::vector<fs::path> path = pathFolders();
    std::vector<fs::path> besideFirst = {fs::read_symlink("/proc/self/exe").parent_path()};
    besideFirst.insert(besideFirst.end(), path.begin(), path.end());
    return {locate(options.yarte, "yarte", besideFirst),
            locate(options.convert, "yarte-convert", besideFirst), locate(options.povray, "povray", path)};
}

/// The line of a case; on a terminal its verdict is coloured.
std::string consoleLine(const CaseReport& c, bool coloured) {
    std::string line = caseLine(c);
    if (coloured) {
        const std::string verdict = name(c.verdict);
        const char* const colour = c.verdict == Verdict::pass   ? "32"
                                   : c.verdict == Verdict::fail ? "31"
                                                                : "33";
        line.replace(0, verdict.size(), fmt::format("\x1b[{}m{}\x1b[0m", colour, verdict));
    }
    return line + "\n";
}

/// Before anything is rendered: a report that cannot be written is found out now. `inner`: what it has a
/// folder for.
void prepareFolder(const fs::path& folder, const char* inner) {
    std::error_code error;
    fs::create_directories(folder / inner, error);
    if (error) throw FileError(folder, error.message());
    if (::access((folder / inner).c_str(), W_OK | X_OK) != 0)
        throw FileError(folder, std::generic_category().message(errno));
}

void writeReport(const Report& report, const fs::path& folder) {
    writeFile(folder / "report.json", jsonReport(report));
    writeFile(folder / "junit.xml", junitReport(report));
    writeFile(folder / "summary.md", markdownReport(report));
    writeFile(folder / "index.html", htmlReport(report));
}

int validateAll(const Options& options) {
    prepareFolder(options.output, "images");
    const StopSignal stop;
    const bool coloured = ::isatty(STDOUT_FILENO) != 0 && environment("NO_COLOR").empty();
    const RunResult result = runCases(options, locatePrograms(options), stop,
                                      [&](const CaseReport& c) { print(stdout, consoleLine(c, coloured)); });
    const Report& report = result.report;
    writeReport(report, options.output);
    if (options.updateBaseline) print(stdout, baselineLine(report, result.removed) + "\n");
    print(stdout,
          fmt::format("{}\nreport: {}\n", summaryLine(report), (options.output / "index.html").string()));
    if (environment("GITHUB_ACTIONS") == "true")
        print(stdout, githubAnnotations(report, environment("GITHUB_WORKSPACE")));
    switch (report.verdict()) {
    case Verdict::pass: return exitGood;
    case Verdict::fail: return exitDiffers;
    case Verdict::error: break;
    }
    return exitCouldNotRun;
}

int measureSpeed(const Options& options) {
    prepareFolder(options.output, "plots");
    const StopSignal stop;
    const SpeedReport report = runSpeed(options, locatePrograms(options), stop,
                                        [](const SpeedCase& c) { print(stdout, speedCaseText(c)); });
    for (const SpeedCase& c : report.cases)
        for (const NamedPlot& plot : plotsOf(c)) writeFile(options.output / plot.file, svgFile(plot.plot));
    writeFile(options.output / "speed.json", speedJson(report));
    writeFile(options.output / "index.html", speedHtml(report));
    print(stdout, fmt::format("report: {}\n", (options.output / "index.html").string()));
    const bool isComplete = std::all_of(report.cases.begin(), report.cases.end(),
                                        [](const SpeedCase& c) { return c.message.empty(); });
    return isComplete ? exitGood : exitCouldNotRun;
}

/// Says why the run ends without a report.
int couldNotRun(const Options& options, const std::string& message) {
    if (!options.jsonDiagnostics) {
        print(stderr, fmt::format("yarte-validate: {}\n", message));
    } else {
        Diagnostics diagnostics;
        diagnostics.error("validate.could-not-run", message);
        print(stderr, format(diagnostics, Sources(), DiagnosticStyle::json));
    }
    return exitCouldNotRun;
}

} // namespace

int main(int argc, char** argv) {
    letLargeWritesFail();
    const ParsedOptions parsed = parseOptions(argc, argv);
    if (!parsed.options) {
        print(parsed.exitCode == 0 ? stdout : stderr, parsed.text);
        return parsed.exitCode;
    }
    try {
        return parsed.options->speed ? measureSpeed(*parsed.options) : validateAll(*parsed.options);
    } catch (const Interrupted& interrupted) {
        couldNotRun(*parsed.options, interrupted.what());
        return exitSignal + interrupted.signal();
    } catch (const std::bad_alloc&) {
        return couldNotRun(*parsed.options, "not enough memory");
    } catch (const std::exception& error) {
        return couldNotRun(*parsed.options, error.what());
    }
}
