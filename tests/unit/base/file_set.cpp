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
#include <vector>

namespace gonio {
namespace {

namespace fs = std::filesystem;

class FileSetTest : public testing::Test {
protected:
    std::string path(const std::string& name) const { return (folder / name).string(); }
    std::ptrdiff_t entries() const { return std::distance(fs::directory_iterator(folder), fs::directory_iterator()); }

    test::TemporaryFolder own;
    const fs::path& folder = own.path();
};

TEST_F(FileSetTest, NothingHasItsNameBeforeTheCommit) {
    ASSERT_TRUE(write_file(path("old"), "before"));
    FileSet set;
    ASSERT_TRUE(set.add(path("old"), "after"));
    ASSERT_TRUE(set.add(path("new"), "new"));
    EXPECT_EQ(*read_file(path("old")), "before");
    EXPECT_FALSE(file_exists(path("new")));
    ASSERT_TRUE(set.commit());
    EXPECT_EQ(*read_file(path("old")), "after");
    EXPECT_EQ(*read_file(path("new")), "new");
    EXPECT_EQ(entries(), 2);
}

TEST_F(FileSetTest, WhatIsNotCommittedLeavesNothing) {
    ASSERT_TRUE(write_file(path("a"), "before"));
    {
        FileSet set;
        ASSERT_TRUE(set.add(path("a"), "after"));
        EXPECT_EQ(entries(), 2);
    }
    EXPECT_EQ(*read_file(path("a")), "before");
    EXPECT_EQ(entries(), 1);
}

TEST_F(FileSetTest, AFolderInAFilesPlaceFailsAndTouchesNothing) {
    ASSERT_TRUE(write_file(path("a"), "before"));
    fs::create_directory(path("b"));
    FileSet set;
    ASSERT_TRUE(set.add(path("a"), "after"));
    const Result<void> added = set.add(path("b"), "after");
    ASSERT_FALSE(added);
    EXPECT_EQ(added.error().failure, Failure::io);
}

// A failure that no earlier check can detect: the last file cannot get its name when the others already have theirs.
TEST_F(FileSetTest, AFailedCommitGivesEveryFileBackWhatItWas) {
    ASSERT_TRUE(write_file(path("a"), "before a"));
    ASSERT_EQ(chmod(path("a").c_str(), 0640), 0);
    for (const bool last : {false, true}) {
        FileSet set;
        ASSERT_TRUE(set.add(path("a"), "after"));
        ASSERT_TRUE(set.add(path("new"), "after"));
        ASSERT_TRUE(set.add(path("b"), "after"));
        if (!last) {
            ASSERT_TRUE(set.add(path("c"), "after"));
        }
        fs::create_directories(path("b") + "/full");
        const Result<void> done = set.commit();
        ASSERT_FALSE(done) << last;
        EXPECT_EQ(done.error().failure, Failure::io);
        EXPECT_EQ(done.error().diagnostics.back().location.file, path("b"));
        EXPECT_EQ(*read_file(path("a")), "before a");
        struct stat status {};
        ASSERT_EQ(stat(path("a").c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777U, 0640U);
        EXPECT_FALSE(file_exists(path("new")));
        EXPECT_FALSE(file_exists(path("c")));
        EXPECT_TRUE(fs::is_directory(path("b") + "/full"));
        EXPECT_EQ(entries(), 2);
        fs::remove_all(path("b"));
    }
}

TEST_F(FileSetTest, ADeviceThatFailsLeavesTheFilesAsTheyWere) {
    ASSERT_TRUE(write_file(path("a"), "before"));
    FileSet set;
    ASSERT_TRUE(set.add(path("a"), "after"));
    ASSERT_TRUE(set.add("/dev/full", "x"));
    const Result<void> done = set.commit();
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().diagnostics.back().location.file, "/dev/full");
    EXPECT_EQ(*read_file(path("a")), "before");
    EXPECT_EQ(entries(), 1);
}

// In a child process, because the limit and the signal's action apply to the whole process.
TEST_F(FileSetTest, AFileSizeLimitLeavesAllFilesAsTheyWere) {
    ASSERT_TRUE(write_file(path("a"), "old a"));
    ASSERT_TRUE(write_file(path("b"), "old b"));
    const auto child = [&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{4096, 4096};
        if (setrlimit(RLIMIT_FSIZE, &limit) != 0) std::_Exit(2);
        FileSet set;
        if (!set.add(path("a"), "new a")) std::_Exit(3);
        if (set.add(path("b"), std::string(100000, 'x'))) std::_Exit(4);
        std::_Exit(0);
    };
    EXPECT_EXIT(child(), testing::ExitedWithCode(0), "");
    EXPECT_EQ(*read_file(path("a")), "old a");
    EXPECT_EQ(*read_file(path("b")), "old b");
}

TEST_F(FileSetTest, TheLongestNameFits) {
    const std::string name(255, 'n');
    ASSERT_TRUE(write_file(path(name), "x"));
    EXPECT_EQ(*read_file(path(name)), "x");
    EXPECT_FALSE(write_file(path(name + "n"), "x"));
    EXPECT_EQ(entries(), 1);
}

TEST_F(FileSetTest, LinksAreFollowedWhereTheyLeadToNothingYet) {
    fs::create_directory(path("d"));
    fs::create_symlink("d/target", path("link"));
    ASSERT_TRUE(write_file(path("link"), "x"));
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(*read_file(path("d/target")), "x");
    fs::create_symlink("loop", path("loop"));
    EXPECT_FALSE(write_file(path("loop"), "x"));
    EXPECT_TRUE(fs::is_symlink(path("loop")));
}

TEST_F(FileSetTest, CheckingLeavesNothingAndTouchesNothing) {
    ASSERT_TRUE(write_file(path("x"), "x"));
    ASSERT_TRUE(write_file(path("x.trial"), "mine"));
    EXPECT_TRUE(check_writable(path("x")));
    EXPECT_TRUE(check_writable(path("y")));
    EXPECT_TRUE(check_writable("/dev/full"));
    EXPECT_FALSE(check_writable(path("no/such")));
    EXPECT_FALSE(check_writable(folder.string()));
    EXPECT_EQ(*read_file(path("x.trial")), "mine");
    EXPECT_EQ(entries(), 2);
}

TEST_F(FileSetTest, DurableFilesAreWrittenAsOthersAre) {
    ASSERT_TRUE(write_file(path("x"), "old"));
    FileSet set({.durable = true});
    ASSERT_TRUE(set.add(path("x"), "new"));
    ASSERT_TRUE(set.add(path("y"), "y"));
    ASSERT_TRUE(set.commit());
    EXPECT_EQ(*read_file(path("x")), "new");
    EXPECT_EQ(*read_file(path("y")), "y");
    EXPECT_EQ(entries(), 2);
}

// A signal handler runs at any moment while many threads write: no temporary file is left, and every file is complete.
TEST_F(FileSetTest, ThreadsThatWriteLeaveNothingWhenASignalEndsThem) {
    const auto child = [&] {
        std::signal(SIGTERM, [](int) {
            remove_temporary_files();
            std::_Exit(7);
        });
        std::vector<std::thread> writers;
        for (int t = 0; t < 4; ++t)
            writers.emplace_back([&, t] {
                for (int i = 0;; ++i) {
                    FileSet set;
                    const std::string name = std::to_string(t);
                    (void)set.add(path(name + ".a"), std::string(20000, 'a'));
                    (void)set.add(path(name + ".b"), std::string(20000, 'b'));
                    (void)set.commit();
                    if (t == 0 && i == 20) (void)std::raise(SIGTERM);
                }
            });
        for (std::thread& writer : writers)
            writer.join();
    };
    EXPECT_EXIT(child(), testing::ExitedWithCode(7), "");
    for (const auto& entry : fs::directory_iterator(folder)) {
        EXPECT_FALSE(entry.path().filename().string().starts_with(".gonio")) << entry.path();
        EXPECT_EQ(fs::file_size(entry.path()), 20000U) << entry.path();
    }
}

TEST_F(FileSetTest, NothingIsWrittenOnceTheProcessEnds) {
    const auto child = [&] {
        remove_temporary_files();
        std::_Exit(write_file(path("x"), "x") ? 1 : 0);
    };
    EXPECT_EXIT(child(), testing::ExitedWithCode(0), "");
    EXPECT_EQ(entries(), 0);
}

TEST_F(FileSetTest, IdentityIsThatOfTheFileNotOfItsName) {
    ASSERT_TRUE(write_file(path("a"), "x"));
    fs::create_hard_link(path("a"), path("hard"));
    fs::create_symlink("a", path("soft"));
    const std::string identity = file_identity(path("a"));
    EXPECT_FALSE(identity.empty());
    EXPECT_EQ(file_identity(path("hard")), identity);
    EXPECT_EQ(file_identity(path("soft")), identity);
    EXPECT_EQ(file_identity(path("./a")), identity);
    EXPECT_NE(file_identity(path("b")), identity);
    EXPECT_EQ(file_identity(path("./b")), file_identity(path("b"))); // does not exist yet
    fs::create_directory_symlink(".", path("here"));
    EXPECT_EQ(file_identity(path("here/b")), file_identity(path("b")));
    EXPECT_EQ(file_identity("/dev/null"), "");
    EXPECT_EQ(file_identity(folder.string()), "");
}

} // namespace
} // namespace gonio
