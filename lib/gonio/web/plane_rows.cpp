#include <gonio/web/plane_rows.hpp>

#include <algorithm>
#include <cmath>

namespace gonio::web_detail {

PlaneRows::PlaneRows(const Web& web, std::span<const double> gammas_deg) : web_(web) {
    rows_.reserve(gammas_deg.size());
    for (const double gamma : gammas_deg)
        rows_.push_back(place_of(web.gammas_deg(), gamma));
}

// As a web finds the place of an angle.
PlaneRows::Place PlaneRows::place_of(std::span<const double> angles_deg, double angle_deg) {
    // Written so that a NaN fails.
    if (!(angle_deg >= angles_deg.front() && angle_deg <= angles_deg.back())) return {};
    const std::size_t last = angles_deg.size() - 1;
    if (last == 0) return {0, 0.0, true};
    const auto above = std::upper_bound(angles_deg.begin(), angles_deg.end(), angle_deg);
    const std::size_t cell = std::min(static_cast<std::size_t>(above - angles_deg.begin()), last) - 1;
    return {cell, (angle_deg - angles_deg[cell]) / (angles_deg[cell + 1] - angles_deg[cell]), true};
}

void PlaneRows::append(double c_deg, std::vector<double>& to) const {
    const Place plane = std::isfinite(c_deg) ? place_of(web_.planes_deg(), web_.folded_c_deg(c_deg)) : Place{};
    if (!plane.inside) {
        to.insert(to.end(), rows_.size(), 0.0);
        return;
    }
    // With a weight of 0 the neighbour is not accessed, because it may not exist.
    const std::span<const double> low_values = web_.column(plane.cell);
    const std::span<const double> high_values = plane.weight == 0.0 ? low_values : web_.column(plane.cell + 1);
    for (const Place& row : rows_) {
        const auto along_vertical = [&](std::span<const double> values) {
            const double value = values[row.cell];
            return row.weight == 0.0 ? value : value + row.weight * (values[row.cell + 1] - value);
        };
        if (!row.inside) {
            to.push_back(0.0);
            continue;
        }
        const double low = along_vertical(low_values);
        to.push_back(plane.weight == 0.0 ? low : low + plane.weight * (along_vertical(high_values) - low));
    }
}

} // namespace gonio::web_detail
