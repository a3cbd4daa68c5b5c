#include "validate/flip.h"

#include "validate/flip_colour.h"
#include "validate/flip_filter.h"
#include "validate/flip_kernels.h"
#include "validate/flip_power.h"
#include "validate/flip_wide.h"

#include <algorithm>
#include <cmath>

namespace yarte::validate {

namespace {

using namespace flip;

YARTE_WIDE void opponentRow(const Colour* pixels, int width, float* y, float* cx, float* cz) {
    for (int x = 0; x < width; ++x) {
        const Vec3 v = ycxczFromXyz(xyzFromRgb(clampedToDisplay(pixels[x])));
        y[x] = static_cast<float>(v.x);
        cx[x] = static_cast<float>(v.y);
        cz[x] = static_cast<float>(v.z);
    }
}

/// The rows of a picture around the one that is looked at, in opponent colours.
class OpponentRows {
public:
    OpponentRows(ImageView image, int radius)
        : y(image.width, image.height, radius), cx(y), cz(y), image_(image), radius_(radius) {}

    /// From row to row, downwards.
    void moveTo(int row) {
        for (const int end = std::min(row + radius_ + 1, image_.height); made_ < end; ++made_)
            opponentRow(&image_.at(0, made_), image_.width, y.row(made_), cx.row(made_), cz.row(made_));
    }

    Plane y, cx, cz;

private:
    ImageView image_;
    int radius_, made_ = 0;
};

/// One row of one picture as FLIP sees it, with the padding of a Plane's row.
struct SeenRow {
    std::vector<float> y, cx, cz, czMore; ///< filtered opponent colours; Cz is the sum of two
    std::vector<double> lightness, a, b;  ///< the same in Hunt-adjusted CIELAB
    std::vector<float> edgeX, edgeY, pointX,
        pointY; ///< of 116 times the luminance that features are defined on

    explicit SeenRow(std::size_t length) {
        for (auto* row : {&y, &cx, &cz, &czMore, &edgeX, &edgeY, &pointX, &pointY}) row->resize(length);
        for (auto* row : {&lightness, &a, &b}) row->resize(length);
    }
};

YARTE_WIDE void huntLabRow(SeenRow& row) {
    const std::size_t length = row.y.size();
    const float *y = row.y.data(), *cx = row.cx.data(), *cz = row.cz.data(), *czMore = row.czMore.data();
    double *lightness = row.lightness.data(), *a = row.a.data(), *b = row.b.data();
#pragma GCC ivdep
    for (std::size_t x = 0; x < length; ++x) {
        const Vec3 lab = huntLabFromXyz(
            xyzFromRgb(clampedToDisplay(rgbFromXyz(xyzFromYcxcz({y[x], cx[x], cz[x] + czMore[x]})))));
        lightness[x] = lab.x;
        a[x] = lab.y;
        b[x] = lab.z;
    }
}

/// Sees one row of a picture after the other.
class Eye {
public:
    Eye(ImageView image, const Kernels& kernels)
        : rows_(image, static_cast<int>(kernels.maxRadius)), kernels_(kernels),
          scratch_(rows_.y, kernels.maxRadius), seen_(rows_.y.stride()) {}

    const SeenRow& see(int row) {
        rows_.moveTo(row);
        filter(rows_.y, row, kernels_.luminance, kernels_.luminance, seen_.y);
        filter(rows_.cx, row, kernels_.redGreen, kernels_.redGreen, seen_.cx);
        filter(rows_.cz, row, kernels_.blueYellow[0], kernels_.blueYellowWeighted[0], seen_.cz);
        filter(rows_.cz, row, kernels_.blueYellow[1], kernels_.blueYellowWeighted[1], seen_.czMore);
        huntLabRow(seen_);

        filter(rows_.y, row, kernels_.gauss, kernels_.edge, seen_.edgeX);
        scratch_.filterAlong(kernels_.point, seen_.pointX);
        filter(rows_.y, row, kernels_.edge, kernels_.gauss, seen_.edgeY);
        filter(rows_.y, row, kernels_.point, kernels_.gauss, seen_.pointY);
        return seen_;
    }

private:
    void filter(const Plane& plane, int row, const Kernel& columns, const Kernel& along,
                std::vector<float>& out) {
        scratch_.filterColumns(plane, row, columns);
        scratch_.filterAlong(along, out);
    }

    OpponentRows rows_;
    const Kernels& kernels_;
    PaddedRow scratch_;
    SeenRow seen_;
};

constexpr double hyabExponent = 0.7;

/// What poweredHyab gives for the two colours of the display that are farthest apart, green and blue.
double largestColourDistance() {
    return power(hyab(huntLabFromXyz(xyzFromRgb({0, 1, 0})), huntLabFromXyz(xyzFromRgb({0, 0, 1}))),
                 hyabExponent);
}

/// The colour difference in [0, 1]: small ones take 95 % of the range [Andersson20, eq. 4].
YARTE_INLINE inline double colourDifference(const SeenRow& a, const SeenRow& b, std::size_t x,
                                            double largest) {
    constexpr double pc = 0.4, pt = 0.95;
    const double knee = pc * largest;
    const double d =
        power(hyab({a.lightness[x], a.a[x], a.b[x]}, {b.lightness[x], b.a[x], b.b[x]}), hyabExponent);
    return std::min(d, knee) * (pt / knee) + std::max(d - knee, 0.0) * ((1 - pt) / (largest - knee));
}

YARTE_INLINE inline double length(float x, float y) {
    return std::sqrt(static_cast<double>(x * x + y * y)) / 116;
}

YARTE_INLINE inline double featureDifference(const SeenRow& a, const SeenRow& b, std::size_t x) {
    const double edge = length(a.edgeX[x], a.edgeY[x]) - length(b.edgeX[x], b.edgeY[x]);
    const double point = length(a.pointX[x], a.pointY[x]) - length(b.pointX[x], b.pointY[x]);
    return std::sqrt(std::max(std::abs(edge), std::abs(point)) / std::numbers::sqrt2);
}

YARTE_WIDE void flipRow(const SeenRow& a, const SeenRow& b, int width, double largest, float* out) {
#pragma GCC ivdep
    for (std::size_t x = 0; x < static_cast<std::size_t>(width); ++x)
        out[x] =
            static_cast<float>(power(colourDifference(a, b, x, largest), 1 - featureDifference(a, b, x)));
}

} // namespace

FlipMap flipMap(ImageView reference, ImageView test, double pixelsPerDegree) {
    const Kernels kernels(pixelsPerDegree);
    const double largest = largestColourDistance();
    Eye eyeA(reference, kernels), eyeB(test, kernels);
    const auto width = static_cast<std::size_t>(reference.width);
    FlipMap map{reference.width, reference.height, {}};
    map.values.resize(width * static_cast<std::size_t>(map.height));
    for (int y = 0; y < map.height; ++y)
        flipRow(eyeA.see(y), eyeB.see(y), map.width, largest,
                &map.values[width * static_cast<std::size_t>(y)]);
    return map;
}

FlipSummary summary(const FlipMap& map) {
    double sum = 0;
    for (const float v : map.values) sum += v;
    const auto largest = std::max_element(map.values.begin(), map.values.end());
    const int at = static_cast<int>(largest - map.values.begin());
    return {sum / static_cast<double>(map.values.size()), *largest, {at % map.width, at / map.width}};
}

} // namespace yarte::validate
