#include <gonio/base/gauss_legendre.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/ibl/detail/texel_outline.hpp>
#include <gonio/ibl/irradiance_sh.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr std::size_t all = 16;

// √((2l + 1)/4π …): the constants of Y.
const double y0 = 0.5 * std::sqrt(1.0 / pi);
const double y1 = std::sqrt(3.0 / (4.0 * pi));
const double y2 = std::sqrt(15.0 / (4.0 * pi)); // xy, yz, xz
const double y20 = 0.25 * std::sqrt(5.0 / pi);
const double y22 = 0.25 * std::sqrt(15.0 / pi);
const double y33 = 0.25 * std::sqrt(35.0 / (2.0 * pi));
const double y32 = 0.5 * std::sqrt(105.0 / pi); // xyz
const double y31 = 0.25 * std::sqrt(21.0 / (2.0 * pi));
const double y30 = 0.25 * std::sqrt(7.0 / pi);

// The gradients of the polynomials that spherical_harmonics() evaluates.
std::array<glm::dvec3, all> gradients(const glm::dvec3& d) {
    const double x = d.x;
    const double y = d.y;
    const double z = d.z;
    return {glm::dvec3(0.0),
            y1 * glm::dvec3(0.0, 1.0, 0.0),
            y1 * glm::dvec3(0.0, 0.0, 1.0),
            y1 * glm::dvec3(1.0, 0.0, 0.0),
            y2 * glm::dvec3(y, x, 0.0),
            y2 * glm::dvec3(0.0, z, y),
            y20 * glm::dvec3(0.0, 0.0, 6.0 * z),
            y2 * glm::dvec3(z, 0.0, x),
            y22 * glm::dvec3(2.0 * x, -2.0 * y, 0.0),
            y33 * glm::dvec3(6.0 * x * y, 3.0 * (x * x - y * y), 0.0),
            y32 * glm::dvec3(y * z, x * z, x * y),
            y31 * glm::dvec3(0.0, 5.0 * z * z - 1.0, 10.0 * y * z),
            y30 * glm::dvec3(0.0, 0.0, 15.0 * z * z - 3.0),
            y31 * glm::dvec3(5.0 * z * z - 1.0, 0.0, 10.0 * x * z),
            0.5 * y32 * glm::dvec3(2.0 * x * z, -2.0 * y * z, x * x - y * y),
            y33 * glm::dvec3(3.0 * (x * x - y * y), -6.0 * x * y, 0.0)};
}

using Integrals = std::array<double, all>;

template<std::size_t count>
void add_side(const detail::OutlineSide& side, Integrals& sums) {
    static constexpr auto nodes = gauss_legendre<count>();
    for (const QuadratureNode& node : nodes) {
        const double t = 0.5 * (1.0 + node.at);
        const glm::dvec3 at = side.at(t);
        const glm::dvec3 outwards = glm::cross(side.step(t), at);
        const std::array<glm::dvec3, all> slope = gradients(at);
        for (std::size_t i = 1; i < all; ++i)
            sums[i] += 0.5 * node.weight * glm::dot(slope[i], outwards);
    }
}

// ∫ Y dω over a texel. The Laplacian of Y(l) on the sphere is −l(l + 1) Y(l): by the divergence theorem the integral is
// −∮ ∇Y·outwards ds/(l(l + 1)).
Integrals integrals_over(const EnvironmentGrid& grid, TexelIndex texel) {
    Integrals sums{};
    for (const detail::OutlineSide& side : detail::outline_of(grid, texel)) {
        constexpr double is_short = 0.1;
        if (side.arc == 0.0) continue;
        if (std::abs(side.arc) < is_short)
            add_side<4>(side, sums);
        else
            add_side<10>(side, sums);
    }
    for (int band = 1; band <= most_sh_order; ++band)
        for (int i = band * band; i < (band + 1) * (band + 1); ++i)
            sums.at(static_cast<std::size_t>(i)) /= -band * (band + 1.0);
    sums[0] = y0 * grid.solid_angle(texel);
    return sums;
}

} // namespace

