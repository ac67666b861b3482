// Illuminance that an area shape gives a receiver which faces it: what "lx@2m" means.
//
// The receiver lies on the shape's direction at distance d from its centre and its normal points back at the centre; a
// tube shines from the side. Values are E/L, illuminance over luminance, in [0, π]: gonio/light/closed_forms.hpp.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/light/shape.hpp>

namespace gonio {

double facing_illuminance(const SphereShape& sphere, Meters distance); // d ≥ r
double facing_illuminance(const DiskShape& disk, Meters distance);     // d ≥ 0
double facing_illuminance(const RectShape& rect, Meters distance);     // d > 0
double facing_illuminance(const TubeShape& tube, Meters distance);     // d ≥ r

} // namespace gonio
