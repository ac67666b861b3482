// The luminous intensity of a TM-33 document in the form of LM-63, which all code that uses the light understands.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/profile/profile.hpp>

#include <optional>

namespace gonio {

// The goniometer's geometry, C where none is named. Nothing for CIE's type A, which is not LM-63's, and for CUSTOM.
std::optional<Photometry> photometry_of(const Tm33File& file);

// Angles, candela, factors, tilt, lumens, watts and luminous opening as LM-63-2019 has them; no keywords. The emitters
// shine together: tables on the same angles are added, each with its multiplier and ballast factor. Quantity does not
// scale, as the number of lamps does not in LM-63. Fails (unsupported) where no emitter has a luminous intensity, where
// their angles or tilt factors differ, and where photometry_of has nothing.
Result<IesFile> lm63_of(const Tm33File& file);

// Lumens of the lamps as the document declares them; nothing for absolute photometry.
// If the document does not say, photometry is relative when lumens are rated.
std::optional<double> declared_flux_lm(const Tm33File& file);

} // namespace gonio
