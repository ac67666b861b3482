// Which format a file has, and which files have none.
#include <gonio/profile/read.hpp>

#include "expect.hpp"

#include <gtest/gtest.h>

#include <set>

namespace {

using namespace gonio;
using namespace gonio::test;

const std::string ies = "IESNA91\nTILT=NONE\n1 1000 1 3 1 1 2 0 0 0\n1 1 10\n0 45 90\n0\n100 80 0\n";

TEST(Recognise, WhatIsNoText) {
    expect_error(read_profile("", "lamp.ies"), "lamp.ies:1:1: error[PRF0101]: the file is empty");
    expect_error(read_profile(" \r\n\t\n", "lamp.ldt"), "lamp.ldt:1:1: error[PRF0101]: the file is empty");
    expect_error(read_profile("\xEF\xBB\xBF", "lamp.ldt"),
                 "lamp.ldt:1:4: error[PRF0102]: not a photometric file: it holds no text");
    expect_error(read_profile(std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16), "lamp.ies"),
                 "lamp.ies:1:1: error[PRF0102]: not a photometric file but a PNG picture");
    expect_error(read_profile("\xEF\xBB\xBF\x89PNG\n", "lamp.ies"),
                 "lamp.ies:1:4: error[PRF0102]: not a photometric file but a PNG picture");
    expect_error(read_profile(std::string("PK\x03\x04\0\0\0\0\0\0", 10), "lamp.ies"),
                 "lamp.ies: error[ARC0101]: the archive has no directory at its end: it is cut off, or is not a zip "
                 "archive"); // GLDF by its content
    for (const auto& [bytes, name] : {std::pair{std::string("%PDF-1.4\n%\xE2"), "a PDF document"},
                                      {"\xFF\xD8\xFF\xE0", "a JPEG picture"},
                                      {"\x1F\x8B\x08", "a gzip archive"},
                                      {"<!DOCTYPE HTML>\n<title>404", "a web page"},
                                      {"SPV1.0\n1 2 3\n", "an SPV file"}})
        expect_error(read_profile(bytes, "lamp.ies"),
                     std::string("lamp.ies:1:1: error[PRF0102]: not a photometric file but ") + name);
    expect_error(read_profile(std::string("abc\n\0def", 8), "lamp.ies"),
                 "lamp.ies:2:1: error[PRF0102]: not a photometric file: text has no NUL bytes");
    expect_error(read_profile(std::string(5, '\0'), "lamp.ldt"),
                 "lamp.ldt:1:1: error[PRF0102]: not a photometric file: it holds no text");
    expect_error(read_profile("hello\nworld\n", "lamp"), "lamp:1:1: error[PRF0103]: neither IES, EULUMDAT nor TM-33");
}

TEST(Recognise, TheBytesBeforeTheName) {
    const Result<Profile> misnamed = read_profile(ies, "lamp.ldt");
    ASSERT_TRUE(misnamed) << said(misnamed);
    EXPECT_TRUE(std::holds_alternative<IesFile>(misnamed->file));
    // Neither format: the name decides, and the reader reports what is missing.
    expect_error(read_profile("hello\n", "lamp.IES"),
                 "lamp.IES:2:1: error[IES0108]: the text ends without a line TILT=NONE or TILT=INCLUDE");
    expect_error(read_profile("hello\n", "lamp.ldt"),
                 "lamp.ldt:2:1: error[LDT0101]: the file ends where the type of luminaire is expected");
    // No version line, but TILT=.
    EXPECT_TRUE(read_profile(ies.substr(8), "-"));
}

TEST(Recognise, MarksAndEnds) {
    const Result<Profile> marked = read_profile("\xEF\xBB\xBF" + ies, "lamp");
    expect_says(marked, "lamp:1:1: warning[PRF0104]: the file begins with a byte order mark");
    EXPECT_EQ(std::get<IesFile>(marked->file).version_line, "IESNA91");
    expect_silent(read_profile(ies + "\x1A", "lamp"));
    expect_silent(read_profile(ies + '\x1A' + std::string(10, '\0'), "lamp"));
    expect_says(read_profile(ies + "\x1A more", "lamp"),
                "lamp:8:3: warning[PRF0105]: data after Ctrl-Z, the end of the text");
}

std::string utf16(const std::string& text, bool big_endian) {
    std::string bytes;
    for (const char c : text)
        bytes += big_endian ? std::string{'\0', c} : std::string{c, '\0'};
    return bytes;
}

TEST(Recognise, Utf16IsConverted) {
    const IesFile expected = std::get<IesFile>(read_profile(ies, "lamp")->file);
    for (const bool big_endian : {false, true})
        for (const std::string mark : {"", big_endian ? "\xFE\xFF" : "\xFF\xFE"}) {
            const std::string bytes = mark + utf16(ies, big_endian);
            const Result<Profile> read = read_profile(bytes, "lamp");
            expect_says(read, "lamp:1:1: warning[PRF0106]: the text is UTF-16");
            EXPECT_EQ(std::get<IesFile>(read->file).candela, expected.candela);
            EXPECT_EQ(std::get<IesFile>(read->file).version, expected.version);
            EXPECT_FALSE(read_profile(bytes, "lamp", {{}, true}));
        }
    expect_error(read_profile("\xEF\xBB\xBF\xFF\xFE" + ies, "lamp"),
                 "lamp:1:4: error[PRF0106]: a UTF-16 mark follows that of UTF-8");
    // The place refers to the converted text.
    expect_error(read_profile("\xFF\xFE" + utf16("IESNA91\nTILT=NONE\n1 x", false), "lamp"),
                 "lamp:3:3: error[IES0201]: expected a number, found 'x'");
}

TEST(Recognise, AFileThatIsNotThereIsAnIoFailure) {
    const Result<Profile> read = read_profile_file("/nonexistent/lamp.ies");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().failure, Failure::io);
}

} // namespace
