// The luminous intensity of a TM-33 document in the form of LM-63, which all code that uses the light supports.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/profile/profile.hpp>

#include <optional>

namespace gonio {

// The goniometer's geometry, C if none is named. Nothing for CIE's type A, which differs from LM-63's, and for CUSTOM.
std::optional<Photometry> photometry_of(const Tm33File& file);

// Angles, candela, factors, tilt, lumens, watts and luminous opening as in LM-63-2019; no keywords. The emitters emit
// together: tables on the same angles are added, each with its multiplier and ballast factor. Quantity does not scale
// the intensity, just as the number of lamps does not in LM-63. Fails (unsupported) if no emitter has a luminous
// intensity, if their angles or tilt factors differ, or if photometry_of returns nothing.
Result<IesFile> lm63_of(const Tm33File& file);

// Lumens of the lamps as the document declares them; nothing for absolute photometry. If the document does not state
// which applies, photometry is relative if it gives rated lumens.
std::optional<double> declared_flux_lm(const Tm33File& file);

} // namespace gonio
