#include <gonio/bake/latlong.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr double radians_per_degree = pi / 180.0;

// A texel's mean along one axis as a weighted sum of grid values.
struct Term {
    std::size_t index;
    double weight;
};
using Terms = std::vector<Term>;

void add(Terms& terms, std::size_t index, double weight) {
    if (weight == 0.0) return;
    for (Term& term : terms) {
        if (term.index != index) continue;
        term.weight += weight;
        return;
    }
    terms.push_back({index, weight});
}

// `low`, what of `knots` lies strictly between, and `high`.
std::vector<double> cuts(const std::vector<double>& knots, double low, double high) {
    std::vector<double> all{low};
    const auto first = std::upper_bound(knots.begin(), knots.end(), low);
    for (auto knot = first; knot != knots.end() && *knot < high; ++knot)
        all.push_back(*knot);
    all.push_back(high);
    return all;
}

// Every C in [0°, 360°] at which the web may bend or end.
std::vector<double> plane_knots(const Web& web) {
    std::vector<double> knots;
    for (const double c : web.planes_deg())
        for (const double image : {c, 180.0 - c, 180.0 + c, 360.0 - c, -c})
            knots.push_back(std::fmod(image + 1080.0, 360.0));
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    return knots;
}

// Weights of the stored planes in the mean over [low, high] degrees of C. Between two knots the web is linear in C, so
// its mean there is its value in the middle.
Terms column_terms(const Web& web, const std::vector<double>& knots, double low_deg, double high_deg) {
    const std::span<const double> planes = web.planes_deg();
    if (web.stored_symmetry() == Symmetry::axial) return {{0, 1.0}};
    Terms terms;
    const std::vector<double> pieces = cuts(knots, low_deg, high_deg);
    for (std::size_t k = 1; k < pieces.size(); ++k) {
        const double share = (pieces[k] - pieces[k - 1]) / (high_deg - low_deg);
        const double c = web.folded_c_deg(0.5 * (pieces[k] + pieces[k - 1]));
        if (c < planes.front() || c > planes.back()) continue;
        const auto above = std::upper_bound(planes.begin(), planes.end(), c);
        const auto right = std::min(static_cast<std::size_t>(above - planes.begin()), planes.size() - 1);
        if (right == 0) continue; // one plane of a web that is not axial: no width, no light
        const double weight = (c - planes[right - 1]) / (planes[right] - planes[right - 1]);
        add(terms, right - 1, share * (1.0 - weight));
        add(terms, right, share * weight);
    }
    return terms;
}

// Weights of the γ rows in the mean over [low, high] degrees of γ, by solid angle.
Terms row_terms(const Web& web, double low_deg, double high_deg) {
    const std::span<const double> gammas = web.gammas_deg();
    const std::vector<double> knots(gammas.begin(), gammas.end());
    const double low = low_deg * radians_per_degree;
    const double high = high_deg * radians_per_degree;
    const double measure = integrate_linear_sin(low, high, 1.0, 1.0);
    Terms terms;
    const std::vector<double> pieces = cuts(knots, low_deg, high_deg);
    for (std::size_t k = 1; k < pieces.size(); ++k) {
        const double from = pieces[k - 1];
        const double to = pieces[k];
        const double middle = 0.5 * (from + to);
        if (middle < gammas.front() || middle > gammas.back() || gammas.size() < 2) continue;
        const auto above = std::upper_bound(gammas.begin(), gammas.end(), middle);
        const auto upper = std::min(static_cast<std::size_t>(above - gammas.begin()), gammas.size() - 1);
        const double cell = gammas[upper] - gammas[upper - 1];
        const double at_from = (from - gammas[upper - 1]) / cell;
        const double at_to = (to - gammas[upper - 1]) / cell;
        const double a = from * radians_per_degree;
        const double b = to * radians_per_degree;
        add(terms, upper - 1, integrate_linear_sin(a, b, 1.0 - at_from, 1.0 - at_to) / measure);
        add(terms, upper, integrate_linear_sin(a, b, at_from, at_to) / measure);
    }
    return terms;
}

// The texture read with bilinear filtering, wrapping in C and clamping in γ, in units of texels.
double filtered(const Image& image, double c_deg, double gamma_deg) {
    const double x = c_deg / 360.0 * image.width - 0.5;
    const double y = std::clamp(gamma_deg / 180.0 * image.height - 0.5, 0.0, image.height - 1.0);
    const double x_floor = std::floor(x);
    const double u = x - x_floor;
    const int width = image.width;
    const int left = ((static_cast<int>(x_floor) % width) + width) % width;
    const int right = (left + 1) % width;
    const int top = static_cast<int>(y);
    const int bottom = std::min(top + 1, image.height - 1);
    const double v = y - top;
    const auto texel = [&](int column, int row) { return static_cast<double>(*image.at(column, row)); };
    const double upper = texel(left, top) + u * (texel(right, top) - texel(left, top));
    const double lower = texel(left, bottom) + u * (texel(right, bottom) - texel(left, bottom));
    return upper + v * (lower - upper);
}

