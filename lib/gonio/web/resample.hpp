// Webs on another grid, with the resulting error.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/web/web.hpp>

#include <vector>

namespace gonio {

struct ResampledWeb {
    Web web; // type C
    // Greatest |resampled − original| over five by five points of every cell of the new grid and every point of the
    // old one, and where it is. Where a table ends in the bright this is the jump that no grid can follow.
    Candelas max_error;
    double max_error_c_deg = 0.0;
    double max_error_gamma_deg = 0.0;
    Lumens flux_error; // flux of the resampled web less that of the original; both are exact
    // The same within cells of 0.001° by 0.001° or less, which max_error leaves out: the grid is that fine only at a
    // direction in which the original has several intensities, as at a pole of type B whose values differ.
    Candelas jump_error{0.0};
};

// The default tolerance of resampling, as a fraction of the peak.
inline constexpr double resampling_tolerance = 0.002;

// The web's intensities at every (C, γ) of the lists, as a type C web of symmetry `stored`, which the caller answers
// for (none: planes from 0° to 360°). Works for every goniometer. Fails as Web::create does.
// Cost: 30 evaluations of the web for each point of the new grid.
Result<ResampledWeb> resampled_to_c(const Web& web, std::vector<double> planes_deg, std::vector<double> gammas_deg,
                                    Symmetry stored = Symmetry::none);

// As above on a grid chosen for the web: its own mirrors kept, γ over [0°, 180°] or as much of it as is not dark, the
// γ of its own angles in the principal planes among them, and steps of 2.5° halved where the light bends by more than
// `tolerance` of the peak. The grid has at most 65536 points, which ends the halving where a table ends in the bright;
// max_error tells. A web of type C is returned as it is. Fails (malformed) never for a web that exists.
Result<ResampledWeb> resampled_to_c(const Web& web, double tolerance = resampling_tolerance);

// `count` + 1 angles from `first` to `last` in equal steps, both ends exact.
std::vector<double> even_angles(double first, double last, std::size_t count);

} // namespace gonio
