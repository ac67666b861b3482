#include <gonio/base/folder.hpp>

#include "../temporary_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>

namespace gonio {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 2> profiles{"ies", "ldt"};

class FolderTest : public testing::Test {
protected:
    void touch(const std::string& name) const {
        fs::create_directories((root_ / name).parent_path());
        std::ofstream(root_ / name) << "x";
    }

    test::TemporaryFolder own_;
    const fs::path& root_ = own_.path();
};

TEST_F(FolderTest, FindsByExtensionAtAnyDepthInTheOrderOfTheNames) {
    for (const char* name : {"b.ies", "a.LDT", "sub/c.ies", "notes.txt", "no-extension", ".hidden.ies", ".git/d.ies"})
        touch(name);
    const auto files = files_in(root_.string(), profiles);
    ASSERT_TRUE(files.has_value());
    const std::vector<std::string> expected{(root_ / "a.LDT").string(), (root_ / "b.ies").string(),
                                            (root_ / "sub/c.ies").string()};
    EXPECT_EQ(*files, expected);
}

TEST_F(FolderTest, DoesNotFollowALinkRoundInACircle) {
    touch("lamp.ies");
    fs::create_directory_symlink(root_, root_ / "again");
    const auto files = files_in(root_.string(), profiles);
    ASSERT_TRUE(files.has_value());
    EXPECT_EQ(files->size(), 1U);
}

TEST_F(FolderTest, AFolderNamedLikeAProfileIsNone) {
    fs::create_directory(root_ / "folder.ies");
    const auto files = files_in(root_.string(), profiles);
    ASSERT_TRUE(files.has_value());
    EXPECT_TRUE(files->empty());
    EXPECT_TRUE(is_folder((root_ / "folder.ies").string()));
}

TEST_F(FolderTest, WhatIsNotThereFailsWithItsName) {
    const std::string missing = (root_ / "missing").string();
    EXPECT_FALSE(is_folder(missing));
    const auto files = files_in(missing, profiles);
    ASSERT_FALSE(files.has_value());
    EXPECT_EQ(files.error().failure, Failure::io);
    EXPECT_EQ(files.error().diagnostics.back().location.file, missing);
}

} // namespace
} // namespace gonio
