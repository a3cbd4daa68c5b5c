#include "yarte/aov_image.h"

#include "yarte/trace/aov.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace yarte {

namespace {

/// Scenes with more bodies have no channels of body masks: they would outgrow all others.
constexpr std::size_t maxMaskedBodies = 240;
/// The heaviest visits that have channels.
constexpr std::size_t visitChannels = 4;
/// Lights beyond this many have no channels of their own.
constexpr std::size_t maxLitChannels = 16;
/// Of a mask in one channel: floats hold 24-bit integers exactly.
constexpr std::size_t maskBits = 24;

/// A body as the channels have it.
struct BodyNumbers {
    int material = -1, line = -1;
};

/// Calls `visit(base, number, suffix, value)` for every channel in a fixed order; the channel's name is base,
/// the number unless it is negative, and suffix.
template <class Visit>
class Channels {
public:
    Channels(const AovPixel& pixel, Visit visit) : pixel_(pixel), visit_(std::move(visit)) {}

    void all(BodyNumbers body) {
        one("body.id", pixel_.body);
        one("material.id", body.material);
        one("line", body.line);
        one("depth.Z", pixel_.depth);
        one("N.X", pixel_.normal.x), one("N.Y", pixel_.normal.y), one("N.Z", pixel_.normal.z);
        one("back", pixel_.isBack);
        std::vector<bool> shadowed;
        for (const AovLight& light : pixel_.lights)
            shadowed.push_back(light.lambert > 0 && light.arriving != Colour{1, 1, 1});
        mask("shadow.lights", shadowed);
        one("reflected.id", pixel_.reflectedBody);
        one("transmitted.id", pixel_.transmittedBody);
        colour("background", -1, pixel_.backgroundWeight, {".weight.R", ".weight.G", ".weight.B"});
        for (std::size_t i = 0; i < std::min(pixel_.lights.size(), maxLitChannels); ++i) light(i);
        for (std::size_t i = 0; i < visitChannels; ++i)
            visit(static_cast<int>(i), i < pixel_.visits.size() ? pixel_.visits[i] : AovVisit{});
        if (pixel_.secondary.size() > maxMaskedBodies) return;
        mask("secondary.bodies", pixel_.secondary);
        mask("casting.bodies", pixel_.casting);
    }

private:
    void one(const char* name, double value) { visit_(name, -1, "", value); }
    void colour(const char* base, int number, Colour c, std::array<const char*, 3> suffixes) {
        visit_(base, number, suffixes[0], c.r);
        visit_(base, number, suffixes[1], c.g);
        visit_(base, number, suffixes[2], c.b);
    }
    void visit(int number, const AovVisit& v) {
        visit_("visit", number, ".body", v.body);
        visit_("visit", number, ".back", v.isBack);
        colour("visit", number, v.weight, {".weight.R", ".weight.G", ".weight.B"});
        colour("visit", number, v.lit, {".lit.R", ".lit.G", ".lit.B"});
        colour("visit", number, v.highlight, {".highlight.R", ".highlight.G", ".highlight.B"});
        colour("visit", number, v.reflected, {".reflected.R", ".reflected.G", ".reflected.B"});
        colour("visit", number, v.transmitted, {".transmitted.R", ".transmitted.G", ".transmitted.B"});
    }
    void light(std::size_t i) {
        const int number = static_cast<int>(i);
        colour("light", number, pixel_.lights[i].arriving, {".arriving.R", ".arriving.G", ".arriving.B"});
        visit_("light", number, ".lambert", pixel_.lights[i].lambert);
        visit_("light", number, ".mirror", pixel_.lights[i].mirror);
        colour("light", number, pixel_.lightShare[i], {".R", ".G", ".B"});
    }
    void mask(const char* base, const std::vector<bool>& bits) {
        for (std::size_t first = 0; first < bits.size(); first += maskBits) {
            std::uint32_t sum = 0;
            for (std::size_t i = first; i < std::min(bits.size(), first + maskBits); ++i)
                if (bits[i]) sum |= 1u << (i - first);
            visit_(base, first == 0 ? -1 : static_cast<int>(first / maskBits), "", sum);
        }
    }

