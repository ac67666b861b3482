// Where two webs differ most. Internal to the library.
#pragma once

#include <gonio/web/compare.hpp>

namespace gonio::web_detail {

// difference() of every direction, without the mean square, which takes most of the time: rms is 0.
WebDifference greatest_difference(const Web& a, const Web& b);

} // namespace gonio::web_detail
