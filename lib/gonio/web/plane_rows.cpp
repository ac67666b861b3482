#include <gonio/web/plane_rows.hpp>

#include <algorithm>
#include <cmath>

namespace gonio::web_detail {

PlaneRows::PlaneRows(const Web& web, std::span<const double> vertical_deg) : web_(web) {
    rows_.reserve(vertical_deg.size());
    std::size_t cell = 0;
    for (const double angle : vertical_deg) {
        rows_.push_back(place_of(web.vertical_deg(), web.folded_vertical_deg(angle), cell));
        cell = rows_.back().cell;
    }
}

// As a web finds the place of an angle; `guess`: the cell of an angle close to it.
PlaneRows::Place PlaneRows::place_of(std::span<const double> angles_deg, double angle_deg, std::size_t guess) {
    // Written so that a NaN fails.
    if (!(angle_deg >= angles_deg.front() && angle_deg <= angles_deg.back())) return {};
    const std::size_t last = angles_deg.size() - 1;
    if (last == 0) return {0, 0.0, true};
    std::size_t cell = guess;
    for (int steps = 0; cell + 1 < last && angle_deg >= angles_deg[cell + 1] && steps < 2; ++steps)
        ++cell;
    if (angle_deg < angles_deg[cell] || (cell + 1 < last && angle_deg >= angles_deg[cell + 1])) {
        const auto above = std::upper_bound(angles_deg.begin(), angles_deg.end(), angle_deg);
        cell = std::min(static_cast<std::size_t>(above - angles_deg.begin()), last) - 1;
    }
    return {cell, (angle_deg - angles_deg[cell]) / (angles_deg[cell + 1] - angles_deg[cell]), true};
}

void PlaneRows::append(double horizontal_deg, std::vector<double>& to) const {
    const std::size_t first = to.size();
    to.resize(first + rows_.size()); // zeros
    const Place plane = std::isfinite(horizontal_deg)
                            ? place_of(web_.horizontal_deg(), web_.folded_horizontal_deg(horizontal_deg), 0)
                            : Place{};
    if (!plane.inside) return;
    double* out = to.data() + first;
    // With a weight of 0 the neighbour is not accessed, because it may not exist.
    const auto along_vertical = [](const double* values, const Place& row) {
        const double value = values[row.cell];
        return row.weight == 0.0 ? value : value + row.weight * (values[row.cell + 1] - value);
    };
    const double* const low_values = web_.column(plane.cell).data();
    if (plane.weight == 0.0) {
        for (const Place& row : rows_)
            *out++ = row.inside ? along_vertical(low_values, row) : 0.0;
        return;
    }
    const double* const high_values = web_.column(plane.cell + 1).data();
    for (const Place& row : rows_) {
        const double low = along_vertical(low_values, row);
        const double cd = low + plane.weight * (along_vertical(high_values, row) - low);
        *out++ = row.inside ? cd : 0.0;
    }
}

} // namespace gonio::web_detail
