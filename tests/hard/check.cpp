#include "tests/hard/check.h"

#include "yarte/lang/scene_printer.h"
#include "yarte/trace/search.h"

#include <fmt/format.h>

namespace yarte::hard {
namespace {

double ulp(double x) { return 2 * halfUlp(x); }

std::string describe(const std::optional<TrueHit>& hit) {
    if (!hit) return "miss";
    return fmt::format("{} body {} face {} at {}", hit->entering ? "enters" : "leaves", hit->body, hit->face,
                       toText(hit->t, 20));
}

/// Of the element's face in its mesh; 0 of other shapes.
std::size_t faceOf(const World& world, trace::ElementId element) {
    std::size_t face = 0;
    while (element.index > face &&
           world.bodyOf({static_cast<std::uint32_t>(element.index - face - 1)}) == world.bodyOf(element))
        ++face;
    return face;
}

} // namespace

Answer answer(const Case& c, const Truth& truth) {
    if (!truth.isDecidable) return {};
    const WorldPtr world = buildWorld(c.scene, {1, 1});
    const trace::Ray ray{c.ray.origin, c.ray.direction, {}};
    const auto hit = nearestHit(*world, ray);
    Answer result;
    const bool isSame =
        hit.has_value() == truth.hit.has_value() &&
        (!hit || (world->bodyOf(hit->element).index == truth.hit->body &&
                  faceOf(*world, hit->element) == truth.hit->face && hit->entering == truth.hit->entering));
    if (!isSame) {
        const std::string got =
            hit ? fmt::format("{} body {} face {} at {:.17g}", hit->entering ? "enters" : "leaves",
                              world->bodyOf(hit->element).index, faceOf(*world, hit->element), hit->t)
                : "miss";
        result.isRight = false;
        result.wrong = fmt::format("got: {}; true: {}; {} is {} +- {:.3g}", got, describe(truth.hit),
                                   truth.deciding, toText(truth.value, 6), truth.range);
        return result;
    }
    if (!hit) return result;
    const auto distance = [](const Real& a, double b) { return static_cast<double>(abs(a - Real(b))); };
    result.tError = distance(truth.hit->t, hit->t) / ulp(static_cast<double>(truth.hit->t)) /
                    std::max(1.0, truth.hit->tCondition);
    const auto normalAt = [&](double t) {
        return world->visit(hit->element,
                            [&](const auto& shape) { return outwardNormal(shape, ray.at(t), hit->part); });
    };
    const Vec3 n = normalAt(hit->t);
    const Vec<Real>& exact = truth.hit->normal;
    result.normalError = length({distance(exact.x, n.x), distance(exact.y, n.y), distance(exact.z, n.z)}) /
                         0x1p-52 / std::max(1.0, truth.hit->normalCondition);
    const double turnedByUlps = length(normalAt(hit->t * (1 + 0x1p-52)) - normalAt(hit->t * (1 - 0x1p-52)));
    if (std::max(maxError * truth.hit->normalCondition * 0x1p-52, turnedByUlps) > maxNormalBlur)
        result.normalError = 0;
    if (!(result.tError <= maxError) || !(result.normalError <= maxError))
        result.wrong =
            fmt::format("t is off by {:.3g}, the normal by {:.3g}, conditions {:.3g}, {:.3g}; true: {}, "
                        "got {:.17g}",
                        result.tError, result.normalError, truth.hit->tCondition, truth.hit->normalCondition,
                        describe(truth.hit), hit->t);
    return result;
}

std::string toText(const Case& c) {
    const auto& [o, d] = c.ray;
    return fmt::format("{}ray {:a} {:a} {:a}  {:a} {:a} {:a}\n", printScene(c.scene), o.x, o.y, o.z, d.x, d.y,
                       d.z);
}

void Score::add(const Case& c) {
    ++cases;
    const Truth truth = truthOf(c.scene, c.ray);
    if (!truth.isDecidable) return;
    ++decidable;
    hits += truth.hit.has_value();
    const Answer a = answer(c, truth);
    wrongDecisions += !a.isRight;
    inexact += a.isRight && !a.wrong.empty();
    worstT = std::max(worstT, a.tError), worstNormal = std::max(worstNormal, a.normalError);
    if (!a.wrong.empty() && wrongDecisions + inexact <= 3) examples += a.wrong + '\n' + toText(c);
}

} // namespace yarte::hard
