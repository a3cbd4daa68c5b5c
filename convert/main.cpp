// yarte-convert: reads a scene or mesh in one format and writes it in another.

#include "convert/convert.h"
#include "yarte/base/file.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <unistd.h>

namespace {

using namespace yarte;

constexpr int good = 0, answerIsNo = 1, couldNotRun = 3, interrupted = 130;

/// While one lives, SIGINT waits: outputs are written whole or not at all.
class InterruptsWait {
public:
    InterruptsWait() {
        sigset_t wait;
        sigemptyset(&wait), sigaddset(&wait, SIGINT);
        sigprocmask(SIG_BLOCK, &wait, &before_);
    }
    ~InterruptsWait() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
    InterruptsWait(const InterruptsWait&) = delete;
    InterruptsWait& operator=(const InterruptsWait&) = delete;

private:
    sigset_t before_{};
};

DiagnosticStyle diagnosticStyle(bool json) {
    if (json) return DiagnosticStyle::json;
    const char* noColour = std::getenv("NO_COLOR");
    const bool wanted = isatty(STDERR_FILENO) && (noColour == nullptr || *noColour == '\0');
    return wanted ? DiagnosticStyle::coloured : DiagnosticStyle::plain;
}

void write(const std::vector<convert::OutputFile>& files) {
    if (const convert::OutputFile& only = files.front(); only.file.empty()) {
        if (std::fwrite(only.bytes.data(), 1, only.bytes.size(), stdout) != only.bytes.size() ||
            std::fflush(stdout) != 0)
            throw FileError("<stdout>", "could not be written");
        return;
    }
    const InterruptsWait wait;
    // The main file last: it names the others.
    for (auto file = files.rbegin(); file != files.rend(); ++file) writeFile(file->file, file->bytes);
}

int run(const convert::Options& options) {
    Sources sources;
    Diagnostics diagnostics;
    convert::Ledger ledger;
    const std::vector<convert::OutputFile> files = convert::convert(options, sources, diagnostics, ledger);
    fmt::print(stderr, "{}", format(diagnostics, sources, diagnosticStyle(options.jsonDiagnostics)));
    if (files.empty()) return answerIsNo;
    write(files);
    if (options.report) write({{*options.report, toJson(ledger)}});
    return options.strict && ledger.hasLoss() ? answerIsNo : good;
}

} // namespace

int main(int argc, char** argv) {
    std::signal(SIGINT, [](int) { _exit(interrupted); });
    letLargeWritesFail();
    const convert::ParsedOptions parsed = convert::parseOptions(argc, argv);
    if (!parsed.options) {
        fmt::print(parsed.exitCode == good ? stdout : stderr, "{}", parsed.text);
        return parsed.exitCode;
    }
    try {
        return run(*parsed.options);
    } catch (const FileError& error) {
        fmt::print(stderr, "yarte-convert: error: {}\n", error.what());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "yarte-convert: error: out of memory\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "yarte-convert: error: {}\n", error.what());
    }
    return couldNotRun;
}
