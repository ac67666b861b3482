// The places of fields in the text of a Profile, for diagnostics that need its light.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#pragma GCC visibility push(default)
namespace gonio {

// Fields that rules about the light may refer to.
enum class ProfileField : std::uint8_t {
    lamp_flux,         // LM-63: lumens per lamp; of the first lamp set of EULUMDAT, of the first emitter of TM-33
    input_watts,       // also of the first
    color_temperature, // also of the first; LM-63: the keyword [_CCT]
    color_rendering,   // also of the first; LM-63: the keyword [_CRI]
    multiplier,        // LM-63: of the candela; EULUMDAT: the conversion factor; of the first emitter of TM-33
    ballast_factor,    // LM-63
    field_12,          // LM-63
    opening,           // LM-63, EULUMDAT: the luminous opening's first size
    downward_flux,     // EULUMDAT, as are the next two
    light_output_ratio,
    direct_ratios, // the first of them
    first_horizontal,
    last_horizontal,
    first_vertical,
    last_vertical,
    intensity,         // the table
    negative_intensity // the first negative value; LM-63, EULUMDAT
};

// How many fields there are.
inline constexpr std::size_t profile_field_count = 17;

// Line and column from 1; 0: not known, or missing.
struct FieldPlace {
    std::uint32_t line = 0;
    std::uint32_t column = 0;
};

// The place in the file of each field that a message may point to.
class FieldPlaces {
public:
    FieldPlace& operator[](ProfileField field) { return places_[static_cast<std::size_t>(field)]; }
    const FieldPlace& operator[](ProfileField field) const { return places_[static_cast<std::size_t>(field)]; }

private:
    std::array<FieldPlace, profile_field_count> places_{};
};

} // namespace gonio
#pragma GCC visibility pop
