#include "validate/judging.h"

#include "validate/attribution.h"
#include "validate/difference.h"
#include "validate/text.h"
#include "validate/verdict.h"

#include <fmt/format.h>
#include <optional>

namespace yarte::validate {

namespace {

/// The scene's own light: an AOV knows nothing of the exposure.
Explanation explained(const CaseReport& report, const Picture& a, const Picture& b, double threshold,
                      const std::optional<Aov>& aov) {
    const Picture unexposedA = scaled(a, 1 / report.exposure), unexposedB = scaled(b, 1 / report.exposure);
    const Difference difference(unexposedA.view(), unexposedB.view(), threshold / report.exposure);
    Explanation explanation = aov ? explain(difference, *aov) : explain(difference);
    for (Region& region : explanation.regions) region.maxError *= report.exposure;
    return explanation;
}

std::string failureText(const CaseReport& report, const std::string& conditions) {
    const Comparison& found = *report.comparison;
    return fmt::format("{} of {} pixels differ by more than {:.4g}, the most at ({}, {}): {:.4g}\n{}",
                       found.pixelsOver, static_cast<long>(report.width) * report.height, found.threshold,
                       found.maxAbs.at.x, found.maxAbs.at.y, found.maxAbs.value, conditions);
}

} // namespace

FlipMap judgeCase(CaseReport& report, const NamedPicture& a, const NamedPicture& b,
                  const Tolerance& tolerance, const AovSource& makeAov) {
    Compared compared = compare(a, b, tolerance.threshold);
    const bool differs = compared.numbers.pixelsOver > 0;
    std::optional<Aov> aov;
    if (makeAov && needsAov(tolerance)) {
        aov = makeAov();
    } else if (makeAov && differs) {
        try {
            aov = makeAov();
        } catch (const CaseError&) {
            // The pictures differ: that is not hidden by a cause that cannot be found. Its command says why.
        }
    }
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
    if (differs) report.explanation = explained(report, a.picture, b.picture, tolerance.threshold, aov);
    return std::move(compared.flip);
}

} // namespace yarte::validate
