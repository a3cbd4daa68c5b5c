// SpeedReport: what `yarte-validate speed` finds out, as plain data. Times in seconds, errors in linear light
// (1 = white) unless a comment says otherwise.
#pragma once

#include "validate/report.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace yarte::validate {

/// Of several runs; what a program did not tell is missing.
struct Seconds {
    std::optional<double> median, least, most;
};

struct PictureError {
    double rmse = 0, maxAbs = 0;
};

/// A picture of N x N samples a pixel.
struct SamplesPoint {
    int samples = 1; ///< N
    Seconds trace; ///< as the program tells: casting rays, without reading the scene and writing the picture
    Seconds wall;  ///< of the whole program
    PictureError error;                     ///< against the reference
    std::optional<PictureError> fromDouble; ///< of --precision fast: against double at as many samples
};

/// A program and its setting.
struct SamplesCurve {
    std::string name; ///< "YARTE double"
    std::vector<SamplesPoint> points;
};

/// A picture, one ray a pixel, of the scene with triangles for its curved shapes.
struct TessellationPoint {
    double chordError = 0;     ///< as asked for, in scene units
    double deviation = 0;      ///< as measured: the largest of all shapes, in scene units
    std::size_t triangles = 0; ///< of all curved shapes, each counted where it stands
    Seconds convert;           ///< yarte-convert's whole run
    Seconds build, trace;      ///< yarte's: making its tree, casting rays
    Seconds wall;              ///< yarte's whole run, with reading the triangles
    PictureError error;        ///< against the exact shapes at as many samples
};

struct Tessellation {
    std::string note;                          ///< why there are no points, or not all; else empty
    double radius = 0;                         ///< the largest of the curved shapes, in scene units
    Seconds exactBuild, exactTrace, exactWall; ///< of the exact shapes
    std::vector<TessellationPoint> points;     ///< the coarsest first
};

/// The middle and the worst of all rays.
struct Spread {
    double median = 0, rms = 0, max = 0;
};

/// What one program says that rays meet, against the truth.
struct RayErrors {
    std::string name;
    std::size_t compared = 0;  ///< rays that meet the same body in truth and here
    std::size_t otherwise = 0; ///< rays that meet something else here: they pass within rounding of an edge
    Spread distance;           ///< |d - truth| / truth
    Spread normal;             ///< |n - truth|, of unit vectors up to their sign: radians
};

struct Rays {
    std::string note;          ///< what was left out and why; else empty
    int width = 0, height = 0; ///< a ray through the centre of each pixel of such a picture
    std::size_t met = 0;       ///< rays that meet something, in truth
    std::vector<RayErrors> programs;
};

struct SpeedCase {
    std::string name, source;
    std::string message; ///< why it could not be measured; else empty
    std::string note;    ///< what is missing all the same, and why; else empty
    int width = 0, height = 0;
    int referenceSamples = 0; ///< the reference is YARTE's in double, of so many samples squared
    double exposure = 1;      ///< POV-Ray got the scene with its light times this; errors are divided by it
    std::vector<SamplesCurve> curves;
    Tessellation tessellation;
    Rays rays;
    std::vector<CommandRecord> commands;
};

struct SpeedReport {
    std::string version;
    int runs = 0;      ///< of each program, of which times are medians
    int processes = 0; ///< of YARTE; threads of POV-Ray
    std::vector<SpeedCase> cases;
};

} // namespace yarte::validate
