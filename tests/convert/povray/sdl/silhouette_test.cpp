// Whether all geometry arrives, in its place: POV-Ray's picture of the original against YARTE's of the
// import, both with one flat colour for each object. POV-Ray does that itself (+Q1: pigments' colours,
// without light, transparency, fog or mirrors); in the import every texture is replaced by its pigment, as
// light. Backgrounds get a colour that no object has.
//
// Files whose pictures cannot be compared are named in tests/data/povray/not-compared.txt, with the reason;
// every other one is compared, and none is named there without need.
//
// YARTE_SILHOUETTE_SIZE=320x240 takes all scenes, not every third, and prints a table of what was found.
#include "tests/convert/povray/sdl/run.h"
#include "tests/support/povray.h"
#include "tests/support/program.h"

#include "convert/povray/sdl/build_scene.h"
#include "validate/pnm.h"
#include "yarte/base/file.h"
#include "yarte/trace/search.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>

namespace yarte::convert::povray::sdl::test {
namespace {

namespace fs = std::filesystem;

constexpr Colour backgroundMark{0.9, 0.1, 0.7};
constexpr Colour anyColour{0, 0, 64}; ///< of what has no colour of its own: a pattern, layers

// The import, flat.

Texture flat(Pigment pigment) {
    Texture texture;
    const Rgbft c = pigment.colour;
    texture.pigment.colour = {c.r, c.g, c.b, 0, 0};
    if (!pigment.pattern.empty()) texture.pigment.colour = {anyColour.r, anyColour.g, anyColour.b, 0, 0};
    texture.finish.ambient = {}, texture.finish.diffuse = 0;
    texture.finish.emission = {1, 1, 1};
    return texture;
}

Layers flat(const Layers& layers) {
    Pigment pigment = layers.back().pigment;
    if (layers.size() > 1 || !layers.back().kind.empty()) pigment.pattern = "several";
    return {flat(pigment)};
}

ObjectPtr flat(const ObjectPtr& object) {
    if (!object) return nullptr;
    Object result = *object;
    if (result.appearance.layers) result.appearance.layers = flat(*result.appearance.layers);
    if (result.appearance.backLayers) result.appearance.backLayers = flat(*result.appearance.backLayers);
    if (auto* parts = std::get_if<UnionShape>(&result.shape)) {
        for (ObjectPtr& part : parts->parts) part = flat(part);
    } else if (auto* light = std::get_if<LightShape>(&result.shape)) {
        light->looksLike = flat(light->looksLike);
    } else if (auto* mesh = std::get_if<std::shared_ptr<const MeshShape>>(&result.shape)) {
        MeshShape own = **mesh;
        for (Layers& layers : own.textures) layers = flat(layers);
        *mesh = std::make_shared<const MeshShape>(std::move(own));
    }
    return std::make_shared<const Object>(std::move(result));
}

Model flat(Model model) {
    model.defaultTexture = flat({model.defaultTexture}).front();
    for (ObjectPtr& object : model.objects) object = flat(object);
    model.background = backgroundMark;
    return model;
}

using Pixels = std::vector<Colour>;

Pixels colours(const Scene& scene, Resolution size) {
    const WorldPtr world = buildWorld(scene, size);
    Pixels result;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const trace::Ray ray = world->camera.through(x, y);
            const auto hit = trace::nearestHit(*world, ray);
            if (!hit) {
                result.push_back(backgroundMark);
                continue;
            }
            const trace::BodyAppearance& body = world->appearanceOf(hit->element);
            const Colour c = body.ambient[hit->entering ? 0 : 1];
            result.push_back(
                c == anyColour ? c : Colour{std::min(c.r, 1.0), std::min(c.g, 1.0), std::min(c.b, 1.0)});
        }
    return result;
}

std::size_t triangles(const Scene& scene) {
    std::size_t count = 0;
    for (const Body& body : scene.bodies)
        if (const auto* mesh = std::get_if<Mesh>(&body.shape))
            count += scene.meshes[mesh->mesh.index].faceCount();
    return count;
}

// The original, by POV-Ray.

Pixels byPovray(const fs::path& original, const fs::path& folder, Resolution size, double assumedGamma) {
    const std::string mark =
        fmt::format("rgb <{}, {}, {}>", backgroundMark.r, backgroundMark.g, backgroundMark.b);
    writeFile(folder / "flat.pov",
              fmt::format("#include \"{0}\"\nbackground {{ {1} }}\nsky_sphere {{ pigment {{ {1} }} }}\n",
                          original.string(), mark));
    const auto [status, said] = yarte::test::runPovray(
        folder, fmt::format("+Iflat.pov +Oflat.ppm +FP16 +W{} +H{} -D -A -P +WT1 +Q1 File_Gamma=1 '+L{}'",
                            size.width, size.height, original.parent_path().string()));
    EXPECT_EQ(status, 0) << said;
    if (status != 0) return {};
    Pixels pixels = validate::readPnm(readFile(folder / "flat.ppm")).pixels;
    for (Colour& c : pixels) // from linear light back to the file's own numbers
        for (double* channel : {&c.r, &c.g, &c.b}) *channel = std::pow(*channel, 1 / assumedGamma);
    return pixels;
}

void writePicture(const fs::path& file, const Pixels& pixels, Resolution size) {
    std::string bytes = fmt::format("P6\n{} {}\n255\n", size.width, size.height);
    for (const Colour c : pixels)
        for (const double channel : {c.r, c.g, c.b})
            bytes += static_cast<char>(std::lround(255 * std::clamp(channel, 0.0, 1.0)));
    writeFile(file, bytes);
}

// Comparing.

bool isClose(Colour a, Colour b) {
    constexpr double step = 2e-3; // 16-bit linear files are coarse near black for a gamma of 2.2
    return std::abs(a.r - b.r) < step && std::abs(a.g - b.g) < step && std::abs(a.b - b.b) < step;
}

bool isBackground(Colour c) { return isClose(c, backgroundMark); }

/// `covers`: only whether there is something.
struct Agreement {
    bool covers;
    bool operator()(Colour a, Colour b) const {
        if (isBackground(a) || isBackground(b)) return isBackground(a) == isBackground(b);
        return covers || a == anyColour || b == anyColour || isClose(a, b);
    }
};

/// Pixels of `a` that have no equal in `b` in their place or beside it, where `matters`.
template <class Matters>
int missing(const Pixels& a, const Pixels& b, Resolution size, Agreement agree, Matters&& matters) {
    int count = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Colour wanted = a[static_cast<std::size_t>(y * size.width + x)];
            if (!matters(wanted)) continue;
            bool isFound = false;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, size.height - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, size.width - 1); ++u)
                    isFound = isFound || agree(wanted, b[static_cast<std::size_t>(v * size.width + u)]);
            count += !isFound;
        }
    return count;
}

