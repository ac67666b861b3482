// A web's intensities by direction, many at once: a fifth to a third of the time of Web::candela(), and as good as its
// rounding. For searches and sums of tens of thousands of intensities. Internal to the library.
//
// Where the rounding of an angle could change more than the last digits (within 2e-9° of the ends of the table, and at
// its poles), the web itself is asked. The same numbers on every machine.
#pragma once

#include <gonio/web/web.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio {

class QuickWeb {
public:
    // The web must outlive this.
    explicit QuickWeb(const Web& web);

    // Intensities along directions (x, y, z) in the light's frame, of lengths from 1e-100 to 1e100: within margin_cd()
    // of Web::candela(). All spans have the length of `to`. If not empty, `is_exact` gets whether a number is the web's
    // own to the last bit; numbers outside the table and between four zeros are.
    void candela(std::span<const double> x, std::span<const double> y, std::span<const double> z, std::span<double> to,
                 std::span<char> is_exact = {}) const;
    void candela(std::span<const glm::dvec3> directions, std::span<double> to, std::span<char> is_exact = {}) const;

    // What the rounding of an angle can change. Large for a web that jumps between angles that nearly coincide.
    [[nodiscard]] double margin_cd() const { return margin_cd_; }

private:
    // Finds the cell of an angle by equal parts of the axis: each is a cell, or has the cell that it begins in.
    struct Axis {
        std::span<const double> angles_deg;
        std::vector<double> per_deg; // of each cell: one over its width
        double narrowest_deg = 0.0;
        double parts_per_deg = 0.0;
        std::vector<std::uint32_t> first_cells; // empty: the parts are the cells
        bool holds_many = false;                // a part may reach into more than two cells
        // 2e-9° inside and outside the ends: between the two, the web is asked.
        double surely_from = 0.0;
        double surely_to = 0.0;
        double never_below = 0.0;
        double never_above = 0.0;

        explicit Axis(std::span<const double> angles);
    };
    // Where angles lie on an axis: the cell, and the weight of its upper end.
    struct Places;
    void locate(const Axis& axis, std::span<const double> angles_deg, Places& places) const;
    // C as a web of type C folds it, from −180° to 180°; NaN where that takes the web itself.
    void fold(std::span<double> c_deg) const;

    struct Found {
        double candela = 0.0;
        bool is_exact = true;
    };
    // Inside the table.
    [[nodiscard]] Found between(const Places& rows, const Places& planes, std::size_t at) const;

    const Web& web_;
    Axis horizontal_;
    Axis vertical_;
    const double* candela_;
    double weight_error_ = 0.0; // greatest, of a place between two angles
    double margin_cd_ = 0.0;
    bool is_axial_;  // one plane, for every C
    bool mirrors_x_; // types A and B
    bool mirrors_y_;
};

} // namespace gonio
