#include <gonio/bake/bake.hpp>
#include <gonio/bake/chart_fill.hpp>
#include <gonio/bake/latlong_fill.hpp>
#include <gonio/bake/point_fill.hpp>
#include <gonio/bake/texel_store.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/base/picture_size.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/symmetry.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gonio {

namespace {

using std::numbers::pi;

// Reads a chart with bilinear filtering between the points of its texels, clamped at its edges unless it wraps.
double filtered(const Image& image, const PlacedChart& placed, glm::dvec2 place, Sampling sampling) {
    const bool corners = sampling == Sampling::corners;
    const bool on_edges = corners || sampling == Sampling::edge_columns;
    const bool wraps = placed.chart->wraps() && !on_edges;
    const double x =
        on_edges ? place.x * (placed.width - 1) : place.x * placed.width - (sampling == Sampling::mean ? 0.5 : 0.0);
    const double y =
        std::clamp(corners ? place.y * (placed.height - 1) : place.y * placed.height - 0.5, 0.0, placed.height - 1.0);
    const double column = wraps ? std::floor(x) : std::floor(std::clamp(x, 0.0, placed.width - 1.0));
    const double u = wraps ? x - column : std::clamp(x, 0.0, placed.width - 1.0) - column;
    const auto wrapped = [&](int i) {
        return wraps ? (i + placed.width) % placed.width : std::min(i, placed.width - 1);
    };
    const int left = wrapped(static_cast<int>(column));
    const int right = wrapped(static_cast<int>(column) + 1);
    const int top = static_cast<int>(y);
    const int bottom = std::min(top + 1, placed.height - 1);
    const double v = y - top;
    const auto texel = [&](int i, int j) { return static_cast<double>(*image.at(placed.x + i, placed.y + j)); };
    const double upper = texel(left, top) + u * (texel(right, top) - texel(left, top));
    const double lower = texel(left, bottom) + u * (texel(right, bottom) - texel(left, bottom));
    return upper + v * (lower - upper);
}

// The greatest |filtered texture − web| at the web's own grid points. `by_angles`: latlong and type C.
double error_at_grid(const Web& web, const Texture& texture, std::span<const PlacedChart> charts, bool by_angles) {
    double worst = 0.0;
    for (const double h : web.horizontal_deg())
        for (const double v : web.vertical_deg()) {
            if (by_angles) { // C and γ are the places themselves
                const glm::dvec2 place{h / 360.0 - std::floor(h / 360.0), v / 180.0};
                const double value = filtered(texture.image, charts[0], place, texture.sampling) * texture.cd_per_unit;
                worst = std::max(worst, std::abs(value - web.candela_at(h, v)));
                continue;
            }
            const glm::dvec3 direction = direction_of(web.photometry(), {h, v});
            for (const PlacedChart& chart : charts)
                if (const std::optional<glm::dvec2> place = chart.chart->locate(direction)) {
                    const double value = filtered(texture.image, chart, *place, texture.sampling) * texture.cd_per_unit;
                    worst = std::max(worst, std::abs(value - web.candela_at(h, v)));
                }
        }
    return worst;
}

StoredTotals sum(const std::vector<StoredTotals>& rows) {
    StoredTotals total;
    for (const StoredTotals& row : rows)
        total += row;
    return total;
}

// latlong of a type C web; a v180 texture of one row is a latlong texture of one column, laid on its side.
StoredTotals fill_in_closed_form(Texture& texture, const Web& web, const BakeOptions& options) {
    Image& image = texture.image;
    const bool one_column = options.layout == Layout::v180 && options.height == 1;
    const int columns = one_column ? 1 : image.width;
    const int rows = one_column ? image.width : image.height;
    const LatlongFill fill(web, columns, options.skip);
    const Storage storage{texture.texel_type, texture.cd_per_unit, texture.transfer};
    std::vector<StoredTotals> totals(static_cast<std::size_t>(rows));
    parallel_for(totals.size(), options.threads, [&](std::size_t index) {
        const int j = static_cast<int>(index);
        float* const begin = one_column ? image.at(j, 0) : image.at(0, j);
        totals[index] = fill.row(static_cast<double>(j) / rows * 180.0, static_cast<double>(j + 1) / rows * 180.0,
                                 storage, {begin, static_cast<std::size_t>(columns)});
    });
    return sum(totals);
}

Result<double> unit_of(Normalization normalization, Candelas peak, Lumens flux) {
    double unit = 1.0;
    if (normalization == Normalization::peak) unit = peak.value;
    if (normalization == Normalization::flux) unit = flux.value;
    if (normalization == Normalization::mean) unit = flux.value / (4.0 * pi);
    if (!(unit > 0.0))
        return fail(Failure::usage, fmt::format("cannot normalise by a {} of {}", to_text(normalization), unit),
                    "this web emits no light; --normalize none stores its candela");
    return unit;
}

// The greatest texel is at most the peak over the unit: half floats overflow early, floats only if the unit is almost
// 0.
Unexpected does_not_fit(const Texture& texture) {
    const bool half = texture.texel_type == TexelType::half;
    return fail(Failure::unsupported,
                fmt::format("texels of up to {:.6g} do not fit {}-bit floats, which end at {}",
                            texture.peak.value / texture.cd_per_unit, half ? 16 : 32, half ? "65504" : "3.4e38"),
                half ? "store 32-bit floats (--pixel float), or shares of the peak (--normalize peak)"
                     : "store candela (--normalize none) or shares of the peak (--normalize peak)");
}

} // namespace

