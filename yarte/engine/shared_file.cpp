#include "yarte/engine/shared_file.h"

#include "yarte/engine/render_error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

namespace yarte {
namespace {

/// -1: not to be had.
int openFile(std::size_t bytes) {
    rlimit largest{};
    if (getrlimit(RLIMIT_FSIZE, &largest) == 0 && largest.rlim_cur < bytes) return -1; // would be a signal
    const int file = memfd_create("yarte-tiles", MFD_CLOEXEC);
    if (file < 0 || ftruncate(file, static_cast<off_t>(bytes)) == 0) return file;
    close(file);
    return -1;
}

/// Calls `transfer(done)`, which reads or writes some of what is left, until all `bytes` are done.
template <class Transfer>
void transferAll(std::size_t bytes, Transfer&& transfer) {
    for (std::size_t done = 0; done < bytes;) {
        const ssize_t moved = transfer(done);
        if (moved > 0)
            done += static_cast<std::size_t>(moved);
        else if (moved == 0 || errno != EINTR)
            throw RenderError(
                fmt::format("cannot keep a tile of the image: {}", std::strerror(moved == 0 ? EIO : errno)));
    }
}

} // namespace

SharedFile::SharedFile(std::size_t bytes) : file_(openFile(bytes)) {
    if (file_ < 0) memory_ = mapSharedMemory(bytes);
}

SharedFile::SharedFile(SharedFile&& other) noexcept
    : file_(std::exchange(other.file_, -1)), memory_(std::move(other.memory_)) {}

SharedFile::~SharedFile() {
    if (file_ >= 0) close(file_);
}

void SharedFile::write(std::size_t offset, const void* from, std::size_t bytes) const {
    if (memory_) {
        std::memcpy(static_cast<char*>(memory_.get()) + offset, from, bytes);
        return;
    }
    transferAll(bytes, [&](std::size_t done) {
        return pwrite(file_, static_cast<const char*>(from) + done, bytes - done,
                      static_cast<off_t>(offset + done));
    });
}

void SharedFile::read(std::size_t offset, void* to, std::size_t bytes) const {
    if (memory_) {
        std::memcpy(to, static_cast<const char*>(memory_.get()) + offset, bytes);
        return;
    }
    transferAll(bytes, [&](std::size_t done) {
        return pread(file_, static_cast<char*>(to) + done, bytes - done, static_cast<off_t>(offset + done));
    });
}

} // namespace yarte
