#include "validate/attribution.h"

#include "validate/attribution_linear.h"
#include "validate/evidence.h"

#include <algorithm>
#include <fmt/format.h>

namespace yarte::validate {

namespace {

// The limits below separate the right from the wrong answers of the mutation test (tests/validate), on seeds
// other than the test's.

/// Of the pixels that differ, so few may have nothing to do with the body that is to blame.
constexpr double fewUnrelated = 0.005;
/// A body that so much of the picture sees is not convicted by being seen.
constexpr double fillsPicture = 0.95;
/// Unexplained energy of a fit that is only a first approximation: where rays meet a body again and again,
/// its cr and ct are powers. Colours, with up to 18 factors, fit anything a little, hence `muchBetter`.
constexpr double fitsTransmission = 0.15, fitsOther = 0.4, muchBetter = 0.3;
/// Parts of outlines: one that has clearly moved; noise; and of the bodies' when it was the camera.
constexpr double hasMoved = 0.3, isNoise = 0.1, mostOutlines = 0.6;
/// A light that moves changes nearly all that it lights.
constexpr double nearlyAllLit = 0.8;

constexpr const char* isElsewhere = "is missing, moved or of another size";

/// A body that may be to blame for all pixels that differ: each sees it, or lies in its shadow.
struct Suspect {
    int body = -1;
    bool shadow = false; ///< some only lie in its shadow
    double reach = 0;
};

class Attribution {
public:
    Attribution(const Difference& difference, const Aov& aov)
        : difference_(difference), aov_(aov), evidence_(evidenceOf(difference, aov)) {}

    Finding find() const;

private:
    std::optional<Finding> exactBodyCause() const;
    std::optional<Finding> bodyCause() const;
    std::optional<Finding> light() const;
    std::optional<Finding> outlines() const;
    std::optional<Finding> seenOutlines() const;

    std::vector<Suspect> suspects() const;
    std::optional<Finding> approximateCause(const Suspect&) const;

    int bodyCount() const { return static_cast<int>(aov_.bodies.size()); }
    const BodyEvidence& evidence(int body) const { return evidence_.bodies[static_cast<std::size_t>(body)]; }
    bool transmits(int body) const {
        return !isBlack(aov_.bodies[static_cast<std::size_t>(body)].transmission);
    }
    Finding about(Cause cause, int body, const char* text) const {
        const AovBody& b = aov_.bodies[static_cast<std::size_t>(body)];
        return {cause, body, {}, b.name(), b.line, fmt::format("the {} {}", b.name(), text)};
    }
    static Finding camera() {
        return {Cause::camera, {}, {},
                "camera",      0,  "the camera differs: the outlines of all bodies have moved"};
    }

