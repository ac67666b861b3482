// Dither: a fixed pattern, so that rounding to few bits leaves neither bands nor a change of the mean.
#pragma once

#include <gonio/base/image.hpp>

#include <vector>

namespace gonio::media {

// The values plus a number in [−½, ½) of a step, which depends on the pixel's place alone: 1/255 for `greatest` = 255.
// A value that is a whole number of steps, rounded afterwards, stays what it was. The pattern is an additive recurrence
// in two dimensions (M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018), the same for all
// channels, so that grey stays grey.
std::vector<float> dithered(const Image& image, int greatest);

} // namespace gonio::media
