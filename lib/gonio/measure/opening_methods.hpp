// Illuminance of receivers near a luminous opening: the columns of transport/, and what there is elsewhere.
//
//   columns     LuminancePattern times the closed form of a uniform light
//   point       the intensity towards the receiver over the square of the distance
//   samples-8   uniform Monte Carlo: eight points of the opening, others at each receiver
//   cubature    C. Luksch, L. Prost and M. Wimmer, "Real-time approximation of photometric polygonal lights", 2020: the
//               polygon above the horizon as a fan of triangles about its point nearest to the receiver, each with the
//               means of its corners' luminances and cosines times its solid angle; equal weights, as in the paper
//
// Look-ups of the last three are one batch of the intensity kernels. Openings must be rectangles.
#pragma once

#include <gonio/measure/method.hpp>
#include <gonio/measure/opening_cases.hpp>

namespace gonio::measure {

// In lx. The instruction sets of the machine for the columns, scalar float and its widest set for the others.
std::vector<Method<OpeningCases>> opening_methods();

} // namespace gonio::measure
