// The two ways through the text of a photometric file: line by line, and number by number. Internal.
//
// A line ends with CR LF, LF or CR. Blanks are space, tab, vertical tab and form feed. Text is bytes: nothing is
// decoded. Neither scanner allocates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace gonio::profile_detail {

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

std::string_view trim_left(std::string_view text);
std::string_view trim(std::string_view text);

// ASCII letters without regard to case.
bool starts_with_any_case(std::string_view text, std::string_view capitals);
bool equals_any_case(std::string_view text, std::string_view capitals);

struct Line {
    std::string_view text; // without its end
    std::size_t offset = 0;
};

class LineScanner {
public:
    // Reads `bytes` from `begin` on, up to `end`.
    LineScanner(std::string_view bytes, std::size_t begin, std::size_t end) : bytes_(bytes), next_(begin), end_(end) {}

    bool at_end() const { return next_ >= end_; }
    std::size_t offset() const { return next_; } // where the next line begins
    Line next();                                 // an empty line at the end

private:
    std::string_view bytes_;
    std::size_t next_;
    std::size_t end_;
};

enum class Token {
    number,
    end,        // no token is left
    not_number, // the token is none
    not_finite  // inf, nan, or beyond the range of a double
};

// Reads the whole of `text` as a decimal number with an optional sign; no blanks, no hexadecimal. Never `end`.
// Exact: the nearest double. `plain` becomes false when the number has an exponent.
Token scan_number(std::string_view text, double& value, bool& plain);

// "'abc'": what a message may show of a file's text, printable ASCII as it is, other bytes in hexadecimal.
std::string quoted(std::string_view text);

// Numbers separated by blanks, line ends and commas.
class NumberScanner {
public:
    NumberScanner(std::string_view bytes, std::size_t begin, std::size_t end)
        : first_(bytes.data()), at_(bytes.data() + begin), end_(bytes.data() + end), token_(at_) {}

    // The next number, in about 8 ns for short ones. On anything but `number`, `value` is left alone.
    Token next(double& value) {
        skip_separators();
        token_ = at_;
        if (at_ == end_) return Token::end;
        return next_fast(value) ? Token::number : next_slow(value);
    }

    // Skips separators; whether nothing else is left.
    bool at_end() {
        skip_separators();
        token_ = at_;
        return at_ == end_;
    }

    std::size_t token_offset() const { return static_cast<std::size_t>(token_ - first_); }
    std::string_view token() const; // the text of the token that was read last, shortened to what a message can hold
    bool token_begins_line() const;
    std::size_t exponent_offset() const { return exponent_; } // of the first number with an exponent, or −1
    std::size_t remaining_bytes() const { return static_cast<std::size_t>(end_ - at_); }

private:
    static bool is_separator(char c) { return c == ' ' || c == ',' || (c >= '\t' && c <= '\r'); }

    void skip_separators() {
        while (at_ != end_ && is_separator(*at_))
            ++at_;
    }

    bool next_fast(double& value);
    Token next_slow(double& value);

    const char* first_;
    const char* at_;
    const char* end_;
    const char* token_;
    std::size_t exponent_ = static_cast<std::size_t>(-1);
};

// Up to 15 digits and a point: the digits are exact in a double and so is the power of ten, so one division rounds
// correctly (W. Clinger, How to read floating point numbers accurately, 1990). Everything else takes the slow way.
inline bool NumberScanner::next_fast(double& value) {
    static constexpr double powers[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                        1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const char* p = at_;
    const bool negative = *p == '-';
    if (negative || *p == '+') ++p;
    std::uint64_t digits = 0;
    const char* const digits_begin = p;
    while (p != end_ && static_cast<unsigned char>(*p - '0') < 10)
        digits = digits * 10 + static_cast<unsigned char>(*p++ - '0'); // may wrap: too many digits are refused below
    auto count = p - digits_begin;
    std::ptrdiff_t decimals = 0;
    if (p != end_ && *p == '.') {
        const char* const decimals_begin = ++p;
        while (p != end_ && static_cast<unsigned char>(*p - '0') < 10)
            digits = digits * 10 + static_cast<unsigned char>(*p++ - '0');
        decimals = p - decimals_begin;
        count += decimals;
    }
    if (count == 0 || count > 15 || (p != end_ && !is_separator(*p))) return false;
    const double magnitude = static_cast<double>(digits) / powers[decimals];
    value = negative ? -magnitude : magnitude;
    at_ = p;
    return true;
}

} // namespace gonio::profile_detail
