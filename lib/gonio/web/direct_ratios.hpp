// The direct ratios of a luminaire, as EULUMDAT states them.
#pragma once

#include <gonio/web/web.hpp>

#include <array>

namespace gonio {

// For room indices k of 0.6, 0.8, 1, 1.25, 1.5, 2, 2.5, 3, 4 and 5: the share of the downward flux that meets the
// working plane before a wall, for luminaires spread uniformly on the ceiling of a square room of side a = 2 k h. A ray
// that travels (x, y) while it falls by the height h stays between the walls if it starts in the part (1 − |x|/a)(1 −
// |y|/a) of the ceiling. All 0 for a web that is dark below the horizon. Midpoints of 2° of C and 0.25° of γ: within
// 1e-4.
std::array<double, 10> direct_ratios(const Web& web);

} // namespace gonio
