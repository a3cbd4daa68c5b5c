#include "validate/compare.h"

#include <fmt/format.h>

namespace yarte::validate {

void checkFinite(const NamedPicture& p) {
    const NonFinite found = nonFinitePixels(p.picture.view());
    if (found.count > 0)
        throw CaseError(fmt::format("{} has nan or infinity in {} pixel{}, the first at ({}, {})", p.name,
                                    found.count, found.count == 1 ? "" : "s", found.first.x, found.first.y));
}

Compared compare(const NamedPicture& a, const NamedPicture& b, double threshold) {
    if (!haveOneSize(a.picture, b.picture))
        throw CaseError(fmt::format("sizes differ: {} is {}x{}, {} is {}x{}", a.name, a.picture.width,
                                    a.picture.height, b.name, b.picture.width, b.picture.height));
    checkFinite(a);
    checkFinite(b);
    const ImageView viewA = a.picture.view(), viewB = b.picture.view();
    FlipMap flip = flipMap(viewB, viewA);
    Comparison result;
    result.maxAbs = maxAbs(viewA, viewB);
    result.rmse = rmse(viewA, viewB);
    result.psnr = psnr(result.rmse);
    result.flip = summary(flip);
    result.threshold = threshold;
    result.pixelsOver = pixelsOver(viewA, viewB, threshold);
    return {result, std::move(flip)};
}

double exposureFor(double max) {
    double exposure = 1;
    while (max * exposure > 1) exposure /= 2;
    return exposure;
}

} // namespace yarte::validate
