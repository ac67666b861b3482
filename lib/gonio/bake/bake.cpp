#include <gonio/bake/bake.hpp>
#include <gonio/bake/latlong.hpp>
#include <gonio/bake/texel_flux.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/meridians.hpp>
#include <gonio/web/metrics.hpp>

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

constexpr double radians_per_degree = pi / 180.0;

// What the rows of a texture add up to.
struct RowTotals {
    double lumens = 0.0;    // of the texels as stored
    double max_error = 0.0; // |texel − web| at the texels' centres [cd]
    double steradians = 0.0;
    double quantization_error = 0.0; // [cd]
};

// A chart read with bilinear filtering, clamped at its edges unless it wraps.
double filtered(const Image& image, const PlacedChart& placed, glm::dvec2 place) {
    const bool wraps = placed.chart->wraps();
    const double x = place.x * placed.width - 0.5;
    const double y = std::clamp(place.y * placed.height - 0.5, 0.0, placed.height - 1.0);
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

// The greatest |filtered texture − web| at the web's own grid points.
double error_at_grid(const Web& web, const Texture& texture, std::span<const PlacedChart> charts) {
    double worst = 0.0;
    for (const double h : web.horizontal_deg())
        for (const double v : web.vertical_deg()) {
            const glm::dvec3 direction = direction_of(web.photometry(), {h, v});
            for (const PlacedChart& chart : charts)
                if (const std::optional<glm::dvec2> place = chart.chart->locate(direction)) {
                    const double value = filtered(texture.image, chart, *place) * texture.cd_per_unit;
                    worst = std::max(worst, std::abs(value - web.candela_at(h, v)));
                }
        }
    return worst;
}

RowTotals sum(const std::vector<RowTotals>& rows) {
    RowTotals total;
    for (const RowTotals& row : rows) {
        total.lumens += row.lumens;
        total.steradians += row.steradians;
        total.max_error = std::max(total.max_error, row.max_error);
        total.quantization_error = std::max(total.quantization_error, row.quantization_error);
    }
    return total;
}

// Puts a texel of that mean into the picture; what is stored, in candela.
double store(double mean, const Texture& texture, float& texel, RowTotals& total) {
    const double wanted = std::max(mean, 0.0);
    const double kept = as_stored(texture.texel_type, wanted / texture.cd_per_unit);
    texel = static_cast<float>(kept);
    const double intensity = kept * texture.cd_per_unit;
    total.quantization_error = std::max(total.quantization_error, std::abs(intensity - wanted));
    return intensity;
}

// latlong of a type C web; v180 is its only column, lying down.
RowTotals fill_in_closed_form(Texture& texture, const Web& web, bool one_column, unsigned threads) {
    Image& image = texture.image;
    const int columns = one_column ? 1 : image.width;
    const int rows = one_column ? image.width : image.height;
    const LatlongMeans means(web, columns);
    std::vector<RowTotals> totals(static_cast<std::size_t>(rows));
    parallel_for(totals.size(), threads, [&](std::size_t index) {
        const int j = static_cast<int>(index);
        const double low = static_cast<double>(j) / rows * 180.0;
        const double high = static_cast<double>(j + 1) / rows * 180.0;
        std::vector<double> row(static_cast<std::size_t>(columns));
        means.row(low, high, row);
        RowTotals& total = totals[index];
        const double gamma = 0.5 * (low + high);
        for (int i = 0; i < columns; ++i) {
            float& texel = one_column ? *image.at(j, 0) : *image.at(i, j);
            const double kept = store(row[static_cast<std::size_t>(i)], texture, texel, total);
            total.lumens += kept;
            total.max_error =
                std::max(total.max_error, std::abs(kept - web.candela((i + 0.5) / columns * 360.0, gamma)));
        }
        const double texel_sr =
            integrate_linear_sin(low * radians_per_degree, high * radians_per_degree, 1.0, 1.0) * 2.0 * pi / columns;
        total.lumens *= texel_sr;
        total.steradians = texel_sr * columns;
    });
    return sum(totals);
}

RowTotals fill(Texture& texture, const Web& web, const Meridians& meridians, const PlacedChart& placed,
               unsigned threads) {
    Image& image = texture.image;
    const TexelFlux flux(meridians, *placed.chart, placed.width, placed.height);
    std::vector<RowTotals> totals(static_cast<std::size_t>(placed.height));
    parallel_for(totals.size(), threads, [&](std::size_t index) {
        const int j = static_cast<int>(index);
        std::vector<double> lumens(static_cast<std::size_t>(placed.width));
        std::vector<double> steradians(lumens.size());
        flux.row(j, lumens, steradians);
        RowTotals& total = totals[index];
        float* const texels = image.at(placed.x, placed.y + j);
        for (std::size_t i = 0; i < lumens.size(); ++i) {
            const double value =
                store(steradians[i] > 0.0 ? lumens[i] / steradians[i] : 0.0, texture, texels[i], total);
            total.lumens += value * steradians[i];
            total.steradians += steradians[i];
            const glm::dvec3 center =
                placed.chart->at((static_cast<double>(i) + 0.5) / placed.width, (j + 0.5) / placed.height).direction;
            total.max_error = std::max(total.max_error, std::abs(value - web.candela(center)));
        }
    });
    return sum(totals);
}

Result<double> unit_of(const Web& web, Normalization normalization) {
    double unit = 1.0;
    if (normalization == Normalization::peak) unit = peak(web).intensity.value;
    if (normalization == Normalization::flux) unit = flux(web).value;
    if (normalization == Normalization::mean) unit = flux(web).value / (4.0 * pi);
    if (!(unit > 0.0))
        return fail(Failure::usage, fmt::format("cannot normalise by a {} of {}", to_text(normalization), unit),
                    "this web emits no light; --normalize none stores its candela");
    return unit;
}

} // namespace

