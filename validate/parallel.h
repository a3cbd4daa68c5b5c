// Doing independent things side by side.
#pragma once

#include <cstddef>
#include <functional>

namespace yarte::validate {

/// Calls `make(i)` for i = 0 ... count - 1 in at most `jobs` threads, and `done(i)` in this order, never two
/// at a time, each as soon as all before it are made. After an exception no more are begun; the first one is
/// thrown here once all threads have ended.
void inParallel(std::size_t count, int jobs, const std::function<void(std::size_t)>& make,
                const std::function<void(std::size_t)>& done);

} // namespace yarte::validate
