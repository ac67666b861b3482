// The tables of LM-63, and of TM-33, which has the same rules.
#include <gonio/web/make_profile.hpp>

#include <fmt/format.h>

namespace gonio::web_detail {

namespace {

// The forms in which LM-63 allows the planes of a web: one plane, a symmetric half or quarter, or the full turn.
Grid type_c_grid(const Web& web, Lm63Planes allowed, Losses& losses) {
    const Symmetry symmetry = web.stored_symmetry();
    if (symmetry == Symmetry::axial) {
        Grid grid = stored_grid(web);
        grid.horizontal_deg = {0.0};
        return grid;
    }
    const bool has_symmetry = symmetry != Symmetry::none && allowed != Lm63Planes::full_turn &&
                              (symmetry != Symmetry::bilateral_90_270 || allowed == Lm63Planes::any_half);
    if (has_symmetry && reaches_its_ends(web)) return stored_grid(web);
    Grid grid = full_turn(web);
    if (symmetry != Symmetry::none)
        losses.add("WEB0208", fmt::format("symmetry {} written out as {} planes over the full turn", to_text(symmetry),
                                          grid.horizontal_deg.size()));
    if (grid.dark_sector)
        losses.add("WEB0207", "the planes do not cover the full turn: the dark sector is written as planes of zeros");
    return grid;
}

// The range end to which a list ending at `angle` is extended: the nearest of `near` and `far` beyond it.
double end_for(double angle, double near, double far, bool upwards) {
    if (upwards) return angle <= near ? near : far;
    return angle >= near ? near : far;
}

void extend_type_c(Grid& grid, Losses& losses) {
    const double first = grid.vertical_deg.front();
    const double last = grid.vertical_deg.back();
    if (!extend_vertical(grid, end_for(first, 90.0, 0.0, false), end_for(last, 90.0, 180.0, true))) return;
    losses.add("WEB0206", fmt::format("vertical angles {} to {} extended with zeros to {} to {}", first, last,
                                      grid.vertical_deg.front(), grid.vertical_deg.back()));
}

// Types A and B run from -90 to 90 degrees, or from 0 if the other half is a mirror image.
void extend_types_ab(Grid& grid, Symmetry symmetry, Losses& losses) {
    const double h = grid.horizontal_deg.front();
    const double h_last = grid.horizontal_deg.back();
    const double v = grid.vertical_deg.front();
    const double v_last = grid.vertical_deg.back();
    const bool h_mirrored = mirrored_in_90_270(symmetry);
    const bool v_mirrored = mirrored_in_0_180(symmetry);
    const bool vertical = extend_vertical(grid, v_mirrored ? 0.0 : -90.0, 90.0);
    const bool horizontal = extend_horizontal(grid, h_mirrored ? 0.0 : -90.0, 90.0);
    if (!vertical && !horizontal) return;
    losses.add("WEB0206", fmt::format("angles H {} to {}, V {} to {} extended with zeros to H {} to {}, V {} to {}", h,
                                      h_last, v, v_last, grid.horizontal_deg.front(), grid.horizontal_deg.back(),
                                      grid.vertical_deg.front(), grid.vertical_deg.back()));
}

} // namespace

Grid lm63_grid(const Web& web, Lm63Planes allowed, Losses& losses) {
    if (web.photometry() != Photometry::c) {
        Grid grid = stored_grid(web);
        extend_types_ab(grid, web.stored_symmetry(), losses);
        return grid;
    }
    Grid grid = type_c_grid(web, allowed, losses);
    extend_type_c(grid, losses);
    return grid;
}

} // namespace gonio::web_detail
