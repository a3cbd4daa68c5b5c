#include "validate/attribution_linear.h"

#include "validate/attribution_fit.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace yarte::validate {

namespace {

std::string words(Colour c) {
    if (c.r == c.g && c.g == c.b) return fmt::format("{:+.3g}", c.r);
    return fmt::format("{:+.3g} {:+.3g} {:+.3g}", c.r, c.g, c.b);
}

std::vector<std::size_t> allPixels(const Difference& difference) {
    std::vector<std::size_t> pixels(difference.size());
    std::iota(pixels.begin(), pixels.end(), std::size_t{0});
    return pixels;
}

} // namespace

std::optional<Finding> globalLinearCause(const Difference& difference, const Aov& aov) {
    const std::vector<std::size_t> pixels = allPixels(difference);
    Column picture, background;
    for (const std::size_t p : pixels) {
        picture.push_back(difference.a(p));
        background.push_back(aov.backgroundWeight[p]);
    }
    if (const Fit fit = fitGrey(difference, pixels, picture); fit.leftover <= explained)
        return Finding{Cause::brightness,
                       {},
                       {},
                       "",
                       0,
                       fmt::format("the whole picture is {:.4g} times as bright", 1 + fit.factors[0].r)};
    if (const Fit fit = fitChannels(difference, pixels, {background}); fit.leftover <= explained)
        return Finding{Cause::background,
                       {},
                       {},
                       "",
                       0,
                       fmt::format("the background colour differs by {}", words(fit.factors[0]))};
    std::optional<Finding> best;
    double least = explained;
    for (std::size_t i = 0; i < aov.lights.size(); ++i) {
        const Fit fit = fitChannels(difference, pixels, {aov.lights[i].share});
        if (fit.leftover > least) continue;
        least = fit.leftover;
        const Colour k = fit.factors[0] + Colour{1, 1, 1};
        best = Finding{Cause::light,
                       {},
                       static_cast<int>(i),
                       aov.lights[i].name(),
                       aov.lights[i].line,
                       fmt::format("the {} is {:.3g} {:.3g} {:.3g} times as bright", aov.lights[i].name(),
                                   k.r, k.g, k.b)};
    }
    return best;
}

namespace {

/// The pixels of one body that can be fitted, and their pictures of its properties.
struct BodyColumns {
    std::vector<std::size_t> pixels;
    Column weight[2], lit[2], highlight[2]; ///< front, back
    Column reflected, transmitted;

