// The labelled rays: files that say what a ray among a few bodies meets, and why.
//
//     ; comment
//     scene NAME
//     sphere 0 0 0 1                          bodies, in the scene language
//     ray 0x1p+0 0x0p+0 ...                   origin and direction, hexadecimal
//     = hit 0 0 enters                        body and face, from 0; or: = miss
//     = proof discriminant 1.5e-16 4.4e-17    what decides, and how far half an ulp of the inputs moves it
//     = t 1.25000...                          to 100 digits
//     = normal 0.6 0 -0.8                     to 30 digits
//     = conditions 3.5 7.25                   of t and of the normal
//
// In scenes whose name begins with "tie: " the inputs exactly as they are decide, by the rule that the first
// in the file wins: "= proof tie". All other rays are decidable.
#pragma once

#include "tests/hard/check.h"

#include <filesystem>
#include <string>
#include <vector>

namespace yarte::hard {

struct LabelledRay {
    std::string scene;
    std::string name; ///< file, scene and number of the ray, for messages
    Case problem;
    std::string label; ///< the lines that begin with "="

    bool isTie() const { return scene.starts_with("tie: "); }
};

/// What the lines after a ray must be.
std::string labelOf(const Case&);

/// Throws std::runtime_error if the file is not as above; of "mesh" the files lie beside it.
std::vector<LabelledRay> readRays(const std::filesystem::path&);

/// The file's text with the label that the oracle gives to every ray, whatever it had before, and without
/// rays that are not decidable.
std::string labelled(const std::filesystem::path&);

} // namespace yarte::hard
