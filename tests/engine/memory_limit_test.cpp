#include "yarte/engine/memory_limit.h"

#include "yarte/engine/framebuffer.h"
#include "yarte/engine/render_error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <climits>

namespace yarte {
namespace {

constexpr double gib = 1024.0 * 1024 * 1024;

TEST(MemoryLimit, SaysWhatTheImageNeedsAndWhatThereIs) {
    EXPECT_EQ(imageTooLarge(100000, 100000, {23.4 * gib, "this machine has"}),
              "image of 100000x100000 pixels needs 223.5 GiB, this machine has 23.4 GiB");
}

TEST(MemoryLimit, TwentyFourBytesAPixelAndNotOneMore) {
    EXPECT_EQ(imageTooLarge(640, 480, {640 * 480 * 24, "this machine has"}), std::nullopt);
    EXPECT_NE(imageTooLarge(640, 480, {640 * 480 * 24 - 1, "this machine has"}), std::nullopt);
}

TEST(MemoryLimit, LargestSidesDoNotOverflow) {
    // 24 (2^31 - 1)^2 bytes, beyond 2^64.
    EXPECT_EQ(
        imageTooLarge(INT_MAX, INT_MAX, {1e19, "this machine has"}),
        "image of 2147483647x2147483647 pixels needs 103079215008.0 GiB, this machine has 9313225746.2 GiB");
}

TEST(MemoryLimit, OfThisMachineIsMoreThanThisTestUses) {
    EXPECT_GT(memoryLimit().bytes, 16e6);
    EXPECT_LT(memoryLimit().bytes, 1e18);
}

TEST(Framebuffer, RefusesBeforeItTakesMemory) {
    try {
        const Framebuffer framebuffer({0, 0, INT_MAX, INT_MAX}, 32);
        FAIL() << "accepted";
    } catch (const RenderError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("image of 2147483647x2147483647 pixels needs "));
    }
}

} // namespace
} // namespace yarte
