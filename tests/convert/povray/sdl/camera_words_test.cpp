// A camera's words in many orders: every pixel's ray is POV-Ray's. It renders them within a sphere whose
// colour says where the ray met it, all as the frames of one animation.
#include "tests/convert/povray/sdl/run.h"
#include "tests/support/povray.h"
#include "tests/support/program.h"
#include "yarte/base/file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace yarte::convert::povray::sdl::test {
namespace {

namespace fs = std::filesystem;

constexpr int side = 3; // of the pictures, in pixels
constexpr double radius = 20;
using Hits = std::vector<Vec3>;

const std::vector<std::string> written{
    "camera { look_at <1, 2, 3> location <1, 0, -4> }",
    "camera { rotate y*20 look_at <1, 2, 3> sky x }",
    "camera { location <1, 1, -4> look_at <1, 2, 3> look_at <2, 2, 3> direction z*2 }",
    "camera { location <1, 1, -4> look_at <1, 2, 3> right -x*1.33 }",
    "camera { location <1, 1, -4> angle 50 right x direction z*3 }",
    "camera { location <1, 1, -4> scale <2, -1, 1> look_at <1, 2, 3> }",
    // Along the sky, and nearly.
    "camera { location <1, 1, -4> look_at <1, 5, -4> }",
    "camera { location <1, 1, -4> look_at <1, -5, -4> right -x }",
    "camera { location <1, 1, -4> look_at <1, 5, -4> right <-1, 0.1, 0.4> }",
    "camera { location <1, 1, -4> look_at <1.00001, 5, -4> }",
    "camera { location <1, 1, -4> sky z look_at <1, 1, -9> }",
    "camera { location <1, 1, -4> sky <1, 1, 0> look_at <3, 3, -4> }",
    // Copies.
    "#declare C = camera { location <1, 1, -4> angle 50 look_at 0 } camera { C rotate y*20 scale 2 }",
    "#declare C = camera { orthographic location <1, 1, -4> angle 50 look_at 0 } camera { C rotate y*20 }",
    // An orthographic picture's size, from all that may give it.
    "camera { orthographic location <1, 2, -3> }",
    "camera { orthographic location <1, 2, -3> look_at <0, 0, 1> }",
    "camera { orthographic location <1, 2, -3> look_at <0, 0, 1> direction z*2 }",
    "camera { orthographic location <1, 2, -3> look_at <0, 0, 1> direction z*2 up y*2 }",
    "camera { orthographic location <1, 2, -3> look_at <0, 0, 1> right x*2 }",
    "camera { orthographic location <1, 2, -3> angle 40 right x*2 up y*3 }",
    "camera { orthographic location <1, 2, -3> angle 40 look_at 0 direction z*3 rotate z*20 }",
};

/// Words of a camera, any of them several times, in any order.
std::string made(std::mt19937& random) {
    const auto pick = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const auto vector = [&](int half) {
        const auto number = [&] { return (pick(200 * half) - 100 * half) / 100.0; };
        const double x = number(), y = number();
        return fmt::format("<{}, {}, {}>", x, y, number());
    };
    const auto word = [&]() -> std::string {
        switch (pick(10)) {
        case 0: return "location " + vector(4);
        case 1: return "look_at " + vector(4);
        case 2: return fmt::format("direction z*{}", 0.5 + pick(3));
        case 3: return fmt::format("right {}", pick(3) ? "x*1.2" : vector(1));
        case 4: return fmt::format("up {}", pick(3) ? "y*0.9" : vector(1));
        case 5: return "sky " + vector(1);
        case 6: return fmt::format("angle {}", 30 + pick(60));
        case 7: return "rotate " + vector(60);
        case 8: return "translate " + vector(3);
        default: return fmt::format("scale <1, {}, 1.5>", pick(2) ? -1 : 2);
        }
    };
    std::string text;
    for (int words = 2 + pick(6); words > 0; --words) text += " " + word();
    return text;
}

/// Each with the #version it is read by.
std::vector<std::string> cameras() {
    std::vector<std::string> list;
    for (const std::string& camera : written)
        for (const char* version : {"3.7", "3.1"})
            list.push_back(fmt::format("#version {}; {}", version, camera));
    std::mt19937 random(11);
    for (int i = 0; i < 30; ++i)
        list.push_back(fmt::format("#version {}; camera {{ {}{} }}", i % 3 == 0 ? "3.1" : "3.7",
                                   i % 2 == 0 ? "orthographic" : "", made(random)));
    return list;
}

std::string animationOf(const std::vector<std::string>& cameras) {
    std::string text =
        "#version 3.7; global_settings { assumed_gamma 1 }\n"
        "#macro Along(V) gradient V color_map { [0 rgb 0] [1 rgb 3*V] } scale 44 translate -22*V #end\n"
        "sphere { 0, 20 hollow finish { ambient 1 diffuse 0 }\n"
        "    pigment { average pigment_map { [1 Along(x)] [1 Along(y)] [1 Along(z)] } } }\n"
        "#switch (frame_number)\n";
    for (std::size_t i = 0; i < cameras.size(); ++i)
        text += fmt::format("#case ({}) {} #break\n", i + 1, cameras[i]);
    return text + "#end #version 3.7;\n";
}

/// The places that a picture of 16 bits a channel shows.
Hits shownBy(const fs::path& ppm) {
    const std::string bytes = readFile(ppm);
    constexpr std::size_t size = side * side * 6;
    if (bytes.size() < size) return {};
    const auto channel = [&](std::size_t i) {
        const std::size_t at = bytes.size() - size + 2 * i;
        return (static_cast<unsigned char>(bytes[at]) * 256 + static_cast<unsigned char>(bytes[at + 1])) /
                   65535.0 * 44 -
               22;
    };
    Hits hits;
    for (std::size_t i = 0; i < 3 * side * side; i += 3)
        hits.push_back({channel(i), channel(i + 1), channel(i + 2)});
    return hits;
}

Hits hitsOf(const CameraModel& c) {
    Hits hits;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const Vec3 across = c.right * ((x + 0.5) / side - 0.5) + c.up * (0.5 - (y + 0.5) / side);
            const bool isParallel = c.kind == "orthographic";
            const Vec3 o = isParallel ? c.location + across : c.location;
            const Vec3 d = normalised(isParallel ? c.direction : c.direction + across);
            const double b = dot(o, d);
            hits.push_back(o + d * (std::sqrt(b * b - dot(o, o) + radius * radius) - b));
        }
    return hits;
}

