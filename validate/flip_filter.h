// Separable filters on planes of floats, one row of the result at a time: the intermediate of a row stays in
// the cache. Beyond its edges a plane repeats its edge pixels.
#pragma once

#include <cstddef>
#include <vector>

namespace yarte::validate::flip {

/// A filter along one direction, given by its weights at the offsets 0 ... radius and what the other side
/// has.
struct Kernel {
    enum class Kind {
        even,     ///< the same weights
        odd,      ///< their negatives; weights[0] is 0
        curvature ///< the same weights, of the differences from the centre: weights[0] makes the sum of all 0
    };
    Kind kind = Kind::even;
    std::vector<float> weights;
};

/// Rows of floats whose lengths are rounded up to whole blocks: the filters work by blocks, and what they
/// find or leave in the rest of a row means nothing. Only as many rows are kept as a filter looks at: those
/// stay in the cache, where a whole plane's would cost more time than the filters do.
class Plane {
public:
    static constexpr int block = 16; ///< floats: enough to keep the registers of any vector unit busy

    /// For filters up to `radius`: row y takes the place of row y - (2 radius + 1).
    Plane(int width, int height, int radius);

    int width() const { return width_; }
    int height() const { return height_; }
    std::size_t stride() const { return stride_; }
    float* row(int y) { return &values_[static_cast<std::size_t>(y % kept_) * stride_]; }
    const float* row(int y) const { return &values_[static_cast<std::size_t>(y % kept_) * stride_]; }

private:
    int width_, height_, kept_;
    std::size_t stride_;
    std::vector<float> values_;
};

/// One row with room for its edge pixels' repetition on both sides.
class PaddedRow {
public:
    /// For rows of planes like this one and kernels up to `maxRadius`.
    PaddedRow(const Plane& like, std::size_t maxRadius);

    /// Becomes row y of `plane` filtered along the columns.
    void filterColumns(const Plane& plane, int y, const Kernel&);
    /// Writes the row filtered along itself to the whole blocks of `out`.
    void filterAlong(const Kernel&, std::vector<float>& out) const;

private:
    std::size_t width_, stride_, maxRadius_;
    std::vector<float> values_;
};

} // namespace yarte::validate::flip
