#include "validate/file_access.h"

#include <cerrno>
#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <system_error>

namespace yarte::validate {

namespace {

constexpr __u64 reading =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
/// All rights of the first version, which every kernel with Landlock knows; what it does not name (moving a
/// file into another folder) it refuses.
constexpr __u64 everything = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1) - 1;
/// Those that mean something for what is no folder.
constexpr __u64 ofFiles =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_WRITE_FILE;

// The C library has no functions for these.
int versionOfLandlock() {
    return static_cast<int>(
        ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION));
}
int newRules() {
    if (!FileRules::areKnown()) return -1;
    const landlock_ruleset_attr handled{.handled_access_fs = everything};
    const int rules = static_cast<int>(::syscall(SYS_landlock_create_ruleset, &handled, sizeof handled, 0));
    if (rules < 0) throw std::system_error(errno, std::generic_category(), "landlock_create_ruleset");
    return rules;
}

void allow(int rules, const std::filesystem::path& path, __u64 access) {
    const Descriptor place(::open(path.c_str(), O_PATH | O_CLOEXEC));
    struct stat status {};
    if (place.get() < 0 || ::fstat(place.get(), &status) != 0) return;
    if (!S_ISDIR(status.st_mode)) access &= ofFiles;
    const landlock_path_beneath_attr rule{.allowed_access = access, .parent_fd = place.get()};
    if (::syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0) != 0)
        throw std::system_error(errno, std::generic_category(), "landlock_add_rule");
}

} // namespace

bool FileRules::areKnown() { return versionOfLandlock() >= 1; }

FileRules::FileRules(const FileAccess& files) : rules_(newRules()) {
    if (rules_.get() < 0) return;
    for (const auto& path : files.readable) allow(rules_.get(), path, reading);
    allow(rules_.get(), files.writable, everything);
}

bool FileRules::enforce() const {
    // A process that could gain rights by what it executes may not lay rules on itself.
    return rules_.get() < 0 || (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
                                ::syscall(SYS_landlock_restrict_self, rules_.get(), 0) == 0);
}

} // namespace yarte::validate
