// Scenes that others wrote for POV-Ray, YARTE's import of them against POV-Ray's own picture of the original.
// Two demands: the pictures agree but for few pixels; and they agree in every pixel once POV-Ray is asked for
// the original without the three things in which it or its file is coarser than YARTE's model: what it drops
// (adc_bailout), its tolerances, which are absolute, and a camera whose vectors are rounded to six digits.
//
// YARTE_AGREEMENT_SIZE=512x512 takes all the scenes at that size, with a table of how many pixels each of the
// three explains.
#include "tests/support/povray.h"
#include "tests/support/program.h"

#include "convert/povray/sdl/read.h"
#include "yarte/base/file.h"
#include "yarte/base/number.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <numbers>

namespace yarte::convert::test {
namespace {

namespace fs = std::filesystem;

struct Case {
    std::string scene;
    double apart = 0.001; ///< part of the pixels that may differ by more than 2/255
    double amplified = 0; ///< part that may differ from the adapted original by more than 4/65535
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.scene; }

const char* fullSize() { return std::getenv("YARTE_AGREEMENT_SIZE"); }

std::vector<Case> cases() {
    std::vector<Case> list;
    for (const char* all :
         {"balls_1", "balls_2", "jacks_1", "lattice_1", "mount_1", "mount_2", "mount_3", "rings_2",
          "shells_1", "teapot_2", "tetra_1", "tetra_2", "tetra_3", "tree_1", "tree_2", "tree_3"})
        if (fullSize() != nullptr) list.push_back({all});
    for (const char* some : {"balls_3", "jacks_2", "lattice_4", "mount_4", "rings_1", "rings_4", "shells_4",
                             "teapot_1", "teapot_4", "tetra_4", "tree_4"})
        list.push_back({some});
    // Mirrors within mirrors: the sixth digit of the camera's vectors shows, and at last the sixteenth of all
    // numbers.
    list.push_back({"balls_4", 0.005, 0.0001});
    list.push_back({"jacks_4", 0.001, 0.0003});
    // Where the gears' bodies touch, POV-Ray's tolerances show, and at last rounding.
    list.push_back({"gears_1", 0.002}), list.push_back({"gears_2", 0.002, 0.0001});
    std::sort(list.begin(), list.end(), [](const Case& a, const Case& b) { return a.scene < b.scene; });
    return list;
}

/// What POV-Ray is asked for instead of the original.
struct Adaptation {
    bool ownCamera = false;  ///< the import's, whose vectors are perpendicular
    bool keepsFaint = false; ///< adc_bailout 0
    double scale = 1;        ///< of all lengths; a power of two
};

std::string withoutComments(const std::string& text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t comment = std::min(text.find("//", at), text.size());
        result.append(text, at, comment - at);
        at = std::min(text.find('\n', comment), text.size());
    }
    return result;
}

/// These files have lengths in two places only: in vectors, and as a radius after a vector and a comma.
/// Factors and angles are vectors, too.
std::string scaled(const std::string& text, double factor) {
    std::string result;
    bool isVector = false, isLength = false;
    const char* const end = text.data() + text.size();
    for (const char* at = text.data(); at < end;) {
        double value = 0;
        const bool isNumber = std::string_view("-.0123456789").find(*at) != std::string_view::npos &&
                              (result.empty() || !std::isalnum(static_cast<unsigned char>(result.back())));
        if (const auto read = std::from_chars(at, end, value); isNumber && read.ec == std::errc()) {
            result += isLength ? printNumber(value * factor) : std::string(at, read.ptr);
            isLength = isVector && isLength;
            at = read.ptr;
            continue;
        }
        if (*at == '<')
            isVector = true, isLength = !result.ends_with("scale ") && !result.ends_with("rotate ");
        else if (*at == '>')
            isVector = isLength = false;
        else if (*at == ',' && !isVector && result.ends_with('>'))
            isLength = true;
        else if (std::isalpha(static_cast<unsigned char>(*at)))
            isLength = false;
        result += *at++;
    }
    return result;
}

std::string cameraText(const Camera& camera, double scale) {
    const Vec3 forward = normalised(camera.focus - camera.position);
    const Vec3 right = normalised(cross(forward, camera.up)), up = cross(right, forward);
    const auto tangent = [](double degrees) { return std::tan(degrees * std::numbers::pi / 180); };
    const auto text = [](Vec3 v) {
        return fmt::format("<{}, {}, {}>", printNumber(v.x), printNumber(v.y), printNumber(v.z));
    };
    return fmt::format("camera {{ location {} direction {} right {} up {} }}\n",
                       text(scale * camera.position), text(forward),
                       text(2 * tangent(camera.horizontalApertureDegrees) * right),
                       text(2 * tangent(camera.verticalApertureDegrees) * up));
}

Camera importedCamera(const fs::path& file, const std::string& text) {
    Sources sources;
    Diagnostics diagnostics;
    Ledger ledger;
    Conversion conversion{
        {sources.add(file.string(), text), file, {}}, "out", {}, sources, diagnostics, ledger};
    const auto scene = povray::readScene(conversion);
    EXPECT_TRUE(scene) << format(diagnostics, sources, DiagnosticStyle::plain);
    return scene ? scene->camera : Camera{};
}

std::string adapted(const fs::path& original, const Adaptation& wanted) {
    std::string text = withoutComments(readFile(original));
    const Camera camera = importedCamera(original, text);
    if (wanted.ownCamera) {
        const std::size_t at = text.find("camera {");
        text.erase(at, text.find('}', at) + 1 - at);
    }
    text = scaled(text, wanted.scale);
    if (wanted.ownCamera) text = cameraText(camera, wanted.scale) + text;
    return (wanted.keepsFaint ? "global_settings { adc_bailout 0 }\n" : "") + text;
}

struct Measured {
    double maxAbs = 0;
    int over = 0, pixels = 0;
    bool has(double part) const { return over > part * pixels; }
};

/// By yarte-validate; pictures and differences stay in `report`.
Measured compare(const fs::path& scene, const std::string& size, const std::string& threshold,
                 const fs::path& folder, const std::string& report) {
    writeFile(folder / "tolerance.json",
              fmt::format(R"({{"pixels_over": {{"threshold": "{}", "count": 0}}, "reason": "a count"}})",
                          threshold));
    const auto result = yarte::test::run("yarte-validate",
                                         {scene.string(), "--size", size, "--jobs", "1", "--tolerance",
                                          (folder / "tolerance.json").string(), "-o", report},
                                         folder);
    const auto json = nlohmann::json::parse(readFile(folder / report / "report.json")).at("cases").at(0);
    EXPECT_NE(json.at("verdict"), "error") << result.out << result.err;
    if (json.at("verdict") == "error") return {};
    return {json.at("max_abs"), json.at("pixels_over").at("count"),
            int{json.at("width")} * int{json.at("height")}};
}

class SpdAgreement : public testing::TestWithParam<Case> {};

TEST_P(SpdAgreement, PicturesAreEqualButForWhatIsExplained) {
    if (std::string(YARTE_CORPORA).empty()) GTEST_SKIP() << "skipped: YARTE_CORPORA is empty";
    if (!yarte::test::hasPovray()) GTEST_SKIP() << "skipped: povray not found";
    const Case& c = GetParam();
    const fs::path original = fs::path(YARTE_CORPORA) / "spd" / (c.scene + ".pov"),
                   folder = yarte::test::emptyTestFolder();
    const std::string size = fullSize() != nullptr ? fullSize() : "128x128";

    const auto adaptedOver = [&](const char* name, const Adaptation& adaptation) {
        writeFile(folder / (std::string(name) + ".pov"), adapted(original, adaptation));
        return compare(folder / (std::string(name) + ".pov"), size, "4/65535", folder, name);
    };
    const Measured plain = compare(original, size, "2/255", folder, "original");
    EXPECT_FALSE(plain.has(c.apart)) << plain.over
                                     << " pixels differ by more than 2/255; pictures: " << folder;
    const Measured all = adaptedOver("adapted", {true, true, 4096});
    EXPECT_FALSE(all.has(c.amplified)) << all.over << " pixels are not explained; pictures: " << folder;
    if (fullSize() == nullptr) return;

    const int none = compare(original, size, "4/65535", folder, "steps").over;
    const int camera = adaptedOver("camera", {true, false, 1}).over;
    const int faint = adaptedOver("faint", {true, true, 1}).over;
    fmt::print("| {} | {:.3f} % | {:.4f} | {} | {} | {} | {} | {} | {:.2f}/65535 |\n", c.scene,
               100.0 - 100.0 * plain.over / plain.pixels, plain.maxAbs, none, none - camera, camera - faint,
               faint - all.over, all.over, all.maxAbs * 65535);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SpdAgreement, testing::ValuesIn(cases()),
                         [](const auto& c) { return c.param.scene; });

} // namespace
} // namespace yarte::convert::test
