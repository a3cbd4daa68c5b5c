#include "validate/judging.h"

#include "validate/attribution.h"
#include "validate/difference.h"
#include "validate/removal.h"
#include "validate/text.h"
#include "validate/verdict.h"

#include <fmt/format.h>
#include <optional>

namespace yarte::validate {

namespace {

/// The scene's own light: an AOV knows nothing of the exposure.
Explanation explained(const CaseReport& report, const Picture& a, const Picture& b, double threshold,
                      const std::optional<Aov>& aov, const std::optional<Aov>& older) {
    const Picture unexposedA = scaled(a, 1 / report.exposure), unexposedB = scaled(b, 1 / report.exposure);
    const Difference difference(unexposedA.view(), unexposedB.view(), threshold / report.exposure);
    std::optional<Explanation> removal;
    if (aov && older && older->size() == aov->size())
        removal =
            explainRemoval(Difference(unexposedB.view(), unexposedA.view(), threshold / report.exposure),
                           *older, aov->bodies);
    Explanation explanation = removal ? *removal : aov ? explain(difference, *aov) : explain(difference);
    for (Region& region : explanation.regions) region.maxError *= report.exposure;
    return explanation;
}

std::string failureText(const CaseReport& report, const std::string& conditions) {
    const Comparison& found = *report.comparison;
    return fmt::format("{} of {} pixels differ by more than {:.4g}, the most at ({}, {}): {:.4g}\n{}",
                       found.pixelsOver, static_cast<long>(report.width) * report.height, found.threshold,
                       found.maxAbs.at.x, found.maxAbs.at.y, found.maxAbs.value, conditions);
}

/// The AOV, if it can be made. That the pictures differ is not hidden by a cause that cannot be found; the
/// command of the program says why.
std::optional<Aov> aovIfPossible(const AovSource& make) {
    if (!make) return std::nullopt;
    try {
        return make();
    } catch (const CaseError&) {
        return std::nullopt;
    } catch (const ImageError&) {
        return std::nullopt;
    }
}

} // namespace

FlipMap judgeCase(CaseReport& report, const NamedPicture& a, const NamedPicture& b,
                  const Tolerance& tolerance, const AovSource& makeAov, const AovSource& makeOlderAov) {
    Compared compared = compare(a, b, tolerance.threshold);
    const bool differs = compared.numbers.pixelsOver > 0;
    std::optional<Aov> aov;
    if (makeAov && needsAov(tolerance))
        aov = makeAov();
    else if (differs)
        aov = aovIfPossible(makeAov);
    try {
        const Judgement judgement =
            judge(tolerance, {a.picture.view(), b.picture.view(), compared.flip, aov ? &*aov : nullptr});
        report.comparison = compared.numbers;
        report.tolerance = cleanText(tolerance.source);
        report.conditions = judgement.conditions;
        report.verdict = judgement.holds ? Verdict::pass : Verdict::fail;
        if (!judgement.holds) report.message = failureText(report, judgement.message);
    } catch (const JudgementError& error) {
        throw CaseError(cleanText(error.what()));
    }
    if (differs)
        report.explanation = explained(report, a.picture, b.picture, tolerance.threshold, aov,
                                       aov ? aovIfPossible(makeOlderAov) : std::nullopt);
    return std::move(compared.flip);
}

} // namespace yarte::validate
