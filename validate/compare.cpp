#include "validate/compare.h"

#include <fmt/format.h>

namespace yarte::validate {

void checkFinite(const NamedPicture& p) {
    const NonFinite found = nonFinitePixels(p.picture.view());
    if (found.count > 0)
        throw CaseError(fmt::format("{} has nan or infinity in {} pixel{}, the first at ({}, {})", p.name,
                                    found.count, found.count == 1 ? "" : "s", found.first.x, found.first.y));
}

Comparison compare(const NamedPicture& a, const NamedPicture& b, const Tolerance& tolerance) {
    if (a.picture.width != b.picture.width || a.picture.height != b.picture.height)
        throw CaseError(fmt::format("sizes differ: {} is {}x{}, {} is {}x{}", a.name, a.picture.width,
                                    a.picture.height, b.name, b.picture.width, b.picture.height));
    checkFinite(a);
    checkFinite(b);
    const ImageView viewA = a.picture.view(), viewB = b.picture.view();
    Comparison result;
    result.maxAbs = maxAbs(viewA, viewB);
    result.rmse = rmse(viewA, viewB);
    result.psnr = psnr(result.rmse);
    result.flip = summary(flipMap(viewB, viewA));
    result.threshold = tolerance.threshold;
    result.pixelsOver = pixelsOver(viewA, viewB, tolerance.threshold);
    return result;
}

void decide(CaseReport& report, const Comparison& comparison, const Tolerance& tolerance) {
    report.comparison = comparison;
    report.verdict = judge(tolerance, comparison.pixelsOver);
    if (report.verdict == Verdict::fail)
        report.message = fmt::format(
            "{} of {} pixels differ by more than {:.4g}, the most at ({}, {}): {:.4g}", comparison.pixelsOver,
            static_cast<long>(report.width) * report.height, comparison.threshold, comparison.maxAbs.at.x,
            comparison.maxAbs.at.y, comparison.maxAbs.value);
}

double exposureFor(double max) {
    double exposure = 1;
    while (max * exposure > 1) exposure /= 2;
    return exposure;
}

} // namespace yarte::validate