TextureSize usual_size(Layout layout) {
    switch (layout) {
    case Layout::latlong:
    case Layout::panorama:
        return {512, 256};
    case Layout::v180:
        return {256, 1};
    case Layout::octahedral:
    case Layout::octahedral_equal_area:
    case Layout::gnomonic:
        return {256, 256};
    case Layout::cube_strip:
        return {768, 128};
    case Layout::cube_cross:
        return {512, 384};
    }
    return {512, 256};
}

Result<Texture> bake_texture(const Web& web, const BakeOptions& options) {
    const bool size_fits = options.width >= 1 && options.height >= 1 && options.width <= max_texture_size &&
                           options.height <= max_texture_size &&
                           std::int64_t{options.width} * options.height <= (std::int64_t{1} << 28);
    if (!size_fits)
        return fail(Failure::usage,
                    fmt::format("a texture of {}x{} texels is out of range", options.width, options.height),
                    fmt::format("each side may have 1 to {} texels, both together 2^28", max_texture_size));
    Result<std::vector<PlacedChart>> charts = charts_of(options.layout, options.width, options.height, options.chart);
    if (!charts) return pass_on(charts);
    Result<double> unit = unit_of(web, options.normalization);
    if (!unit) return pass_on(unit);

    Texture texture;
    texture.layout = info_of(options.layout).name;
    texture.texel_convention = info_of(options.layout).texel_convention;
    texture.image = Image(options.width, options.height, 1);
    texture.normalization = options.normalization;
    texture.cd_per_unit = *unit;
    texture.texel_type = options.texel_type;
    texture.peak = peak(web).intensity;
    texture.flux = flux(web);

    std::vector<RowTotals> totals;
    const bool latlong = options.layout == Layout::latlong || options.layout == Layout::v180;
    if (latlong && web.photometry() == Photometry::c) {
        totals.push_back(fill_in_closed_form(texture, web, options.layout == Layout::v180, options.threads));
    } else {
        const Meridians meridians(web);
        for (const PlacedChart& chart : *charts)
            totals.push_back(fill(texture, web, meridians, chart, options.threads));
    }
    const RowTotals total = sum(totals);
    texture.texture_flux = Lumens(total.lumens);
    texture.solid_angle = Steradians(total.steradians);
    texture.quantization_error = Candelas(total.quantization_error);
    texture.max_error = Candelas(std::max(total.max_error, error_at_grid(web, texture, *charts)));
    return texture;
}

} // namespace gonio
