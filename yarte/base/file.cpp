#include "yarte/base/file.h"

#include "yarte/base/huge_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace yarte {
namespace fs = std::filesystem;
namespace {

/// The system's words for `error`, beginning in lower case as all our messages do.
std::string reasonOf(int error) {
    std::string reason = std::generic_category().message(error);
    if (!reason.empty() && reason[0] >= 'A' && reason[0] <= 'Z')
        reason[0] = static_cast<char>(reason[0] - 'A' + 'a');
    return reason;
}

[[noreturn]] void fail(const fs::path& file, int error) { throw FileError(file, reasonOf(error)); }

/// An open file that is closed at the end of its scope.
class Descriptor {
public:
    Descriptor(const fs::path& file, int flags, mode_t mode = 0)
        : number_(::open(file.c_str(), flags | O_CLOEXEC, mode)) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (isOpen()) ::close(number_);
    }

    bool isOpen() const { return number_ >= 0; }
    int number() const { return number_; }
    /// False (and errno) if the last bytes could not be written after all: some file systems tell only now.
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

private:
    int number_;
};

/// False (and errno) on failure.
bool writeAll(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written >= 0)
            bytes.remove_prefix(static_cast<std::size_t>(written));
        else if (errno != EINTR)
            return false;
    }
    return true;
}

/// A device or a pipe cannot be replaced by a file of its name: it takes the bytes as they come.
void writeDirectly(const fs::path& file, std::string_view bytes) {
    Descriptor out(file, O_WRONLY);
    if (!out.isOpen() || !writeAll(out.number(), bytes) || !out.close()) fail(file, errno);
}

/// A name beside `file` that no other process or thread uses.
fs::path temporaryName(const fs::path& file) {
    static std::atomic<unsigned> count = 0;
    return file.parent_path() / fmt::format(".yarte-{}-{}.tmp", ::getpid(), count++);
}

void writeBesideAndRename(const fs::path& file, std::string_view bytes, const struct stat* existing) {
    const auto attempt = [&](const fs::path& temporary) -> int {
        Descriptor out(temporary, O_WRONLY | O_CREAT | O_EXCL, 0666);
        if (!out.isOpen()) return errno;
        const bool written = (existing == nullptr || ::fchmod(out.number(), existing->st_mode & 0777) == 0) &&
                             writeAll(out.number(), bytes) && ::fsync(out.number()) == 0 && out.close() &&
                             ::rename(temporary.c_str(), file.c_str()) == 0;
        if (written) return 0;
        const int error = errno;
        ::unlink(temporary.c_str());
        return error;
    };
    // A temporary file may have been left by a killed process that had our number.
    int error = EEXIST;
    for (int i = 0; i < 100 && error == EEXIST; ++i) error = attempt(temporaryName(file));
    if (error != 0) fail(file, error);
}

/// True if the components of `folder` begin those of `file`; both canonical.
bool liesBelow(const fs::path& file, const fs::path& folder) {
    auto end = folder.end();
    if (!folder.empty() && std::prev(end)->empty()) --end; // "folder/" ends in an empty component
    return std::mismatch(folder.begin(), end, file.begin(), file.end()).first == end;
}

} // namespace

FileError::FileError(const fs::path& file, std::string_view reason)
    : std::runtime_error(fmt::format("{}: {}", file.string(), reason)), reason_(reason) {}

std::string readFile(const fs::path& file) {
    const Descriptor in(file, O_RDONLY);
    if (!in.isOpen()) fail(file, errno);
    struct stat status {};
    if (::fstat(in.number(), &status) != 0) fail(file, errno);
    // One byte more than the file has, to see its end; a pipe tells no size and takes more rounds.
    const std::size_t expected = static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)) + 1;
    // Read, not mapped: a mapped file that another program cuts short ends this one (SIGBUS), and huge pages
    // make reading nearly as fast.
    std::string bytes;
    reserveWhole(bytes, expected);
    bytes.resize(expected);
    std::size_t size = 0;
    for (;;) {
        if (size == bytes.size()) bytes.resize(2 * size + 4096);
        const ssize_t got = ::read(in.number(), bytes.data() + size, bytes.size() - size);
        if (got < 0 && errno != EINTR) fail(file, errno);
        if (got == 0) break;
        size += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
    }
    bytes.resize(size);
    return bytes;
}

std::optional<std::string> whyUnreadable(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return reasonOf(errno);
    if (S_ISDIR(status.st_mode)) return reasonOf(EISDIR);
    if (!S_ISREG(status.st_mode)) return "not a regular file";
    if (::access(file.c_str(), R_OK) != 0) return reasonOf(errno);
    return std::nullopt;
}

void writeFile(const fs::path& file, std::string_view bytes) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) {
        if (errno != ENOENT) fail(file, errno);
        return writeBesideAndRename(file, bytes, nullptr);
    }
    if (S_ISDIR(status.st_mode)) fail(file, EISDIR);
    if (!S_ISREG(status.st_mode)) return writeDirectly(file, bytes);
    if (::access(file.c_str(), W_OK) != 0) fail(file, errno);
    // The file behind a link is replaced, not the link. Any other is named as the caller does.
    std::error_code error;
    const fs::path target = fs::is_symlink(file, error) ? fs::canonical(file, error) : file;
    if (error) fail(file, error.value());
    writeBesideAndRename(target, bytes, &status);
}

bool ReadableFolders::contain(const fs::path& file) const {
    std::error_code error;
    const fs::path resolved = fs::weakly_canonical(fs::absolute(file, error), error);
    if (error || resolved.empty()) return false;
    return std::any_of(folders.begin(), folders.end(), [&](const fs::path& folder) {
        std::error_code folderError;
        const fs::path root = fs::weakly_canonical(
            folder.empty() ? fs::current_path(folderError) : fs::absolute(folder, folderError), folderError);
        return !folderError && liesBelow(resolved, root);
    });
}

void letLargeWritesFail() { std::signal(SIGXFSZ, SIG_IGN); }

} // namespace yarte
