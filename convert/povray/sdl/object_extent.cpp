#include "convert/povray/sdl/object_extent.h"

#include <algorithm>
#include <cmath>

namespace yarte::convert::povray::sdl {
namespace {

/// Extents of an object's parts.
struct Box {
    std::optional<std::array<Vec3, 2>> box{};

    void add(Vec3 p) {
        if (!box) box = {p, p};
        auto& [low, high] = *box;
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    /// The corners of a box, mapped: what POV-Ray takes for the extent of what was transformed.
    void add(const Affine& map, const std::array<Vec3, 2>& of) {
        for (unsigned corner = 0; corner < 8; ++corner)
            add(mapPoint(map, {of[corner & 1].x, of[corner >> 1 & 1].y, of[corner >> 2].z}));
    }
};

std::optional<std::array<Vec3, 2>> ownExtent(const ObjectShape& shape) {
    Box box;
    if (const auto* s = std::get_if<SphereShape>(&shape)) {
        const Vec3 r{s->radius, s->radius, s->radius};
        box.add(s->centre - r), box.add(s->centre + r);
    } else if (const auto* b = std::get_if<BoxShape>(&shape)) {
        box.add(b->a), box.add(b->b);
    } else if (const auto* c = std::get_if<ConeShape>(&shape)) {
        const Vec3 axis = c->b - c->a;
        const double l = length(axis);
        const auto spread = [&](double component) {
            return l == 0 ? 1.0 : std::sqrt(std::max(0.0, 1 - component * component / (l * l)));
        };
        const Vec3 r{spread(axis.x), spread(axis.y), spread(axis.z)};
        box.add(c->a - r * c->radiusA), box.add(c->a + r * c->radiusA);
        box.add(c->b - r * c->radiusB), box.add(c->b + r * c->radiusB);
    } else if (const auto* d = std::get_if<DiscShape>(&shape)) {
        const Vec3 r{d->radius, d->radius, d->radius};
        box.add(d->centre - r), box.add(d->centre + r);
    } else if (const auto* t = std::get_if<TorusShape>(&shape)) {
        const double r = t->major + t->minor;
        box.add({-r, -t->minor, -r}), box.add({r, t->minor, r});
    } else if (const auto* p = std::get_if<PolygonShape>(&shape)) {
        for (const auto& contour : p->contours)
            for (const Vec3 v : contour) box.add(v);
    } else if (const auto* triangle = std::get_if<TriangleShape>(&shape)) {
        for (const Vec3 v : triangle->corners) box.add(v);
    } else if (const auto* mesh = std::get_if<std::shared_ptr<const MeshShape>>(&shape)) {
        for (const Vec3 v : (*mesh)->vertices) box.add(v);
    } else if (const auto* all = std::get_if<UnionShape>(&shape)) {
        for (const ObjectPtr& part : all->parts) {
            if (std::holds_alternative<LightShape>(part->shape)) continue;
            const auto of = extentOf(*part);
            if (!of) return std::nullopt;
            box.add((*of)[0]), box.add((*of)[1]);
        }
    }
    return box.box;
}

} // namespace

std::optional<std::array<Vec3, 2>> extentOf(const Object& object) {
    const auto own = ownExtent(object.shape);
    if (!own || object.transform == Affine{}) return own;
    Box box;
    box.add(object.transform, *own);
    return box.box;
}

} // namespace yarte::convert::povray::sdl
