// Aov: what YARTE knows of a picture's pixels besides their colour (`yarte --aov`; the channels are explained
// in yarte/README.md).
#pragma once

#include "validate/image_file.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace yarte::validate {

/// A body of the scene as its file has it.
struct AovBody {
    std::string kind; ///< the directive's name
    int line = 0;     ///< of the directive, from 1
    double exponent = 1, reflection = 0;
    Colour transmission; ///< ct times the tint

    std::string name() const; ///< "truncated cone at line 23"
};

struct AovLight {
    int line = 0;
    std::vector<Colour> arriving; ///< by pixel: part of its light that shadows leave at the first hit
    std::vector<float> mirror;    ///< R.L there
    std::vector<Colour> share;    ///< what it adds to the pixel
    Colour brightness;

    std::string name() const; ///< "light at line 9"
};

/// What a body adds to a pixel: see AovVisit in yarte/trace/aov.h. body < 0: nothing.
struct AovVisit {
    int body = -1;
    bool isBack = false;
    Colour weight, lit, highlight, reflected, transmitted;
};

/// Masks of numbered things, by pixel.
class AovMask {
public:
    AovMask() = default;
    explicit AovMask(std::vector<std::vector<std::uint32_t>> words) : words_(std::move(words)) {}

    bool has(int number, std::size_t pixel) const {
        const auto n = static_cast<std::size_t>(number);
        return n / bits < words_.size() && (words_[n / bits][pixel] >> (n % bits) & 1) != 0;
    }
    /// Calls `visit` with each number that the pixel has.
    template <class Visit>
    void forEach(std::size_t pixel, Visit visit) const {
        for (std::size_t plane = 0; plane < words_.size(); ++plane)
            for (std::uint32_t word = words_[plane][pixel]; word != 0; word &= word - 1)
                visit(static_cast<int>(plane * bits) + std::countr_zero(word));
    }
    bool same(std::size_t pixel, std::size_t other) const {
        for (const auto& plane : words_)
            if (plane[pixel] != plane[other]) return false;
        return true;
    }

private:
    static constexpr std::size_t bits = 24; ///< in one channel
    std::vector<std::vector<std::uint32_t>> words_;
};

struct Aov {
    int width = 0, height = 0;
    std::vector<AovBody> bodies;
    std::vector<AovLight> lights;
    // By pixel, row 0 on top:
    std::vector<int> body, reflectedBody, transmittedBody; ///< indices into bodies, or -1
    std::vector<float> depth;                              ///< along the camera ray; -1: nothing there
    std::vector<Colour> backgroundWeight;
    std::vector<std::vector<AovVisit>> visits; ///< the heaviest first
    AovMask shadowedLights, secondaryBodies, castingBodies;

    std::size_t size() const { return body.size(); }
};

/// From the channels of a file. Throws ImageError if they are not those of `yarte --aov`.
Aov aovFrom(const Layers&);

} // namespace yarte::validate
