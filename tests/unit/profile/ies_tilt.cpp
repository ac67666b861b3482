// TILT=INCLUDE and TILT=<name>: the factors of a tilted lamp, in the file or beside it.
#include <gonio/base/file.hpp>
#include <gonio/base/file_set.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/profile/write.hpp>

#include "../temporary_folder.hpp"
#include "expect.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace {

using namespace gonio;
using namespace gonio::test;
namespace fs = std::filesystem;

TextLines lamp(const std::string& tilt) {
    return {"IESNA:LM-63-1995", "TILT=" + tilt, "1 1000 1 3 1 1 2 0 0 0", "1 1 10", "0 45 90", "0", "100 80 0"};
}

const std::string table = "2\r\n3\r\n0 45 90\r\n1 0.95 0.9\r\n";

// Reads `lines` with a folder that holds the one file "lamp.tlt".
Result<Profile> read(const TextLines& lines, const std::string& tilt_bytes, bool strict = false) {
    ReadOptions options{ProfileFormat::ies, strict};
    options.read_beside = [&](const std::string& name) -> Result<std::string> {
        EXPECT_EQ(name.find_first_of("/\\:"), std::string::npos) << name;
        if (name == "lamp.tlt") return tilt_bytes;
        return fail(Failure::io, "no such file");
    };
    return read_profile(joined(lines), "folder/lamp", options);
}

void expect_factors(const Result<Profile>& profile) {
    ASSERT_TRUE(profile) << said(profile);
    const IesTilt& tilt = std::get<IesFile>(profile->file).tilt;
    EXPECT_EQ(tilt.lamp_to_luminaire_geometry, 2);
    EXPECT_EQ(tilt.angles_deg, (std::vector<double>{0, 45, 90}));
    EXPECT_EQ(tilt.factors, (std::vector<double>{1, 0.95, 0.9}));
    EXPECT_EQ(std::get<IesFile>(profile->file).candela.size(), 3U);
}

TEST(IesTilt, Include) {
    TextLines lines = lamp("INCLUDE");
    lines.insert(lines.begin() + 2, {"2", "3", "0 45 90", "1 0.95", "0.9"});
    const auto read_it = [](const TextLines& text) { return read_profile(joined(text), "lamp", {ProfileFormat::ies}); };
    expect_factors(read_it(lines));
    expect_silent(read_it(lines));
    expect_error(read_it(with(lines, 3, "4")),
                 "lamp:3:1: error[IES0113]: lamp-to-luminaire geometry 4, expected 1, 2 or 3");
    expect_error(read_it(with(lines, 4, "0")), "lamp:4:1: error[IES0114]: 0 is not a number of tilt angles");
    expect_error(read_it(with(lines, 5, "0 90 45")), "lamp:5:6: error[IES0114]: tilt angle 45 follows 90");
    expect_error(read_it(with(lines, 4, "2147483647")), "lamp:6:1: error[IES0114]: tilt angle 1 follows 90");
    lines.resize(6);
    expect_error(read_it(lines), "lamp:7:1: error[IES0114]: 3 tilt factors announced, 2 found");
    lines.resize(3);
    expect_error(read_it(lines),
                 "lamp:4:1: error[IES0114]: the text ends before the lamp geometry and the number of tilt angles");
}

TEST(IesTilt, FileBeside) {
    const Result<Profile> profile = read(lamp("lamp.tlt"), table);
    expect_factors(profile);
    expect_silent(profile);
    expect_silent(read(lamp("lamp.tlt"), table, true));
    // The name is kept and written, but not the factors.
    const std::string written = write_ies(std::get<IesFile>(profile->file));
    EXPECT_NE(written.find("\r\nTILT=lamp.tlt\r\n1 1000 1 3"), std::string::npos) << written;
}

TEST(IesTilt, FilesOf2019MayNameNone) {
    const TextLines lines = with(lamp("lamp.tlt"), 1, "IES:LM-63-2019");
    expect_says(read(lines, table),
                "folder/lamp:2:6: warning[IES0112]: LM-63-2019 does not allow TILT factors in another file");
    expect_factors(read(lines, table));
    EXPECT_FALSE(read(lines, table, true));
}

