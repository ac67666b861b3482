// Real files, read in place: all files in the corpus folder's good/ must be read, all files in its bad/ refused.
#include <gonio/base/diagnostic_codes.hpp>
#include <gonio/base/file.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/profile/write.hpp>

#include "../folders.hpp"
#include "equal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

namespace {

using namespace gonio;
namespace fs = std::filesystem;

std::vector<std::string> files_in(const fs::path& folder) {
    std::vector<std::string> paths;
    if (fs::is_directory(folder))
        for (const fs::directory_entry& entry : fs::directory_iterator(folder))
            if (entry.is_regular_file()) paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

class ProfileCorpus : public testing::Test {
protected:
    void SetUp() override {
        if (!fs::is_directory(fs::path(test::corpus_folder) / "good") || std::string(test::corpus_folder).empty())
            GTEST_SKIP() << "no folder of real profiles: set GONIO_CORPUS";
    }
    std::vector<std::string> good = files_in(fs::path(test::corpus_folder) / "good");
    std::vector<std::string> bad = files_in(fs::path(test::corpus_folder) / "bad");
};

std::string all_text(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& d : diagnostics)
        text += to_text(d) + '\n';
    return text;
}

TEST_F(ProfileCorpus, EveryGoodFileIsReadAndKeepsItselfWhenWritten) {
    ASSERT_FALSE(good.empty());
    for (const std::string& path : good) {
        const Result<Profile> read = read_profile_file(path);
        ASSERT_TRUE(read) << all_text(read.error().diagnostics);
        for (const Diagnostic& d : read->diagnostics) {
            EXPECT_NE(d.severity, Severity::error) << to_text(d);
            EXPECT_FALSE(d.code.empty()) << to_text(d);
            EXPECT_EQ(d.location.file, path);
        }
        const std::string written = write_profile(*read);
        // Recognised from its own bytes, without a file name extension.
        const Result<Profile> again = read_profile(written, "again");
        ASSERT_TRUE(again) << path << '\n' << all_text(again.error().diagnostics);
        EXPECT_TRUE(test::equal(read->file, again->file)) << path;
        EXPECT_EQ(write_profile(*again), written) << path;
    }
}

// Tolerant and strict reading agree: a code, a line and a column, and no diagnostic after the reason.
TEST_F(ProfileCorpus, EveryBadFileIsRefusedWithItsPlace) {
    ASSERT_FALSE(bad.empty());
    for (const std::string& path : bad)
        for (const bool strict : {false, true}) {
            const Result<Profile> read = read_profile_file(path, {{}, strict, {}});
            ASSERT_FALSE(read) << path;
            EXPECT_EQ(read.error().failure, Failure::malformed) << path;
            ASSERT_FALSE(read.error().diagnostics.empty()) << path;
            const Diagnostic& reason = read.error().diagnostics.back();
            EXPECT_EQ(reason.severity, Severity::error) << path;
            EXPECT_NE(find_diagnostic_code(reason.code), nullptr) << to_text(reason);
            EXPECT_EQ(reason.location.file, path);
            EXPECT_GE(reason.location.line, 1U) << to_text(reason);
            EXPECT_GE(reason.location.column, 1U) << to_text(reason);
        }
}

// INDEX.tsv lists the counts of each file's table, found by another program.
TEST_F(ProfileCorpus, CountsAgreeWithTheIndex) {
    const Result<std::string> index = read_file((fs::path(test::corpus_folder) / "INDEX.tsv").string());
    ASSERT_TRUE(index);
    std::istringstream lines(*index);
    std::string line;
    std::getline(lines, line);
    int checked = 0;
    while (std::getline(lines, line)) {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, '\t');)
            cells.push_back(cell);
        if (cells.size() < 10 || cells[0].rfind("good/", 0) != 0) continue;
        const Result<Profile> read = read_profile_file((fs::path(test::corpus_folder) / cells[0]).string());
        ASSERT_TRUE(read) << cells[0];
        if (const auto* ies = std::get_if<IesFile>(&read->file)) {
            EXPECT_EQ(std::to_string(ies->vertical_deg.size()), cells[7]) << cells[0];
            EXPECT_EQ(std::to_string(ies->horizontal_deg.size()), cells[8]) << cells[0];
            EXPECT_EQ(ies->photometry == Photometry::b ? "B" : "C", cells[6]) << cells[0];
        } else {
            const LdtFile& ldt = std::get<LdtFile>(read->file);
            EXPECT_EQ(std::to_string(ldt.gammas_deg.size()), cells[7]) << cells[0];
            EXPECT_EQ(std::to_string(ldt.candela_per_klm.size() / ldt.gammas_deg.size()), cells[8]) << cells[0];
        }
        ++checked;
    }
    EXPECT_EQ(checked, static_cast<int>(good.size()));
}

} // namespace
