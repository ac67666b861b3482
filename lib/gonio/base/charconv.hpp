// from_chars and to_chars of double, where the standard library has them, and otherwise (libc++ before 20 and 14) the
// same by other means: the same text is accepted, the same text is written. Independent of the locale. Internal.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace gonio {

// What std::from_chars and std::to_chars do, by nearest_double and fmt. Here on every machine, so that tests can
// compare the two.
std::from_chars_result portable_from_chars(const char* first, const char* last, double& value);
std::to_chars_result portable_to_chars(char* first, char* last, double value, std::chars_format format);
std::to_chars_result portable_to_chars(char* first, char* last, double value, std::chars_format format, int precision);

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 200000
inline std::from_chars_result from_chars(const char* first, const char* last, double& value) {
    return portable_from_chars(first, last, value);
}
#else
using std::from_chars;
#endif

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000
inline std::to_chars_result to_chars(char* first, char* last, double value, std::chars_format format) {
    return portable_to_chars(first, last, value, format);
}
inline std::to_chars_result to_chars(char* first, char* last, double value, std::chars_format format, int precision) {
    return portable_to_chars(first, last, value, format, precision);
}
#else
using std::to_chars;
#endif

// The number at the start of a text, after blanks; empty for "nw".
std::optional<double> leading_number(std::string_view text);

} // namespace gonio