    const Difference& difference_;
    const Aov& aov_;
    Evidence evidence_;
};

/// Colours, exponent, cr or ct of one body, if that leaves nothing over.
std::optional<Finding> Attribution::exactBodyCause() const {
    std::optional<Finding> best;
    double least = explained;
    for (int body = 0; body < bodyCount(); ++body) {
        const BodyEvidence& e = evidence(body);
        if (e.unrelated > fewUnrelated) continue;
        // Gone, with one colour in its place: that is no colour of its own but the background behind it.
        const bool isGone = e.isGone() || (e.outline.pairs == 0 && e.seen.rate() > hasMoved);
        if (isGone && e.isUniform) continue;
        const bool shadow = e.unseen > fewUnrelated;
        for (const Suspicion& s : suspicions(difference_, aov_, body)) {
            if (shadow && s.finding.cause != Cause::refraction)
                break; // no colour, no mirror changes a shadow
            if (s.fit.leftover > explained) continue;
            if (s.fit.leftover < least || !best) least = s.fit.leftover, best = s.finding;
            break;
        }
    }
    return best;
}

/// Those first that the fewest pixels see.
std::vector<Suspect> Attribution::suspects() const {
    std::vector<Suspect> list;
    for (int body = 0; body < bodyCount(); ++body) {
        const BodyEvidence& e = evidence(body);
        if (e.unrelated > fewUnrelated || e.isGone()) continue;
        // Outlines of other bodies stay where they are.
        if (evidence_.outline.vanished - e.outline.vanished > 2 + 0.03 * evidence_.outline.pairs) continue;
        list.push_back({body, e.unseen > fewUnrelated, e.reach});
    }
    std::sort(list.begin(), list.end(), [](const Suspect& a, const Suspect& b) { return a.reach < b.reach; });
    return list;
}

std::optional<Finding> Attribution::approximateCause(const Suspect& suspect) const {
    std::optional<Finding> best;
    double least = 1;
    for (const Suspicion& s : suspicions(difference_, aov_, suspect.body)) {
        const bool isColour = s.finding.cause == Cause::shading,
                   isTransmission = s.finding.cause == Cause::refraction;
        if ((suspect.shadow && !isTransmission) || (isColour && suspect.reach > fillsPicture)) continue;
        if (s.fit.unexplained > (isTransmission ? fitsTransmission : fitsOther)) continue;
        if (best && s.fit.unexplained > (isColour ? muchBetter : 1) * least) continue;
        least = s.fit.unexplained, best = s.finding;
    }
    return best;
}

/// One body is to blame, by elimination: nothing else could reach these pixels and only these.
std::optional<Finding> Attribution::bodyCause() const {
    const std::vector<Suspect> list = suspects();
    for (const Suspect& s : list) {
        if (!transmits(s.body) && evidence(s.body).seen.rate() > hasMoved)
            return about(Cause::body, s.body, isElsewhere);
        if (const auto cause = approximateCause(s)) return cause;
    }
    if (light()) return std::nullopt;
    for (const Suspect& s : list)
        if (transmits(s.body) && !s.shadow && s.reach <= fillsPicture)
            return about(Cause::refraction, s.body, "refracts differently: its ior differs");
    for (const Suspect& s : list) // no material explains the shadow
        if (s.shadow && s.reach <= fillsPicture) return about(Cause::body, s.body, isElsewhere);
    return std::nullopt;
}

/// Nearly all that a light lights differs, and yet all outlines are where they were.
std::optional<Finding> Attribution::light() const {
    if (evidence_.differingBackground > 0 || evidence_.outline.rate() > isNoise ||
        evidence_.seen.rate() > isNoise)
        return std::nullopt;
    if (std::any_of(evidence_.bodies.begin(), evidence_.bodies.end(),
                    [](const BodyEvidence& e) { return e.isGone(); }))
        return std::nullopt;
    const std::vector<double>& parts = evidence_.litDiffering;
    const auto most = std::max_element(parts.begin(), parts.end());
    if (most == parts.end() || *most <= nearlyAllLit) return std::nullopt;
    const auto number = static_cast<std::size_t>(most - parts.begin());
    const AovLight& l = aov_.lights[number];
    return Finding{Cause::light, {},     static_cast<int>(number),
                   l.name(),     l.line, fmt::format("the {} has moved", l.name())};
}

/// Outlines have moved: all bodies' for the camera, else the body's whose moved most.
std::optional<Finding> Attribution::outlines() const {
    const Outline& all = evidence_.outline;
    if (all.vanished < 3 || all.rate() < 0.01) return std::nullopt;
    int best = 0, movedPairs = 0, movedBodies = 0;
    for (int body = 0; body < bodyCount(); ++body) {
        const Outline& o = evidence(body).outline;
        if (o.vanished > evidence(best).outline.vanished) best = body;
        if (o.rate() > 0.02) movedPairs += o.pairs, ++movedBodies;
    }
    const bool isShared = movedBodies > 1 && movedPairs > mostOutlines * all.pairs &&
                          evidence(best).outline.vanished < 0.8 * all.vanished;
    if (isShared && evidence_.differingPart > 0.3) return camera();
    return about(Cause::body, best, isElsewhere);
}

/// The same where things are seen only through glass or in mirrors.
std::optional<Finding> Attribution::seenOutlines() const {
    int best = -1, movedPairs = 0;
    double most = isNoise;
    for (int body = 0; body < bodyCount(); ++body) {
        const Outline& o = evidence(body).seen;
        if (o.rate() > 0.4) movedPairs += o.pairs;
        if (o.vanished >= 3 && o.rate() > most) most = o.rate(), best = body;
    }
    if (best < 0) return std::nullopt;
    if (movedPairs > mostOutlines * evidence_.seen.pairs) return camera();
    return about(Cause::body, best, isElsewhere);
}

Finding Attribution::find() const {
    if (difference_.count() == 0) return {};
    if (const auto cause = globalLinearCause(difference_, aov_)) return *cause;
    if (const auto cause = exactBodyCause()) return *cause;
    if (const auto cause = bodyCause()) return *cause;
    if (const auto cause = light()) return *cause;
    if (const auto cause = outlines()) return *cause;
    return seenOutlines().value_or(Finding{});
}

} // namespace

Finding commonCause(const Difference& difference, const Aov& aov) {
    return Attribution(difference, aov).find();
}

} // namespace yarte::validate
