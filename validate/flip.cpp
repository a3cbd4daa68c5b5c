#include "validate/flip.h"

#include "validate/flip_colour.h"
#include "validate/flip_filter.h"
#include "validate/flip_kernels.h"

#include <algorithm>
#include <cmath>

namespace yarte::validate {

namespace {

using namespace flip;

struct OpponentPlanes {
    Plane y, cx, cz;

    explicit OpponentPlanes(ImageView image)
        : y(image.width, image.height), cx(image.width, image.height), cz(image.width, image.height) {
        for (int row = 0; row < image.height; ++row)
            for (int x = 0; x < image.width; ++x) {
                const Vec3 v = ycxczFromXyz(xyzFromRgb(clampedToDisplay(image.at(x, row))));
                y.row(row)[x] = static_cast<float>(v.x);
                cx.row(row)[x] = static_cast<float>(v.y);
                cz.row(row)[x] = static_cast<float>(v.z);
            }
    }
};

/// One row of one picture as FLIP sees it.
class SeenRow {
public:
    SeenRow(const OpponentPlanes& planes, const Kernels& kernels)
        : planes_(planes), kernels_(kernels), scratch_(planes.y, kernels.maxRadius) {
        for (auto* row : {&y_, &cx_, &cz_, &czMore_, &edgeX_, &edgeY_, &pointX_, &pointY_})
            row->resize(planes.y.stride());
        lab_.resize(planes.y.stride());
    }

    void moveTo(int row) {
        filter(planes_.y, row, kernels_.luminance, kernels_.luminance, y_);
        filter(planes_.cx, row, kernels_.redGreen, kernels_.redGreen, cx_);
        filter(planes_.cz, row, kernels_.blueYellow[0], kernels_.blueYellowWeighted[0], cz_);
        filter(planes_.cz, row, kernels_.blueYellow[1], kernels_.blueYellowWeighted[1], czMore_);

        for (std::size_t x = 0; x < lab_.size(); ++x) lab_[x] = huntLab({y_[x], cx_[x], cz_[x] + czMore_[x]});

        filter(planes_.y, row, kernels_.gauss, kernels_.edge, edgeX_);
        scratch_.filterAlong(kernels_.point, pointX_);
        filter(planes_.y, row, kernels_.edge, kernels_.gauss, edgeY_);
        filter(planes_.y, row, kernels_.point, kernels_.gauss, pointY_);
    }

    /// The filtered colour in Hunt-adjusted CIELAB.
    const Vec3& colour(std::size_t x) const { return lab_[x]; }
    /// Features are defined on (Y + 16)/116; of a zero-sum kernel's result only the factor remains.
    double edge(std::size_t x) const {
        return std::sqrt(edgeX_[x] * edgeX_[x] + edgeY_[x] * edgeY_[x]) / 116;
    }
    double point(std::size_t x) const {
        return std::sqrt(pointX_[x] * pointX_[x] + pointY_[x] * pointY_[x]) / 116;
    }

private:
    static Vec3 huntLab(Vec3 ycxcz) {
        return huntLabFromXyz(xyzFromRgb(clampedToDisplay(rgbFromXyz(xyzFromYcxcz(ycxcz)))));
    }
    void filter(const Plane& plane, int row, const Kernel& columns, const Kernel& along,
                std::vector<float>& out) {
        scratch_.filterColumns(plane, row, columns);
        scratch_.filterAlong(along, out);
    }

    const OpponentPlanes& planes_;
    const Kernels& kernels_;
    PaddedRow scratch_;
    std::vector<float> y_, cx_, cz_, czMore_, edgeX_, edgeY_, pointX_, pointY_;
    std::vector<Vec3> lab_;
};

/// In single precision, which the map has: it takes a third of the time.
double power(double base, double exponent) {
    return static_cast<double>(std::pow(static_cast<float>(base), static_cast<float>(exponent)));
}

double poweredHyab(Vec3 a, Vec3 b) { return power(hyab(a, b), 0.7); }

/// The colour difference in [0, 1]: small ones take 95 % of the range [Andersson20, eq. 4].
double colourDifference(Vec3 a, Vec3 b) {
    static const double largest =
        poweredHyab(huntLabFromXyz(xyzFromRgb({0, 1, 0})), huntLabFromXyz(xyzFromRgb({0, 0, 1})));
    constexpr double pc = 0.4, pt = 0.95;
    const double d = poweredHyab(a, b), knee = pc * largest;
    return d < knee ? d * pt / knee : pt + (d - knee) / (largest - knee) * (1 - pt);
}

double featureDifference(const SeenRow& a, const SeenRow& b, std::size_t x) {
    const double d = std::max(std::abs(a.edge(x) - b.edge(x)), std::abs(a.point(x) - b.point(x)));
    return std::sqrt(d / std::sqrt(2.0));
}

} // namespace

FlipMap flipMap(ImageView reference, ImageView test, double pixelsPerDegree) {
    const Kernels kernels(pixelsPerDegree);
    const OpponentPlanes planesA(reference), planesB(test);
    SeenRow a(planesA, kernels), b(planesB, kernels);
    FlipMap map{reference.width, reference.height, {}};
    map.values.reserve(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
    for (int y = 0; y < map.height; ++y) {
        a.moveTo(y);
        b.moveTo(y);
        for (std::size_t x = 0; x < static_cast<std::size_t>(map.width); ++x) {
            const double colour = colourDifference(a.colour(x), b.colour(x));
            map.values.push_back(static_cast<float>(power(colour, 1 - featureDifference(a, b, x))));
        }
    }
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
