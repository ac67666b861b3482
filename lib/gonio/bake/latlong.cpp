#include <gonio/bake/latlong.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/web/goniometer.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/rings.hpp>
#include <gonio/web/separable.hpp>
#include <gonio/web/symmetry.hpp>

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
    for (const double h : web.horizontal_deg())
        for (const double v : web.vertical_deg()) {
            GoniometerAngles at{h, v};
            if (web.photometry() != Photometry::c) at = angles_of(Photometry::c, direction_of(web.photometry(), at));
            const double stored = filtered(image, at.horizontal_deg, at.vertical_deg) * texture.cd_per_unit;
            worst[rows] = std::max(worst[rows], std::abs(stored - web.candela(at.horizontal_deg, at.vertical_deg)));
        }
    return *std::max_element(worst.begin(), worst.end());
}

// A row's texel means from sums over stored planes: exact, for type C.
class SeparableRows {
public:
    SeparableRows(const Web& web, int width) : web_(web), columns_(static_cast<std::size_t>(width)) {
        const std::vector<double> bends = plane_bends_deg(web);
        for (int i = 0; i < width; ++i) {
            Terms& terms = columns_[static_cast<std::size_t>(i)];
            terms = plane_terms(web, bends, static_cast<double>(i) / width * 360.0,
                                static_cast<double>(i + 1) / width * 360.0);
            for (Term& term : terms)
                term.weight *= width / (2.0 * pi);
        }
    }

    void means(double low_deg, double high_deg, std::span<double> out) const {
        const Terms row = gamma_terms(web_, low_deg, high_deg);
        const double row_measure =
            integrate_linear_sin(low_deg * radians_per_degree, high_deg * radians_per_degree, 1.0, 1.0);
        std::vector<double> plane_means(web_.planes_deg().size(), 0.0);
        for (std::size_t p = 0; p < plane_means.size(); ++p)
            for (const Term& term : row)
                plane_means[p] += term.weight / row_measure * web_.column(p)[term.index];
        for (std::size_t i = 0; i < out.size(); ++i) {
            out[i] = 0.0;
            for (const Term& term : columns_[i])
                out[i] += term.weight * plane_means[term.index];
        }
    }

private:
    const Web& web_;
    std::vector<Terms> columns_; // per texel column
};

// A row's texel means by quadrature cut at the native grid, for types A and B.
class RingRows {
public:
    RingRows(const Web& web, int width) : rings_(web) {
        for (int i = 0; i <= width; ++i)
            edges_deg_.push_back(static_cast<double>(i) / width * 360.0);
    }

    void means(double low_deg, double high_deg, std::span<double> out) const {
        std::fill(out.begin(), out.end(), 0.0);
        rings_.add(low_deg, high_deg, edges_deg_, out);
        const double texel_sr =
            integrate_linear_sin(low_deg * radians_per_degree, high_deg * radians_per_degree, 1.0, 1.0) * 2.0 * pi /
            static_cast<double>(out.size());
        for (double& mean : out)
            mean /= texel_sr;
    }

private:
    Rings rings_;
    std::vector<double> edges_deg_;
};

// Fills the texture's pixels, negative means as 0, and adds up its flux.
template<class Rows>
void fill(Texture& texture, const Rows& rows, unsigned threads) {
    Image& image = texture.image;
    const auto height = static_cast<std::size_t>(image.height);
    std::vector<double> row_lumens(height, 0.0);
    parallel_for(height, threads, [&](std::size_t j) {
        const double low = static_cast<double>(j) / image.height * 180.0;
        const double high = static_cast<double>(j + 1) / image.height * 180.0;
        std::vector<double> means(static_cast<std::size_t>(image.width));
        rows.means(low, high, means);
        double sum = 0.0;
        float* const texels = image.at(0, static_cast<int>(j));
        for (std::size_t i = 0; i < means.size(); ++i) {
            texels[i] = static_cast<float>(std::max(means[i], 0.0) / texture.cd_per_unit);
            sum += static_cast<double>(texels[i]);
        }
        const double texel_sr = integrate_linear_sin(low * radians_per_degree, high * radians_per_degree, 1.0, 1.0) *
                                2.0 * pi / image.width;
        row_lumens[j] = sum * texel_sr * texture.cd_per_unit;
    });
    double total = 0.0;
    for (const double lumens : row_lumens)
        total += lumens;
    texture.texture_flux = Lumens(total);
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

    if (web.photometry() == Photometry::c)
        fill(texture, SeparableRows(web, options.width), options.threads);
    else
        fill(texture, RingRows(web, options.width), options.threads);
    texture.max_error = Candelas(greatest_error(web, texture, options.threads));
    return texture;
}

} // namespace gonio
