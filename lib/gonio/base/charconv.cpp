#include <gonio/base/charconv.hpp>
#include <gonio/base/nearest_double.hpp>

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <string>
#include <string_view>

namespace gonio {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

const char* skip_digits(const char* p, const char* last) {
    while (p != last && is_digit(*p))
        ++p;
    return p;
}

// Behind `word`, in lower case, if the text begins with it in any case; nullptr otherwise.
const char* skip_word(const char* p, const char* last, std::string_view word) {
    for (const char c : word) {
        if (p == last || (*p | 0x20) != c) return nullptr;
        ++p;
    }
    return p;
}

// Behind the decimal at `first`, or nullptr if there is none. `digits` is whether one of its digits is not 0.
const char* skip_decimal(const char* first, const char* last, bool& digits) {
    const char* p = skip_digits(first, last);
    std::ptrdiff_t count = p - first;
    const char* end = p;
    if (p != last && *p == '.') {
        end = skip_digits(p + 1, last);
        count += end - (p + 1);
    }
    if (count == 0) return nullptr;
    digits = std::string_view(first, static_cast<std::size_t>(end - first)).find_first_of("123456789") !=
             std::string_view::npos;
    if (end != last && (*end | 0x20) == 'e') {
        p = end + 1;
        if (p != last && (*p == '+' || *p == '-')) ++p;
        const char* const exponent_end = skip_digits(p, last);
        if (exponent_end != p) end = exponent_end;
    }
    return end;
}

// "inf", "infinity", "nan", "nan(abc_1)", without the sign; nullptr for anything else.
const char* skip_not_finite(const char* first, const char* last, double& value) {
    if (const char* end = skip_word(first, last, "inf"); end != nullptr) {
        value = HUGE_VAL;
        const char* const longer = skip_word(end, last, "inity");
        return longer != nullptr ? longer : end;
    }
    const char* const end = skip_word(first, last, "nan");
    if (end == nullptr) return nullptr;
    value = std::nan("");
    if (end == last || *end != '(') return end;
    const char* p = end + 1;
    while (p != last && (is_digit(*p) || *p == '_' || ((*p | 0x20) >= 'a' && (*p | 0x20) <= 'z')))
        ++p;
    return p != last && *p == ')' ? p + 1 : end;
}

std::to_chars_result put(char* first, char* last, std::string_view text) {
    if (last - first < static_cast<std::ptrdiff_t>(text.size())) return {last, std::errc::value_too_large};
    std::memcpy(first, text.data(), text.size());
    return {first + text.size(), std::errc()};
}

// The shortest decimal that reads as `value`, finite and above 0: its digits and the power of ten of the first.
struct Digits {
    std::string digits;
    int exponent = 0;
};

Digits shortest_digits(double value) {
    const std::string text = fmt::format("{}", value);
    const std::size_t e = text.find('e');
    const std::string_view mantissa = std::string_view(text).substr(0, e);
    const auto point = static_cast<int>(std::min(mantissa.find('.'), mantissa.size()));
    Digits shortest;
    for (const char c : mantissa)
        if (c != '.') shortest.digits += c;
    const std::size_t zeros = shortest.digits.find_first_not_of('0');
    shortest.digits.erase(0, zeros);
    shortest.digits.erase(shortest.digits.find_last_not_of('0') + 1);
    shortest.exponent = point - 1 - static_cast<int>(zeros);
    if (e != std::string::npos) shortest.exponent += std::atoi(text.c_str() + e + 1);
    return shortest;
}

std::string fixed(const Digits& shortest) {
    const auto count = static_cast<int>(shortest.digits.size());
    const auto zeros = [](int n) { return std::string(static_cast<std::size_t>(n), '0'); };
    if (shortest.exponent < 0) return "0." + zeros(-shortest.exponent - 1) + shortest.digits;
    if (shortest.exponent >= count - 1) return shortest.digits + zeros(shortest.exponent - (count - 1));
    std::string text = shortest.digits;
    return text.insert(static_cast<std::size_t>(shortest.exponent) + 1, 1, '.');
}

std::string scientific(const Digits& shortest) {
    std::string text = shortest.digits;
    if (text.size() > 1) text.insert(1, 1, '.');
    return text + fmt::format("e{}{:02}", shortest.exponent < 0 ? '-' : '+', std::abs(shortest.exponent));
}

} // namespace

std::from_chars_result portable_from_chars(const char* first, const char* last, double& value) {
    const char* const begin = first != last && *first == '-' ? first + 1 : first;
    double special = 0.0;
    if (const char* const end = skip_not_finite(begin, last, special); end != nullptr) {
        value = begin != first ? -special : special;
        return {end, std::errc()};
    }
    bool nonzero = false;
    const char* const end = skip_decimal(begin, last, nonzero);
    if (end == nullptr) return {first, std::errc::invalid_argument};
    const double read = nearest_double({first, static_cast<std::size_t>(end - first)});
    if (std::isinf(read) || (nonzero && read == 0.0)) return {end, std::errc::result_out_of_range};
    value = read;
    return {end, std::errc()};
}

std::to_chars_result portable_to_chars(char* first, char* last, double value, std::chars_format format) {
    std::string text = std::signbit(value) ? "-" : "";
    const double magnitude = std::abs(value);
    if (!std::isfinite(magnitude))
        text += std::isnan(magnitude) ? "nan" : "inf";
    else if (magnitude == 0.0)
        text += format == std::chars_format::scientific ? "0e+00" : "0";
    else if (format == std::chars_format::scientific)
        text += scientific(shortest_digits(magnitude));
    else if (magnitude < 0x1p53)
        text += fixed(shortest_digits(magnitude));
    else // a whole number, with all its digits
        fmt::format_to(std::back_inserter(text), "{:.0f}", magnitude);
    return put(first, last, text);
}

std::to_chars_result portable_to_chars(char* first, char* last, double value, std::chars_format format, int precision) {
    if (!std::isfinite(value)) return portable_to_chars(first, last, value, format);
    return put(first, last,
               format == std::chars_format::scientific ? fmt::format("{:.{}e}", value, precision)
                                                       : fmt::format("{:.{}f}", value, precision));
}

std::optional<double> leading_number(std::string_view text) {
    while (text.starts_with(' '))
        text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() ? std::optional(value) : std::nullopt;
}

} // namespace gonio
