// Small files as lists of lines, and the expected diagnostics with their exact places.
#pragma once

#include <gonio/profile/read.hpp>

#include "../said.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace gonio::test {

using TextLines = std::vector<std::string>;

inline std::string joined(const TextLines& lines, const std::string& end = "\n") {
    std::string text;
    for (const std::string& line : lines)
        text += line + end;
    return text;
}

// `lines` with line `number` (1-based) replaced.
inline TextLines with(TextLines lines, std::size_t number, const std::string& text) {
    lines.at(number - 1) = text;
    return lines;
}

inline TextLines without(TextLines lines, std::size_t number) {
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(number - 1));
    return lines;
}

inline std::string said(const Result<Profile>& read) {
    return said(read ? read->diagnostics : read.error().diagnostics);
}

// Checks that `read` failed as malformed, and that the reason is "lamp:LINE:COLUMN: error[CODE]: MESSAGE".
inline void expect_error(const Result<Profile>& read, const std::string& reason, Failure failure = Failure::malformed) {
    ASSERT_FALSE(read) << "read, and expected: " << reason;
    EXPECT_EQ(read.error().failure, failure);
    ASSERT_FALSE(read.error().diagnostics.empty());
    Diagnostic last = read.error().diagnostics.back();
    last.hint.clear();
    EXPECT_EQ(to_text(last), reason);
}

// Checks that `read` succeeded, and that one of its diagnostics is "lamp:LINE:COLUMN: warning[CODE]: MESSAGE".
inline void expect_says(const Result<Profile>& read, const std::string& sentence) {
    ASSERT_TRUE(read) << said(read);
    const bool found = std::any_of(read->diagnostics.begin(), read->diagnostics.end(), [&](Diagnostic d) {
        d.hint.clear();
        return to_text(d) == sentence;
    });
    EXPECT_TRUE(found) << "expected: " << sentence << "\nsaid: " << said(read);
}

inline void expect_silent(const Result<Profile>& read) {
    ASSERT_TRUE(read) << said(read);
    EXPECT_TRUE(read->diagnostics.empty()) << said(read);
}

} // namespace gonio::test
