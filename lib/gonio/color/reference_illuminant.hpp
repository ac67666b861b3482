// The reference illuminants of colour rendering: what a light of the same colour temperature is compared with.
#pragma once

#include <gonio/base/quantity.hpp>

#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// Kinds of reference illuminants.
enum class ReferenceIlluminant {
    planckian, // a black body
    blend,     // a black body and a D illuminant of equal luminous flux, mixed linearly over 4000–5000 K
    daylight   // a D illuminant
};
// "black body", "black body and daylight", "daylight"
std::string_view to_text(ReferenceIlluminant kind);

// There is none beyond these: temperatures end at the first, daylight at the second.
inline constexpr Kelvin coolest_reference{500.0};
inline constexpr Kelvin hottest_reference{25000.0};

} // namespace gonio
#pragma GCC visibility pop
