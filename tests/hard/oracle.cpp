#include "tests/hard/oracle.h"

#include "tests/hard/surfaces.h"

namespace yarte::hard {
namespace {

template <class N>
struct Search {
    const Candidate<N>* nearest = nullptr;
    Decision weakest = signOf(Rational(1), "nothing");

    void dependOn(const Decision& d) { weakest = weaker(weakest, d); }
};

/// The first candidate at t > 0 and everything that this depends on.
template <class N>
Search<N> searchNearest(const std::vector<Candidate<N>>& candidates, const std::vector<Decision>& absences) {
    Search<N> search;
    for (const Decision& d : absences) search.dependOn(d);
    std::vector<std::pair<const Candidate<N>*, Decision>> possible; // with what makes it one
    for (const Candidate<N>& c : candidates) {
        const Decision ahead = signOf(c.t, "distance of the start from the surface");
        const bool counts = c.exists.sign >= 0 && ahead.sign > 0;
        // Either reason not to count is enough.
        Decision reason = weaker(c.exists, ahead);
        if (!counts)
            reason = c.exists.sign >= 0 ? ahead : ahead.sign > 0 ? c.exists : stronger(c.exists, ahead);
        if (counts || !reason.isCertain())
            possible.push_back({&c, reason});
        else
            search.dependOn(reason);
        if (!counts) continue;
        if (!search.nearest) {
            search.nearest = &c;
        } else {
            const int sign = compare(c.t, search.nearest->t, "order").sign;
            if (sign < 0 || (sign == 0 && c.body < search.nearest->body)) search.nearest = &c;
        }
    }
    for (const auto& [candidate, reason] : possible) {
        if (candidate == search.nearest || !search.nearest) {
            search.dependOn(reason);
            continue;
        }
        // One that is farther need not exist.
        const Decision order = compare(candidate->t, search.nearest->t, "order");
        const bool counts = candidate->exists.sign >= 0 && signOf(candidate->t, "").sign > 0;
        if (counts || order.sign > 0)
            search.dependOn(order.sign > 0 ? (counts ? order : stronger(order, reason)) : order);
        else
            search.dependOn(reason);
    }
    return search;
}

template <class N>
Line<N> lineOf(Inputs<N>& inputs, const InputRay& ray) {
    Line<N> line{vectorOf(inputs, ray.origin), {}};
    line.d = vectorOf(inputs, ray.direction);
    return line;
}

Vec<Uncertain> unit(const Vec<Uncertain>& v) { return v * inverse(sqrt(dot(v, v))); }

double sensitivity(const Inputs<Uncertain>& inputs, const Vec<Uncertain>& v) {
    const double x = inputs.sensitivity(v.x), y = inputs.sensitivity(v.y), z = inputs.sensitivity(v.z);
    return std::sqrt(x * x + y * y + z * z);
}

} // namespace

Truth truthOf(const Scene& scene, const InputRay& ray) {
    Inputs<Uncertain> inputs;
    const Line<Uncertain> line = lineOf(inputs, ray);
    const SurfaceFinder<Uncertain> found(inputs, line, scene);
    const auto [nearest, weakest] = searchNearest(found.candidates, found.absences);
    Truth truth;
    truth.deciding = weakest.what, truth.value = weakest.value, truth.range = weakest.range;
    truth.isDecidable = weakest.isCertain();
    if (!nearest) return truth;
    const Uncertain t = valueOf(nearest->t);
    const Vec<Uncertain> n = unit(nearest->normal(t));
    const Vec<Uncertain> there = unit(nearest->normal(inputs.number(t.value())));
    truth.hit = TrueHit{nearest->body,
                        nearest->face,
                        nearest->entering,
                        t.value(),
                        {n.x.value(), n.y.value(), n.z.value()},
                        inputs.sensitivity(t) / std::abs(static_cast<double>(t.value())),
                        sensitivity(inputs, n) + sensitivity(inputs, there)};
    return truth;
}

std::optional<TrueHit> exactTruthOf(const Scene& scene, const InputRay& ray) {
    Inputs<Rational> inputs;
    const Line<Rational> line = lineOf(inputs, ray);
    const SurfaceFinder<Rational> found(inputs, line, scene);
    const Candidate<Rational>* nearest = searchNearest(found.candidates, found.absences).nearest;
    if (!nearest) return std::nullopt;
    TrueHit hit;
    hit.body = nearest->body, hit.face = nearest->face, hit.entering = nearest->entering;
    hit.t = Real(nearest->t.p) + Real(nearest->t.q) * boost::multiprecision::sqrt(Real(nearest->t.d));
    return hit;
}

} // namespace yarte::hard
