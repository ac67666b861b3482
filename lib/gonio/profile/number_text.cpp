#include <gonio/base/charconv.hpp>
#include <gonio/profile/number_text.hpp>

#include <array>
#include <charconv>
#include <cmath>

namespace gonio::profile_detail {

void append_number(std::string& text, double value) {
    const double magnitude = std::abs(value);
    const bool plain = magnitude == 0.0 || (magnitude >= 1e-30 && magnitude < 1e15);
    std::array<char, 64> buffer{}; // the longest: a sign, "0.", 29 zeros and 17 digits
    const auto [end, error] = to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                       plain ? std::chars_format::fixed : std::chars_format::scientific);
    text.append(buffer.data(), end);
}

} // namespace gonio::profile_detail
