// Illuminance that an area shape gives a receiver which faces it, in closed form: what "lx@2m" means.
//
// The receiver lies on the shape's direction at distance d from its centre and its normal points back at the centre; a
// tube shines from the side. Values are E/L, illuminance over luminance, in [0, π]. No form here cancels.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/light/shape.hpp>

namespace gonio {

// π r²/d², for d ≥ r: the inverse square is exact for a sphere.
double facing_illuminance(const SphereShape& sphere, Meters distance);

// π r²/(d² + r²), for d ≥ 0.
double facing_illuminance(const DiskShape& disk, Meters distance);

// 2 [A/√(1+A²) atan(B/√(1+A²)) + B/√(1+B²) atan(A/√(1+B²))] with A = w/2d, B = h/2d, for d > 0: four times the corner
// of the parallel plane (J. R. Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3).
double facing_illuminance(const RectShape& rect, Meters distance);

// The outline of a capsule, two great arcs and two caps, for d ≥ r; with s = r/d, κ = √(1−s²), z = l/2, D² = d² + z²,
// h = atan2(Dκ, sz): 2s atan(z/(dκ)) + 2(r²d/D³) h + 2(rz/D³) √(D²−r²) sin h.
double facing_illuminance(const TubeShape& tube, Meters distance);

} // namespace gonio
