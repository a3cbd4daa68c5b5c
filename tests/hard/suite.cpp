#include "tests/hard/suite.h"

#include "yarte/lang/pmf.h"
#include "yarte/lang/scene_reader.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace yarte::hard {
namespace {

Scene sceneOf(const std::string& bodies, const std::filesystem::path& folder) {
    static constexpr MeshFormat formats[] = {{".pmf", readPmf}};
    const std::string text =
        "camera_position 0 0 10\nfocus_point 0 0 0\nmaterial 0 0 0 1 1 1 0 0 0 1 0 0 0\n" + bodies;
    Sources sources;
    Diagnostics diagnostics;
    const auto scene = parseScene(sources.add("bodies", text), folder, {{}, formats}, sources, diagnostics);
    if (!scene) throw std::runtime_error("no scene:\n" + bodies);
    return *scene;
}

InputRay rayOf(const std::string& numbers) {
    std::istringstream in(numbers);
    double value[6];
    for (double& v : value) {
        std::string word;
        if (!(in >> word)) throw std::runtime_error("a ray has six numbers: " + numbers);
        v = std::strtod(word.c_str(), nullptr);
    }
    return {{value[0], value[1], value[2]}, {value[3], value[4], value[5]}};
}

/// Calls `visit(text, ray)` for every line; ray: the labelled ray that it begins, without its label.
template <class Visit>
void readLines(const std::filesystem::path& file, Visit&& visit) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    std::string name, bodies, text;
    int number = 0;
    bool inBodies = false;
    while (std::getline(in, text)) {
        std::optional<LabelledRay> ray;
        if (text.starts_with("scene ")) {
            name = text.substr(6), bodies.clear(), number = 0, inBodies = true;
        } else if (text.starts_with("ray ")) {
            ray = LabelledRay{name,
                              fmt::format("{}: {} {}", file.filename().string(), name, number++),
                              {sceneOf(bodies, file.parent_path()), rayOf(text.substr(4))},
                              {}};
        } else if (!text.starts_with("=") && !text.starts_with(";") && inBodies) {
            bodies += text + '\n';
        }
        visit(text, ray);
    }
}

} // namespace

std::string labelOf(const Case& c) {
    const Truth truth = truthOf(c.scene, c.ray);
    const auto exact = exactTruthOf(c.scene, c.ray);
    const std::string verdict = exact ? fmt::format("= hit {} {} {}\n", exact->body, exact->face,
                                                    exact->entering ? "enters" : "leaves")
                                      : "= miss\n";
    if (!truth.isDecidable)
        return verdict + "= proof tie\n" + (exact ? fmt::format("= t {}\n", toText(exact->t, 100)) : "");
    const bool isSame = exact.has_value() == truth.hit.has_value() &&
                        (!exact || (exact->body == truth.hit->body && exact->face == truth.hit->face));
    if (!isSame) throw std::logic_error("the oracle contradicts itself");
    std::string label =
        verdict + fmt::format("= proof {} {} {:.3e}\n", truth.deciding, toText(truth.value, 12), truth.range);
    if (const auto& hit = truth.hit) {
        label += fmt::format("= t {}\n", toText(hit->t, 100));
        const auto& n = hit->normal;
        label += fmt::format("= normal {} {} {}\n", toText(n.x, 30), toText(n.y, 30), toText(n.z, 30));
        label += fmt::format("= conditions {:.6e} {:.6e}\n", hit->tCondition, hit->normalCondition);
    }
    return label;
}

std::vector<LabelledRay> readRays(const std::filesystem::path& file) {
    std::vector<LabelledRay> rays;
    readLines(file, [&](const std::string& text, std::optional<LabelledRay>& ray) {
        if (ray)
            rays.push_back(std::move(*ray));
        else if (text.starts_with("=") && !rays.empty())
            rays.back().label += text + '\n';
    });
    return rays;
}

std::string labelled(const std::filesystem::path& file) {
    std::string result;
    readLines(file, [&](const std::string& text, const std::optional<LabelledRay>& ray) {
        if (text.starts_with("=")) return;
        if (ray && !ray->isTie() && !truthOf(ray->problem.scene, ray->problem.ray).isDecidable) return;
        result += text + '\n';
        if (ray) result += labelOf(ray->problem);
    });
    return result;
}

} // namespace yarte::hard
