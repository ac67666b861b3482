// Grid: the table of a web, brought into the shapes that files and their readers ask for. Internal to the web room.
//
// Every step keeps the light: mirrored planes are copies, planes in between are the interpolant's own, and where a web
// is dark because its table ends, zeros are written `dark_step_deg` beyond the last value.
#pragma once

#include <gonio/web/web.hpp>

#include <vector>

namespace gonio::web_detail {

// Far below any goniometer's step, and wide enough that two angles stay apart in a reader's single precision.
inline constexpr double dark_step_deg = 1e-4;

struct Grid {
    std::vector<double> horizontal_deg;
    std::vector<double> vertical_deg;
    std::vector<double> candela; // [horizontal][vertical]
    bool dark_sector = false;    // the planes leave a part of the circle out
    bool jump_at_zero = false;   // the planes at 0° and 360° differ

    [[nodiscard]] std::size_t rows() const { return vertical_deg.size(); }
};

// The table as it is stored, of any goniometer.
Grid stored_grid(const Web& web);

// The planes of a type C web over 0° to 360°, both included: mirrored planes written out, dark sectors closed with
// zeros, a plane put at 0° where there is none.
Grid full_turn(const Web& web);

// Type C: whether the stored planes reach both ends of the range that their symmetry mirrors, so that they stand for
// themselves.
bool reaches_its_ends(const Web& web);

// Extends the vertical angles to `first` and `last` with zeros, where they begin later or end earlier. Whether anything
// was written.
bool extend_vertical(Grid& grid, double first, double last);

// The same for the horizontal angles.
bool extend_horizontal(Grid& grid, double first, double last);

// Of a full turn whose planes at 0° and 360° differ: the interpolant just before 360°, and the plane of 0° at 360°.
void step_before_the_turn(Grid& grid);

// Puts a copy of the interpolant between two planes, so that a last gap of `widest` or less closes the circle for
// readers who see neither the plane at 360° nor how wide the gap is.
void halve_last_cell(Grid& grid);

// The step of evenly spaced angles, 0 when they are not or there is one; `tolerance_deg` is what may be called even.
double even_step(const std::vector<double>& angles_deg, double tolerance_deg);

} // namespace gonio::web_detail
