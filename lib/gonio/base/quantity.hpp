// Quantities are types: each is one explicit double in the unit that it is named for.
//
// Photometric: Lumens [lm], Candelas [cd = lm/sr], Lux [lx = lm/m²], Nits [cd/m²]. Angles are radians inside gonio,
// degrees only at its edges. Lengths are metres. Values are not range-checked here: a quantity may be negative or not
// finite; functions that take one state what they accept.
#pragma once

#include <gonio/base/exposure_value.hpp>

#include <compare>
#include <numbers>

#pragma GCC visibility push(default)
namespace gonio {

// A number in one unit. It adds to and compares with its own kind only.
template<class Unit>
struct Quantity {
    double value = 0.0;

    constexpr Quantity() = default;
    constexpr explicit Quantity(double v) : value(v) {}

    friend constexpr auto operator<=>(Quantity, Quantity) = default;
    friend constexpr Quantity operator+(Quantity a, Quantity b) { return Quantity(a.value + b.value); }
    friend constexpr Quantity operator-(Quantity a, Quantity b) { return Quantity(a.value - b.value); }
    friend constexpr Quantity operator-(Quantity a) { return Quantity(-a.value); }
    friend constexpr Quantity operator*(Quantity a, double s) { return Quantity(a.value * s); }
    friend constexpr Quantity operator*(double s, Quantity a) { return Quantity(a.value * s); }
    friend constexpr Quantity operator/(Quantity a, double s) { return Quantity(a.value / s); }
    friend constexpr double operator/(Quantity a, Quantity b) { return a.value / b.value; }
};

// The units: lm, cd, lx, cd/m², K, W, rad, m, sr.
using Lumens = Quantity<struct LumenUnit>;
using Candelas = Quantity<struct CandelaUnit>;
using Lux = Quantity<struct LuxUnit>;
using Nits = Quantity<struct NitUnit>;
using Kelvin = Quantity<struct KelvinUnit>;
using Watts = Quantity<struct WattUnit>;
using Radians = Quantity<struct RadianUnit>;
using Meters = Quantity<struct MeterUnit>;
using Steradians = Quantity<struct SteradianUnit>;

// Exposure value at ISO 100 of a luminance, and of an illuminance (gonio/base/exposure_value.hpp).
using Ev100 = Quantity<struct Ev100Unit>;
using EvLux = Quantity<struct EvLuxUnit>;

// An angle in degrees as a quantity, and back.
constexpr Radians degrees(double deg) {
    return Radians(deg * (std::numbers::pi / 180.0));
}
constexpr double to_degrees(Radians angle) {
    return angle.value * (180.0 / std::numbers::pi);
}

// The luminance or illuminance of an exposure value, and back.
inline Nits luminance(Ev100 ev) {
    return Nits(luminance_of_ev(ev.value));
}
// Needs L > 0; 0 gives −∞.
inline Ev100 ev100(Nits luminance) {
    return Ev100(ev_of_luminance(luminance.value));
}
inline Lux illuminance(EvLux ev) {
    return Lux(illuminance_of_ev(ev.value));
}
// Needs E > 0; 0 gives −∞.
inline EvLux ev_lux(Lux illuminance) {
    return EvLux(ev_of_illuminance(illuminance.value));
}

} // namespace gonio
#pragma GCC visibility pop
