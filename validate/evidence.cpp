#include "validate/evidence.h"

#include <optional>

namespace yarte::validate {

namespace {

/// A step of colour below so many thresholds is not clear enough to be missed.
constexpr double clearStep = 20;
/// A step is gone if less than this part of it is left.
constexpr double goneStep = 0.3;

double ratio(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

class Gathering {
public:
    Gathering(const Difference& difference, const Aov& aov)
        : difference_(difference), aov_(aov), seeing_(aov.bodies.size()), shadowed_(aov.bodies.size()),
          reached_(aov.bodies.size()), colours_(aov.bodies.size()) {
        evidence_.bodies.resize(aov.bodies.size());
    }

    Evidence gather();

private:
    BodyEvidence& body(int number) { return evidence_.bodies[static_cast<std::size_t>(number)]; }
    void addPixel(std::size_t p);
    void addColour(std::size_t p);
    void addPair(std::size_t p, std::size_t q);
    void addSeenPair(std::size_t p, std::size_t q, const std::vector<int>& ids);
    bool isGone(std::size_t p, std::size_t q) const {
        return (difference_.differs(p) || difference_.differs(q)) &&
               pixelError(difference_.b(p), difference_.b(q)) <
                   goneStep * pixelError(difference_.a(p), difference_.a(q));
    }
    double litDiffering(const AovLight&) const;

    const Difference& difference_;
    const Aov& aov_;
    Evidence evidence_;
    std::vector<std::size_t> seeing_,
        shadowed_; ///< by body: pixels that differ and see it, lie in its shadow alone
    std::vector<std::size_t> reached_;
    std::vector<std::optional<Colour>> colours_; ///< by body: of picture b where the camera saw it first
    std::size_t shown_ = 0, shownDiffering_ = 0;
};

void Gathering::addPixel(std::size_t p) {
    const bool differs = difference_.differs(p);
    const int first = aov_.body[p];
    const auto sees = [&](int b) { return b == first || aov_.secondaryBodies.has(b, p); };
    const auto see = [&](int b) {
        ++reached_[static_cast<std::size_t>(b)];
        seeing_[static_cast<std::size_t>(b)] += differs;
    };
    if (first >= 0) {
        ++shown_, shownDiffering_ += differs;
        see(first);
        addColour(p);
    } else {
        evidence_.differingBackground += differs;
    }
    aov_.secondaryBodies.forEach(p, [&](int b) {
        if (b != first) see(b);
    });
    aov_.castingBodies.forEach(p, [&](int b) {
        if (sees(b)) return;
        ++reached_[static_cast<std::size_t>(b)];
        shadowed_[static_cast<std::size_t>(b)] += differs;
    });
}

void Gathering::addColour(std::size_t p) {
    std::optional<Colour>& colour = colours_[static_cast<std::size_t>(aov_.body[p])];
    if (!colour) colour = difference_.b(p);
    if (pixelError(*colour, difference_.b(p)) > difference_.threshold()) body(aov_.body[p]).isUniform = false;
}

void Gathering::addPair(std::size_t p, std::size_t q) {
    if (pixelError(difference_.a(p), difference_.a(q)) < clearStep * difference_.threshold()) return;
    if (aov_.body[p] == aov_.body[q]) {
        addSeenPair(p, q, aov_.transmittedBody);
        addSeenPair(p, q, aov_.reflectedBody);
        return;
    }
    const auto isFar = [&](std::size_t pixel) { return aov_.depth[pixel] < 0; };
    const bool pInFront = isFar(q) || (!isFar(p) && aov_.depth[p] < aov_.depth[q]);
    for (Outline* o : {&body(aov_.body[pInFront ? p : q]).outline, &evidence_.outline})
        ++o->pairs, o->vanished += isGone(p, q);
}

/// Which of the two is in front is not known.
void Gathering::addSeenPair(std::size_t p, std::size_t q, const std::vector<int>& ids) {
    if (ids[p] == ids[q]) return;
    for (const int id : {ids[p], ids[q]}) {
        if (id < 0) continue;
        for (Outline* o : {&body(id).seen, &evidence_.seen}) ++o->pairs, o->vanished += isGone(p, q);
    }
}

double Gathering::litDiffering(const AovLight& light) const {
    std::size_t lit = 0, differing = 0;
    for (std::size_t p = 0; p < aov_.size(); ++p)
        if (maxComponent(light.share[p]) > difference_.threshold())
            ++lit, differing += difference_.differs(p);
    return ratio(differing, lit);
}

Evidence Gathering::gather() {
    const auto width = static_cast<std::size_t>(aov_.width);
    for (std::size_t p = 0; p < aov_.size(); ++p) {
        addPixel(p);
        if (p % width + 1 < width) addPair(p, p + 1);
        if (p + width < aov_.size()) addPair(p, p + width);
    }
    const std::size_t count = difference_.count();
    for (std::size_t b = 0; b < evidence_.bodies.size(); ++b) {
        BodyEvidence& e = evidence_.bodies[b];
        e.unseen = ratio(count - seeing_[b], count);
        e.unrelated = ratio(count - seeing_[b] - shadowed_[b], count);
        e.reach = ratio(reached_[b], aov_.size());
    }
    evidence_.differingPart = ratio(shownDiffering_, shown_);
    for (const AovLight& light : aov_.lights) evidence_.litDiffering.push_back(litDiffering(light));
    return std::move(evidence_);
}

} // namespace

Evidence evidenceOf(const Difference& difference, const Aov& aov) {
    return Gathering(difference, aov).gather();
}

} // namespace yarte::validate