TextureSize usual_size(Layout layout) {
    return size_of_side(info_of(layout), info_of(layout).usual_side);
}

Result<Texture> bake_texture(const Web& web, const BakeOptions& options) {
    if (Result<void> fits =
            check_picture_size(options.width, options.height, limit("texture-side"), "a texture", "texels");
        !fits)
        return pass_on(fits);
    Result<std::vector<PlacedChart>> charts = charts_of(options.layout, options.width, options.height, options.chart);
    if (!charts) return pass_on(charts);

    Texture texture;
    texture.peak = peak(web).intensity;
    texture.flux = flux(web);
    Result<double> unit = unit_of(options.normalization, texture.peak, texture.flux);
    if (!unit) return pass_on(unit);
    texture.layout = info_of(options.layout).name;
    texture.texel_convention = info_of(options.layout).texel_convention;
    texture.image = Image(options.width, options.height, 1);
    texture.normalization = options.normalization;
    texture.cd_per_unit = *unit;
    texture.texel_type = options.texel_type;
    texture.sampling = options.sampling;
    texture.transfer = options.transfer;

    const bool latlong = options.layout == Layout::latlong || (options.layout == Layout::v180 && options.height == 1);
    const Storage storage{texture.texel_type, texture.cd_per_unit, texture.transfer};
    StoredTotals total;
    if (options.sampling != Sampling::mean)
        total = fill_points(texture.image, web, *charts, storage, options.sampling, options.threads);
    else if (latlong && web.photometry() == Photometry::c && options.chart.turned == glm::dmat3(1.0))
        total = fill_in_closed_form(texture, web, options);
    else
        // Uses the mirrors that the light has, whatever the file states: line integrals make the search worthwhile.
        total = fill_charts(texture.image, compacted(web, 0.0), *charts, storage, options.skip, options.threads);
    for (const PlacedChart& chart : *charts)
        texture.texels += static_cast<std::size_t>(chart.width) * static_cast<std::size_t>(chart.height);
    if (!std::isfinite(total.lumens)) return does_not_fit(texture);
    texture.evaluated = total.evaluated;
    texture.least_mean = Candelas(total.deepest_negative);
    texture.texture_flux = Lumens(total.lumens);
    texture.solid_angle = Steradians(total.steradians);
    texture.quantization_error = Candelas(total.quantization_error);
    const bool by_angles = options.layout == Layout::latlong && web.photometry() == Photometry::c &&
                           options.chart.turned == glm::dmat3(1.0);
    // Point samples are not at texel centres, so only the web's grid shows their errors.
    const double at_centers = options.sampling == Sampling::mean ? total.max_error : 0.0;
    texture.max_error = Candelas(std::max(at_centers, error_at_grid(web, texture, *charts, by_angles)));
    return texture;
}

} // namespace gonio
