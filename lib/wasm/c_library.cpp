// What replaces functions of the C library in modules (the linker's --wrap): strtod in all, which works in 128-bit
// floating point there, and snprintf in the module of profiles, a fiftieth of which they would be. Nothing of gonio
// that is in these modules calls them, but nlohmann::json, fmt and libc++ do.
#include <gonio/base/charconv.hpp>
#include <gonio/base/nearest_double.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdarg>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <system_error>

// NOLINTBEGIN(bugprone-reserved-identifier,cert-*,cppcoreguidelines-pro-type-const-cast,cppcoreguidelines-pro-type-vararg):
// names of the linker, types of C.

// A decimal as JSON has it: without blanks or a plus sign in front.
extern "C" double __wrap_strtod(const char* text, char** end) {
    double value = 0.0;
    const auto [stop, error] = gonio::portable_from_chars(text, text + std::strlen(text), value);
    if (end != nullptr) *end = const_cast<char*>(stop);
    if (error == std::errc::result_out_of_range) // infinity, or next to 0, as in C
        return gonio::nearest_double({text, static_cast<std::size_t>(stop - text)});
    return value;
}

// With %d, %04x and %.4X, of any width: the number of an unknown error, an escape in JSON, a character that JSON does
// not allow. Others are not expected.
extern "C" int __wrap_snprintf(char* to, std::size_t size, const char* format, ...) {
    std::va_list arguments;
    va_start(arguments, format);
    std::string text;
    for (; *format != '\0'; ++format) {
        if (*format != '%') {
            text += *format;
            continue;
        }
        if (format[1] == '.') ++format;
        std::size_t width = 0;
        while (*++format >= '0' && *format <= '9')
            width = 10 * width + static_cast<std::size_t>(*format - '0');
        std::array<char, 16> digits{};
        char* const first = digits.data();
        char* last = first;
        if (*format == 'd')
            last = std::to_chars(first, first + digits.size(), va_arg(arguments, int)).ptr;
        else if (*format == 'x' || *format == 'X')
            last = std::to_chars(first, first + digits.size(), va_arg(arguments, unsigned), 16).ptr;
        else
            __builtin_trap();
        if (*format == 'X')
            std::transform(first, last, first, [](char c) { return c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c; });
        const std::string_view number(first, static_cast<std::size_t>(last - first));
        if (number.size() < width) text.append(width - number.size(), '0');
        text += number;
    }
    va_end(arguments);
    if (size > 0) to[text.copy(to, size - 1)] = '\0';
    return static_cast<int>(text.size());
}
// NOLINTEND(bugprone-reserved-identifier,cert-*,cppcoreguidelines-pro-type-const-cast,cppcoreguidelines-pro-type-vararg)
