// Huge pages: memory that is about to be filled comes from the system in pieces of 2 MiB instead of 4 KiB.
// Giving out and clearing small pages one by one took most of the time of reading a large mesh.
#pragma once

#include <cstddef>

namespace yarte {

/// Asks the system for huge pages where [begin, begin + size) has whole ones; it may decline. For memory that
/// is going to be used throughout: a huge page is there as a whole once a byte of it is.
void adviseHugePages(const void* begin, std::size_t size);

/// Reserves room in a vector or string for `count` elements, all of which are going to be there.
template <class Container>
void reserveWhole(Container& container, std::size_t count) {
    container.reserve(count);
    adviseHugePages(container.data(), count * sizeof(typename Container::value_type));
}

} // namespace yarte
