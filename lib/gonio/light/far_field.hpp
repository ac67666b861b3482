// Where the far field of a luminaire begins: from which distance on it may count as a point.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/light/luminous_body.hpp>
#include <gonio/web/web.hpp>

#pragma GCC visibility push(default)
namespace gonio {

// The distance from the middle of the body from which on receivers that face it get what a point with the web's
// intensities gives them, within `tolerance` (relative, > 0) and for 95 % of the light. Between one and 64 times the
// largest size, to 5 % of the distance; the web is that of LuminousBody::of(). Sums over points of the faces, by
// Gauss-Legendre: some 0.1 ms on average.
Meters point_distance(const LuminousBody& body, const Web& web, double tolerance);

} // namespace gonio
#pragma GCC visibility pop
