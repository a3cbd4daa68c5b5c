#include "validate/attribution.h"

#include "validate/aov_edges.h"
#include "validate/evidence.h"
#include "validate/regions.h"

#include <algorithm>
#include <fmt/format.h>
#include <map>

namespace yarte::validate {

namespace {

/// More regions than these would help nobody; what is left over becomes one.
constexpr std::size_t maxRegions = 50;
/// A region is an edge's if at least this part of its pixels lies along it.
constexpr double mostly = 0.8;
/// Single pixels along outlines: while no body's outline is gone by more than this part.
constexpr double sparse = 0.15;

/// The number that `of` gives for the most pixels; -1 if that is what it gives.
template <class Of>
int mostFrequent(const std::vector<std::size_t>& pixels, Of of) {
    std::map<int, int> counts;
    for (const std::size_t p : pixels) ++counts[of(p)];
    const auto most = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == counts.end() ? -1 : most->first;
}

double part(const std::vector<std::size_t>& pixels, const std::vector<bool>& mask) {
    const auto count = std::count_if(pixels.begin(), pixels.end(), [&](std::size_t p) { return mask[p]; });
    return static_cast<double>(count) / static_cast<double>(pixels.size());
}

class RegionAttribution {
public:
    RegionAttribution(const Difference& difference, const Aov& aov)
        : difference_(difference), aov_(aov), edges_(edgesOf(aov)) {}

    /// Every pixel that differs lies along some edge, and those are few: not a thing that has changed, but
    /// decisions that fell the other way.
    bool isEdgesOnly() const;
    /// The finding of a region that nothing else explains.
    Finding find(const std::vector<std::size_t>& pixels) const;
    /// Where a region lies, seen from the body that is to blame: ": its shadow".
    std::string role(const Finding& common, const std::vector<std::size_t>& pixels) const;

private:
    /// `text` has the place of the body's name.
    Finding about(Cause cause, int body, const char* text) const {
        if (body < 0) return {cause, {}, {}, "", 0, fmt::format(fmt::runtime(text), "background")};
        const AovBody& b = aov_.bodies[static_cast<std::size_t>(body)];
        return {cause, body, {}, b.name(), b.line, fmt::format(fmt::runtime(text), b.name())};
    }
    int nearestAround(std::size_t pixel) const;

    const Difference& difference_;
    const Aov& aov_;
    AovEdges edges_;
};

bool RegionAttribution::isEdgesOnly() const {
    for (std::size_t p = 0; p < aov_.size(); ++p)
        if (difference_.differs(p) && !edges_.outline[p] && !edges_.shadow[p] && !edges_.mirrored[p] &&
            !edges_.seen[p])
            return false;
    const Evidence evidence = evidenceOf(difference_, aov_);
    return std::all_of(evidence.bodies.begin(), evidence.bodies.end(), [](const BodyEvidence& e) {
        return e.outline.rate() <= sparse && e.seen.rate() <= sparse;
    });
}

/// Of the bodies around a pixel the one in front, whose outline it is.
int RegionAttribution::nearestAround(std::size_t pixel) const {
    int found = aov_.body[pixel];
    float depth = aov_.depth[pixel];
    const auto width = static_cast<std::size_t>(aov_.width);
    for (const std::size_t q : {pixel - 1, pixel + 1, pixel - width, pixel + width, pixel - width - 1,
                                pixel - width + 1, pixel + width - 1, pixel + width + 1}) {
        if (q >= aov_.size() || aov_.depth[q] < 0 || (depth >= 0 && aov_.depth[q] >= depth)) continue;
        found = aov_.body[q], depth = aov_.depth[q];
    }
    return found;
}

Finding RegionAttribution::find(const std::vector<std::size_t>& pixels) const {
    const int body = mostFrequent(pixels, [&](std::size_t p) { return aov_.body[p]; });
    if (part(pixels, edges_.outline) >= mostly)
        return about(Cause::silhouette, mostFrequent(pixels, [&](std::size_t p) { return nearestAround(p); }),
                     "pixels along the outline of the {}");
    if (part(pixels, edges_.shadow) >= mostly)
        return about(Cause::shadowEdge, body, "pixels along the edge of a shadow on the {}");
    if (part(pixels, edges_.seen) >= mostly)
        return about(Cause::refraction, body, "pixels along an edge that is seen through the {}");
    if (part(pixels, edges_.mirrored) >= mostly)
        return about(Cause::reflection, body, "pixels along an edge that the {} mirrors");
    return about(Cause::unknown, body, "on the {}");
}

std::string RegionAttribution::role(const Finding& common, const std::vector<std::size_t>& pixels) const {
    if (!common.body) return {};
    const int body = *common.body;
    enum Role { itself, around, mirrored, shadow, elsewhere };
    const auto isNear = [&](std::size_t p) { return edges_.outline[p] && nearestAround(p) == body; };
    const int role = mostFrequent(pixels, [&](std::size_t p) -> int {
        if (aov_.body[p] == body) return itself;
        if (isNear(p)) return around;
        if (aov_.secondaryBodies.has(body, p)) return mirrored;
        return aov_.castingBodies.has(body, p) ? shadow : elsewhere;
    });
    switch (role) {
    case mirrored: return "; here in a mirror image or through glass";
    case shadow: return "; here in its shadow";
    default: return {};
    }
}

/// Everything beyond the largest regions as one.
Region restOf(const std::vector<PixelGroup>& groups) {
    Region rest = groups[maxRegions - 1].region;
    for (std::size_t i = maxRegions; i < groups.size(); ++i) {
        const Region& r = groups[i].region;
        rest.box = {std::min(rest.box.x0, r.box.x0), std::min(rest.box.y0, r.box.y0),
                    std::max(rest.box.x1, r.box.x1), std::max(rest.box.y1, r.box.y1)};
        rest.pixels += r.pixels;
        if (r.maxError > rest.maxError) rest.maxError = r.maxError, rest.maxErrorAt = r.maxErrorAt;
    }
    rest.finding.explanation = fmt::format("{} smaller regions", groups.size() - maxRegions + 1);
    return rest;
}

/// `finding` names the cause of a group of pixels.
template <class Find>
std::vector<Region> regionsOf(const std::vector<PixelGroup>& groups, Find find) {
    std::vector<Region> regions;
    for (const PixelGroup& group : groups) {
        if (groups.size() > maxRegions && regions.size() + 1 == maxRegions) {
            regions.push_back(restOf(groups));
            break;
        }
        regions.push_back(group.region);
        regions.back().finding = find(group.pixels);
    }
    return regions;
}

} // namespace

Explanation explain(const Difference& difference, const Aov& aov) {
    const std::vector<PixelGroup> groups = groupPixels(difference);
    if (groups.empty()) return {};
    const RegionAttribution attribution(difference, aov);
    if (!attribution.isEdgesOnly())
        if (const Finding common = commonCause(difference, aov); common.cause != Cause::unknown)
            return {common, regionsOf(groups, [&](const std::vector<std::size_t>& pixels) {
                        Finding finding = common;
                        finding.explanation += attribution.role(common, pixels);
                        return finding;
                    })};
    return {{}, regionsOf(groups, [&](const std::vector<std::size_t>& pixels) {
                return attribution.find(pixels);
            })};
}

Explanation explain(const Difference& difference) {
    return {{},
            regionsOf(groupPixels(difference), [](const std::vector<std::size_t>&) { return Finding{}; })};
}

} // namespace yarte::validate
