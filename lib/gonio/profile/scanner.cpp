#include <gonio/base/amount_range.hpp>
#include <gonio/base/charconv.hpp>
#include <gonio/base/text.hpp>
#include <gonio/profile/scanner.hpp>
#include <gonio/profile/token_scan.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <system_error>

namespace gonio::profile_detail {

namespace {

constexpr bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

// from_chars reports overflow and underflow alike. The position of the first digit that is not zero, plus the exponent,
// distinguishes the two. `text` is a well-formed number.
bool is_underflow(std::string_view text) {
    const std::size_t e = text.find_first_of("eE");
    const std::string_view mantissa = text.substr(0, e);
    const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
    const std::size_t first = mantissa.find_first_of("123456789");
    if (first == std::string_view::npos) return true;
    const auto place = static_cast<long long>(point) - static_cast<long long>(first);
    long long exponent = 0;
    if (e != std::string_view::npos) {
        std::string_view digits = text.substr(e + 1);
        if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
        if (read.ec == std::errc::result_out_of_range) return !digits.empty() && digits.front() == '-';
    }
    return exponent < -place;
}

} // namespace

std::string_view trim_left(std::string_view text) {
    while (!text.empty() && is_blank(text.front()))
        text.remove_prefix(1);
    return text;
}

std::string_view trim_right(std::string_view text) {
    while (!text.empty() && is_blank(text.back()))
        text.remove_suffix(1);
    return text;
}

std::string_view trim(std::string_view text) {
    return trim_right(trim_left(text));
}

Line LineScanner::next() {
    const std::size_t begin = std::min(next_, end_);
    std::size_t at = begin;
    // Eight bytes at a time: x − 0x01… sets a byte's high bit where x has a zero byte and possibly in bytes above it;
    // the exact place is found below.
    const auto has_zero = [](std::uint64_t x) { return (x - 0x0101010101010101U) & ~x & 0x8080808080808080U; };
    while (at + 8 <= end_) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes_.data() + at, sizeof word);
        if ((has_zero(word ^ 0x0A0A0A0A0A0A0A0AU) | has_zero(word ^ 0x0D0D0D0D0D0D0D0DU)) != 0) break;
        at += 8;
    }
    while (at < end_ && bytes_[at] != '\n' && bytes_[at] != '\r')
        ++at;
    next_ = at;
    if (at < end_) ++next_;
    if (next_ < end_ && bytes_[at] == '\r' && bytes_[next_] == '\n') ++next_;
    return {bytes_.substr(begin, at - begin), begin};
}

Token scan_number(std::string_view text, double& value, bool& plain) {
    std::string_view rest = text;
    if (!rest.empty() && rest.front() == '+') {
        rest.remove_prefix(1);
        if (!rest.empty() && rest.front() == '-') return Token::not_number;
    }
    std::string_view magnitude = rest;
    if (!magnitude.empty() && magnitude.front() == '-') magnitude.remove_prefix(1);
    // from_chars also accepts "inf" and "nan", and "infinity"; a number begins with a digit or a point.
    if (magnitude.empty() || !(is_digit(magnitude.front()) || magnitude.front() == '.')) {
        for (const std::string_view word : {"INF", "NAN", "INFINITY"})
            if (equals_any_case(magnitude, word)) return Token::not_finite;
        return Token::not_number;
    }
    double read = 0.0;
    const auto [end, error] = from_chars(rest.data(), rest.data() + rest.size(), read);
    if (error == std::errc::invalid_argument || end != rest.data() + rest.size()) return Token::not_number;
    if (error == std::errc::result_out_of_range) {
        if (!is_underflow(magnitude)) return Token::not_finite;
        read = rest.front() == '-' ? -0.0 : 0.0;
    }
    if (!in_amount_range(read)) return Token::not_finite;
    if (rest.find_first_of("eE") != std::string_view::npos) plain = false;
    value = read;
    return Token::number;
}

std::string quoted(std::string_view text) {
    std::string result = "'";
    for (const char c : text)
        if (c >= ' ' && c <= '~')
            result += c;
        else
            result += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    return result + "'";
}

Token NumberScanner::next_slow(double& value) {
    const char* p = at_;
    while (p != end_ && !ends_number(*p))
        ++p;
    bool plain = true;
    const Token token = scan_number({at_, static_cast<std::size_t>(p - at_)}, value, plain);
    if (token == Token::number) at_ = p;
    if (!plain && exponent_ == static_cast<std::size_t>(-1)) exponent_ = token_offset();
    return token;
}

void take_numbers(NumberRun& run, const char* first, Separators separators) {
    constexpr std::ptrdiff_t before = 8;
    const TokenKernels* const kernels = token_kernels_in_use();
    if (kernels == nullptr || run.at - first < before || run.wanted == 0) return;
    run.convert = convert_token;
    kernels->read(run, separators);
    // The kernels leave the last bytes of a text: those are read from a copy that separators follow.
    constexpr std::ptrdiff_t longest = 160;
    const std::ptrdiff_t rest = run.end - run.at;
    if (run.taken == run.wanted || rest < 2 || rest > longest) return;
    std::array<char, before + longest + 64 + 64 + decimal_lookahead> copy;
    copy.fill(separators == Separators::lines ? '\n' : ' ');
    std::memcpy(copy.data() + before, run.at, static_cast<std::size_t>(rest));
    const char* const at = run.at;
    const char* const end = run.end;
    const std::size_t taken = run.taken;
    run.at = copy.data() + before;
    run.end = copy.data() + copy.size();
    kernels->read(run, separators);
    const auto place = [&](const char* p) { return at + (p - (copy.data() + before)); };
    run.at = std::min(place(run.at), end);
    run.end = end;
    if (run.taken != taken) run.last = place(run.last);
}

std::size_t NumberScanner::next_quickly(std::span<double> numbers, double& lowest, double& highest) {
    NumberRun run;
    run.at = at_;
    run.end = end_;
    run.numbers = numbers.data();
    run.wanted = numbers.size();
    run.lowest = lowest;
    run.highest = highest;
    take_numbers(run, first_, Separators::any);
    if (run.taken == 0) return 0;
    at_ = run.at;
    token_ = run.last;
    lowest = run.lowest;
    highest = run.highest;
    return run.taken;
}

std::string_view NumberScanner::token() const {
    constexpr std::ptrdiff_t longest = 40;
    const char* p = token_;
    while (p != end_ && !ends_number(*p) && p - token_ < longest)
        ++p;
    return {token_, static_cast<std::size_t>(p - token_)};
}

bool NumberScanner::token_begins_line() const {
    const char* p = token_;
    while (p != first_ && is_blank(p[-1]))
        --p;
    return p == first_ || p[-1] == '\n' || p[-1] == '\r';
}

} // namespace gonio::profile_detail
