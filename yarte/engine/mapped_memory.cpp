#include "yarte/engine/mapped_memory.h"

#include "yarte/base/huge_pages.h"
#include "yarte/engine/memory_limit.h"

#include <new>

#include <sys/mman.h>

namespace yarte {

void Unmap::operator()(void* memory) const { munmap(memory, bytes); }

namespace {

MappedMemory map(std::size_t bytes, int sharing) {
    // The system promises more than it has, and kills who uses it.
    if (static_cast<double>(bytes) > memoryLimit().bytes) throw std::bad_alloc();
    void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, sharing | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    return MappedMemory(memory, Unmap{bytes});
}

} // namespace

MappedMemory mapSharedMemory(std::size_t bytes) { return map(bytes, MAP_SHARED); }

MappedMemory mapPrivateMemory(std::size_t bytes) {
    MappedMemory memory = map(bytes, MAP_PRIVATE);
    adviseHugePages(memory.get(), bytes);
    return memory;
}

} // namespace yarte
