// Illuminance of receivers near a rectangle with an image: the nodes of transport/, and what there is elsewhere.
//
//   nodes       ImagePattern times the closed form of a uniform light
//   mean        a uniform light of the image's mean luminance
//   samples-8   uniform Monte Carlo: eight points of the rectangle, others at each receiver, the pixel at each
#pragma once

#include <gonio/measure/method.hpp>
#include <gonio/measure/opening_cases.hpp>

namespace gonio::measure {

// In lx, of cases whose light has an image. The instruction sets of the machine for the nodes and the mean, scalar
// float for the samples.
std::vector<Method<OpeningCases>> image_methods();

} // namespace gonio::measure