std::array<double, 16> spherical_harmonics(const glm::dvec3& direction) {
    const double x = direction.x;
    const double y = direction.y;
    const double z = direction.z;
    return {y0,
            y1 * y,
            y1 * z,
            y1 * x,
            y2 * x * y,
            y2 * y * z,
            y20 * (3.0 * z * z - 1.0),
            y2 * x * z,
            y22 * (x * x - y * y),
            y33 * y * (3.0 * x * x - y * y),
            y32 * x * y * z,
            y31 * y * (5.0 * z * z - 1.0),
            y30 * z * (5.0 * z * z - 3.0),
            y31 * x * (5.0 * z * z - 1.0),
            0.5 * y32 * z * (x * x - y * y),
            y33 * x * (x * x - 3.0 * y * y)};
}

double cosine_factor(int band) {
    constexpr std::array factors{pi, 2.0 * pi / 3.0, pi / 4.0, 0.0};
    return factors.at(static_cast<std::size_t>(band));
}

IrradianceSh::IrradianceSh(std::vector<glm::dvec3> radiance) : radiance_(std::move(radiance)) {
    while (static_cast<std::size_t>(order_ + 1) * static_cast<std::size_t>(order_ + 1) < radiance_.size())
        ++order_;
}

std::vector<glm::dvec3> IrradianceSh::irradiance_coefficients() const {
    std::vector<glm::dvec3> coefficients = radiance_;
    for (int band = 0; band <= order_; ++band)
        for (int i = band * band; i < (band + 1) * (band + 1); ++i)
            coefficients.at(static_cast<std::size_t>(i)) *= cosine_factor(band);
    return coefficients;
}

glm::dvec3 IrradianceSh::irradiance(const glm::dvec3& normal) const {
    const std::array<double, all> y = spherical_harmonics(normal);
    glm::dvec3 sum(0.0);
    for (int band = 0; band <= std::min(order_, 2); ++band)
        for (int i = band * band; i < (band + 1) * (band + 1); ++i)
            sum += cosine_factor(band) * y.at(static_cast<std::size_t>(i)) * radiance_[static_cast<std::size_t>(i)];
    return sum;
}

glm::dvec3 IrradianceSh::least() const {
    // On a spiral of the golden angle (H. Vogel, 1979).
    constexpr int normals = 16384;
    constexpr double golden_angle = 2.399963229728653;
    glm::dvec3 least(1e300);
    for (int i = 0; i < normals; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / normals;
        const double r = std::sqrt((1.0 - z) * (1.0 + z));
        least = glm::min(least, irradiance({r * std::cos(golden_angle * i), r * std::sin(golden_angle * i), z}));
    }
    return least;
}

IrradianceSh irradiance_sh(const EnvironmentMap& map, int order, unsigned threads) {
    const EnvironmentGrid& grid = map.grid();
    const std::size_t count = static_cast<std::size_t>(order + 1) * static_cast<std::size_t>(order + 1);
    using Sums = std::array<glm::dvec3, all>;
    std::vector<Sums> rows(static_cast<std::size_t>(grid.height()));
    parallel_for(rows.size(), threads, [&](std::size_t at) {
        const int row = static_cast<int>(at);
        Sums sums{};
        for (int column = 0; column < grid.width(); ++column) {
            if (!grid.covers({column, row})) continue;
            const glm::dvec3 light = map.texel({column, row});
            if (light == glm::dvec3(0.0)) continue;
            const Integrals integrals = integrals_over(grid, {column, row});
            for (std::size_t i = 0; i < count; ++i)
                sums.at(i) += integrals.at(i) * light;
        }
        rows[at] = sums;
    });
    std::vector<glm::dvec3> total(count, glm::dvec3(0.0));
    for (const Sums& row : rows)
        for (std::size_t i = 0; i < count; ++i)
            total[i] += row.at(i);
    return IrradianceSh(std::move(total));
}

} // namespace gonio
