// Readers access only the bytes they are given: texts in blocks of exactly their size, checked by AddressSanitizer,
// truncated at every byte.
#include <gonio/base/file.hpp>
#include <gonio/profile/read.hpp>

#include "../folders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

namespace gonio {
namespace {

Result<Profile> read_in_block(std::string_view text, bool strict) {
    const std::unique_ptr<char[]> block(new char[text.size()]);
    std::copy(text.begin(), text.end(), block.get());
    return read_profile({block.get(), text.size()}, "block", {{}, strict, {}});
}

// Bytes after the block must not matter: the same text within a longer one is read alike.
void expect_alike(const std::string& text, std::size_t size) {
    const std::string_view part = std::string_view(text).substr(0, size);
    for (const bool strict : {false, true}) {
        const Result<Profile> alone = read_in_block(part, strict);
        const Result<Profile> within = read_profile(part, "block", {{}, strict, {}});
        ASSERT_EQ(alone.has_value(), within.has_value()) << size;
        const Diagnostics& a = alone ? alone->diagnostics : alone.error().diagnostics;
        const Diagnostics& b = within ? within->diagnostics : within.error().diagnostics;
        ASSERT_EQ(a.size(), b.size()) << size;
        for (std::size_t i = 0; i < a.size(); ++i)
            EXPECT_EQ(to_text(a[i]), to_text(b[i])) << size;
    }
}

std::string authored(const std::string& name) {
    const Result<std::string> bytes = read_file(std::string(test::source_folder) + "/profiles/" + name);
    EXPECT_TRUE(bytes);
    return bytes ? *bytes : std::string();
}

TEST(ExactBlocks, OfEveryFormatAreReadToTheirEndAndNoFurther) {
    for (const char* const name : {"pendant.ies", "pendant.ldt", "pendant.xml", "lm-63-2019/pendant.ies"}) {
        const std::string text = authored(name);
        ASSERT_FALSE(text.empty());
        for (std::size_t size = 0; size <= text.size(); ++size)
            ASSERT_NO_FATAL_FAILURE(expect_alike(text, size)) << name;
    }
}

// Tables long enough for the fast paths, and every way in which a last number can end.
TEST(ExactBlocks, EndInNumbersOfEveryLength) {
    std::string ies = "IESNA:LM-63-1995\nTILT=NONE\n1 1000 1 100 1 1 2 0 0 0\n1 1 10\n";
    for (int i = 0; i < 100; ++i)
        ies += std::to_string(i) + " ";
    ies += "\n0\n";
    for (int i = 0; i < 99; ++i)
        ies += "123.25 ";
    std::string ldt = "c\n1\n1\n1\n0\n100\n1\nr\nn\nn\nf\nd\n";
    for (int i = 13; i <= 26; ++i)
        ldt += i == 24 || i == 26 ? "1\n" : "0\n";
    ldt += "1\nLED\n1000\n3000\n80\n10\n";
    for (int i = 0; i < 11; ++i) // ratios and the plane
        ldt += "0\n";
    for (int i = 0; i < 100; ++i)
        ldt += std::to_string(i) + "\n";
    for (int i = 0; i < 99; ++i)
        ldt += "123.25\r\n";
    for (const std::string& table : {ies, ldt}) {
        ASSERT_TRUE(read_in_block(table + "7", false)) << table;
        for (const char* const last : {"7",
                                       "-7",
                                       "+7",
                                       ".5",
                                       "-.5",
                                       "5.",
                                       "1234567",
                                       "12345678",
                                       "123456789",
                                       "1234567890123456789",
                                       "12345678901234567890",
                                       "0.0000000000000000001",
                                       "000000000000000000000001.5",
                                       "1e3",
                                       "1e-400",
                                       "9,",
                                       "9\r",
                                       "9\r\n",
                                       "9 ",
                                       "9x",
                                       "-",
                                       "1.2.3",
                                       "123456789012345678901234567890123456789012345678"})
            ASSERT_NO_FATAL_FAILURE(expect_alike(table + last, table.size() + std::string_view(last).size())) << last;
    }
}

} // namespace
} // namespace gonio
