#include <gonio/base/file.hpp>
#include <gonio/base/file_set.hpp>

#include "../temporary_folder.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace gonio {
namespace {

namespace fs = std::filesystem;

class File : public testing::Test {
protected:
    std::string path(const char* name) const { return (folder / name).string(); }
    std::ptrdiff_t entries() const { return std::distance(fs::directory_iterator(folder), fs::directory_iterator()); }

    test::TemporaryFolder own;
    const fs::path& folder = own.path();
};

TEST_F(File, WritesAndReadsBack) {
    const std::string bytes("a\0b\r\n", 5);
    ASSERT_TRUE(write_file(path("x"), bytes));
    EXPECT_EQ(*read_file(path("x")), bytes);
    EXPECT_EQ(entries(), 1);
}

TEST_F(File, KeepsPermissionsAndFollowsLinks) {
    ASSERT_TRUE(write_file(path("real"), "old"));
    ASSERT_EQ(chmod(path("real").c_str(), 0640), 0);
    fs::create_symlink("real", path("link"));
    ASSERT_TRUE(write_file(path("link"), "new"));
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(*read_file(path("real")), "new");
    struct stat status {};
    ASSERT_EQ(stat(path("real").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST_F(File, NewFilesFollowTheUmask) {
    const mode_t before = umask(027);
    ASSERT_TRUE(write_file(path("x"), "x"));
    umask(before);
    struct stat status {};
    ASSERT_EQ(stat(path("x").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST_F(File, RefusesFoldersAndMissingOnes) {
    const auto folder_read = read_file(folder.string());
    ASSERT_FALSE(folder_read);
    EXPECT_EQ(folder_read.error().failure, Failure::io);
    EXPECT_FALSE(write_file(folder.string(), "x"));
    const auto missing = write_file(path("no/such/x"), "x");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().diagnostics.back().hint.find("does not exist"), std::string::npos);
    EXPECT_EQ(entries(), 0);
}

TEST_F(File, DevicesAreWrittenAndNotReplaced) {
    const auto full = write_file("/dev/full", "x");
    ASSERT_FALSE(full);
    EXPECT_EQ(full.error().failure, Failure::io);
    EXPECT_TRUE(write_file("/dev/null", "x"));
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(File, PipesAreWritten) {
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    std::string got;
    std::thread reader([&] { got = read_file(path("pipe")).value_or("failed"); });
    EXPECT_TRUE(write_file(path("pipe"), "through"));
    reader.join();
    EXPECT_EQ(got, "through");
    EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

TEST_F(File, AnEndlessInputIsAnError) {
    const auto zeros = read_file("/dev/zero", limit("tilt-bytes"));
    ASSERT_FALSE(zeros);
    EXPECT_EQ(zeros.error().failure, Failure::io);
    EXPECT_EQ(zeros.error().diagnostics.back().message, "larger than 1 MiB, the limit 'tilt-bytes'");
}

// In a child process, because the limit and the signal's action apply to the whole process.
TEST_F(File, AFileSizeLimitLeavesTheOldFileAndNothingElse) {
    ASSERT_TRUE(write_file(path("x"), "old"));
    const auto child = [&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{4096, 4096};
        if (setrlimit(RLIMIT_FSIZE, &limit) != 0) std::_Exit(2);
        const auto written = write_file(path("x"), std::string(100000, 'x'));
        std::_Exit(!written && written.error().failure == Failure::io ? 0 : 1);
    };
    EXPECT_EXIT(child(), testing::ExitedWithCode(0), "");
    EXPECT_EQ(*read_file(path("x")), "old");
    EXPECT_EQ(entries(), 1);
}

} // namespace
} // namespace gonio
