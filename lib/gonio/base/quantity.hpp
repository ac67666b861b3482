// Quantities are types: each is one explicit double in the unit that its name says.
//
// Photometric: Lumens [lm], Candelas [cd = lm/sr], Lux [lx = lm/m²], Nits [cd/m²]. Angles are radians inside gonio,
// degrees only at its edges. Lengths are metres. Values are not range-checked here: a quantity may be negative or
// not finite, the functions that take one say what they accept.
#pragma once

#include <cmath>
#include <compare>
#include <numbers>

namespace gonio {

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

using Lumens = Quantity<struct LumenUnit>;
using Candelas = Quantity<struct CandelaUnit>;
using Lux = Quantity<struct LuxUnit>;
using Nits = Quantity<struct NitUnit>;
using Kelvin = Quantity<struct KelvinUnit>;
using Watts = Quantity<struct WattUnit>;
using Radians = Quantity<struct RadianUnit>;
using Meters = Quantity<struct MeterUnit>;
using Steradians = Quantity<struct SteradianUnit>;

// Exposure value at ISO 100 of a luminance, and of an illuminance.
using Ev100 = Quantity<struct Ev100Unit>;
using EvLux = Quantity<struct EvLuxUnit>;

constexpr Radians degrees(double deg) {
    return Radians(deg * (std::numbers::pi / 180.0));
}
constexpr double to_degrees(Radians angle) {
    return angle.value * (180.0 / std::numbers::pi);
}

// L = 2^(EV−3): a reflected-light meter with the calibration constant K = 12.5 (ISO 2720).
inline Nits luminance(Ev100 ev) {
    return Nits(std::exp2(ev.value - 3.0));
}
// Needs L > 0; 0 gives −∞.
inline Ev100 ev100(Nits luminance) {
    return Ev100(std::log2(luminance.value) + 3.0);
}

// E = 2.5·2^EV: an incident-light meter with the calibration constant C = 250 (ISO 2720).
inline Lux illuminance(EvLux ev) {
    return Lux(2.5 * std::exp2(ev.value));
}
// Needs E > 0; 0 gives −∞.
inline EvLux ev_lux(Lux illuminance) {
    return EvLux(std::log2(illuminance.value / 2.5));
}

} // namespace gonio
