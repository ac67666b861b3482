#include <gonio/bake/point_fill.hpp>
#include <gonio/bake/texel_flux.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/meridians.hpp>
#include <gonio/web/separable.hpp>
#include <gonio/web/symmetry.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

namespace gonio {

namespace {

using std::numbers::pi;

// Mean over C of the intensity at γ. Type C: each plane has the weight of its share of the full circle. Types A and B,
// for which the interpolant is not a product: the flux of a thin ring over its solid angle.
class RingMeans {
public:
    RingMeans(const Web& web, const Chart& rings) : web_(web), rings_(rings) {
        if (web.photometry() != Photometry::c)
            meridians_.emplace(web);
        else
            planes_ = plane_terms(web, plane_bends_deg(web), 0.0, 360.0);
    }

    [[nodiscard]] double at(double gamma_deg) const {
        if (meridians_) {
            constexpr double thin = 1e-6;
            const double s = std::clamp(gamma_deg / 180.0, thin, 1.0 - thin);
            const CellFlux ring = cell_flux(*meridians_, rings_, {s - 0.5 * thin, s + 0.5 * thin, 0.0, 1.0});
            return ring.lumens / ring.steradians;
        }
        double sum = 0.0;
        for (const Term& plane : planes_)
            sum += plane.weight * web_.candela_at(web_.planes_deg()[plane.index], gamma_deg);
        return sum / (2.0 * pi);
    }

private:
    const Web& web_;
    const Chart& rings_;
    std::optional<Meridians> meridians_;
    Terms planes_;
};

double ring_sr(int column, int width) {
    return 2.0 * pi * integrate_linear_sin(column * pi / width, (column + 1) * pi / width, 1.0, 1.0);
}

StoredTotals fill_rings(Image& image, const Web& web, const PlacedChart& placed, const Storage& storage) {
    const RingMeans means(web, *placed.chart);
    StoredTotals totals;
    for (int column = 0; column < placed.width; ++column) {
        const double value = means.at(static_cast<double>(column) / placed.width * 180.0);
        const double kept = store_texel(value, value, storage, *image.at(placed.x + column, placed.y), totals);
        totals.lumens += kept * ring_sr(column, placed.width);
    }
    totals.steradians = placed.chart->solid_angle();
    return totals;
}

} // namespace

StoredTotals fill_points(Image& image, const Web& web, std::span<const PlacedChart> charts, const Storage& storage,
                         Sampling sampling, unsigned threads) {
    const Meridians meridians(web);
    StoredTotals sum;
    for (const PlacedChart& placed : charts) {
        const Chart& chart = *placed.chart;
        if (sampling == Sampling::left_edge && placed.height == 1) {
            sum += fill_rings(image, web, placed, storage);
            continue;
        }
        const bool corners = sampling == Sampling::corners;
        const bool on_edges = corners || sampling == Sampling::edge_columns;
        const TexelFlux flux(meridians, chart, placed.width, placed.height);
        std::vector<StoredTotals> totals(static_cast<std::size_t>(placed.height));
        parallel_for(totals.size(), threads, [&](std::size_t index) {
            const int row = static_cast<int>(index);
            std::vector<double> lumens(static_cast<std::size_t>(placed.width));
            std::vector<double> steradians(lumens.size());
            flux.rows(row, 1, {}, false, lumens, steradians);
            StoredTotals& total = totals[index];
            for (int column = 0; column < placed.width; ++column) {
                const double s = on_edges ? static_cast<double>(column) / std::max(1, placed.width - 1)
                                          : static_cast<double>(column) / placed.width;
                const double t =
                    corners ? static_cast<double>(row) / std::max(1, placed.height - 1) : (row + 0.5) / placed.height;
                const double value = web.candela(chart.at(s, t).direction);
                const double kept =
                    store_texel(value, value, storage, *image.at(placed.x + column, placed.y + row), total);
                total.lumens += kept * steradians[static_cast<std::size_t>(column)];
            }
        });
        for (const StoredTotals& total : totals)
            sum += total;
        sum.steradians += chart.solid_angle();
    }
    return sum;
}

} // namespace gonio
