#include "yarte/engine/journal.h"

#include "yarte/base/file.h"
#include "yarte/base/hash.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace yarte {

namespace {

constexpr std::string_view magic = "yarte checkpoint 2";
constexpr std::size_t longestHead = 1 << 20; ///< bytes, of one that is not ours

/// How often what was written is flushed to the disk, in seconds.
constexpr std::int64_t flushInterval = 5;

/// What stands before the pixels of a record. Its checksum is of all that follows it, and of the journal's
/// head: the record of another journal counts as damaged.
struct RecordHead {
    std::uint64_t checksum;
    std::uint64_t tile;
    RayCounts rays;
};
static_assert(std::is_trivially_copyable_v<RecordHead> && std::is_trivially_copyable_v<Colour>);

std::uint64_t checksumOfRecord(const std::vector<char>& record, std::uint64_t checksumOfHead) {
    constexpr std::size_t begin = sizeof(RecordHead::checksum);
    return checksum({record.data() + begin, record.size() - begin}) ^ checksumOfHead;
}

/// The head: a line for each item and an empty one, then the checksum of these.
std::string headOf(std::span<const JournalItem> items) {
    std::string head = fmt::format("{}\n", magic);
    for (const JournalItem& item : items) head += fmt::format("{}\t{}\n", item.name, item.value);
    head += '\n';
    return head + fmt::format("{:016x}\n", checksum(head));
}

std::int64_t now() {
    return std::chrono::duration_cast<std::chrono::seconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

[[noreturn]] void fail(const std::filesystem::path& file, int error) {
    throw FileError(file, std::strerror(error));
}

/// As many bytes as there are, up to `size`.
std::size_t readUpTo(int file, std::int64_t offset, char* to, std::size_t size,
                     const std::filesystem::path& path) {
    std::size_t done = 0;
    while (done < size) {
        const ssize_t got = ::pread(file, to + done, size - done, offset + static_cast<std::int64_t>(done));
        if (got < 0 && errno != EINTR) fail(path, errno);
        if (got == 0) break;
        done += static_cast<std::size_t>(std::max<ssize_t>(got, 0));
    }
    return done;
}

/// 0, or the error.
int appendAll(int file, const char* from, std::size_t size) {
    while (size > 0) {
        const ssize_t put = ::write(file, from, size);
        if (put < 0 && errno != EINTR) return errno;
        from += std::max<ssize_t>(put, 0), size -= static_cast<std::size_t>(std::max<ssize_t>(put, 0));
    }
    return 0;
}

} // namespace

Journal::Journal(const std::filesystem::path& path, Use use, TileList tiles) : path_(path), tiles_(tiles) {
    std::size_t largest = 0;
    for (std::size_t tile = 0; tile < tiles_.size(); ++tile) largest = std::max(largest, pixelCount(tile));
    recordSize_ = sizeof(RecordHead) + largest * sizeof(Colour);
    const int mode = use == Use::look     ? O_RDONLY
                     : use == Use::create ? O_RDWR | O_APPEND | O_CREAT | O_EXCL
                                          : O_RDWR | O_APPEND;
    file_ = ::open(path.c_str(), mode | O_CLOEXEC, 0666);
    if (file_ < 0) fail(path, errno);
    if (use != Use::look && ::flock(file_, LOCK_EX | LOCK_NB) != 0) {
        ::close(file_);
        throw FileError(path, "in use by another render");
    }
}

Journal::Journal(Journal&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)), tiles_(other.tiles_),
      recordSize_(other.recordSize_), firstRecord_(other.firstRecord_),
      checksumOfHead_(other.checksumOfHead_), flushedAt_(other.flushedAt_), record_(std::move(other.record_)),
      failure_(std::move(other.failure_)) {}

Journal::~Journal() {
    if (file_ >= 0) ::close(file_);
}

Journal Journal::create(const std::filesystem::path& path, std::span<const JournalItem> items,
                        TileList tiles) {
    Journal journal(path, Use::create, tiles);
    journal.writeHead(items);
    return journal;
}

Journal Journal::resume(const std::filesystem::path& path, std::span<const JournalItem> items,
                        TileList tiles) {
    Journal journal(path, Use::resume, tiles);
    struct stat status {};
    if (::fstat(journal.file_, &status) != 0) fail(path, errno);
    if (status.st_size == 0) // stopped before there was a head
        journal.writeHead(items);
    else
        journal.checkHead(items);
    return journal;
}

Journal Journal::look(const std::filesystem::path& path, std::span<const JournalItem> items, TileList tiles) {
    Journal journal(path, Use::look, tiles);
    journal.checkHead(items);
    return journal;
}

