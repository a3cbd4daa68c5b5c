// Rays: how far what programs say that rays meet is from the truth.
#pragma once

#include "validate/speed/speed_report.h"
#include "validate/speed/speed_settings.h"
#include "validate/truth/true_scene.h"
#include "validate/workshop.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace yarte::validate {

/// A program's answer for a ray.
struct RayAnswer {
    int body = -1; ///< index into Scene::bodies; -1: nothing is met
    double distance = 0;
    Vec3 normal; ///< to either side
};

/// A ray of a program that was asked, and what is true of it.
struct RayPair {
    std::optional<TrueHit> truth;
    RayAnswer answer;
};

RayErrors rayErrors(std::string name, const std::vector<RayPair>&);

/// The answers in a file of `yarte --hits`, pixel by pixel. Throws CaseError if it is none.
std::vector<RayAnswer> hitsIn(std::string_view text);

/// A size with about the sides' ratio and at most `rays` pixels.
Resolution sizeForRays(int width, int height, int rays);

/// Of `scene`, a file that renderWithYarte takes, which reads as `content`; `width` and `height` are its
/// picture's. Throws CaseError.
Rays measureRays(Workshop&, const SpeedSettings&, const std::filesystem::path& scene, const Scene& content,
                 int width, int height);

} // namespace yarte::validate
