#include "yarte/engine/journal.h"

#include "yarte/base/file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include <csignal>
#include <sys/resource.h>
#include <unistd.h>

namespace yarte {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const Tile region{3, 2, 13, 9};
const TileList tiles(region, 4); // 3 x 2 of them, some narrower
const std::vector<JournalItem> items{{"the scene's text", "abc"}, {"--tile", "4"}};

struct Kept {
    RayCounts rays;
    std::vector<Colour> pixels;
    friend bool operator==(const Kept&, const Kept&) = default;
};
using KeptTiles = std::map<std::size_t, Kept>;

Kept contentOf(std::size_t tile) {
    Kept result;
    result.rays = {tile, tile + 1, 7, 9};
    const Tile t = tiles[tile];
    for (int i = 0; i < t.width() * t.height(); ++i)
        result.pixels.push_back({1.0 / (1 + i), static_cast<double>(tile), -0.1 * i});
    return result;
}

void add(Journal& journal, std::size_t tile) {
    const Kept content = contentOf(tile);
    journal.add(tile, content.rays, content.pixels.data());
}

struct Reading {
    KeptTiles kept;
    std::size_t damaged = 0;
};

Reading read(Journal& journal) {
    Reading result;
    result.damaged = journal.readTiles([&](std::size_t tile, const RayCounts& rays, const Colour* pixels) {
        result.kept[tile] = {rays, {pixels, pixels + tiles[tile].width() * tiles[tile].height()}};
    });
    return result;
}

class JournalFile : public testing::Test {
protected:
    JournalFile() { fs::remove(file_); }
    ~JournalFile() override { fs::remove(file_); }

    /// Without the flushing to the disk that writeFile does.
    void write(const std::string& bytes) const {
        std::ofstream(file_, std::ios::binary | std::ios::trunc) << bytes;
    }

    /// A journal of three tiles, closed.
    std::string written() const {
        {
            Journal journal = Journal::create(file_, items, tiles);
            for (const std::size_t tile : {4u, 0u, 5u}) add(journal, tile);
            EXPECT_FALSE(journal.failure());
        }
        return readFile(file_);
    }

    std::string whyNotResumed(const std::vector<JournalItem>& other) const {
        try {
            Journal::resume(file_, other, tiles);
        } catch (const JournalError& error) {
            return error.what();
        }
        return "";
    }

    const fs::path file_ = fs::temp_directory_path() / ("yarte-journal-" + std::to_string(::getpid()));
};

TEST_F(JournalFile, HoldsWhatWasAdded) {
    written();
    Journal journal = Journal::resume(file_, items, tiles);
    const Reading reading = read(journal);
    EXPECT_EQ(reading.damaged, 0U);
    EXPECT_EQ(reading.kept, (KeptTiles{{0, contentOf(0)}, {4, contentOf(4)}, {5, contentOf(5)}}));
    add(journal, 2); // and goes on
    Journal again = Journal::look(file_, items, tiles);
    EXPECT_EQ(read(again).kept.size(), 4U);
}

TEST_F(JournalFile, IsNotMadeOverAnotherNorUsedTwice) {
    Journal journal = Journal::create(file_, items, tiles);
    EXPECT_THROW(Journal::create(file_, items, tiles), FileError);
    try {
        Journal::resume(file_, items, tiles);
        ADD_FAILURE() << "resumed while in use";
    } catch (const FileError& error) {
        EXPECT_THAT(error.what(), HasSubstr("in use by another render"));
    }
    EXPECT_TRUE(read(journal).kept.empty());
    Journal looked = Journal::look(file_, items, tiles); // to read is allowed
}

TEST_F(JournalFile, ATornTailLosesItsOwnTileOnly) {
    const std::string whole = written();
    const std::size_t recordSize = 8 + 8 + 4 * 8 + 16 * sizeof(Colour);
    for (std::size_t cut = 1; cut <= recordSize; ++cut) {
        write(whole.substr(0, whole.size() - cut));
        {
            Journal journal = Journal::resume(file_, items, tiles);
            const Reading reading = read(journal);
            EXPECT_EQ(reading.damaged, 0U) << cut;
            EXPECT_EQ(reading.kept, (KeptTiles{{0, contentOf(0)}, {4, contentOf(4)}})) << cut;
            add(journal, 5);
        }
        EXPECT_EQ(readFile(file_), whole) << cut;
    }
}

TEST_F(JournalFile, EveryFlippedByteIsFound) {
    const std::string whole = written();
    const std::size_t head = whole.size() - 3 * (8 + 8 + 4 * 8 + 16 * sizeof(Colour));
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string flipped = whole;
        flipped[at] = static_cast<char>(flipped[at] ^ (1 << at % 8));
        write(flipped);
        if (at < head) {
            EXPECT_NE(whyNotResumed(items), "") << at;
            continue;
        }
        Journal journal = Journal::resume(file_, items, tiles);
        const Reading reading = read(journal);
        EXPECT_EQ(reading.damaged, 1U) << at;
        EXPECT_EQ(reading.kept.size(), 2U) << at;
        for (const auto& [tile, kept] : reading.kept) EXPECT_EQ(kept, contentOf(tile));
    }
}

