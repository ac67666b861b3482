// The alpha-opic quantities of a light that is sampled already.
#pragma once

#include <gonio/color/alpha_opic.hpp>
#include <gonio/color/detail/test_light.hpp>

namespace gonio::detail {

AlphaOpic alpha_opic_of_rays(const Rays& light);

} // namespace gonio::detail
