#include "validate/speed/povray_rays.h"

#include "validate/compare.h"
#include "validate/speed/numbers.h"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace yarte::validate {

namespace {

/// yarte-convert's comment above a body, as above a light: "// sphere, line 9".
bool isPlace(std::string_view line) {
    return line.starts_with("// ") && line.find(", line ") != std::string_view::npos &&
           !line.starts_with("// light");
}

std::string vector(Vec3 v) {
    return fmt::format("<{}, {}, {}>", printNumber(v.x), printNumber(v.y), printNumber(v.z));
}

/// Each prints how far away the ray meets Body, and the normal there: 0 if it meets it nowhere.
constexpr std::string_view macro = R"(
#macro Ask(Body, Origin, Direction)
    #local Normal = <0, 0, 0>;
    #local Place = trace(Body, Origin*World_Scale, Direction, Normal);
    #local Distance = vlength(Place - Origin*World_Scale)/World_Scale;
    #write (Answers, str(Distance, 0, 25), ",", str(Normal.x, 0, 25), ",", str(Normal.y, 0, 25), ",", str(Normal.z, 0, 25), "\n")
#end
)";

} // namespace

std::string askingScene(std::string_view sdl, std::size_t bodies, const std::vector<RayQuestion>& questions,
                        std::string_view file) {
    std::string text;
    std::size_t named = 0;
    bool isExpected = false; // the next object is a body
    while (!sdl.empty()) {
        const std::string_view line = sdl.substr(0, sdl.find('\n'));
        sdl.remove_prefix(std::min(sdl.size(), line.size() + 1));
        if (isPlace(line)) {
            isExpected = true;
        } else if (isExpected && !line.empty() && std::isalpha(static_cast<unsigned char>(line[0])) != 0) {
            text += fmt::format("#declare Body_{} = ", named++);
            isExpected = false;
        }
        text += line;
        text += '\n';
    }
    if (named != bodies)
        throw CaseError(fmt::format("yarte-convert wrote {} of {} bodies for POV-Ray", named, bodies));
    text += fmt::format("\n#fopen Answers \"{}\" write\n{}", file, macro);
    for (const RayQuestion& question : questions)
        text += fmt::format("Ask(Body_{}, {}, {})\n", question.body, vector(question.origin),
                            vector(question.direction));
    return text + "#fclose Answers\n";
}

std::vector<RayAnswer> answersIn(std::string_view text, const std::vector<RayQuestion>& questions) {
    std::vector<RayAnswer> answers;
    for (const RayQuestion& question : questions) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        if (line.find("nan") != std::string_view::npos) { // at a tip: where, but not with which normal
            answers.emplace_back();
            continue;
        }
        const auto numbers = numbersIn<4>(line);
        if (!numbers) throw CaseError(fmt::format("POV-Ray wrote an answer that cannot be read: {}", line));
        const auto& [distance, x, y, z] = *numbers;
        const bool isMet = Vec3{x, y, z} != Vec3{};
        answers.push_back(isMet ? RayAnswer{question.body, distance, {x, y, z}} : RayAnswer{});
    }
    return answers;
}

} // namespace yarte::validate
