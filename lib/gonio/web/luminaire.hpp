// A web with its header, and changes to both.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/web.hpp>

#include <span>

namespace gonio {

struct Luminaire {
    Web web;
    ProfileHeader header;
};

// Every intensity and the lamps' flux times `factor`, so that the light output ratio stays; the input watts stay.
// Fails as scaled_by() does.
Result<Luminaire> dimmed(const Luminaire& luminaire, double factor);

// The same linear luminaire `factor` times as long: intensities, lamps' flux and input watts grow with it, and so do
// the lengths of the housing and of the luminous opening. Fails as scaled_by() does, and (usage) where the
// opening has no length (a disk, a sphere, a point).
Result<Luminaire> stretched(const Luminaire& luminaire, double factor);

// Scaled to the flux, the lamps' flux with it. Fails as scaled_to() does.
Result<Luminaire> scaled_to(const Luminaire& luminaire, Lumens flux);

// Σ weightᵢ · luminaireᵢ by combined(): flux of the lamps and watts are added alike, texts and opening are the first's.
// Absolute where any of them is.
struct CombinedLuminaire {
    Luminaire luminaire;
    double max_error_cd = 0.0;
};

Result<CombinedLuminaire> combined(std::span<const Luminaire> luminaires, std::span<const double> weights);

} // namespace gonio
