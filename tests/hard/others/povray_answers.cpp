#include "tests/hard/others/povray_answers.h"

#include "convert/povray/body.h"
#include "convert/povray/extent.h"
#include "convert/povray/library.h"
#include "convert/povray/sdl_text.h"
#include "validate/program.h"
#include "validate/temporary_folder.h"
#include "yarte/base/file.h"
#include "yarte/scene/check.h"
#include "yarte/scene/referential.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <variant>

namespace yarte::hard {
namespace {

constexpr double largestExtent = 0x1p20, nearestCrossing = 0x1p-6;

/// How near to the start the line crosses something, ahead or behind.
double nearestAlong(const Case& c) {
    double nearest = INFINITY;
    for (const double sign : {1.0, -1.0})
        if (const auto hit = truthOf(c.scene, {c.ray.origin, sign * c.ray.direction}).hit)
            nearest = std::min(nearest, static_cast<double>(hit->t));
    return nearest;
}

/// Nothing if POV-Ray's tolerances would decide at any scale.
std::optional<double> scaleFor(const Case& c) {
    Scene scene = c.scene;
    scene.camera.position = c.ray.origin;
    for (const Body& body : scene.bodies)
        if (std::holds_alternative<Mesh>(body.shape) || !check(body.shape).empty()) return std::nullopt;
    const double nearest = nearestAlong(c);
    double extent = convert::povray::extentOf(scene);
    if (std::isfinite(nearest)) extent = std::max(extent, nearest);
    if (!(extent > 0) || !std::isfinite(extent)) return std::nullopt;
    const double scale = std::exp2(std::floor(std::log2(largestExtent / extent)));
    return nearest * scale >= nearestCrossing ? std::optional(scale) : std::nullopt;
}

/// SDL that writes a line for each body: a flag, the point, the normal. Axes are written as the rotation that
/// they stand for.
std::string askingText(const Case& c, double scale) {
    Scene scene = c.scene;
    std::string text = fmt::format("#declare World_Scale = {:.17g};\n", scale);
    const Sources sources;
    convert::Ledger ledger;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        scene.bodies[i].span = {}; // its text is not at hand
        if (auto& axes = scene.bodies[i].referential) {
            const Frame frame = resolveReferential(*axes);
            axes = Referential{frame.x, frame.y, frame.z};
        }
        text += "#declare Asked = " + convert::povray::bodyText(i, "Any", {scene, sources, true, ledger}) +
                fmt::format("Ask(Asked, {}*World_Scale, {})\n", convert::povray::sdl(c.ray.origin),
                            convert::povray::sdl(c.ray.direction));
    }
    return text;
}

constexpr const char* prologue = R"(#version 3.7;
global_settings { assumed_gamma 1 }
#declare Any = material { texture { pigment { rgb 1 } } }
#fopen Answers "answers.txt" write
#macro Ask(Asked, Start, Direction)
    #local N = <0, 0, 0>;
    #local P = trace(Asked, Start, Direction, N);
    #write(Answers, str(vlength(N), 0, 6), " ", str(P.x, 0, 25), " ", str(P.y, 0, 25), " ", str(P.z, 0, 25),
        " ", str(N.x, 0, 20), " ", str(N.y, 0, 20), " ", str(N.z, 0, 20), "\n")
#end
)";

std::optional<OtherHit> hitIn(const std::string& line, const Case& c, double scale, std::size_t body) {
    std::istringstream words(line);
    std::string flag, x, y, z, nx, ny, nz;
    if (!(words >> flag >> x >> y >> z >> nx >> ny >> nz))
        throw std::runtime_error("unexpected answer of POV-Ray: " + line);
    if (std::stod(flag) == 0) return std::nullopt;
    OtherHit hit{body, 0, {std::stod(nx), std::stod(ny), std::stod(nz)}}; // at a tip: not a number
    const auto real = [](Vec3 v) { return Vec<Real>{v.x, v.y, v.z}; };
    const Vec<Real> d = real(c.ray.direction),
                    way = Vec<Real>{Real(x), Real(y), Real(z)} - real(c.ray.origin) * Real(scale);
    hit.t = dot(way, d) / dot(d, d) / Real(scale);
    return hit;
}

} // namespace

std::vector<OtherAnswer> askPovray(const std::filesystem::path& povray, std::span<const Case> cases) {
    std::vector<std::optional<double>> scales;
    std::string questions;
    for (const Case& c : cases) {
        scales.push_back(scaleFor(c));
        if (scales.back()) questions += askingText(c, *scales.back());
    }
    const validate::TemporaryFolder folder(std::filesystem::temp_directory_path());
    std::ofstream(folder.path() / "ask.pov")
        << prologue << convert::povray::libraryFor(questions, true) << questions
        << "#fclose Answers\ncamera { location <0, 0, 0> look_at <0, 0, 1> }\n";
    const std::vector<std::string> command{povray, "+Iask.pov", "-D", "-F", "+W1", "+H1", "+WT1", "-GA"};
    const auto result =
        validate::run({command, folder.path(), {"HOME=" + folder.path().string()}}, validate::StopSignal{});
    std::ifstream answers(folder.path() / "answers.txt");
    if (!result.succeeded() || !answers) throw std::runtime_error("POV-Ray failed: " + result.errorText);

    std::vector<OtherAnswer> said(cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        said[i].wasAsked = scales[i].has_value();
        if (!said[i].wasAsked) continue;
        for (std::size_t body = 0; body < cases[i].scene.bodies.size(); ++body) {
            std::string line;
            if (!std::getline(answers, line)) throw std::runtime_error("answers of POV-Ray are missing");
            const auto hit = hitIn(line, cases[i], *scales[i], body);
            if (hit && (!said[i].hit || hit->t < said[i].hit->t)) said[i].hit = hit;
        }
    }
    return said;
}

} // namespace yarte::hard