TEST(SdlCameraWords, HavePovraysRaysInAnyOrder) {
    if (!yarte::test::hasPovray()) GTEST_SKIP() << "skipped: povray not found";
    const std::vector<std::string> list = cameras();
    const fs::path folder = yarte::test::emptyTestFolder();
    writeFile(folder / "scene.pov", animationOf(list));
    ASSERT_EQ(std::to_string(list.size()).size(), 2U); // the digits of a frame's number
    // Between frames POV-Ray mostly sleeps: eight of them have the frames in shares.
    std::string command = fmt::format("cd '{}' || exit 1\n", folder.string());
    for (std::size_t share = 0; share < 8; ++share)
        command += fmt::format("povray +Iscene.pov +Oout.ppm +FP16 +W{} +H{} -A -D +WT1 File_Gamma=1.0 "
                               "+KFI1 +KFF{} +SF{} +EF{} > out{}.txt 2>&1 &\n",
                               side, side, list.size(), share * list.size() / 8 + 1,
                               (share + 1) * list.size() / 8, share);
    ASSERT_EQ(std::system((command + "wait").c_str()), 0);
    for (std::size_t i = 0; i < list.size(); ++i) {
        const SdlRun run(list[i]);
        ASSERT_TRUE(run.model) << list[i] << run.problems();
        const Hits ours = hitsOf(*run.model->camera);
        const Hits theirs = shownBy(folder / fmt::format("out{:02}.ppm", i + 1));
        ASSERT_EQ(ours.size(), theirs.size()) << list[i];
        double apart = 0;
        for (std::size_t k = 0; k < ours.size(); ++k) apart = std::max(apart, length(ours[k] - theirs[k]));
        EXPECT_LE(apart, 0.003) << list[i]; // POV-Ray's colours are floats; a step of the file is 0.0007
    }
}

TEST(SdlCameraWords, ThatSayNothingAreErrors) {
    EXPECT_NE(SdlRun("camera { location x look_at x }").problems().find("sdl.look-at"), std::string::npos);
    EXPECT_NE(SdlRun("camera { angle 0 }").problems().find("sdl.angle"), std::string::npos);
}

} // namespace
} // namespace yarte::convert::povray::sdl::test
