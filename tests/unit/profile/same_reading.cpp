// Reading in bulk, with every instruction set, gives what reading number by number gives: file, messages and places.
#include "same_reading.hpp"

#include <gonio/base/file.hpp>
#include <gonio/profile/reader_report.hpp>

#include "../folders.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>

namespace gonio {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> texts_in(const fs::path& folder) {
    std::vector<std::string> texts;
    if (!fs::is_directory(folder)) return texts;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".ies" || entry.path().extension() == ".ldt")
            if (Result<std::string> bytes = read_file(entry.path().string()); bytes) texts.push_back(std::move(*bytes));
    return texts;
}

void expect_alike(const std::string& text) {
    for (const bool strict : {false, true})
        ASSERT_EQ(test::difference_of_readings(text, "text", {{}, strict, {}}), "") << text.substr(0, 2000);
}

TEST(SameReading, OfAuthoredProfiles) {
    const std::vector<std::string> texts = texts_in(fs::path(test::source_folder) / "profiles");
    ASSERT_FALSE(texts.empty());
    for (const std::string& text : texts)
        ASSERT_NO_FATAL_FAILURE(expect_alike(text));
}

TEST(SameReading, OfRealProfiles) {
    const std::vector<std::string> texts = texts_in(test::corpus_folder);
    if (texts.empty()) GTEST_SKIP() << "no folder of real profiles: set GONIO_CORPUS";
    for (const std::string& text : texts)
        ASSERT_NO_FATAL_FAILURE(expect_alike(text));
}

// Small changes to a small file: what is left out, doubled or replaced by what numbers and lines are made of.
TEST(SameReading, OfDamagedProfiles) {
    std::mt19937 random(30);
    static constexpr std::string_view pieces[] = {" ",    "\n",   "\r",   "\r\n", ",", ".",   "-",         "0",
                                                  "1e3",  "+5",   "90",   "180",  "/", "nan", "123456789", "-0",
                                                  "\x1a", "\n\n", " 1\n", "0 ",   "x", "\t",  "1e40",      "360"};
    for (const char* const name : {"downlight.ies", "downlight.ldt", "lm-63-1995/pendant.ies", "street.ldt"}) {
        const Result<std::string> read = read_file(std::string(test::source_folder) + "/profiles/" + name);
        ASSERT_TRUE(read) << name;
        for (int i = 0; i < 400; ++i) {
            std::string text = *read;
            for (int k = 0; k <= i % 3; ++k) {
                const std::size_t at = random() % text.size();
                text.replace(at, random() % 4, pieces[random() % std::size(pieces)]);
            }
            if (i % 8 == 0) text.resize(random() % text.size());
            ASSERT_NO_FATAL_FAILURE(expect_alike(text));
        }
    }
}

TEST(SameReading, PlacesCountLinesOfEveryKind) {
    std::mt19937 random(31);
    for (int i = 0; i < 400; ++i) {
        std::string text;
        while (text.size() < 200)
            text += std::string_view("ab\r\n\n\r")[random() % 6];
        std::uint32_t line = 1;
        std::uint32_t column = 1;
        for (std::size_t at = 0; at <= text.size(); ++at) {
            profile_detail::Report report(text, "text", false);
            report.mark(ProfileField::intensity, at);
            const FieldPlace place = report.places()[ProfileField::intensity];
            ASSERT_EQ(place.line, line) << i << " " << at;
            ASSERT_EQ(place.column, column) << i << " " << at;
            if (at == text.size()) break;
            const bool cr_of_crlf = text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n';
            const bool ends = text[at] == '\n' || (text[at] == '\r' && !cr_of_crlf);
            line += ends ? 1 : 0;
            column = ends ? 1 : column + 1;
        }
    }
}

} // namespace
} // namespace gonio
