#include "validate/report_html.h"

#include "validate/report_json.h"
#include "validate/report_page.h" // made by CMake of the files in validate/report
#include "yarte/base/base64.h"
#include "yarte/base/number.h"

#include <fmt/format.h>

namespace yarte::validate {

namespace {

/// JSON inside a script element: without '<' nothing in it can end the element.
std::string forScript(const std::string& json) {
    std::string text;
    for (const char c : json) {
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    }
    return text;
}

/// What the page must know to unpack and place a case's pixels, as JSON.
std::string pageJson(const PagePixels& page) {
    if (page.width == 0) return "{\"width\": 0, \"thumbnail\": null}";
    return fmt::format("{{\"width\": {}, \"height\": {}, \"reduction\": {}, \"offset\": {}, \"unit\": {}, "
                       "\"thumbnail\": \"data:image/png;base64,{}\"}}",
                       page.width, page.height, page.reduction, printNumber(page.offset),
                       printNumber(page.unit), base64(page.thumbnail));
}

std::string pagesJson(const Report& report) {
    std::string json;
    for (const CaseReport& c : report.cases)
        json += fmt::format("{}{}", json.empty() ? "" : ",\n", pageJson(c.page));
    return fmt::format("[{}]", json);
}

/// A block of data for each case: the browser does not look at it before the script does.
std::string pixelBlocks(const Report& report) {
    std::string html;
    for (std::size_t i = 0; i < report.cases.size(); ++i) {
        const PagePixels& page = report.cases[i].page;
        if (page.width == 0) continue;
        html += fmt::format("<script type=\"text/plain\" id=\"pixels-{}\">{}", i, base64(page.reference));
        if (!page.difference.empty())
            html += fmt::format(" {} {}", base64(page.difference), base64(page.flip));
        html += "</script>\n";
    }
    return html;
}

/// `text` with the one place that says `marker` replaced.
std::string filled(std::string text, std::string_view marker, std::string_view value) {
    return text.replace(text.find(marker), marker.size(), value);
}

} // namespace

std::string htmlReport(const Report& report) {
    std::string text(page::html);
    // From the end, so that no marker is looked for in what a report says.
    text = filled(std::move(text), "/*script*/", page::script);
    text = filled(std::move(text), "/*pixels*/", pixelBlocks(report));
    text = filled(std::move(text), "/*pages*/", pagesJson(report));
    text = filled(std::move(text), "/*report*/", forScript(jsonReport(report)));
    return filled(std::move(text), "/*style*/", page::style);
}

} // namespace yarte::validate
