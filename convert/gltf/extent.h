// Extent: where a scene is and how large.
#pragma once

#include "convert/gltf/transform.h"
#include "yarte/scene/mesh_data.h"

#include <algorithm>

namespace yarte::convert::gltf {

/// Axis-parallel box; empty at first.
class Extent {
public:
    void add(Vec3 p) {
        low_ = isEmpty_ ? p : Vec3{std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
        high_ = isEmpty_ ? p : Vec3{std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
        isEmpty_ = false;
    }
    /// A box around where `m` takes this one.
    void addPlaced(const Extent& box, const Transform& m) {
        if (box.isEmpty_) return;
        for (int corner = 0; corner < 8; ++corner)
            add(m.point({corner & 1 ? box.low_.x : box.high_.x, corner & 2 ? box.low_.y : box.high_.y,
                         corner & 4 ? box.low_.z : box.high_.z}));
    }

    Vec3 centre() const { return low_ + (high_ - low_) / 2; }
    double halfDiagonal() const { return length(high_ - low_) / 2; }
    /// Of a ball around it; 1 if it is empty or a point.
    double radius() const { return halfDiagonal() > 0 ? halfDiagonal() : 1; }

private:
    Vec3 low_, high_;
    bool isEmpty_ = true;
};

} // namespace yarte::convert::gltf
