// Alpha-opic quantities of CIE S 026:2018: how much light stimulates each kind of receptor of the eye.
//
// The efficacy of luminous radiation is ∑S s / (683 ∑S V), in milliwatts per lumen, with the action spectrum s of the
// receptor. Over that of D65 it is the daylight (D65) efficacy ratio, DER. The equivalent daylight (D65) illuminance,
// EDI, is the illuminance times the DER.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/color/spectrum.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// Receptors of the eye, in the order of CIE S 026.
enum class Receptor { s_cone, m_cone, l_cone, rhodopic, melanopic };
inline constexpr std::size_t receptor_count = 5;

// A receptor by its name in reports.
struct ReceptorName {
    std::string_view name; // "s_cone"
    std::string_view says; // "S cone"
    Receptor receptor;
    double d65_mw_per_lm = 0.0; // efficacy of D65, as CIE S 026 prints it
};
// All of them, in the order of the enumeration.
std::span<const ReceptorName> receptor_names();

// Of each receptor, in the order of the enumeration.
struct AlphaOpic {
    std::array<double, receptor_count> efficacy_mw_per_lm{};
    std::array<double, receptor_count> der{};

    double melanopic_der() const { return der[static_cast<std::size_t>(Receptor::melanopic)]; }
};

// Over 380–780 nm. Fails (usage) on a spectrum without visible light. Some 6 µs at 1 nm.
Result<AlphaOpic> alpha_opic(const Spectrum& spectrum);

} // namespace gonio
#pragma GCC visibility pop
