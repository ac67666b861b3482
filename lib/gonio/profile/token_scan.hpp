// Converts a number whose begin and end are known: those that TokenKernels leave. Internal.
#pragma once

#include <gonio/profile/fast_number.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace gonio::profile_detail {

// Converts the token of 16 to 20 characters from `p` to `end`, as the shortest texts of doubles have them: without the
// loop of read_long_decimal, because the length is known. False as convert_magnitude, also for more than 19 digits.
inline bool convert_three_words(const char* p, const char* end, double& value) {
    const auto length = static_cast<unsigned>(end - p);
    // Bytes before the token are cleared.
    std::uint64_t high = length == 16 ? 0 : digits_at(end - 24) & (~std::uint64_t{0} << (192U - 8U * length));
    std::uint64_t middle = digits_at(end - 16);
    std::uint64_t low = digits_at(end - 8);
    constexpr std::uint64_t mark = 0x1010101010101010U; // set in what is not a digit; the bit 1 of those in the point
    const std::uint64_t high_point = high & mark;
    const std::uint64_t middle_point = middle & mark;
    const std::uint64_t low_point = low & mark;
    // The sum of all bytes; most machines that this is built for have no instruction that counts bits.
    const std::uint64_t points = ((high_point + middle_point + low_point) >> 4U) * 0x0101010101010101U >> 56U;
    if (points > 1 || length > 19 + points) return false;
    if (((high & high_point >> 4U) | (middle & middle_point >> 4U) | (low & low_point >> 4U)) != 0) return false;
    int decimals = 0;
    // The digits before the point move up by one byte, over the point.
    const auto close = [&](std::uint64_t& word, std::uint64_t point, std::uint64_t across, int behind) {
        const std::uint64_t before = (point >> 4U) - 1;
        decimals = behind + std::countl_zero(point) / 8;
        word = (word & ~(before | (point >> 4U) * 0xFF)) | (word & before) << 8U | across;
    };
    if (low_point != 0) {
        close(low, low_point, middle >> 56U, 0);
        middle = middle << 8U | high >> 56U;
        high <<= 8U;
    } else if (middle_point != 0) {
        close(middle, middle_point, high >> 56U, 8);
        high <<= 8U;
    } else if (high_point != 0) {
        close(high, high_point, 0, 16);
    }
    constexpr std::uint64_t eight_digits = 100000000;
    const std::uint64_t w =
        (number_of_digits(high) * eight_digits + number_of_digits(middle)) * eight_digits + number_of_digits(low);
    constexpr std::uint64_t exact = std::uint64_t{1} << 53U;
    value = w < exact ? static_cast<double>(w) / decimal_powers<>[static_cast<std::size_t>(decimals)]
                      : divide_exactly(w, decimals);
    return true;
}

// Converts the token from `p` to `end`, which has no sign and consists of the bytes -./0123456789 only. At least
// eight bytes of text must lie before `p`, and decimal_lookahead bytes after `end`. False, with `value` unchanged, if
// the token needs another method, or is not a number.
inline bool convert_magnitude(const char* p, const char* end, double& value) {
    if constexpr (std::endian::native != std::endian::little) return false;
    const auto length = static_cast<std::size_t>(end - p);
    if (length > 8) [[unlikely]]
        return (length >= 16 && length <= 20 && convert_three_words(p, end, value)) ||
               read_long_decimal(p, value) == end;
    // The word that ends with the token; bytes before the token are cleared.
    const std::uint64_t token = digits_at(end - 8) & (~std::uint64_t{0} << (64U - 8U * static_cast<unsigned>(length)));
    // Digits are 0 to 9 now, '.' is 0x1E, '-' 0x1D and '/' 0x1F: the bit 0x10 distinguishes them from digits, the bit 1
    // the point from the other two. One point is allowed, and none of the others.
    const std::uint64_t point = token & 0x1010101010101010U;
    if (((point & (point - 1)) | (token & (point >> 4U))) != 0) return false;
    static constexpr std::array<double, 9> powers{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e0}; // the last: no point
    std::uint64_t digits = token;
    double power = 1.0;
    if (point != 0) {
        if (length == 1) return false;
        // The digits before the point move up by one byte, over the point.
        const std::uint64_t before = (point >> 4U) - 1;
        digits = (token & ~(before | (point >> 4U) * 0xFF)) | (token & before) << 8U;
        power = powers[static_cast<std::size_t>(std::countl_zero(point)) / 8];
    }
    value = static_cast<double>(static_cast<std::int64_t>(number_of_digits(digits))) / power;
    return true;
}

// As convert_magnitude, for a token that may have a minus.
inline bool convert_token(const char* p, const char* end, double& value) {
    if (*p != '-') [[likely]]
        return convert_magnitude(p, end, value);
    double magnitude = 0.0;
    if (p + 1 == end || !convert_magnitude(p + 1, end, magnitude)) return false;
    value = -magnitude;
    return true;
}

} // namespace gonio::profile_detail
