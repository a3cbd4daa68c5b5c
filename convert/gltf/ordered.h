// Elements in the order that they had when they were written.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace yarte::convert::gltf {

template <class T>
struct Ordered {
    std::optional<std::size_t> order; ///< as Exact::order
    T value;
};

/// By order; what has none comes last, as it came.
template <class T>
std::vector<T> sorted(std::vector<Ordered<T>> elements) {
    std::ranges::stable_sort(elements, {}, [](const Ordered<T>& element) {
        return element.order.value_or(std::numeric_limits<std::size_t>::max());
    });
    std::vector<T> values;
    for (Ordered<T>& element : elements) values.push_back(std::move(element.value));
    return values;
}

} // namespace yarte::convert::gltf
