// The numbers of data/ that the quality of light needs, compiled in: fit/quality_tables.sh prints quality_tables.cpp.
// A source of its own, so that programs which do not ask for it do not link it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gonio::detail {

// All of them cover this range, observer and action spectra in steps of 1 nm, samples in steps of 5 nm.
inline constexpr int quality_first_nm = 380;
inline constexpr int quality_last_nm = 780;
inline constexpr int sample_step_nm = 5;
inline constexpr std::size_t sample_nodes = 81;

// x̄, ȳ, z̄ of the CIE 1964 10° observer.
extern const std::array<std::array<double, 3>, 401> observer_10deg;

// S cone, M cone, L cone, rhodopic, melanopic (CIE S 026).
extern const std::array<std::array<double, 5>, 401> alpha_opic_spectra;

// Spectral radiance factors of the test colour samples 1 to 15 of CIE 13.3 and JIS Z 8726, in thousandths.
inline constexpr double rendering_sample_unit = 1e-3;
extern const std::array<std::array<std::uint16_t, 15>, sample_nodes> rendering_samples;

// The same of the 99 samples of CIE 224, in hundred-thousandths. Rounded to four decimals
// they would change Rf of a hue bin by up to 0.07.
inline constexpr double fidelity_sample_unit = 1e-5;
extern const std::array<std::array<std::uint32_t, 99>, sample_nodes> fidelity_samples;

} // namespace gonio::detail
