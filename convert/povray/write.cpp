#include "convert/povray/write.h"

#include "convert/povray/appearance.h"
#include "convert/povray/body.h"
#include "convert/povray/extent.h"
#include "convert/povray/library.h"
#include "convert/povray/limits.h"
#include "convert/povray/mesh.h"
#include "convert/povray/sdl_text.h"
#include "yarte/base/number.h"

#include <fmt/format.h>

namespace yarte::convert::povray {
namespace {

std::string header(const Scene& scene, const Conversion& c) {
    const std::string source = c.input.file.empty() ? "" : " from " + c.input.file.filename().string();
    const auto [width, height] = scene.resolution;
    return fmt::format(R"(#version 3.7;
// Written by yarte-convert{}. Render with: povray +FP16 +W{} +H{} -A File_Gamma=1
// Numbers are the scene's own, in its units.

#declare Image_Width = {};
#declare Image_Height = {};
#declare Display_Gamma = {};
#declare Max_Recursion = {}; // secondary generations of rays
#declare World_Scale = {}; // of all lengths: POV-Ray's tolerances are absolute; a power of two changes no digit
#declare Exposure = {}; // of all light: POV-Ray's files end at 1

global_settings {{ assumed_gamma 1 max_trace_level Max_Recursion + 1 adc_bailout 0 }}
#default {{ finish {{ ambient 0 diffuse 0 }} }}
)",
                       source, width, height, width, height, printNumber(scene.gamma), scene.maxRecursion,
                       printNumber(worldScaleOf(scene)), printNumber(c.options.exposure));
}

std::string settings(const Scene& scene, const Sources& sources) {
    const Camera& camera = scene.camera;
    std::string text = fmt::format(
        "\nYarte_Camera({}, {}, {}, {}, {})\n", sdl(camera.position), sdl(camera.focus), sdl(camera.up),
        printNumber(camera.horizontalApertureDegrees), printNumber(camera.verticalApertureDegrees));
    text += fmt::format("background {{ rgb {}*Exposure }}\n", sdl(scene.background));
    for (const Light& light : scene.lights)
        text += fmt::format("\n// {}\nlight_source {{ {}*World_Scale rgb {}*Exposure }}\n",
                            placeOf("light", light.span, sources), sdl(light.position),
                            sdlGrey(light.brightness));
    return text;
}

} // namespace

std::vector<OutputFile> writeScene(const Scene& scene, Conversion& c) {
    const Appearances appearances(scene);
    std::string text = "\n" + appearances.declarations() + meshDeclarations(scene, c.options.plainTextures) +
                       settings(scene, c.sources);
    reportScene(scene, c.ledger);
    reportMaterials(scene, c.options.plainTextures, c.ledger);
    const BodyWriting writing{scene, c.sources, c.options.plainTextures, c.ledger};
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) text += bodyText(i, appearances.nameOf(i), writing);
    return {{c.output, header(scene, c) + "\n" + libraryFor(text, c.options.plainTextures) + text}};
}

} // namespace yarte::convert::povray