/// What the ledger lets a picture show.
struct Demand {
    bool isPlaced = true; ///< nothing was 0 that the file's program asked of its objects (trace, max_extent)
    bool isSeen = true;   ///< by the original's camera
    bool isWhole = true;  ///< no object was dropped
    bool isUncut = true;  ///< no object is larger than the original's
};

Demand demandOf(const Ledger& ledger, const std::vector<std::string>& unread) {
    Demand result;
    const auto isOneOf = [](const std::string& word, std::initializer_list<const char*> list) {
        return std::find(list.begin(), list.end(), word) != list.end();
    };
    for (const std::string& what : unread)
        if (!isOneOf(what, {"sky_sphere", "fog", "media", "radiosity", "photons", "rainbow"}))
            result.isPlaced = false;
    for (const LedgerRow& row : ledger.rows()) {
        if (!isLoss(row.action)) continue;
        const std::string kind = row.where.substr(0, row.where.find(" at "));
        const bool isRounding = row.property == "right and up" && row.bound.value_or(1) < 0.01; // degrees
        if (kind == "camera" && row.property != "orthographic" && !isRounding) result.isSeen = false;
        const bool isNoneThereEither = row.detail.find("POV-Ray drops it too") != std::string::npos;
        if (row.property == "everything" && row.action == Action::dropped && !isNoneThereEither)
            result.isWhole = false;
        if (isOneOf(row.property, {"clipped_by", "looks_like", "inverse"}))
            result.isUncut = result.isWhole = false;
    }
    return result;
}

/// A file's import, flat.
struct Import {
    std::string obstacle; ///< to comparing its picture, in not-compared.txt's words; empty: none
    std::string problems; ///< if there is no scene
    std::optional<Scene> scene;
    Demand demand;
    double assumedGamma = 1;
};

/// `folder`: what the file's program may write to.
Import importOf(const fs::path& file, const fs::path& folder, Resolution size) {
    Limits limits;
    limits.tokens = 2'000'000;
    SdlRun run(readFile(file), file, limits, folder);
    Import result;
    Ledger ledger;
    if (run.model)
        result.scene = buildScene(flat(*run.model), {{}, size}, run.sources, run.diagnostics, ledger);
    if (!result.scene) {
        result.obstacle = run.diagnostics.all().back().code, result.problems = run.problems();
        return result;
    }
    result.demand = demandOf(ledger, run.reported);
    result.assumedGamma = run.model->assumedGamma.value_or(1);
    if (!result.demand.isSeen)
        result.obstacle = "camera";
    else if (!result.demand.isPlaced)
        result.obstacle = "program";
    else if (triangles(*result.scene) > 4'000'000)
        result.obstacle = "triangles";
    return result;
}

// The files.

