// How much memory an image may take, asked before any is taken.
#pragma once

#include <optional>
#include <string>

namespace yarte {

struct MemoryLimit {
    double bytes = 0;
    std::string owner; ///< who sets it, as the subject of a sentence: "this machine has"
};

/// The least of the machine's memory, the address space allowed (ulimit -v), and the control group's
/// memory.max.
MemoryLimit memoryLimit();

/// Why an image of this size (of pixels in double precision) does not fit; nothing if it does.
std::optional<std::string> imageTooLarge(int width, int height, const MemoryLimit&);

} // namespace yarte
