// Checkpoints: what a render goes on from. Behind a good head, which no mutation would hit, lie the records.
#include "tests/fuzz/scratch.h"
#include "tests/fuzz/target.h"

#include "yarte/base/file.h"
#include "yarte/engine/journal.h"

#include <cmath>
#include <cstdlib>

namespace {

using yarte::Journal;

const yarte::TileList tiles({0, 0, 12, 9}, 4);
const std::vector<yarte::JournalItem> items{{"the scene", "1"}, {"--size", "12x9"}};

const yarte::fuzz::Scratch scratch;

/// A journal with two tiles.
std::string good() {
    Journal journal = Journal::create(scratch / "good", items, tiles);
    const std::vector<yarte::Colour> pixels(16, yarte::Colour{0.25, 0.5, 1});
    for (const std::size_t tile : {0u, 4u}) journal.add(tile, {}, pixels.data());
    return yarte::readFile(scratch / "good");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const std::string base = good();
    // Bytes that are changed, by place and new value; the last may cut it short or make it longer.
    std::string bytes = base;
    for (std::size_t i = 0; i + 3 <= size; i += 3) {
        const std::size_t place = (data[i] + 256u * data[i + 1]) % (bytes.size() + 1);
        if (place == bytes.size())
            bytes += static_cast<char>(data[i + 2]);
        else
            bytes[place] = static_cast<char>(data[i + 2]);
    }
    if (size % 3 == 2) bytes.resize((data[size - 2] + 256u * data[size - 1]) % (bytes.size() + 1));
    const std::filesystem::path file = scratch.put("changed", bytes);
    try {
        Journal journal = Journal::look(file, items, tiles);
        journal.readTiles([&](std::size_t tile, const yarte::RayCounts&, const yarte::Colour* pixels) {
            // What is restored is what was written: a checksum stands before it.
            if ((tile != 0 && tile != 4) || pixels[0].r != 0.25 || pixels[15].b != 1) std::abort();
        });
    } catch (const yarte::JournalError&) {
    }
    return 0;
}
