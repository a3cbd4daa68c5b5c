// Tolerance: how far two pictures may be apart, as data: a tree of conditions. The format of its files is in
// the README, "Tolerances"; reading them is in tolerance_json.h, applying them in verdict.h.
#pragma once

#include "validate/region.h"

#include <filesystem>
#include <string>
#include <vector>

namespace yarte::validate {

/// A pixel's error above this counts as a difference unless a tolerance says otherwise; linear light.
inline constexpr double defaultThreshold = 4.0 / 65535;

/// Pixels of a picture, as a union of what is given.
struct PixelSet {
    std::vector<PixelBox> rectangles; ///< parts outside the picture mean nothing
    /// Mask images, their pixels that are not black; each has the picture's size.
    std::vector<std::filesystem::path> images;
    /// Pixels at most so many pixels (in x and in y) from an edge between bodies; 0: none.
    int silhouette = 0;

    bool empty() const { return rectangles.empty() && images.empty() && silhouette == 0; }
};

struct Condition {
    enum class Kind {
        all,           ///< every part must hold
        any,           ///< one of the parts must hold
        maxAbs,        ///< the largest pixel error is at most `limit`
        rmse,          ///< at most `limit`
        flipMean,      ///< at most `limit`
        pixelCount,    ///< at most `limit` pixels have an error above `threshold`
        pixelFraction, ///< the same as a part of the judged pixels, in [0, 1]
    };
    Kind kind = Kind::maxAbs;
    double limit = defaultThreshold;
    double threshold = defaultThreshold; ///< of pixelCount and pixelFraction
    PixelSet only;                       ///< empty: the whole picture
    PixelSet except;                     ///< of those, these are not judged; parts of a group inherit both
    std::string reason;                  ///< why it is not the default
    std::string pointer;                 ///< its place in the file: a JSON pointer, "" for the root
    std::vector<Condition> parts;        ///< of all and any

    bool isGroup() const { return kind == Kind::all || kind == Kind::any; }
};

struct Tolerance {
    Condition condition; ///< default: strict, max_abs at most 4/65535 everywhere
    /// Above this a pixel counts as different where regions, maps and counts are shown: the smallest
    /// threshold that a condition on single pixels has.
    double threshold = defaultThreshold;
    std::string source; ///< the file's name; empty: the default
};

/// How one condition turned out, the tree flattened in the order of the file.
struct ConditionResult {
    int depth = 0; ///< 0: the root
    bool holds = false;
    bool isGroup = false; ///< all or any: no measured value
    std::string text;     ///< "max_abs <= 4/65535 except within 1 px of an outline"
    double measured = 0, limit = 0;
    std::string reason;
    std::string pointer;
};

} // namespace yarte::validate
