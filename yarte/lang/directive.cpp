#include "yarte/lang/directive.h"

#include "yarte/base/text.h"

#include <algorithm>
#include <array>

namespace yarte {
namespace {

constexpr bool once = true, withFileName = true;

constexpr Directive table[] = {
    {Keyword::imageResolution, "image_resolution", "width height", 2, 0, once},
    {Keyword::cameraPosition, "camera_position", "x y z", 3, 0, once},
    {Keyword::cameraApertures, "camera_apertures", "horizontal vertical", 2, 0, once},
    {Keyword::focusPoint, "focus_point", "x y z", 3, 0, once},
    {Keyword::upVector, "up_vector", "x y z", 3, 0, once},
    {Keyword::lightSource, "light_source", "position, brightness or red green blue", 4, 6},
    {Keyword::backgroundColour, "background_colour", "red green blue", 3, 0, once},
    {Keyword::maxRecurseLevel, "max_recurse_level", "level", 1, 0, once},
    {Keyword::gammaCorrectionFactor, "gamma_correction_factor", "gamma", 1, 0, once},
    {Keyword::material, "material", "ambient, diffuse, specular, exponent, reflection, transmission, index",
     13},
    {Keyword::tint, "tint", "red green blue", 3},
    {Keyword::sphere, "sphere", "centre, radius", 4},
    {Keyword::box, "box", "centre, sides", 6},
    {Keyword::cone, "cone", "base centre, radius, height", 5},
    {Keyword::truncatedCone, "truncated_cone", "base centre, radius, cone height, height", 6},
    {Keyword::disc, "disc", "centre, radius", 4},
    {Keyword::polygon, "polygon", "vertex count, vertices", 0},
    {Keyword::mesh, "mesh", "scale, three axes, translation", 13, 0, !once, withFileName},
    {Keyword::cylinder, "cylinder", "base centre, radius, height", 5},
    {Keyword::openCylinder, "open_cylinder", "base centre, radius, height", 5},
    {Keyword::frustum, "frustum", "base centre, base radius, top radius, height", 6},
    {Keyword::plane, "plane", "normal, distance", 4},
    {Keyword::backfaceColour, "backface_colour", "ambient, diffuse, specular", 9},
    {Keyword::instanceReferential, "instance_referential", "x axis, y axis, z axis if wanted", 6, 9},
};

static_assert(std::size(table) == keywordCount);
static_assert([] {
    for (std::size_t i = 0; i < keywordCount; ++i)
        if (table[i].keyword != static_cast<Keyword>(i)) return false;
    return true;
}());

} // namespace

std::span<const Directive> directives() { return table; }

const Directive& directive(Keyword keyword) { return table[static_cast<std::size_t>(keyword)]; }

const Directive* findDirective(std::string_view word) {
    const auto found =
        std::find_if(std::begin(table), std::end(table), [=](const Directive& d) { return d.name == word; });
    return found == std::end(table) ? nullptr : found;
}

const Directive* closestDirective(std::string_view word) {
    std::array<std::string_view, keywordCount> names;
    std::transform(std::begin(table), std::end(table), names.begin(),
                   [](const Directive& d) { return d.name; });
    const auto name = closestWord(word, names);
    return name ? findDirective(*name) : nullptr;
}

} // namespace yarte