TEST_F(JournalFile, RecordsOfAnotherJournalAreDamaged) {
    const std::string whole = written();
    const std::size_t head = whole.size() - 3 * (8 + 8 + 4 * 8 + 16 * sizeof(Colour));
    fs::remove(file_);
    const std::vector<JournalItem> others{{"the scene's text", "abd"}, {"--tile", "4"}};
    Journal::create(file_, others, tiles);
    write(readFile(file_) + whole.substr(head));
    Journal journal = Journal::resume(file_, others, tiles);
    const Reading reading = read(journal);
    EXPECT_EQ(reading.damaged, 3U);
    EXPECT_TRUE(reading.kept.empty());
}

TEST_F(JournalFile, NamesTheItemThatDiffers) {
    written();
    EXPECT_EQ(whyNotResumed(items), "");
    EXPECT_THAT(whyNotResumed({{"the scene's text", "abd"}, {"--tile", "4"}}),
                HasSubstr("of another render: the scene's text was abc, is abd"));
    EXPECT_THAT(whyNotResumed({{"the scene's text", "abc"}, {"--tile", "5"}}),
                HasSubstr("of another render: --tile was 4, is 5"));
    EXPECT_THAT(whyNotResumed({{"the scene's text", "abc"}, {"the mesh 'a'", "1"}, {"--tile", "4"}}),
                HasSubstr("of a render without the mesh 'a'"));
    EXPECT_THAT(whyNotResumed({{"the scene's text", "abc"}}), HasSubstr("of a render with --tile"));
    write("something else altogether");
    EXPECT_THAT(whyNotResumed(items), HasSubstr("no checkpoint, or its head is damaged"));
    write(""); // stopped before the first byte
    EXPECT_EQ(whyNotResumed(items), "");
}

/// Files may not grow beyond `bytes`, until the end of the scope: stands for a disk that is full.
class FullDisk {
public:
    explicit FullDisk(std::uintmax_t bytes) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit little{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &little);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};

TEST_F(JournalFile, AFullDiskLeavesNoHalfHead) {
    {
        const FullDisk disk(10);
        EXPECT_THROW(Journal::create(file_, items, tiles), FileError);
    }
    EXPECT_EQ(whyNotResumed(items), "");
}

TEST_F(JournalFile, AFullDiskEndsTheKeepingNotTheRender) {
    Journal journal = Journal::create(file_, items, tiles);
    add(journal, 0);
    {
        const FullDisk disk(fs::file_size(file_) + 100);
        add(journal, 1);
    }
    EXPECT_EQ(journal.failure(), "File too large");
    add(journal, 2); // not kept: it would lie behind half a record
    Journal again = Journal::look(file_, items, tiles);
    EXPECT_EQ(read(again).kept, (KeptTiles{{0, contentOf(0)}}));
}

} // namespace
} // namespace yarte