/// Short, and no other file's.
std::string nameOf(const fs::path& file) { return file.parent_path().filename() / file.filename(); }

/// The obstacles by files' names.
const std::map<std::string, std::string>& notCompared() {
    static const auto list = [] {
        std::map<std::string, std::string> result;
        std::istringstream lines(readFile(fs::path(YARTE_SOURCE_DIR) / "tests/data/povray/not-compared.txt"));
        for (std::string line; std::getline(lines, line);) {
            std::istringstream words(line);
            std::string name, obstacle;
            if (!line.starts_with('#') && words >> name >> obstacle) result[name] = obstacle;
        }
        return result;
    }();
    return list;
}

std::string statedObstacle(const fs::path& file) {
    const auto found = notCompared().find(nameOf(file));
    return found == notCompared().end() ? "" : found->second;
}

const char* wantedSize() { return std::getenv("YARTE_SILHOUETTE_SIZE"); }

const fs::path examples = "/usr/share/doc/povray/examples";

std::vector<fs::path> allScenes() {
    std::vector<fs::path> result;
    const fs::path corpora = YARTE_CORPORA;
    if (corpora.empty() || !fs::exists(examples)) return result;
    for (const char* folder : {"spd", "povray"})
        for (const auto& entry : fs::directory_iterator(corpora / folder))
            if (entry.path().extension() == ".pov") result.push_back(entry.path());
    std::istringstream list(readFile(corpora / "povray/debian-examples-open.txt"));
    for (std::string name; list >> name;) result.push_back(examples.parent_path() / name);
    std::sort(result.begin(), result.end());
    return result;
}

std::vector<fs::path> scenes() {
    const std::vector<fs::path> all = allScenes();
    if (wantedSize() != nullptr) return all;
    std::vector<fs::path> some;
    for (std::size_t i = 0; i < all.size(); i += 3) some.push_back(all[i]);
    return some;
}

} // namespace

TEST(SdlSilhouettesCorpora, HaveAllFilesThatAreNotCompared) {
    if (allScenes().empty())
        GTEST_SKIP() << "skipped: YARTE_CORPORA is empty, or povray-examples is not installed";
    std::vector<std::string> names;
    for (const fs::path& file : allScenes()) names.push_back(nameOf(file));
    EXPECT_GE(names.size(), 200U);
    for (const auto& [name, obstacle] : notCompared())
        EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
}

class SdlSilhouettes : public testing::TestWithParam<fs::path> {};

TEST_P(SdlSilhouettes, EverythingIsInItsPlace) {
    if (!yarte::test::hasPovray()) GTEST_SKIP() << "skipped: povray not found";
    const char* const wanted = wantedSize();
    Resolution size{120, 90};
    if (wanted != nullptr) std::sscanf(wanted, "%dx%d", &size.width, &size.height);
    const fs::path file = GetParam(), folder = yarte::test::emptyTestFolder();
    const Import import = importOf(file, folder, size);
    ASSERT_EQ(import.obstacle, statedObstacle(file))
        << (import.obstacle.empty() ? "the pictures can be compared now: take it off not-compared.txt\n"
                                    : "not-compared.txt does not say what hinders comparing\n")
        << import.problems;
    if (!import.obstacle.empty()) return;

    const Pixels original = byPovray(file, folder, size, import.assumedGamma);
    if (HasFailure()) return;
    const Pixels ours = colours(*import.scene, size);
    writePicture(folder / "import.ppm", ours, size), writePicture(folder / "original.ppm", original, size);
    const auto isObject = [](Colour c) { return !isBackground(c); };
    const int extra = missing(ours, original, size, {true}, isObject);
    const int lacking = missing(original, ours, size, {true}, isObject);
    const int other = missing(ours, original, size, {false}, isObject);
    if (import.demand.isUncut) {
        EXPECT_EQ(extra, 0) << "pixels that only the import covers; pictures: " << folder;
    }
    if (import.demand.isWhole) {
        EXPECT_EQ(lacking, 0) << "pixels that only the original covers; pictures: " << folder;
        EXPECT_EQ(other, 0) << "pixels that show another object's colour; pictures: " << folder;
    }
    if (wanted != nullptr)
        fmt::print("| {} | {} | {} | {} | {} | {} |\n", file.string(),
                   std::count_if(ours.begin(), ours.end(), isObject),
                   import.demand.isWhole   ? "all"
                   : import.demand.isUncut ? "import within original"
                                           : "cut",
                   extra, lacking, other);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SdlSilhouettes, testing::ValuesIn(scenes()), [](const auto& c) {
    std::string name = c.param.parent_path().filename().string() + "_" + c.param.stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char x) { return !std::isalnum(static_cast<unsigned char>(x)); }, '_');
    return name;
});
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(SdlSilhouettes);

} // namespace yarte::convert::povray::sdl::test
