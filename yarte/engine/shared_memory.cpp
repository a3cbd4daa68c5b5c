#include "yarte/engine/shared_memory.h"

#include "yarte/engine/memory_limit.h"

#include <new>

#include <sys/mman.h>

namespace yarte {

void Unmap::operator()(void* memory) const { munmap(memory, bytes); }

SharedMemory mapSharedMemory(std::size_t bytes) {
    // The system promises more than it has, and kills who uses it.
    if (static_cast<double>(bytes) > memoryLimit().bytes) throw std::bad_alloc();
    void* const memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    return SharedMemory(memory, Unmap{bytes});
}

} // namespace yarte
