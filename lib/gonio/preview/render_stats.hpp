// What a rendering evaluated and what it skipped.
#pragma once

#include <cstddef>

#pragma GCC visibility push(default)
namespace gonio {

// A pair is one light and the part of one surface that is visible in one tile of the picture (32×32 pixels); an
// evaluation is one light at one surface point.
struct RenderStats {
    std::size_t lights = 0;
    std::size_t dark_lights = 0; // without flux: skipped at once
    std::size_t tiles = 0;
    std::size_t samples = 0;                  // surface points
    std::size_t samples_without_specular = 0; // of these, on materials with reflection that does not depend on the view
    std::size_t axial_webs = 0;               // lights whose web is looked up by γ alone

    std::size_t pairs = 0;
    std::size_t pairs_lit = 0;
    std::size_t evaluations = 0;   // all lights at all samples
    std::size_t evaluated = 0;     // evaluations done
    std::size_t from_center = 0;   // of these, those of a light as seen from its centre (RenderOptions::error)
    std::size_t as_point = 0;      // and those of an opening as a point at its centre
    std::size_t out_of_range = 0;  // evaluations skipped, by the first reason that applied
    std::size_t outside_cone = 0;  // behind the light, outside its lobe or where its web is dark
    std::size_t below_horizon = 0; // behind the surface
    std::size_t in_shadow = 0;
    std::size_t dark = 0;            // of lights without flux
    std::size_t at_shadow_edges = 0; // evaluations added there
    std::size_t not_converged = 0;   // method reference: evaluations that ended before the requested error was reached
    std::size_t shadow_tests = 0;    // all evaluations of lights that reach the point
    std::size_t shadow_tested = 0;   // of these, those done: where something may be in between
    std::size_t in_penumbra = 0;     // of these, those where a light with a size was partly hidden

    void add(const RenderStats& other);
};

} // namespace gonio
#pragma GCC visibility pop
