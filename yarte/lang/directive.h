// The directives of the scene language and the arguments they take: the one list of keywords.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace yarte {

enum class Keyword {
    imageResolution,
    cameraPosition,
    cameraApertures,
    focusPoint,
    upVector,
    lightSource,
    backgroundColour,
    maxRecurseLevel,
    gammaCorrectionFactor,
    material,
    tint,
    sphere,
    box,
    cone,
    truncatedCone,
    disc,
    polygon,
    mesh,
    cylinder,
    openCylinder,
    frustum,
    plane,
    backfaceColour,
    instanceReferential,
};

inline constexpr std::size_t keywordCount = 24;

struct Directive {
    Keyword keyword;
    std::string_view name;
    std::string_view arguments; ///< in words, for messages
    std::size_t count;          ///< of numbers; 0: the first number tells it
    std::size_t otherCount = 0; ///< may be given instead; 0: none
    bool once = false;          ///< a setting: the scene has one value of it
    bool takesFileName = false; ///< before the numbers
};

/// In the order of the paper, extensions after what they resemble.
std::span<const Directive> directives();

const Directive& directive(Keyword);

/// Nothing for a word that is no keyword.
const Directive* findDirective(std::string_view word);

/// The directive that a misspelt word was probably meant to be.
const Directive* closestDirective(std::string_view word);

} // namespace yarte
