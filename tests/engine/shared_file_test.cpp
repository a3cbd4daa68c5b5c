#include "yarte/engine/shared_file.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace yarte {
namespace {

/// Lowers the largest size of files that this process may write, for a while.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit lower{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &lower);
    }
    ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    rlimit before_{};
};

/// What two processes have written, as the parent takes it in pieces that cross theirs.
std::vector<int> writtenByTwo() {
    constexpr std::size_t half = 50'000;
    std::vector<int> numbers(2 * half);
    std::iota(numbers.begin(), numbers.end(), 1);
    const SharedFile file(numbers.size() * sizeof(int));
    for (std::size_t part = 0; part < 2; ++part)
        if (fork() == 0) {
            file.write(part * half * sizeof(int), &numbers[part * half], half * sizeof(int));
            _exit(0);
        }
    while (wait(nullptr) > 0) {
    }
    std::vector<int> taken(numbers.size());
    for (std::size_t at = 0, count = 0; at < taken.size(); at += count) {
        count = std::min<std::size_t>(777, taken.size() - at);
        file.read(at * sizeof(int), &taken[at], count * sizeof(int));
    }
    return taken;
}

std::vector<int> expected() {
    std::vector<int> numbers(100'000);
    std::iota(numbers.begin(), numbers.end(), 1);
    return numbers;
}

TEST(SharedFile, GivesTheParentWhatProcessesWrite) { EXPECT_EQ(writtenByTwo(), expected()); }

TEST(SharedFile, DoesSoWhereFilesMustBeSmall) {
    const FileSizeLimit limit(1000);
    EXPECT_EQ(writtenByTwo(), expected());
}

TEST(SharedFile, IsZeroWhereNothingWasWritten) {
    const SharedFile file(100);
    int number = 7;
    file.read(50, &number, sizeof number);
    EXPECT_EQ(number, 0);
}

} // namespace
} // namespace yarte
