// Memory that a process shares with those it forks afterwards.
#pragma once

#include <cstddef>
#include <memory>

namespace yarte {

struct Unmap {
    std::size_t bytes = 0;
    void operator()(void* memory) const;
};

/// Owned by every process that has it: each unmaps its own view.
using SharedMemory = std::unique_ptr<void, Unmap>;

/// `bytes` > 0 zeros, on a page boundary. Pages take up memory when they are first written. Throws
/// std::bad_alloc.
SharedMemory mapSharedMemory(std::size_t bytes);

} // namespace yarte
