#include <gonio/bake/chart_fill.hpp>
#include <gonio/bake/mirror_images.hpp>
#include <gonio/bake/texel_flux.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/web/meridians.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace gonio {

namespace {

// Rows that one thread takes at a time: edges between these rows are computed only once.
constexpr int band_rows = 16;

struct Band {
    std::size_t chart;
    int row;
    int rows;
};

std::vector<Band> bands_of(std::span<const PlacedChart> charts) {
    std::vector<Band> bands;
    for (std::size_t k = 0; k < charts.size(); ++k)
        for (int row = 0; row < charts[k].height; row += band_rows)
            bands.push_back({k, row, std::min(band_rows, charts[k].height - row)});
    return bands;
}

} // namespace

StoredTotals fill_charts(Image& image, const Web& web, std::span<const PlacedChart> charts, const Storage& storage,
                         bool skip, unsigned threads) {
    const Meridians meridians(web);
    const MirrorImages images(charts, web);
    const bool mirrored = images.any();
    const std::vector<Band> bands = bands_of(charts);
    std::vector<StoredTotals> totals(bands.size());
    parallel_for(bands.size(), threads, [&](std::size_t index) {
        const Band& band = bands[index];
        const PlacedChart& placed = charts[band.chart];
        const TexelFlux flux(meridians, *placed.chart, placed.width, placed.height);
        const auto count = static_cast<std::size_t>(placed.width) * static_cast<std::size_t>(band.rows);
        std::vector<double> lumens(count);
        std::vector<double> steradians(count);
        std::vector<char> wanted(mirrored ? count : 0);
        const auto place = [&](std::size_t at) {
            const auto width = static_cast<std::size_t>(placed.width);
            return TexelPlace{band.chart, static_cast<int>(at % width), band.row + static_cast<int>(at / width)};
        };
        for (std::size_t at = 0; at < wanted.size(); ++at)
            wanted[at] = images.first_of(place(at)) == place(at) ? 1 : 0;
        flux.rows(band.row, band.rows, wanted, skip, lumens, steradians);
        // Without skipping, mirror images are evaluated too, but at the place of their first image: its mirrored
        // integral has the same digits, while that of the image's own place may differ in the last one.
        for (std::size_t at = 0; at < wanted.size() && !skip; ++at) {
            if (wanted[at] != 0) continue;
            const TexelPlace first = images.first_of(place(at));
            const PlacedChart& of = charts[first.chart];
            const CellFlux cell = TexelFlux(meridians, *of.chart, of.width, of.height).texel(first.column, first.row);
            lumens[at] = cell.lumens;
            steradians[at] = cell.steradians;
        }
        StoredTotals& total = totals[index];
        for (std::size_t at = 0; at < count; ++at) {
            if (!(steradians[at] > 0.0)) continue; // dark, or a mirror image of another texel
            const TexelPlace texel = place(at);
            const double mean = lumens[at] / steradians[at];
            const glm::dvec3 center =
                placed.chart->at((texel.column + 0.5) / placed.width, (texel.row + 0.5) / placed.height).direction;
            const double kept = store_texel(mean, web.candela(center), storage,
                                            *image.at(placed.x + texel.column, placed.y + texel.row), total);
            total.lumens += kept * steradians[at] * static_cast<double>(skip && mirrored ? images.count_of(texel) : 1);
        }
    });
    StoredTotals sum;
    for (const StoredTotals& total : totals)
        sum += total;
    for (const PlacedChart& chart : charts)
        sum.steradians += chart.chart->solid_angle();
    if (!skip || !mirrored) return sum;
    parallel_for(bands.size(), threads, [&](std::size_t index) {
        const Band& band = bands[index];
        const PlacedChart& placed = charts[band.chart];
        for (int row = band.row; row < band.row + band.rows; ++row)
            for (int column = 0; column < placed.width; ++column) {
                const TexelPlace texel{band.chart, column, row};
                const TexelPlace first = images.first_of(texel);
                if (first == texel) continue;
                const PlacedChart& from = charts[first.chart];
                *image.at(placed.x + column, placed.y + row) = *image.at(from.x + first.column, from.y + first.row);
            }
    });
    return sum;
}

} // namespace gonio
