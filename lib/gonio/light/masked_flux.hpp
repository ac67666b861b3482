// Flux of a shape behind a mask: ∬ lobe · mask dω, which has no closed form.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/light/shape.hpp>
#include <gonio/web/web.hpp>

namespace gonio {

// Φ/I of a shape of intensity I along its direction (before the mask) behind `mask` over its peak, which must be
// greater than 0; 0 for profiles and the sun. The mask is the web's interpolant in the usual frame: γ = 0 along the
// axis, C0 along X.
//
// For a point this is the exact flux of the web. A spot does not depend on C: the C-integral of the web is linear in γ
// between its angles, and each piece between those and the edges of the lobe is integrated by Gauss–Legendre rules of
// 16 nodes (in closed form where the lobe is uniform). A frustum is integrated exactly in γ up to its face and by
// Gauss–Legendre rules in C between all azimuths at which its outline turns or crosses the grid, halved until they
// agree. Relative error below 1e-11 for a web without negative values; no randomness, no threads. Cost: 10 µs to 10 ms.
// Masks of types A and B are integrated ring by ring (gonio/web/rings.hpp) to 1e-6, in some 10 ms. A sphere is treated
// as a point. A disk, rectangle or tube is weighted by its projected area and integrated by Gauss–Legendre rules on
// cells of one degree (and between the angles γ of a web of type C): 1e-10 where planes lie on whole degrees, else
// 1e-5, in some 20 ms.
Steradians masked_solid_angle(const Shape& shape, const Web& mask);

} // namespace gonio
