// Numbers with units as text: "800lm", "2.5klm", "3cm", "25deg", "12ev".
//
// A unit belongs to one dimension and converts to that dimension's base unit by a factor (lm, cd, lx, cd/m², W, K,
// rad, m; the two EV dimensions are logarithmic and are their own base). The locale does not matter.
#pragma once

#include <gonio/base/result.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// What a unit measures.
enum class Dimension {
    luminous_flux,
    luminous_intensity,
    illuminance,
    luminance,
    luminance_ev,
    illuminance_ev,
    power,
    temperature,
    angle,
    length
};

// A unit that text may use: "mm", "lm", "deg".
struct Unit {
    std::string_view symbol;
    std::string_view name;
    Dimension dimension;
    double base_per_unit; // value in base units = number × base_per_unit
};

// Every unit that text may use, grouped by dimension.
std::span<const Unit> all_units();

// By its symbol, which is case-sensitive, or by its name in words ("lumens", "lux", "feet"). nullptr when there is
// none.
const Unit* find_unit(std::string_view symbol);

std::string_view dimension_name(Dimension dimension); // "luminous flux"

// A number with its unit, as written.
struct Amount {
    double number = 0.0; // as written
    const Unit* unit = nullptr;

    // Correctly rounded for decimal multiples of the base: 1.3cm is the double nearest to 0.013.
    double in_base_units() const;
};

// "800lm", "800 lm", "800 lumens". Fails (usage) on a bare number, an unknown unit, anything that is not finite.
Result<Amount> parse_amount(std::string_view text);

// As above, and the unit must be of `dimension`; returns base units. `what` names the value in the message.
Result<double> parse_amount(std::string_view text, Dimension dimension, std::string_view what);

// Text that is exactly one finite decimal number, with an optional sign; no locale, no hexadecimal.
std::optional<double> parse_number(std::string_view text);

// The shortest text that reads back as the same double: "0.1", "1e+300".
std::string shortest(double value);

// `value` with at most `digits` significant digits, without trailing zeros: for people, not for programs.
std::string rounded(double value, int digits = 6);

} // namespace gonio
#pragma GCC visibility pop
