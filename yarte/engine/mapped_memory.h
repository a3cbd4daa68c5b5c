// Memory from the system in whole pages, shared with the processes forked afterwards or not.
#pragma once

#include <cstddef>
#include <memory>

namespace yarte {

struct Unmap {
    std::size_t bytes = 0;
    void operator()(void* memory) const;
};

/// Owned by every process that has it: each unmaps its own view.
using MappedMemory = std::unique_ptr<void, Unmap>;

/// `bytes` > 0 zeros, on a page boundary. Pages take up memory when they are first written. Throws
/// std::bad_alloc.
MappedMemory mapSharedMemory(std::size_t bytes);

/// The same, but what is written after a fork is not shared; in huge pages where the system has them.
MappedMemory mapPrivateMemory(std::size_t bytes);

} // namespace yarte
