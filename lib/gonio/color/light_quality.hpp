// The quality of light: all figures of a spectrum at once, with what is to be said about them.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/color/alpha_opic.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/color/color_fidelity.hpp>
#include <gonio/color/color_rendering.hpp>
#include <gonio/color/spectrum.hpp>

#include <optional>

#pragma GCC visibility push(default)
namespace gonio {

// What a spectrum does for colours and for the eye.
struct LightQuality {
    // None of these three if the light has no reference illuminant.
    std::optional<Cct> cct; // of the light and of its reference illuminants
    std::optional<ColorRendering> rendering;
    std::optional<ColorFidelity> fidelity;
    AlphaOpic alpha_opic;
    Diagnostics diagnostics;
};

// Warns of a light without a reference illuminant, of one too far from it for CIE 13.3, and of spectra that standards
// do not accept: in steps above 5 nm, or short of 380–780 nm. Fails (usage) on a spectrum without visible light. Some
// 60 µs at 5 nm, 120 µs at 1 nm (MEASURED.md).
Result<LightQuality> light_quality(const Spectrum& spectrum);

} // namespace gonio
#pragma GCC visibility pop
