#include "yarte/base/file.h"

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace yarte {
namespace fs = std::filesystem;
namespace {

/// An empty folder for each test.
struct FileTest : testing::Test {
    FileTest() {
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
    ~FileTest() override { fs::remove_all(folder); }

    std::size_t fileCount() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }
    static std::string reasonOf(const auto& action) {
        try {
            action();
        } catch (const FileError& e) {
            return e.reason();
        }
        return "no error";
    }

    fs::path folder =
        fs::path(YARTE_TEST_OUTPUT) / "file" / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::path file = folder / "out.bin";
};

TEST_F(FileTest, BytesReadBackAsWritten) {
    std::string bytes(300000, '\0');
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 7);
    writeFile(file, bytes);
    EXPECT_EQ(readFile(file), bytes);
    EXPECT_EQ(fileCount(), 1U);
    writeFile(file, "");
    EXPECT_EQ(readFile(file), "");
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(FileTest, ReadErrorsTellTheReason) {
    EXPECT_EQ(reasonOf([&] { readFile(file); }), "no such file or directory");
    EXPECT_EQ(reasonOf([&] { readFile(folder); }), "is a directory");
    EXPECT_EQ(reasonOf([&] { readFile(folder / "a" / "b"); }), "no such file or directory");
    try {
        readFile(file);
        FAIL();
    } catch (const FileError& e) {
        EXPECT_EQ(e.what(), file.string() + ": no such file or directory");
    }
}

TEST_F(FileTest, PipeIsReadToItsEnd) {
    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    std::jthread writer([&] { writeFile(pipe, std::string(100000, 'x')); });
    EXPECT_EQ(readFile(pipe), std::string(100000, 'x'));
}

TEST_F(FileTest, WriteErrorsLeaveNothing) {
    EXPECT_EQ(reasonOf([&] { writeFile(folder / "none" / "x", "a"); }), "no such file or directory");
    EXPECT_EQ(reasonOf([&] { writeFile(folder, "a"); }), "is a directory");
    EXPECT_EQ(reasonOf([&] { writeFile("/dev/full", "a"); }), "no space left on device");
    writeFile(file, "a");
    EXPECT_EQ(reasonOf([&] { writeFile(file / "x", "a"); }), "not a directory");
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(FileTest, FailedWriteKeepsTheOldFile) {
    writeFile(file, "old");
    // A limit on the size of files stands for a full disk.
    const rlim_t limit = 1000;
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{limit, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string reason = reasonOf([&] { writeFile(file, std::string(5000, 'x')); });
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, oldHandler);
    EXPECT_EQ(reason, "file too large");
    EXPECT_EQ(readFile(file), "old");
    EXPECT_EQ(fileCount(), 1U);
}

TEST_F(FileTest, DevicesTakeTheBytesDirectly) {
    writeFile("/dev/null", "a");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(FileTest, ModeOfAnExistingFileStays) {
    writeFile(file, "a");
    fs::permissions(file, fs::perms(0640));
    writeFile(file, "b");
    EXPECT_EQ(fs::status(file).permissions(), fs::perms(0640));
}

TEST(FileDeathTest, ReadOnlyFileIsNotReplaced) {
    // In a child process, which becomes nobody where it is root: root may write everywhere.
    const fs::path folder = fs::temp_directory_path() / ("yarte-file-test-" + std::to_string(::getpid()));
    const fs::path file = folder / "out.bin";
    const auto refused = [&] {
        if (::geteuid() == 0 && ::setuid(65534) != 0) std::exit(2);
        fs::create_directory(folder);
        writeFile(file, "a");
        fs::permissions(file, fs::perms(0444));
        const std::string reason = FileTest::reasonOf([&] { writeFile(file, "b"); });
        const bool kept = readFile(file) == "a";
        fs::remove_all(folder);
        std::exit(reason == "permission denied" && kept ? 0 : 1);
    };
    EXPECT_EXIT(refused(), testing::ExitedWithCode(0), "");
}

TEST_F(FileTest, LinkStaysALink) {
    writeFile(folder / "target", "a");
    fs::create_symlink("target", file);
    writeFile(file, "b");
    EXPECT_TRUE(fs::is_symlink(file));
    EXPECT_EQ(readFile(folder / "target"), "b");
}

TEST_F(FileTest, WhyUnreadable) {
    writeFile(file, "a");
    EXPECT_EQ(whyUnreadable(file), std::nullopt);
    EXPECT_EQ(whyUnreadable(folder), "is a directory");
    EXPECT_EQ(whyUnreadable(folder / "none"), "no such file or directory");
    EXPECT_EQ(whyUnreadable("/dev/null"), "not a regular file");
}

struct ReadableFoldersTest : FileTest {
    ReadableFoldersTest() {
        fs::create_directories(folder / "scene" / "meshes");
        fs::create_directories(folder / "scene2");
        writeFile(folder / "scene" / "meshes" / "a.pmf", "");
        writeFile(folder / "scene2" / "b.pmf", "");
    }
    ReadableFolders readable{{folder / "scene"}};
};

TEST_F(ReadableFoldersTest, ContainTheFolderAndBelow) {
    EXPECT_TRUE(readable.contain(folder / "scene" / "meshes" / "a.pmf"));
    EXPECT_TRUE(readable.contain(folder / "scene" / "meshes" / ".." / "none.pmf"));
    EXPECT_FALSE(readable.contain(folder / "scene" / ".." / "scene2" / "b.pmf"));
    EXPECT_FALSE(readable.contain("/etc/passwd"));
    EXPECT_FALSE(readable.contain(""));
}

TEST_F(ReadableFoldersTest, CompareComponentsNotLetters) {
    EXPECT_FALSE(readable.contain(folder / "scene2" / "b.pmf"));
    EXPECT_TRUE((ReadableFolders{{folder / "scene2" / ""}}.contain(folder / "scene2" / "b.pmf")));
}

TEST_F(ReadableFoldersTest, LinksAreFollowed) {
    fs::create_symlink(folder / "scene2" / "b.pmf", folder / "scene" / "out.pmf");
    fs::create_symlink("meshes/a.pmf", folder / "scene" / "in.pmf");
    fs::create_symlink(folder / "scene2", folder / "scene" / "elsewhere");
    EXPECT_FALSE(readable.contain(folder / "scene" / "out.pmf"));
    EXPECT_FALSE(readable.contain(folder / "scene" / "elsewhere" / "b.pmf"));
    EXPECT_TRUE(readable.contain(folder / "scene" / "in.pmf"));
}

TEST_F(ReadableFoldersTest, EmptyFolderIsTheCurrentOne) {
    EXPECT_TRUE((ReadableFolders{{""}}.contain("some.pmf")));
    EXPECT_TRUE((ReadableFolders{{"."}}.contain("./some.pmf")));
    EXPECT_FALSE((ReadableFolders{{""}}.contain("../some.pmf")));
    EXPECT_FALSE(ReadableFolders{}.contain("some.pmf"));
}

} // namespace
} // namespace yarte
