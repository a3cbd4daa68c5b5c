// Journal: finished tiles on disk, so that an interrupted render can go on (--checkpoint). The format is in
// yarte/README.md.
#pragma once

#include "yarte/engine/tile_list.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace yarte {

/// Something that a picture depends on: of two runs that agree in all items, every tile has the same bytes.
struct JournalItem {
    std::string name, value; ///< one line each; the name is for people: "the scene's text", "--size"
};

/// The journal is not of this render, or its head is damaged.
class JournalError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class Journal {
public:
    /// Called with what the journal holds.
    using Restore = std::function<void(std::size_t tile, const RayCounts&, const Colour* pixels)>;

    /// A new file. Throws FileError, also if there is one.
    static Journal create(const std::filesystem::path&, std::span<const JournalItem>, TileList);

    /// One that exists, to be gone on with. Throws FileError, JournalError (which names the item that
    /// differs).
    static Journal resume(const std::filesystem::path&, std::span<const JournalItem>, TileList);

    /// One that exists, which may be in use; to be read only. Throws as resume.
    static Journal look(const std::filesystem::path&, std::span<const JournalItem>, TileList);

    Journal(Journal&&) noexcept;
    Journal& operator=(Journal&&) = delete;
    ~Journal();

    /// Calls `restore` for every tile whose record is whole and undamaged; returns how many were not. A
    /// record that was being written when the machine or program stopped is cut off, and not counted. Throws
    /// FileError.
    std::size_t readTiles(const Restore&);

    /// Adds a tile's pixels, row after row. What has been added survives the end of this process at once, and
    /// that of the machine a few seconds later or after flush(). After a failure the journal takes no more.
    void add(std::size_t tile, const RayCounts&, const Colour* pixels);
    void flush();

    /// Why the journal takes no more tiles, in words; nothing if it does.
    const std::optional<std::string>& failure() const { return failure_; }

private:
    enum class Use { create, resume, look };
    Journal(const std::filesystem::path&, Use, TileList);
    void writeHead(std::span<const JournalItem>);
    void checkHead(std::span<const JournalItem>);
    void beginRecordsAfter(std::string_view head);
    std::size_t pixelCount(std::size_t tile) const;

    std::filesystem::path path_;
    int file_ = -1;
    TileList tiles_;
    std::size_t recordSize_;
    std::int64_t firstRecord_ = 0; ///< offset
    std::uint64_t checksumOfHead_ = 0;
    std::int64_t flushedAt_ = 0; ///< seconds of the steady clock
    std::vector<char> record_;
    std::optional<std::string> failure_;
};

} // namespace yarte
