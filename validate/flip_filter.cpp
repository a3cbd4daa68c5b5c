#include "validate/flip_filter.h"

#include "validate/flip_wide.h"

#include <algorithm>
#include <cstring>

namespace yarte::validate::flip {

namespace {

using Block = float __attribute__((vector_size(Plane::block * sizeof(float))));

YARTE_INLINE inline void load(Block& block, const float* from) { std::memcpy(&block, from, sizeof block); }

/// Filters one block. `tap(k)` is where the values at offset k begin. Odd and curvature kernels sum
/// differences, so that constant pictures give exactly 0: FLIP takes the square root of their results and
/// would make rounding errors visible.
template <Kernel::Kind kind, class Tap>
YARTE_INLINE inline void filterBlock(const std::vector<float>& weights, const Tap& tap, float* out) {
    Block centre, before, after;
    load(centre, tap(0));
    Block sums = kind == Kernel::Kind::even ? weights[0] * centre : Block{};
    const int radius = static_cast<int>(weights.size()) - 1;
    for (int k = 1; k <= radius; ++k) {
        load(before, tap(-k));
        load(after, tap(k));
        const float weight = weights[static_cast<std::size_t>(k)];
        if constexpr (kind == Kernel::Kind::even)
            sums += weight * (after + before);
        else if constexpr (kind == Kernel::Kind::odd)
            sums += weight * (after - before);
        else
            sums += weight * ((after + before) - 2 * centre);
    }
    std::memcpy(out, &sums, sizeof sums);
}

/// `tapAt(x, k)`: where the values at offset k from x begin.
template <class TapAt>
YARTE_INLINE inline void filterRow(const Kernel& kernel, std::size_t length, const TapAt& tapAt, float* out) {
    const auto run = [&]<Kernel::Kind kind>() YARTE_INLINE {
        for (std::size_t x = 0; x < length; x += Plane::block)
            filterBlock<kind>(
                kernel.weights, [&](int k) YARTE_INLINE { return tapAt(x, k); }, out + x);
    };
    switch (kernel.kind) {
    case Kernel::Kind::even: run.template operator()<Kernel::Kind::even>(); break;
    case Kernel::Kind::odd: run.template operator()<Kernel::Kind::odd>(); break;
    case Kernel::Kind::curvature: run.template operator()<Kernel::Kind::curvature>(); break;
    }
}

} // namespace

Plane::Plane(int width, int height, int radius)
    : width_(width), height_(height), kept_(std::min(height, 2 * radius + 1)),
      stride_((static_cast<std::size_t>(width) + block - 1) / block * block),
      values_(stride_ * static_cast<std::size_t>(kept_)) {}

PaddedRow::PaddedRow(const Plane& like, std::size_t maxRadius)
    : width_(static_cast<std::size_t>(like.width())), stride_(like.stride()), maxRadius_(maxRadius),
      values_(stride_ + 2 * maxRadius) {}

YARTE_WIDE void PaddedRow::filterColumns(const Plane& plane, int y, const Kernel& kernel) {
    const int radius = static_cast<int>(kernel.weights.size()) - 1;
    std::vector<const float*> rows;
    for (int k = -radius; k <= radius; ++k)
        rows.push_back(plane.row(std::clamp(y + k, 0, plane.height() - 1)));
    float* const first = values_.data() + maxRadius_;
    filterRow(
        kernel, stride_,
        [&](std::size_t x, int k) YARTE_INLINE { return rows[static_cast<std::size_t>(k + radius)] + x; },
        first);
    std::fill(values_.data(), first, first[0]);
    std::fill(first + width_, values_.data() + values_.size(), first[width_ - 1]);
}

YARTE_WIDE void PaddedRow::filterAlong(const Kernel& kernel, std::vector<float>& out) const {
    const float* const first = values_.data() + maxRadius_;
    filterRow(
        kernel, stride_, [&](std::size_t x, int k) YARTE_INLINE { return first + x + k; }, out.data());
}

} // namespace yarte::validate::flip