    const AovPixel& pixel_;
    Visit visit_;
};

std::vector<ImageLayer> emptyLayers(const AovPixel& pixel, std::size_t size) {
    std::vector<ImageLayer> layers;
    const auto add = [&](const char* base, int number, const char* suffix, double) {
        layers.push_back(
            {number < 0 ? fmt::format("{}{}", base, suffix) : fmt::format("{}{}{}", base, number, suffix),
             std::vector<float>(size)});
    };
    Channels(pixel, add).all({});
    return layers;
}

const char* kindOf(const Shape& shape) {
    constexpr std::array names{"sphere", "box",      "cone",          "truncated_cone", "disc", "polygon",
                               "mesh",   "cylinder", "open_cylinder", "frustum",        "plane"};
    static_assert(names.size() == std::variant_size_v<Shape>);
    return names[shape.index()];
}

int lineOf(const Span& span, const Sources& sources) {
    return span.source.valid() ? static_cast<int>(sources[span.source].position(span.begin).line) : -1;
}

/// {"bodies":[{"kind":"sphere","line":9,"exponent":20,"reflection":0.3,"transmission":[0,0,0]}],
///  "lights":[{"line":5,"brightness":[1,1,1]}]}
std::string sceneJson(const Scene& scene, const Sources& sources) {
    std::vector<std::string> bodies, lights;
    for (const Body& body : scene.bodies) {
        const Material& m = scene.materials[body.material.index];
        const Colour passes = transmittance(m);
        bodies.push_back(fmt::format(
            R"({{"kind":"{}","line":{},"exponent":{},"reflection":{},"transmission":[{},{},{}]}})",
            kindOf(body.shape), lineOf(body.span, sources), m.exponent, m.reflection, passes.r, passes.g,
            passes.b));
    }
    for (const Light& light : scene.lights)
        lights.push_back(fmt::format(R"({{"line":{},"brightness":[{},{},{}]}})", lineOf(light.span, sources),
                                     light.brightness.r, light.brightness.g, light.brightness.b));
    return fmt::format(R"({{"bodies":[{}],"lights":[{}]}})", fmt::join(bodies, ","), fmt::join(lights, ","));
}

} // namespace

std::optional<LayeredImage> aovImage(const Scene& scene, const Sources& sources, const World& world,
                                     RenderOptions options, const ProgressFunction& progress) {
    const Tile region = options.region;
    const auto width = static_cast<std::size_t>(region.width());
    std::vector<BodyNumbers> bodies;
    for (const Body& body : scene.bodies)
        bodies.push_back({static_cast<int>(body.material.index), lineOf(body.span, sources)});

    LayeredImage image{region.width(), region.height(), {}, {{"yarte.scene", sceneJson(scene, sources)}}};
    image.layers = emptyLayers(aovPixel(world, scene.lights, region.x0, region.y0),
                               width * static_cast<std::size_t>(region.height()));
    const auto fillTile = [&](Tile tile, Colour*, std::size_t, RayCounts&) {
        for (int y = tile.y0; y < tile.y1; ++y)
            for (int x = tile.x0; x < tile.x1; ++x) {
                const AovPixel pixel = aovPixel(world, scene.lights, x, y);
                const std::size_t at =
                    static_cast<std::size_t>(y - region.y0) * width + static_cast<std::size_t>(x - region.x0);
                std::size_t layer = 0;
                const auto store = [&](const char*, int, const char*, double value) {
                    image.layers[layer++].values[at] = static_cast<float>(value);
                };
                Channels(pixel, store)
                    .all(pixel.body < 0 ? BodyNumbers{} : bodies[static_cast<std::size_t>(pixel.body)]);
            }
    };
    if (options.mode == RenderMode::processes) options.mode = RenderMode::threads;
    if (!render(options, fillTile, progress)) return std::nullopt;
    return image;
}

} // namespace yarte
