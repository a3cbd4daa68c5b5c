#include "validate/flip_filter.h"

#include <algorithm>

namespace yarte::validate::flip {

namespace {

/// Filters one block. `tap(k)` is where the values at offset k begin. The constant length of the inner loops
/// lets the compiler keep the sums in registers. Odd and curvature kernels sum differences, so that constant
/// pictures give exactly 0: FLIP takes the square root of their results and would make rounding errors
/// visible.
template <Kernel::Kind kind, class Tap>
inline void filterBlock(const std::vector<float>& weights, const Tap& tap, float* out) {
    const float* const centre = tap(0);
    float sums[Plane::block];
    for (int i = 0; i < Plane::block; ++i) sums[i] = kind == Kernel::Kind::even ? weights[0] * centre[i] : 0;
    const int radius = static_cast<int>(weights.size()) - 1;
    for (int k = 1; k <= radius; ++k) {
        const float weight = weights[static_cast<std::size_t>(k)];
        const float *const before = tap(-k), *const after = tap(k);
        for (int i = 0; i < Plane::block; ++i)
            if constexpr (kind == Kernel::Kind::even)
                sums[i] += weight * (after[i] + before[i]);
            else if constexpr (kind == Kernel::Kind::odd)
                sums[i] += weight * (after[i] - before[i]);
            else
                sums[i] += weight * ((after[i] + before[i]) - 2 * centre[i]);
    }
    std::copy(sums, sums + Plane::block, out);
}

/// `tapAt(x, k)`: where the values at offset k from x begin.
template <class TapAt>
void filterRow(const Kernel& kernel, std::size_t length, const TapAt& tapAt, float* out) {
    const auto run = [&]<Kernel::Kind kind>() {
        for (std::size_t x = 0; x < length; x += Plane::block)
            filterBlock<kind>(
                kernel.weights, [&](int k) { return tapAt(x, k); }, out + x);
    };
    switch (kernel.kind) {
    case Kernel::Kind::even: run.template operator()<Kernel::Kind::even>(); break;
    case Kernel::Kind::odd: run.template operator()<Kernel::Kind::odd>(); break;
    case Kernel::Kind::curvature: run.template operator()<Kernel::Kind::curvature>(); break;
    }
}

} // namespace

Plane::Plane(int width, int height)
    : width_(width), height_(height), stride_((static_cast<std::size_t>(width) + block - 1) / block * block),
      values_(stride_ * static_cast<std::size_t>(height)) {}

PaddedRow::PaddedRow(const Plane& like, std::size_t maxRadius)
    : width_(static_cast<std::size_t>(like.width())), stride_(like.stride()), maxRadius_(maxRadius),
      values_(stride_ + 2 * maxRadius) {}

void PaddedRow::filterColumns(const Plane& plane, int y, const Kernel& kernel) {
    const int radius = static_cast<int>(kernel.weights.size()) - 1;
    std::vector<const float*> rows;
    for (int k = -radius; k <= radius; ++k)
        rows.push_back(plane.row(std::clamp(y + k, 0, plane.height() - 1)));
    float* const first = values_.data() + maxRadius_;
    filterRow(
        kernel, stride_, [&](std::size_t x, int k) { return rows[static_cast<std::size_t>(k + radius)] + x; },
        first);
    std::fill(values_.data(), first, first[0]);
    std::fill(first + width_, values_.data() + values_.size(), first[width_ - 1]);
}

void PaddedRow::filterAlong(const Kernel& kernel, std::vector<float>& out) const {
    const float* const first = values_.data() + maxRadius_;
    filterRow(
        kernel, stride_, [&](std::size_t x, int k) { return first + x + k; }, out.data());
}

} // namespace yarte::validate::flip
