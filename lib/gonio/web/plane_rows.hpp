// A web's intensities at the same vertical angles of many planes: each is found in the table once. Internal to the web
// room.
#pragma once

#include <gonio/web/web.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace gonio::web_detail {

class PlaneRows {
public:
    // The grid's own angles: γ for type C, V for A and B. The web must outlive this.
    PlaneRows(const Web& web, std::span<const double> vertical_deg);

    // web.candela_at() at each of them, appended to `to`: the same to the last bit.
    void append(double horizontal_deg, std::vector<double>& to) const;

private:
    // The cell [cell, cell + 1] of an angle and the weight of its upper end.
    struct Place {
        std::size_t cell = 0;
        double weight = 0.0;
        bool inside = false;
    };
    static Place place_of(std::span<const double> angles_deg, double angle_deg, std::size_t guess);

    const Web& web_;
    std::vector<Place> rows_;
};

} // namespace gonio::web_detail
