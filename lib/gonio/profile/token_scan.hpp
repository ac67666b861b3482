// Converts a number whose begin and end are known: those that TokenKernels leave. Internal.
#pragma once

#include <gonio/profile/fast_number.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace gonio::profile_detail {

// Converts the token from `p` to `end`, which has no sign and consists of the bytes -./0123456789 only. At least
// eight bytes of text must lie before `p`, and decimal_lookahead bytes after `end`. False, with `value` unchanged, if
// the token needs another method, or is not a number.
inline bool convert_magnitude(const char* p, const char* end, double& value) {
    if constexpr (std::endian::native != std::endian::little) return false;
    const auto length = static_cast<std::size_t>(end - p);
    if (length > 8) [[unlikely]]
        return read_long_decimal(p, value) == end;
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
