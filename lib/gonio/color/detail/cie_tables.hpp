// The numbers of data/*.csv, compiled in: fit/cie_tables.sh prints cie_tables.cpp.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace gonio::detail {

// x̄, ȳ, z̄ of the CIE 1931 2° observer at 360 nm, 361 nm, … 830 nm. ȳ is V(λ).
inline constexpr int observer_first_nm = 360;
inline constexpr int observer_last_nm = 830;
extern const std::array<std::array<double, 3>, 471> observer;

// S0, S1, S2 of the D illuminants at 300 nm, 305 nm, … 830 nm, linear between.
inline constexpr int daylight_first_nm = 300;
extern const std::array<std::array<double, 3>, 107> daylight_components;

// Relative spectral power at first_nm, first_nm + 5 nm, …
struct IlluminantTable {
    std::string_view name;
    int first_nm = 0;
    std::span<const double> power;
};
inline constexpr int illuminant_step_nm = 5;
extern const std::array<IlluminantTable, 52> illuminant_tables;

} // namespace gonio::detail
