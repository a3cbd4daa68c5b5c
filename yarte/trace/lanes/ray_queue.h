// RayQueueOf: the rays of one generation that wait to be traced, component by component, so that packets load
// straight from it.
#pragma once

#include "yarte/base/colour.h"
#include "yarte/trace/lanes/media_pool.h"
#include "yarte/trace/ray.h"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <vector>

namespace yarte::trace {

/// All components are of the type that the kernels compute in: levels, flags and pixels of a block are small
/// integers, which it holds exactly; for ids see scalar.h.
template <class Scalar>
class RayQueueOf {
public:
    /// The weight is one number, or, where there are tints, one for each channel.
    enum Component {
        ox,
        oy,
        oz,
        dx,
        dy,
        dz,
        from,
        inside,
        pixel,
        levels,
        media,
        weight,
        weightG,
        weightB,
        componentCount
    };

    /// Begins anew, empty.
    void start(bool isTinted) {
        components_ = isTinted ? componentCount : weight + 1;
        size_ = 0;
    }

    std::size_t size() const { return size_; }
    const Scalar* at(Component c, std::size_t i) const { return data_.get() + c * capacity_ + i; }

    void clear() { size_ = 0; }
    void swap(RayQueueOf& other) {
        std::swap(data_, other.data_), std::swap(capacity_, other.capacity_), std::swap(size_, other.size_);
    }

    /// Room for `count` more rays, and a vector's width beyond that may be overwritten.
    void reserve(std::size_t count) {
        if (size_ + count + slack <= capacity_) return;
        const std::size_t capacity =
            std::max<std::size_t>(2 * capacity_, (size_ + count + slack + 63) / 64 * 64);
        Data data(new (alignment) Scalar[capacity * componentCount]);
        for (std::size_t c = 0; c < components_ && size_ > 0; ++c)
            std::copy_n(data_.get() + c * capacity_, size_, data.get() + c * capacity);
        data_ = std::move(data), capacity_ = capacity;
    }
    /// Where the next ray's component goes, after reserve().
    Scalar* end(Component c) { return data_.get() + c * capacity_ + size_; }
    void grow(std::size_t count) { size_ += count; }

    void append(const RayQueueOf& other) {
        if (other.size_ == 0) return;
        reserve(other.size_);
        for (std::size_t c = 0; c < components_; ++c)
            std::copy_n(other.at(Component(c), 0), other.size_, end(Component(c)));
        grow(other.size_);
    }
    /// Repeats the last ray behind the end, so that whole vectors can be loaded there.
    void pad(std::size_t count) {
        reserve(count);
        for (std::size_t c = 0; c < components_; ++c)
            std::fill_n(end(Component(c)), count, *(end(Component(c)) - 1));
    }

private:
    static constexpr std::size_t slack = 64;
    static constexpr std::align_val_t alignment{64}; // of the widest vectors
    struct Free {
        void operator()(Scalar* data) const { ::operator delete[](data, alignment); }
    };
    using Data = std::unique_ptr<Scalar[], Free>;

    Data data_;
    std::size_t components_ = componentCount; ///< in use
    std::size_t capacity_ = 0, size_ = 0;
};

/// What the tracing of a tile needs of memory, for the next tile to use again: given back in between, the
/// system would clear and hand out the same pages for every tile, which took longer than the tracing.
template <class Scalar>
struct Workspace {
    std::vector<ElementId> blockers; ///< of each light; see findShadows
    std::vector<Colour> sums;        ///< of a block's pixels
    RayQueueOf<Scalar> current, reflected, transmitted;
    std::size_t blockCount = 0; ///< of those rendered up to now
};

} // namespace yarte::trace
