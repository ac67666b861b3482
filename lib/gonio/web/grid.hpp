// Grid: the table of a web, converted to the forms that files and their readers require. Internal to the web room.
//
// Every step preserves the light: mirrored planes are copies, planes in between are those of the interpolant, and where
// a web is dark because its table ends, zeros are written `dark_step_deg` beyond the last value.
#pragma once

#include <gonio/web/web.hpp>

#include <vector>

namespace gonio::web_detail {

// Far below any goniometer's step, but wide enough that two angles stay distinct in a reader's single precision.
inline constexpr double dark_step_deg = 1e-4;

struct Grid {
    std::vector<double> horizontal_deg;
    std::vector<double> vertical_deg;
    std::vector<double> candela; // [horizontal][vertical]
    bool dark_sector = false;    // the planes do not cover the whole circle
    bool jump_at_zero = false;   // the planes at 0° and 360° differ

    [[nodiscard]] std::size_t rows() const { return vertical_deg.size(); }
};

// The table as it is stored, of any goniometer.
Grid stored_grid(const Web& web);

// The planes of a type C web over 0° to 360°, both included: mirrored planes written out, dark sectors closed with
// zeros, a plane added at 0° if there is none.
Grid full_turn(const Web& web);

// Type C: whether the stored planes reach both ends of the range that their symmetry mirrors, so that they can be
// written as they are.
bool reaches_its_ends(const Web& web);

// Extends the vertical angles to `first` and `last` with zeros, if they begin later or end earlier. Returns whether the
// grid was changed.
bool extend_vertical(Grid& grid, double first, double last);

// The same for the horizontal angles.
bool extend_horizontal(Grid& grid, double first, double last);

// For a full turn with different planes at 0° and 360°: adds the interpolant just before 360°, and the plane of 0° at
// 360°.
void step_before_the_turn(Grid& grid);

// Inserts the interpolant in the middle of the last gap, so that readers that see neither the plane at 360° nor how
// wide the gap is close the circle across a narrow gap.
void halve_last_cell(Grid& grid);

// The step of uniformly spaced angles; 0 if they are not uniform or there is only one. `tolerance_deg` is the allowed
// deviation.
double even_step(const std::vector<double>& angles_deg, double tolerance_deg);

} // namespace gonio::web_detail
