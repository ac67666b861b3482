#include <gonio/base/file_scope.hpp>

#include "../temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <sys/stat.h>

namespace gonio {
namespace {

namespace fs = std::filesystem;

class FileScopeTest : public testing::Test {
protected:
    FileScopeTest() {
        fs::create_directories(at("rigs/lamps"));
        for (const char* file : {"secret", "rigs/a.ies", "rigs/lamps/b.ies", "rigs-of-others"})
            std::ofstream(at(file)) << "text";
        fs::create_symlink("../secret", at("rigs/out.ies"));
        fs::create_symlink("lamps/b.ies", at("rigs/in.ies"));
        fs::create_directory_symlink("..", at("rigs/up"));
        fs::create_directory_symlink("rigs", at("link"));
        EXPECT_EQ(mkfifo(at("rigs/pipe").c_str(), 0600), 0);
    }
    std::string at(const std::string& name) const { return (folder_.path() / name).string(); }

    std::string refusal(const std::string& name, const std::string& folder = "rigs") const {
        FileScope scope = FileScope::under(at(folder));
        const Result<std::string> path = scope.path_of(name);
        if (path) return "taken as " + *path;
        EXPECT_EQ(path.error().failure, Failure::io);
        EXPECT_TRUE(scope.named().empty());
        return path.error().diagnostics.back().message;
    }

    test::TemporaryFolder folder_;
};

TEST_F(FileScopeTest, TakesRegularFilesUnderItsFolder) {
    for (const char* folder : {"rigs", "rigs/", "link"}) {
        FileScope scope = FileScope::under(at(folder));
        for (const std::string name : {"a.ies", "lamps/b.ies", "./a.ies", "lamps/../a.ies", "in.ies", "none.ies"})
            EXPECT_TRUE(scope.path_of(name)) << folder << ' ' << name;
        // Absolute, by the folder's own name and by the name of a link to it.
        EXPECT_EQ(*scope.path_of(at("rigs/a.ies")), at("rigs/a.ies"));
        EXPECT_EQ(*scope.path_of(at("link/a.ies")), at("link/a.ies"));
    }
    FileScope here = FileScope::under("");
    EXPECT_EQ(*here.path_of("CMakeLists.txt"), "CMakeLists.txt");
    EXPECT_TRUE(FileScope::under("/").path_of(at("secret")));
}

TEST_F(FileScopeTest, RefusesWhatLiesOutside) {
    for (const std::string& name :
         {std::string("../secret"), at("secret"), std::string("out.ies"), std::string("up/secret"),
          at("rigs-of-others"), std::string("/etc/passwd"), std::string("../none"), std::string("none/../../secret")})
        EXPECT_EQ(refusal(name), fmt::format("the file '{}' is outside the folder '{}'", name, at("rigs")));
    FileScope here = FileScope::under("");
    EXPECT_EQ(here.path_of("/etc/passwd").error().diagnostics.back().message,
              "the file '/etc/passwd' is outside the current folder");
    EXPECT_EQ(refusal("a.ies", "no such folder"), "taken as " + at("no such folder/a.ies")) << "reading it says more";
}

TEST_F(FileScopeTest, RefusesPipesAndDevicesWithoutOpeningThem) {
    EXPECT_EQ(refusal("pipe"), fmt::format("'pipe' in the folder '{}' is not a regular file", at("rigs")));
    EXPECT_EQ(FileScope::under("/dev").path_of("zero").error().failure, Failure::io);
}

TEST_F(FileScopeTest, AdvisesWhatItsOwnerSays) {
    EXPECT_EQ(FileScope::under(at("rigs")).path_of("../secret").error().diagnostics.back().hint,
              "put it under that folder");
    EXPECT_EQ(FileScope::under(at("rigs"), "ask").path_of("../secret").error().diagnostics.back().hint, "ask");
}

TEST_F(FileScopeTest, AnywhereTakesAllAndBothRemember) {
    FileScope scope = FileScope::anywhere(at("rigs"));
    for (const std::string& name : {std::string("pipe"), std::string("../secret"), at("secret"), std::string("pipe")})
        EXPECT_TRUE(scope.path_of(name)) << name;
    EXPECT_EQ(scope.named(), (std::set<std::string>{at("rigs/pipe"), at("rigs/../secret"), at("secret")}));
}

TEST(FolderOfFile, IsWhatStandsBeforeTheLastSlash) {
    EXPECT_EQ(folder_of_file("a/b/rig.json"), "a/b");
    EXPECT_EQ(folder_of_file("/rig.json"), "/");
    EXPECT_EQ(folder_of_file("rig.json"), "");
    EXPECT_EQ(folder_of_file("-"), "");
}

} // namespace
} // namespace gonio