TEST(IesTilt, WithoutTheFileThereAreNoFactors) {
    const Result<Profile> missing = read(lamp("other.tlt"), table);
    expect_says(missing, "folder/lamp:2:6: warning[IES0111]: TILT factors in the file 'other.tlt': no such file");
    EXPECT_EQ(std::get<IesFile>(missing->file).tilt_keyword, "other.tlt");
    EXPECT_TRUE(std::get<IesFile>(missing->file).tilt.factors.empty());
    expect_error(read(lamp("other.tlt"), table, true),
                 "folder/lamp:2:6: error[IES0111]: TILT factors in the file 'other.tlt': no such file");
    expect_says(read_profile(joined(lamp("lamp.tlt")), "lamp"),
                "lamp:2:6: warning[IES0111]: TILT factors in the file 'lamp.tlt' are not read");
}

TEST(IesTilt, NamesThatAreNoPlainNamesAreNeverAskedFor) {
    for (const std::string name :
         {"/etc/lamp.tlt", "../lamp.tlt", "..", ".", "a/b", "C:\\LAMPS\\MH.TLT", "C:MH.TLT", "..\\mh.tlt"}) {
        const Result<Profile> profile = read(lamp(name), table); // asserts that no such name arrives
        expect_says(profile, "folder/lamp:2:6: warning[IES0111]: TILT factors in '" + name +
                                 "': only a file in the same folder is read");
        EXPECT_FALSE(read(lamp(name), table, true)) << name;
    }
    const Result<Profile> long_name = read(lamp(std::string(300, 'x')), table);
    ASSERT_TRUE(long_name);
    EXPECT_EQ(long_name->diagnostics.size(), 1U) << said(long_name);
}

TEST(IesTilt, WhatIsWrongInTheFileIsSaidOfTheFile) {
    expect_error(read(lamp("lamp.tlt"), "2\n3\n0 90 45\n1 1 1\n"),
                 "folder/lamp.tlt:3:6: error[IES0114]: tilt angle 45 follows 90");
    expect_error(read(lamp("lamp.tlt"), "2\r3\r0 45 x\r"),
                 "folder/lamp.tlt:3:6: error[IES0201]: expected a number, found 'x'");
    expect_error(read(lamp("lamp.tlt"), "hunter2 1\n"),
                 "folder/lamp.tlt:1:1: error[IES0201]: not a file of TILT factors");
    expect_error(read(lamp("lamp.tlt"), "1\nhunter2\n"),
                 "folder/lamp.tlt:2:1: error[IES0201]: not a file of TILT factors");
    expect_error(read(lamp("lamp.tlt"), ""), "folder/lamp.tlt:1:1: error[PRF0101]: the file is empty");
    expect_error(read(lamp("lamp.tlt"), std::string("2\n\0", 3) + "x"),
                 "folder/lamp.tlt:2:1: error[PRF0102]: not a photometric file: text has no NUL bytes");
    expect_says(read(lamp("lamp.tlt"), table + "4"),
                "folder/lamp.tlt:5:1: warning[IES0214]: '4' follows the 3 factors announced");
    expect_factors(read(lamp("lamp.tlt"), table + "4"));
}

class IesTiltFolder : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directories(folder / "in");
        put("in/lamp.ies", joined(lamp("mh.tlt")));
    }
    void put(const std::string& name, const std::string& bytes) const {
        ASSERT_TRUE(write_file((folder / name).string(), bytes));
    }
    [[nodiscard]] Result<Profile> read_it(bool strict = true) const {
        return read_profile_file((folder / "in/lamp.ies").string(), {{}, strict});
    }
    TemporaryFolder own;
    const fs::path& folder = own.path();
};

TEST_F(IesTiltFolder, IsReadWhereTheProfileLies) {
    EXPECT_FALSE(read_it());
    put("mh.tlt", table); // beside the folder, not in it
    EXPECT_FALSE(read_it());
    put("in/mh.tlt", table);
    expect_factors(read_it());
}

TEST_F(IesTiltFolder, CaseOfTheNameMadeNoDifferenceToDos) {
    put("in/MH.TLT", table);
    expect_factors(read_it());
}

TEST_F(IesTiltFolder, LinksOutOfTheFolderAreNotFollowed) {
    put("mh.tlt", table);
    fs::create_symlink(folder / "mh.tlt", folder / "in/mh.tlt");
    expect_error(read_it(), (folder / "in/lamp.ies").string() +
                                ":2:6: error[IES0111]: TILT factors in the file 'mh.tlt': the link leads out of the "
                                "folder");
    put("in/real.tlt", table);
    fs::remove(folder / "in/mh.tlt");
    fs::create_symlink("real.tlt", folder / "in/mh.tlt");
    expect_factors(read_it());
    fs::remove(folder / "in/mh.tlt");
    fs::create_directory(folder / "in/mh.tlt");
    EXPECT_FALSE(read_it());
}

} // namespace