double greatest_error(const Web& web, const Texture& texture, unsigned threads) {
    const Image& image = texture.image;
    const auto rows = static_cast<std::size_t>(image.height);
    std::vector<double> worst(rows + 1, 0.0);
    parallel_for(rows, threads, [&](std::size_t j) {
        const double gamma = (static_cast<double>(j) + 0.5) / image.height * 180.0;
        for (int i = 0; i < image.width; ++i) {
            const double c = (i + 0.5) / image.width * 360.0;
            const double stored = static_cast<double>(*image.at(i, static_cast<int>(j))) * texture.cd_per_unit;
            worst[j] = std::max(worst[j], std::abs(stored - web.candela(c, gamma)));
        }
    });
    for (std::size_t p = 0; p < web.planes_deg().size(); ++p)
        for (const double gamma : web.gammas_deg()) {
            const double c = web.planes_deg()[p];
            const double stored = filtered(image, c, gamma) * texture.cd_per_unit;
            worst[rows] = std::max(worst[rows], std::abs(stored - web.candela(c, gamma)));
        }
    return *std::max_element(worst.begin(), worst.end());
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

Result<Texture> bake_latlong(const Web& web, const BakeOptions& options) {
    const bool size_fits = options.width >= 1 && options.height >= 1 && options.width <= max_texture_size &&
                           options.height <= max_texture_size &&
                           std::int64_t{options.width} * options.height <= (std::int64_t{1} << 28);
    if (!size_fits)
        return fail(Failure::usage,
                    fmt::format("a texture of {}x{} texels is out of range", options.width, options.height),
                    fmt::format("each side may have 1 to {} texels, both together 2^28", max_texture_size));
    Result<double> unit = unit_of(web, options.normalization);
    if (!unit) return pass_on(unit);

    Texture texture;
    texture.layout = "latlong";
    texture.texel_convention = "column i covers C in [i, i+1]/width*360 deg, row j covers gamma in [j, j+1]/height*180 "
                               "deg, first row at gamma = 0 (nadir); a texel holds the mean over its solid angle";
    texture.image = Image(options.width, options.height, 1);
    texture.normalization = options.normalization;
    texture.cd_per_unit = *unit;
    texture.peak = peak(web).intensity;
    texture.flux = flux(web);

    const auto width = static_cast<std::size_t>(options.width);
    const auto height = static_cast<std::size_t>(options.height);
    const std::size_t planes = web.planes_deg().size();
    const std::vector<double> knots = plane_knots(web);
    std::vector<Terms> columns(width);
    for (std::size_t i = 0; i < width; ++i)
        columns[i] = column_terms(web, knots, static_cast<double>(i) / options.width * 360.0,
                                  static_cast<double>(i + 1) / options.width * 360.0);

    std::vector<double> row_lumens(height, 0.0);
    parallel_for(height, options.threads, [&](std::size_t j) {
        const double low = static_cast<double>(j) / options.height * 180.0;
        const double high = static_cast<double>(j + 1) / options.height * 180.0;
        const Terms row = row_terms(web, low, high);
        std::vector<double> plane_means(planes, 0.0);
        for (std::size_t p = 0; p < planes; ++p)
            for (const Term& term : row)
                plane_means[p] += term.weight * web.column(p)[term.index];

        double sum = 0.0;
        float* const texels = texture.image.at(0, static_cast<int>(j));
        for (std::size_t i = 0; i < width; ++i) {
            double mean = 0.0;
            for (const Term& term : columns[i])
                mean += term.weight * plane_means[term.index];
            texels[i] = static_cast<float>(std::max(mean, 0.0) / *unit);
            sum += static_cast<double>(texels[i]);
        }
        const double texel_sr = integrate_linear_sin(low * radians_per_degree, high * radians_per_degree, 1.0, 1.0) *
                                2.0 * pi / options.width;
        row_lumens[j] = sum * texel_sr * *unit;
    });
    double total = 0.0;
    for (const double lumens : row_lumens)
        total += lumens;
    texture.texture_flux = Lumens(total);
    texture.max_error = Candelas(greatest_error(web, texture, options.threads));
    return texture;
}

} // namespace gonio
