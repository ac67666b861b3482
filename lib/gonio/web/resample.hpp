// Webs resampled to another grid, with the resulting error.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/web/web.hpp>

#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// A web on another grid, and how far it is from the original.
struct ResampledWeb {
    Web web; // type C
    // Greatest |resampled − original| over five by five points of every cell of the new grid and every point of the old
    // one, and its direction. Where a table ends at a non-zero value, this is the jump, which no grid can follow.
    Candelas max_error;
    double max_error_c_deg = 0.0;
    double max_error_gamma_deg = 0.0;
    Lumens flux_error; // flux of the resampled web minus that of the original; both are exact
    // The same within cells of 0.001° by 0.001° or less, which max_error excludes: the grid is that fine only at a
    // direction in which the original has several intensities, such as a pole of type B with differing values.
    Candelas jump_error{0.0};
};

// The default tolerance of resampling, as a fraction of the peak.
inline constexpr double resampling_tolerance = 0.002;

// The web's intensities at every (C, γ) of the lists, as a type C web of symmetry `stored`; the caller must ensure that
// the web has this symmetry (none: planes from 0° to 360°). Works for every goniometer. Fails as Web::create does.
// Cost: 30 evaluations of the web for each point of the new grid.
Result<ResampledWeb> resampled_to_c(const Web& web, std::vector<double> planes_deg, std::vector<double> gammas_deg,
                                    Symmetry stored = Symmetry::none);

// The same web without its errors, which take most of the time.
Result<Web> sampled_on_grid(const Web& web, std::vector<double> planes_deg, std::vector<double> gammas_deg,
                            Symmetry stored = Symmetry::none);

// As resampled_to_c() above, on a grid chosen for the web: its mirrors are kept, γ covers [0°, 180°] or the hemisphere
// that is not dark, includes the γ of the web's own angles in the principal planes, and steps of 2.5° are halved where
// the light bends by more than `tolerance` of the peak. The grid has at most 65536 points, which ends the halving where
// a table ends at a non-zero value; check max_error. A web of type C is returned unchanged. Never fails for a valid
// web.
Result<ResampledWeb> resampled_to_c(const Web& web, double tolerance = resampling_tolerance);

// `count` + 1 angles from `first` to `last` in equal steps, both ends exact.
std::vector<double> even_angles(double first, double last, std::size_t count);

} // namespace gonio
#pragma GCC visibility pop
