// Report: everything a run found out, as plain data. The report_*.h files make texts of it.
#pragma once

#include "validate/flip.h"
#include "validate/metrics.h"
#include "validate/page_pixels.h"
#include "validate/region.h"
#include "validate/tolerance.h"
#include "validate/verdict.h"

#include <optional>
#include <string>
#include <vector>

namespace yarte::validate {

/// Of two finite pictures of one size; linear light, 1 = white.
struct Comparison {
    LargestError maxAbs;
    double rmse = 0;
    std::optional<double> psnr; ///< dB; none: equal
    FlipSummary flip;
    double threshold = 0;
    std::size_t pixelsOver = 0;
};

/// A program that was run for a case; all paths in it are absolute or relative to the case's folder.
struct CommandRecord {
    std::string line; ///< as a shell would read it
    double seconds = 0;
    std::string outcome; ///< "exit code 0", "killed by signal 11", "stopped after 600 s", ...
};

/// Seconds; what a program did not tell is missing.
struct YarteTimes {
    std::optional<double> trace, wall, build{};
    bool inDouble = true; ///< false: it says that it computed in float
};
struct PovrayTimes {
    std::optional<double> parse, trace, wall;
    bool cached = false; ///< they are those of an earlier run, whose picture was kept
};

/// A picture of a case: its name in the report and its file in the case's folder.
struct PictureRecord {
    std::string label, file;
};

/// What a case did to the stored references; see baseline.h.
struct BaselineChange {
    enum class Kind { added, changed, unchanged };
    Kind kind = Kind::unchanged;
    /// Of the old reference and the new, linear light at the case's exposure; none: their sizes differ.
    std::optional<double> maxAbs = 0.0;
};

struct CaseReport {
    std::string name;     ///< unique in the report; also the name of its folder
    std::string source;   ///< what was compared: the scene, or the two images
    std::string sides[2]; ///< what to call the two pictures; "": there is none
    Verdict verdict = Verdict::error;
    std::string message; ///< one or more lines: why it is not a pass; else empty
    int width = 0, height = 0;
    double exposure = 1; ///< both pictures are those of the scene with its light times this
    std::optional<Comparison> comparison;
    Explanation explanation;                 ///< of what differs
    std::string tolerance;                   ///< the file of the conditions; empty: the default
    std::vector<ConditionResult> conditions; ///< how each turned out
    std::optional<BaselineChange> baselineChange;
    YarteTimes yarte;
    PovrayTimes povray;
    std::vector<CommandRecord> commands;
    std::vector<PictureRecord> pictures; ///< PNGs for people
    PagePixels page;                     ///< for the page's viewer
};

struct Report {
    std::string version;
    std::string encoding;  ///< how the numbers in the compared files were read, in words
    std::string reference; ///< what the pictures were compared with, in words
    int jobs = 1;          ///< so many cases ran side by side
    std::vector<CaseReport> cases;

    std::size_t count(Verdict) const;
    /// The worst of all cases: error, then fail, then pass.
    Verdict verdict() const;
};

/// The folder of a case in the report's folder, with '/'.
std::string folderOf(const CaseReport&);

/// Why its pictures differ, each cause once: the common one, else those of its largest regions, at most
/// three.
std::vector<Finding> causes(const CaseReport&);

/// POV-Ray's trace time divided by YARTE's, if both are known and not 0.
std::optional<double> speedRatio(const CaseReport&);

} // namespace yarte::validate
