#include "validate/speed/speed_html.h"

#include "validate/report_page.h" // made by CMake of the files in validate/report
#include "validate/speed/speed_plots.h"
#include "validate/speed/speed_text.h"
#include "validate/text.h"

#include <fmt/format.h>

namespace yarte::validate {

namespace {

std::string row(const char* element, std::initializer_list<std::string> cells) {
    std::string text = "<tr>";
    for (const std::string& cell : cells) text += fmt::format("<{0}>{1}</{0}>", element, cell);
    return text + "</tr>\n";
}

/// The first column is text, the others are numbers; wide ones scroll by themselves.
std::string table(const std::string& head, const std::string& rows) {
    if (rows.empty()) return {};
    return fmt::format("<div class=\"scroll\"><table><thead>{}</thead><tbody>\n{}</tbody></table></div>\n",
                       head, rows);
}

std::string note(const std::string& text) {
    return text.empty() ? "" : fmt::format("<p class=\"faint\">{}</p>\n", markupText(text));
}

std::string number(double value) { return value == 0 ? "0" : fmt::format("{:.2e}", value); }

std::string timeCell(const Seconds& s) {
    if (!s.median) return "?";
    return fmt::format("<span title=\"{:.4g} to {:.4g} s\">{}</span>", *s.least, *s.most, secondsText(s));
}

std::string raysTable(const Rays& rays) {
    std::string rows;
    for (const RayErrors& r : rays.programs)
        rows += row("td", {markupText(r.name), fmt::format("{}", r.compared), fmt::format("{}", r.otherwise),
                           number(r.distance.median), number(r.distance.rms), number(r.distance.max),
                           number(r.normal.median), number(r.normal.rms), number(r.normal.max)});
    return table(row("th", {"program", "rays", "meet something else", "distance: median", "rms", "max",
                            "normal: median", "rms", "max"}),
                 rows);
}

std::string pixelsTable(const SpeedCase& c) {
    std::string rows;
    for (const SamplesCurve& curve : c.curves)
        for (const SamplesPoint& p : curve.points)
            rows += row("td", {markupText(curve.name), fmt::format("{0} × {0}", p.samples), timeCell(p.trace),
                               timeCell(p.wall), number(p.error.rmse), number(p.error.maxAbs),
                               p.fromDouble ? number(p.fromDouble->rmse) : "",
                               p.fromDouble ? number(p.fromDouble->maxAbs) : ""});
    return table(row("th", {"program", "samples", "trace", "whole run", "RMS error", "largest",
                            "from double: RMS", "largest"}),
                 rows);
}

std::string trianglesTable(const Tessellation& t) {
    if (t.points.empty()) return {};
    std::string rows = row("td", {"exact shapes", "", "", "", timeCell(t.exactBuild), timeCell(t.exactTrace),
                                  timeCell(t.exactWall), "0", "0"});
    for (const TessellationPoint& p : t.points)
        rows +=
            row("td", {fmt::format("{:.3g}", p.chordError), fmt::format("{:.3g}", p.deviation),
                       fmt::format("{}", p.triangles), timeCell(p.convert), timeCell(p.build),
                       timeCell(p.trace), timeCell(p.wall), number(p.error.rmse), number(p.error.maxAbs)});
    return table(row("th", {"chord error asked for", "largest deviation", "triangles", "converting",
                            "building", "trace", "whole run", "RMS error", "largest"}),
                 rows);
}

/// The diagrams whose names begin so.
std::string plotsText(const std::vector<NamedPlot>& plots, const std::string& prefix) {
    std::string text;
    for (const NamedPlot& plot : plots)
        if (plot.file.starts_with(prefix))
            text += fmt::format("<figure class=\"card\">{}</figure>\n", svg(plot.plot));
    return text.empty() ? "" : fmt::format("<div class=\"plots\">\n{}</div>\n", text);
}

/// What was not measured has its note and no more.
std::string section(const char* title, const std::string& explanation, const std::string& reason,
                    const std::string& content) {
    return fmt::format("<h3>{}</h3>\n{}{}{}", title,
                       content.empty() ? "" : fmt::format("<p class=\"faint\">{}</p>\n", explanation),
                       note(reason), content);
}

std::string caseText(const SpeedCase& c) {
    std::string text = fmt::format("<section>\n<h2>{}</h2>\n<p class=\"faint\">{}{}</p>\n",
                                   markupText(c.name), markupText(c.source),
                                   c.width > 0 ? fmt::format(", {} × {} pixels", c.width, c.height) : "");
    if (!c.message.empty())
        return text +
               fmt::format("<pre class=\"message error\">{}</pre>\n</section>\n", markupText(c.message));
    const std::vector<NamedPlot> plots = plotsOf(c);
    const std::string prefix = fmt::format("plots/{}-", c.name);
    text +=
        section("Rays",
                fmt::format("What the rays through the centres of {} × {} pixels meet, against numbers of "
                            "fifty digits; {} meet something. Distances are relative, normals in radians.",
                            c.rays.width, c.rays.height, c.rays.met),
                c.rays.note, plotsText(plots, prefix + "rays") + raysTable(c.rays));
    text += section("Pixels",
                    fmt::format("Pictures of N × N samples a pixel (the numbers at the points), against "
                                "YARTE's of {0} × {0} in double. Linear light, 1 = white{1}.",
                                c.referenceSamples,
                                c.exposure == 1
                                    ? ""
                                    : fmt::format("; POV-Ray's files hold light times {:g}", c.exposure)),
                    c.note, plotsText(plots, prefix + "pixels") + pixelsTable(c));
    text += section(
        "Triangles",
        "The scene with triangles for its curved shapes, one ray a pixel, against the exact shapes at "
        "as many rays. Lengths are in scene units.",
        c.tessellation.note, plotsText(plots, prefix + "triangles") + trianglesTable(c.tessellation));
    std::string commands;
    for (const CommandRecord& command : c.commands) commands += markupText(command.line) + "\n";
    return text + fmt::format("<details><summary>{} commands</summary><pre>{}</pre></details>\n</section>\n",
                              c.commands.size(), commands);
}

std::string introduction(const SpeedReport& report) {
    return fmt::format(
        "<p>Times are medians of {} run{} in turn, with {} process{} of YARTE and as many threads "
        "of POV-Ray. Lower and further left is better. YARTE {}.</p>\n",
        report.runs, report.runs == 1 ? "" : "s", report.processes, report.processes == 1 ? "" : "es",
        markupText(report.version));
}

/// `text` with the one place that says `marker` replaced.
std::string filled(std::string text, std::string_view marker, std::string_view value) {
    return text.replace(text.find(marker), marker.size(), value);
}

} // namespace

std::string speedHtml(const SpeedReport& report) {
    std::string content = introduction(report);
    for (const SpeedCase& c : report.cases) content += caseText(c);
    // From the end, so that no marker is looked for in what a report says.
    std::string text = filled(std::string(page::speedHtml), "<!--content-->", content);
    return filled(std::move(text), "/*style*/", fmt::format("{}{}", page::speedStyle, page::plot));
}

} // namespace yarte::validate
