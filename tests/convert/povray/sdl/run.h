// SDL text run in memory: what it prints with #debug, what it describes, what is wrong with it.
#pragma once

#include "convert/povray/sdl/parser.h"

#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace yarte::convert::povray::sdl::test {

/// The lines that begin with '@': what a program prints among all that POV-Ray says.
inline std::vector<std::string> markedLines(const std::string& text) {
    std::vector<std::string> list;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with('@')) list.push_back(line);
    return list;
}

struct SdlRun {
    Sources sources;
    Diagnostics diagnostics;
    std::string printed; ///< by #debug
    std::vector<std::string> reported;
    std::optional<Model> model;

    explicit SdlRun(const std::string& text, const std::filesystem::path& file = "scene.pov",
                    const Limits& limits = {}, const std::optional<std::filesystem::path>& writable = {}) {
        Parser parser;
        Environment environment{.sources = sources, .diagnostics = diagnostics, .readable = {}};
        environment.library = {"/usr/share/povray-3.7/include"};
        environment.limits = limits, environment.writable = writable;
        environment.debug = [this](const std::string& s) { printed += s; };
        environment.report = [this](Span, const std::string& what, const std::string&) {
            reported.push_back(what);
        };
        Interpreter in(environment, parser, sources.add(file.string(), text), file);
        try {
            model = parser.parse(in);
        } catch (const SyntaxError& error) {
            diagnostics.error(error.code, error.what(), error.span).notes = in.trace();
        }
    }

    std::string problems() const { return format(diagnostics, sources, DiagnosticStyle::plain); }
};

/// What #debug prints for "EXPRESSION", a string.
inline std::string printedBy(const std::string& statements) {
    const SdlRun run(statements);
    return run.printed + run.problems();
}

} // namespace yarte::convert::povray::sdl::test