std::size_t Journal::pixelCount(std::size_t tile) const {
    const Tile t = tiles_[tile];
    return static_cast<std::size_t>(t.width()) * static_cast<std::size_t>(t.height());
}

void Journal::writeHead(std::span<const JournalItem> items) {
    const std::string head = headOf(items);
    if (const int error = appendAll(file_, head.data(), head.size())) {
        // Half a head would be refused from now on; an empty file is one to begin.
        [[maybe_unused]] const int result = ::ftruncate(file_, 0);
        fail(path_, error);
    }
    beginRecordsAfter(head);
}

void Journal::beginRecordsAfter(std::string_view head) {
    firstRecord_ = static_cast<std::int64_t>(head.size());
    checksumOfHead_ = checksum(head);
    flushedAt_ = now();
}

void Journal::checkHead(std::span<const JournalItem> items) {
    const std::string head = headOf(items);
    const auto beginning = [this](std::size_t size) {
        std::string bytes(size, '\0');
        bytes.resize(readUpTo(file_, 0, bytes.data(), size, path_));
        return bytes;
    };
    if (beginning(head.size()) == head) return beginRecordsAfter(head);
    const std::string there = beginning(longestHead);
    const auto damaged = [&] {
        return JournalError(fmt::format("{}: no checkpoint, or its head is damaged", path_.string()));
    };
    constexpr std::size_t digits = 16;
    const std::size_t end = there.find("\n\n");
    if (!there.starts_with(magic) || end == std::string::npos || there.size() < end + 2 + digits)
        throw damaged();
    if (there.substr(end + 2, digits) !=
        fmt::format("{:016x}", checksum(std::string_view(there).substr(0, end + 2))))
        throw damaged();
    // An undamaged head that is another one: the first line that differs says what has changed.
    std::string_view rest = std::string_view(there).substr(0, end + 1);
    rest.remove_prefix(rest.find('\n') + 1);
    for (const JournalItem& item : items) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        const std::size_t tab = line.find('\t');
        if (line.substr(0, tab) != item.name)
            throw JournalError(fmt::format("{}: of a render without {}", path_.string(), item.name));
        if (line.substr(tab + 1) != item.value)
            throw JournalError(fmt::format("{}: of another render: {} was {}, is {}", path_.string(),
                                           item.name, line.substr(tab + 1), item.value));
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    }
    throw JournalError(
        fmt::format("{}: of a render with {}", path_.string(), rest.substr(0, rest.find('\t'))));
}

std::size_t Journal::readTiles(const Restore& restore) {
    std::size_t damaged = 0;
    record_.resize(recordSize_);
    std::int64_t offset = firstRecord_;
    std::vector<Colour> pixels;
    for (;; offset += static_cast<std::int64_t>(recordSize_)) {
        if (readUpTo(file_, offset, record_.data(), recordSize_, path_) < recordSize_) break;
        RecordHead head;
        std::memcpy(&head, record_.data(), sizeof head);
        if (head.checksum != checksumOfRecord(record_, checksumOfHead_) || head.tile >= tiles_.size()) {
            ++damaged;
            continue;
        }
        pixels.resize(pixelCount(head.tile));
        std::memcpy(pixels.data(), record_.data() + sizeof head, pixels.size() * sizeof(Colour));
        restore(head.tile, head.rays, pixels.data());
    }
    // Where the file can be written, the beginning of a record at its end would shift all that follow.
    if ((::fcntl(file_, F_GETFL) & O_ACCMODE) == O_RDWR && ::ftruncate(file_, offset) != 0)
        fail(path_, errno);
    return damaged;
}

void Journal::add(std::size_t tile, const RayCounts& rays, const Colour* pixels) {
    if (failure_) return;
    record_.assign(recordSize_, 0);
    RecordHead head{0, tile, rays};
    std::memcpy(record_.data(), &head, sizeof head);
    std::memcpy(record_.data() + sizeof head, pixels, pixelCount(tile) * sizeof(Colour));
    head.checksum = checksumOfRecord(record_, checksumOfHead_);
    std::memcpy(record_.data(), &head.checksum, sizeof head.checksum);
    if (const int error = appendAll(file_, record_.data(), record_.size())) failure_ = std::strerror(error);
    if (now() >= flushedAt_ + flushInterval) flush();
}

void Journal::flush() {
    flushedAt_ = now();
    if (::fdatasync(file_) != 0 && !failure_) failure_ = std::strerror(errno);
}

} // namespace yarte
