// Difference: two pictures of one size and where they differ.
#pragma once

#include "validate/metrics.h"
#include "validate/picture.h"

#include <cstddef>
#include <vector>

namespace yarte::validate {

class Difference {
public:
    /// A pixel differs if its error exceeds `threshold`. The pictures must outlive this.
    Difference(ImageView a, ImageView b, double threshold);

    int width() const { return a_.width; }
    int height() const { return a_.height; }
    std::size_t size() const { return differs_.size(); }
    double threshold() const { return threshold_; }
    bool differs(std::size_t pixel) const { return differs_[pixel]; }
    std::size_t count() const { return count_; } ///< pixels that differ
    /// b - a: what is to be explained.
    Colour at(std::size_t pixel) const { return b_.pixels[pixel] + -1.0 * a_.pixels[pixel]; }
    Colour a(std::size_t pixel) const { return a_.pixels[pixel]; }
    Colour b(std::size_t pixel) const { return b_.pixels[pixel]; }
    double error(std::size_t pixel) const { return pixelError(a_.pixels[pixel], b_.pixels[pixel]); }

private:
    ImageView a_, b_;
    double threshold_;
    std::vector<bool> differs_;
    std::size_t count_ = 0;
};

} // namespace yarte::validate
