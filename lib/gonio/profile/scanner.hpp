// The two scanners for the text of a photometric file: line by line, and number by number. Internal.
//
// A line ends with CR LF, LF or CR. Blanks are space, tab, vertical tab and form feed. Text is bytes: nothing is
// decoded. Neither scanner allocates.
#pragma once

#include <gonio/profile/fast_number.hpp>
#include <gonio/profile/token_kernels.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace gonio::profile_detail {

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

std::string_view trim_left(std::string_view text);
std::string_view trim_right(std::string_view text);
std::string_view trim(std::string_view text);

struct Line {
    std::string_view text; // without its end
    std::size_t offset = 0;
};

class LineScanner {
public:
    // Reads `bytes` from `begin` on, up to `end`.
    LineScanner(std::string_view bytes, std::size_t begin, std::size_t end) : bytes_(bytes), next_(begin), end_(end) {}

    [[nodiscard]] bool at_end() const { return next_ >= end_; }
    [[nodiscard]] std::size_t offset() const { return next_; } // where the next line begins
    void go_to(std::size_t offset) { next_ = offset; }
    Line next(); // an empty line at the end

private:
    std::string_view bytes_;
    std::size_t next_;
    std::size_t end_;
};

enum class Token {
    number,
    end,        // no token is left
    not_number, // the token is not a number
    not_finite  // inf, nan, or of a magnitude above greatest_amount
};

// Reads the whole of `text` as a decimal number with an optional sign; no blanks, no hexadecimal. Never returns `end`.
// Exact: the nearest double. A magnitude above greatest_amount is refused (not_finite). `plain` becomes false if the
// number has an exponent.
Token scan_number(std::string_view text, double& value, bool& plain);

// "'abc'": a file's text in the form that messages show, printable ASCII unchanged, other bytes in hexadecimal.
std::string quoted(std::string_view text);

// Takes what TokenKernels take of the text that begins at `first`, up to its very end. run.convert is set here.
void take_numbers(NumberRun& run, const char* first, Separators separators);

// Numbers separated by blanks, line ends and commas.
class NumberScanner {
public:
    NumberScanner(std::string_view bytes, std::size_t begin, std::size_t end)
        : first_(bytes.data()), at_(bytes.data() + begin), end_(bytes.data() + end), token_(at_) {}

    // The next number. If the result is not `number`, `value` is unchanged.
    Token next(double& value) {
        skip_separators();
        token_ = at_;
        if (at_ == end_) return Token::end;
        const char* const behind = read_decimal(at_, end_, value);
        if (behind == nullptr) return next_slow(value);
        at_ = behind;
        return Token::number;
    }

    // Reads numbers into `numbers` as long as they can be read quickly; returns how many were read. next() reads the
    // one at which it stopped. `lowest` and `highest` are widened to include the numbers read; token_offset() and
    // token_begins_line() are those of the last of them.
    std::size_t next_quickly(std::span<double> numbers, double& lowest, double& highest);

    // Skips separators; returns whether nothing else is left.
    bool at_end() {
        skip_separators();
        token_ = at_;
        return at_ == end_;
    }

    [[nodiscard]] std::size_t token_offset() const { return static_cast<std::size_t>(token_ - first_); }
    [[nodiscard]] std::string_view token() const; // the text of the last token read, shortened to fit into a message
    [[nodiscard]] bool token_begins_line() const;
    [[nodiscard]] std::size_t exponent_offset() const {
        return exponent_;
    } // of the first number with an exponent, or −1
    [[nodiscard]] std::size_t remaining_bytes() const { return static_cast<std::size_t>(end_ - at_); }

private:
    void skip_separators() {
        while (at_ != end_ && ends_number(*at_))
            ++at_;
    }

    Token next_slow(double& value);

    const char* first_;
    const char* at_;
    const char* end_;
    const char* token_;
    std::size_t exponent_ = static_cast<std::size_t>(-1);
};

} // namespace gonio::profile_detail
