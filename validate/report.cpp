#include "validate/report.h"

#include <algorithm>

namespace yarte::validate {

std::size_t Report::count(Verdict verdict) const {
    return static_cast<std::size_t>(
        std::count_if(cases.begin(), cases.end(), [&](const CaseReport& c) { return c.verdict == verdict; }));
}

Verdict Report::verdict() const {
    if (count(Verdict::error) > 0) return Verdict::error;
    return count(Verdict::fail) > 0 ? Verdict::fail : Verdict::pass;
}

std::string folderOf(const CaseReport& c) { return "images/" + c.name; }

std::vector<Finding> causes(const CaseReport& c) {
    constexpr std::size_t most = 3;
    if (c.explanation.common) return {*c.explanation.common};
    std::vector<Finding> found;
    for (const Region& region : c.explanation.regions) {
        const auto isKnown = [&](const Finding& f) { return f.explanation == region.finding.explanation; };
        if (region.finding.explanation.empty()) continue; // of pictures without a scene nothing is known
        if (found.size() < most && std::none_of(found.begin(), found.end(), isKnown))
            found.push_back(region.finding);
    }
    return found;
}

std::optional<double> speedRatio(const CaseReport& c) {
    const auto yarte = c.yarte.trace, povray = c.povray.trace;
    if (!yarte || !povray || *yarte <= 0 || *povray <= 0) return std::nullopt;
    return *povray / *yarte;
}

} // namespace yarte::validate