    void add(std::size_t pixel, const std::vector<AovVisit>& visits, int body) {
        pixels.push_back(pixel);
        for (int side = 0; side < 2; ++side)
            for (Column* column : {&weight[side], &lit[side], &highlight[side]}) column->emplace_back();
        reflected.emplace_back(), transmitted.emplace_back();
        for (const AovVisit& visit : visits) {
            if (visit.body != body) continue;
            weight[visit.isBack].back() = visit.weight;
            lit[visit.isBack].back() = visit.lit;
            highlight[visit.isBack].back() = visit.highlight;
            reflected.back() += visit.reflected;
            transmitted.back() += visit.transmitted;
        }
    }
};

/// The pixels that `fits`.
template <class Fits>
BodyColumns columnsOf(const Aov& aov, int body, Fits fits) {
    BodyColumns columns;
    for (std::size_t p = 0; p < aov.size(); ++p)
        if (fits(p) && std::any_of(aov.visits[p].begin(), aov.visits[p].end(),
                                   [&](const AovVisit& v) { return v.body == body; }))
            columns.add(p, aov.visits[p], body);
    return columns;
}

/// The pixels whose camera ray, and no other, met the body.
BodyColumns metOnce(const Aov& aov, int body) {
    return columnsOf(aov, body,
                     [&](std::size_t p) { return aov.body[p] == body && !aov.secondaryBodies.has(body, p); });
}

/// Whether a good part of the pixels that differ is among them.
bool isEnough(const Difference& difference, const BodyColumns& c) {
    const auto differing =
        std::count_if(c.pixels.begin(), c.pixels.end(), [&](std::size_t p) { return difference.differs(p); });
    return differing >= 8 && static_cast<double>(differing) > 0.2 * static_cast<double>(difference.count());
}

/// The specular highlights that the body's directly seen pixels would have with another exponent.
Column highlights(const Aov& aov, const std::vector<std::size_t>& pixels, int body, double exponent) {
    Column column;
    for (const std::size_t p : pixels) {
        Colour sum;
        if (aov.body[p] == body)
            for (const AovLight& light : aov.lights)
                if (!isBlack(light.arriving[p]) && light.mirror[p] > 0)
                    sum += light.brightness *
                           (light.arriving[p] * std::pow(static_cast<double>(light.mirror[p]), exponent));
        column.push_back(sum);
    }
    return column;
}

/// A fit with a second highlight, of the exponent that explains most.
struct ExponentFit {
    Fit fit;
    double exponent = 0;
};

ExponentFit fitExponent(const Difference& difference, const Aov& aov, int body) {
    // Of highlights seen in mirrors no other exponent is known.
    BodyColumns c = metOnce(aov, body);
    if (!isEnough(difference, c))
        c = columnsOf(aov, body, [&](std::size_t p) { return aov.body[p] == body; });
    if (c.pixels.empty()) return {};
    const double old = aov.bodies[static_cast<std::size_t>(body)].exponent;
    const auto fitted = [&](double logarithm) {
        const double exponent = old * std::exp2(logarithm);
        return ExponentFit{
            fitChannels(difference, c.pixels,
                        {c.highlight[0], c.highlight[1], highlights(aov, c.pixels, body, exponent)}),
            exponent};
    };
    // A coarse search over powers of 2, then finer and finer around the best.
    ExponentFit best;
    double centre = 0;
    for (double step = 1, reach = 6; step > 1e-3; reach = step, step /= 4) {
        const double from = centre - reach, to = centre + reach;
        for (double at = from; at <= to; at += step)
            if (const ExponentFit tried = fitted(at); tried.fit.unexplained < best.fit.unexplained)
                best = tried, centre = at;
    }
    return best;
}

/// Three factors always explain some more than one: the tint is named if they leave a good deal less.
constexpr double muchLess = 0.5;

Finding findingOf(Cause cause, int number, const AovBody& body, const std::string& text) {
    return {cause, number, {}, body.name(), body.line, text};
}

/// cr, ct and the tint are linear only in pixels that meet the body once. Such a fit, if it explains these
/// and they are not too few; else one of all of the body's pixels, which is a first approximation.
template <class FitColumn>
Fit fitOnward(const Difference& difference, const Aov& aov, int body, const BodyColumns& all,
              Column BodyColumns::*column, FitColumn fitted) {
    if (const BodyColumns once = metOnce(aov, body); isEnough(difference, once))
        if (Fit fit = fitted(difference, once.pixels, once.*column); fit.leftover <= explained) return fit;
    return fitted(difference, all.pixels, all.*column);
}

Fit fitTint(const Difference& difference, const std::vector<std::size_t>& pixels, const Column& column) {
    return fitChannels(difference, pixels, {column});
}

} // namespace

std::vector<Suspicion> suspicions(const Difference& difference, const Aov& aov, int number) {
    const AovBody& body = aov.bodies[static_cast<std::size_t>(number)];
    const BodyColumns c = columnsOf(aov, number, [](std::size_t) { return true; });
    std::vector<Suspicion> list;
    if (c.pixels.empty()) return list;
    const auto add = [&](Cause cause, const std::string& text, Fit fit) {
        list.push_back({findingOf(cause, number, body, text), std::move(fit)});
    };
    if (!isBlack(body.transmission)) {
        Fit fit = fitOnward(difference, aov, number, c, &BodyColumns::transmitted, fitGrey);
        Fit tint = fitOnward(difference, aov, number, c, &BodyColumns::transmitted, fitTint);
        const bool isTinted = fit.leftover > explained && tint.unexplained < muchLess * fit.unexplained;
        add(Cause::refraction,
            isTinted ? fmt::format("the tint of the {} differs", body.name())
                     : fmt::format("the transmission (ct) of the {} differs by {:+.2g}", body.name(),
                                   fit.factors[0].r),
            isTinted ? tint : fit);
    }
    Fit mirror = fitOnward(difference, aov, number, c, &BodyColumns::reflected, fitGrey);
    add(Cause::reflection,
        fmt::format("the reflection (cr) of the {} differs by {:+.2g}", body.name(), mirror.factors[0].r),
        mirror);
    add(Cause::shading, fmt::format("the colours of the {} differ", body.name()),
        fitChannels(difference, c.pixels,
                    {c.weight[0], c.weight[1], c.lit[0], c.lit[1], c.highlight[0], c.highlight[1]}));
    if (list.back().fit.leftover <= explained) return list;
    const ExponentFit other = fitExponent(difference, aov, number);
    add(Cause::shading,
        fmt::format("the exponent of the {} differs: {:.3g} instead of {:.3g}", body.name(), other.exponent,
                    body.exponent),
        other.fit);
    return list;
}

} // namespace yarte::validate
