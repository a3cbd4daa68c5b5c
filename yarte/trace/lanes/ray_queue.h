// RayQueue: the rays of one generation that wait to be traced, component by component, so that packets load
// straight from it.
#pragma once

#include "yarte/trace/media.h"
#include "yarte/trace/ray.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace yarte::trace {

/// Index of a media stack in its pool; 0 is that of the camera.
using MediaIndex = std::uint32_t;

struct RayQueue {
    enum Component { ox, oy, oz, dx, dy, dz, from, inside, weight, componentCount };

    std::array<std::vector<double>, componentCount> components;
    std::vector<std::uint32_t> pixels; ///< which sum the ray's colour goes to
    std::vector<int> levelsLeft;
    std::vector<MediaIndex> media;

    std::size_t size() const { return pixels.size(); }
    double at(Component c, std::size_t i) const { return components[c][i]; }

    void clear() {
        for (auto& c : components) c.clear();
        pixels.clear(), levelsLeft.clear(), media.clear();
    }
    void push(const std::array<double, componentCount>& values, std::uint32_t pixel, int levels,
              MediaIndex medium) {
        for (std::size_t c = 0; c < componentCount; ++c) components[c].push_back(values[c]);
        pixels.push_back(pixel), levelsLeft.push_back(levels), media.push_back(medium);
    }
    void append(const RayQueue& other) {
        for (std::size_t c = 0; c < componentCount; ++c)
            components[c].insert(components[c].end(), other.components[c].begin(), other.components[c].end());
        pixels.insert(pixels.end(), other.pixels.begin(), other.pixels.end());
        levelsLeft.insert(levelsLeft.end(), other.levelsLeft.begin(), other.levelsLeft.end());
        media.insert(media.end(), other.media.begin(), other.media.end());
    }
};

} // namespace yarte::trace
