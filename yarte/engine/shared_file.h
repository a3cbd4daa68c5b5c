// SharedFile: bytes that threads or forked processes write and their parent reads.
#pragma once

#include "yarte/engine/shared_memory.h"

#include <cstddef>

namespace yarte {

/// A file without a name, in memory: written by calls, not through a mapping, whose pages every process would
/// first have to be given one by one, at many times the cost of the bytes themselves. Where the system has no
/// such files, or limits their size (ulimit -f), shared memory does the same.
class SharedFile {
public:
    /// Of `bytes` > 0 zeros. Throws std::bad_alloc.
    explicit SharedFile(std::size_t bytes);
    ~SharedFile();
    SharedFile(SharedFile&&) noexcept;
    SharedFile& operator=(SharedFile&&) = delete;

    /// Called by several processes at once for different places. Throws RenderError if memory is used up.
    void write(std::size_t offset, const void* from, std::size_t bytes) const;
    /// Reads what was written. Throws RenderError.
    void read(std::size_t offset, void* to, std::size_t bytes) const;

private:
    int file_ = -1;
    SharedMemory memory_; ///< if there is no file
};

} // namespace yarte
