#include "yarte/base/huge_pages.h"

#include <cstdint>

#include <sys/mman.h>

namespace yarte {

void adviseHugePages(const void* begin, std::size_t size) {
#ifdef MADV_HUGEPAGE
    constexpr std::uintptr_t pageSize = std::uintptr_t{1} << 21; // of x86-64, and of most others
    const auto address = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t first = (address + pageSize - 1) / pageSize * pageSize;
    const std::uintptr_t last = (address + size) / pageSize * pageSize;
    // What it answers does not matter: without huge pages all works, only slower.
    if (first < last) ::madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
#else
    static_cast<void>(begin), static_cast<void>(size);
#endif
}

} // namespace yarte
