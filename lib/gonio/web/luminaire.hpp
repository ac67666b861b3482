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

// Every intensity and the lamps' flux multiplied by `factor`, so that the light output ratio stays the same; the input
// watts do not change. Fails as scaled_by() does.
Result<Luminaire> dimmed(const Luminaire& luminaire, double factor);

// The same linear luminaire `factor` times as long: intensities, lamps' flux and input watts grow in proportion, and so
// do the lengths of the housing and of the luminous opening. Fails as scaled_by() does, and (usage) if the opening has
// no length (a disk, a sphere, a point).
Result<Luminaire> stretched(const Luminaire& luminaire, double factor);

// Scaled to the flux, with the lamps' flux in proportion. Fails as scaled_to() does.
Result<Luminaire> scaled_to(const Luminaire& luminaire, Lumens flux);

// Σ weightᵢ · luminaireᵢ by combined(): the lamps' flux and the watts are added in the same way; texts and opening are
// those of the first. Absolute if any of them is absolute.
struct CombinedLuminaire {
    Luminaire luminaire;
    double max_error_cd = 0.0;
};

Result<CombinedLuminaire> combined(std::span<const Luminaire> luminaires, std::span<const double> weights);

} // namespace gonio
