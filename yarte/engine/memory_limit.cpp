#include "yarte/engine/memory_limit.h"

#include "yarte/base/colour.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include <sys/resource.h>
#include <unistd.h>

namespace yarte {

namespace {

void lower(MemoryLimit& limit, double bytes, const char* owner) {
    if (bytes < limit.bytes) limit = {bytes, owner};
}

/// The limits of this process's control group (version 2) and of those around it.
void lowerToControlGroup(MemoryLimit& limit) {
    std::ifstream groups("/proc/self/cgroup");
    std::string group;
    while (std::getline(groups, group) && !group.starts_with("0::/")) {
    }
    if (!groups) return;
    const std::filesystem::path root = "/sys/fs/cgroup";
    for (std::filesystem::path folder = root / group.substr(4);; folder = folder.parent_path()) {
        double bytes = 0;
        if (std::ifstream(folder / "memory.max") >> bytes) // "max", no limit, is not read as a number
            lower(limit, bytes, "its control group allows");
        if (folder == root || !folder.has_relative_path()) return;
    }
}

} // namespace

MemoryLimit memoryLimit() {
    MemoryLimit limit{static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                          static_cast<double>(sysconf(_SC_PAGESIZE)),
                      "this machine has"};
    rlimit addressSpace{};
    if (getrlimit(RLIMIT_AS, &addressSpace) == 0 && addressSpace.rlim_cur != RLIM_INFINITY)
        lower(limit, static_cast<double>(addressSpace.rlim_cur), "its address space is limited to");
    lowerToControlGroup(limit);
    return limit;
}

std::optional<std::string> imageTooLarge(int width, int height, const MemoryLimit& limit) {
    // In floating point, where the product of the largest sides does not overflow.
    const double needed = static_cast<double>(width) * height * sizeof(Colour);
    if (needed <= limit.bytes) return std::nullopt;
    constexpr double gib = 1024.0 * 1024 * 1024;
    return fmt::format("image of {}x{} pixels needs {:.1f} GiB, {} {:.1f} GiB", width, height, needed / gib,
                       limit.owner, limit.bytes / gib);
}

} // namespace yarte
