#include "validate/report_html.h"

#include "validate/base64.h"
#include "validate/report_json.h"
#include "validate/report_page.h" // made by CMake of the files in validate/report
#include "yarte/base/file.h"

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

/// {"images/paper/yarte.png": "data:...", ...}. Names of files need no escapes: see caseNames.
std::string picturesJson(const Report& report, const std::filesystem::path& folder) {
    std::string json;
    for (const CaseReport& c : report.cases)
        for (const PictureRecord& picture : c.pictures) {
            const std::string file = folderOf(c) + "/" + picture.file;
            json += fmt::format("{}\"{}\": \"data:image/png;base64,{}\"", json.empty() ? "" : ",\n", file,
                                base64(readFile(folder / file)));
        }
    return "{" + json + "}";
}

/// `text` with the one place that says `marker` replaced.
std::string filled(std::string text, std::string_view marker, std::string_view value) {
    return text.replace(text.find(marker), marker.size(), value);
}

} // namespace

std::string htmlReport(const Report& report, const std::filesystem::path& folder) {
    std::string text(page::index_html);
    text = filled(std::move(text), "/*style*/", page::style_css);
    text = filled(std::move(text), "/*script*/", page::script_js);
    text = filled(std::move(text), "/*report*/", forScript(jsonReport(report)));
    return filled(std::move(text), "/*pictures*/", picturesJson(report, folder));
}

} // namespace yarte::validate
