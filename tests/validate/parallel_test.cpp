#include "validate/parallel.h"

#include <atomic>
#include <gtest/gtest.h>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

namespace yarte::validate {
namespace {

TEST(Parallel, EverythingIsMadeOnceAndToldInOrder) {
    for (const int jobs : {1, 2, 5, 100}) {
        std::vector<std::atomic<int>> made(40);
        std::vector<std::size_t> told;
        inParallel(
            made.size(), jobs,
            [&](std::size_t i) {
                if (i % 7 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
                ++made[i];
            },
            [&](std::size_t i) {
                EXPECT_EQ(made[i], 1);
                told.push_back(i);
            });
        std::vector<std::size_t> all(made.size());
        std::iota(all.begin(), all.end(), 0);
        EXPECT_EQ(told, all) << jobs;
    }
}

TEST(Parallel, NoMoreThanTheJobsAtOnce) {
    std::atomic<int> now = 0, most = 0;
    inParallel(
        20, 3,
        [&](std::size_t) {
            const int running = ++now;
            for (int seen = most; running > seen && !most.compare_exchange_weak(seen, running);) {
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            --now;
        },
        [](std::size_t) {});
    EXPECT_LE(most, 3);
    EXPECT_GE(most, 2) << "side by side at all";
}

TEST(Parallel, AFailureEndsItAndIsThrown) {
    std::atomic<int> made = 0;
    const auto make = [&](std::size_t i) {
        if (i == 5) throw std::runtime_error("five");
        ++made;
    };
    std::vector<std::size_t> told;
    EXPECT_THROW(inParallel(1000, 1, make, [&](std::size_t i) { told.push_back(i); }), std::runtime_error);
    EXPECT_EQ(made, 5);
    EXPECT_EQ(told.size(), 5u);
    EXPECT_THROW(inParallel(1000, 4, make, [](std::size_t) {}), std::runtime_error);
}

TEST(Parallel, NothingToDo) {
    inParallel(
        0, 4, [](std::size_t) { FAIL(); }, [](std::size_t) { FAIL(); });
}

} // namespace
} // namespace yarte::validate
