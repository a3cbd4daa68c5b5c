#include "convert/povray/sdl/read.h"

#include "convert/povray/sdl/build_scene.h"
#include "convert/povray/sdl/parser.h"
#include "convert/povray/sdl/report.h"

namespace yarte::convert::povray {
namespace {

/// Of Debian's package povray-includes.
constexpr const char* povrayLibrary = "/usr/share/povray-3.7/include";

} // namespace

std::optional<Scene> readScene(Conversion& c) {
    const sdl::BuildOptions options{c.options.chordError, c.options.size};
    sdl::Report report(c.sources); // what a loop makes many times is one row
    sdl::Environment environment{
        .sources = c.sources,
        .diagnostics = c.diagnostics,
        .readable = c.input.readable,
        .writable = c.input.writable,
        .library = {povrayLibrary},
        .width = c.options.size.width,
        .height = c.options.size.height,
    };
    environment.report = [&](Span where, std::string what, std::string detail) {
        report.tell(what, where, {"everything", Action::dropped, std::move(detail)});
    };
    sdl::Parser parser;
    std::optional<sdl::Model> model;
    {
        sdl::Interpreter interpreter(std::move(environment), parser, c.input.text, c.input.file);
        try {
            model = parser.parse(interpreter);
        } catch (const sdl::SyntaxError& error) {
            c.diagnostics.error(error.code, error.what(), error.span).notes = interpreter.trace();
            return std::nullopt;
        }
    }
    report.writeTo(c.ledger);
    return sdl::buildScene(*model, options, c.sources, c.diagnostics, c.ledger);
}

} // namespace yarte::convert::povray
