// A lobe over one texel, by Gauss nodes along the texel's outline: the narrowest lobe needs no parts of texels.
#pragma once

#include <gonio/base/gauss_legendre.hpp>
#include <gonio/ibl/detail/texel_outline.hpp>
#include <gonio/ibl/ggx_lobe.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace gonio::detail {

// ∫ w dω over texels, as ∮ F(u) (R × ω)·dω/(1 − c²) along their outlines with dF/du = w: Stokes' theorem for the part
// of the sphere between a curve and R, or the curve and −R.
// With 8 nodes a piece within 1e-9 of the lobe's whole, with 5 within 1e-6.
template<std::size_t nodes>
class LobeOverTexel {
public:
    LobeOverTexel(const GgxLobe& lobe, const glm::dvec3& direction) : lobe_(lobe), direction_(direction) {}

    [[nodiscard]] double operator()(const TexelOutline& outline, const glm::dvec3& middle, double reach) const {
        const double height = glm::dot(middle, direction_);
        if (height < -reach) return 0.0;
        // F(0) = 0 where R may be in the texel, F = 0 below the horizon where −R may be.
        const double shift = height > 0.0 ? 0.0 : -lobe_.whole() / (2.0 * std::numbers::pi);
        double sum = 0.0;
        for (const OutlineSide& side : outline)
            if (side.arc != 0.0) sum += height < reach ? broken(side, shift) : along(side, shift, 0.0, 1.0, 0);
        return sum;
    }

private:
    // In parts between the places where the side crosses the horizon, where the lobe has a corner.
    [[nodiscard]] double broken(const OutlineSide& side, double shift) const {
        // R·ω = even + cos(s) across + sin(s) down = even + swing cos(s − turn)
        const double even = glm::dot(direction_, side.middle);
        const double across = glm::dot(direction_, side.e);
        const double down = glm::dot(direction_, side.f);
        const double swing = std::hypot(across, down);
        std::array<double, 4> ends{0.0, 1.0, 1.0, 1.0};
        std::size_t count = 1;
        if (std::abs(even) < swing) {
            const double turn = std::atan2(down, across);
            const double half = std::acos(-even / swing);
            for (const double s : {turn - half, turn + half})
                for (const double t :
                     {s / side.arc, (s + 2.0 * std::numbers::pi) / side.arc, (s - 2.0 * std::numbers::pi) / side.arc})
                    if (t > 0.0 && t < 1.0 && count < 3) ends.at(count++) = t;
        }
        ends.at(count) = 1.0;
        std::sort(ends.begin(), ends.end());
        double sum = 0.0;
        for (std::size_t i = 0; i < count; ++i)
            if (ends.at(i + 1) > ends.at(i)) sum += along(side, shift, ends.at(i), ends.at(i + 1), 0);
        return sum;
    }

    // In pieces that are no longer than the distance over which the lobe changes.
    [[nodiscard]] double along(const OutlineSide& side, double shift, double from, double to, int halvings) const {
        const double length = std::abs(side.arc) * glm::length(side.f) * (to - from);
        const double apart = glm::length(side.at(0.5 * (from + to)) - direction_) - 0.5 * length;
        const double scale = std::max(apart, 0.0) + lobe_.alpha();
        constexpr double smooth = 0.15;
        constexpr int most_halvings = 16;
        if (length < smooth * scale) return of_piece<3>(side, shift, from, to);
        if (length < scale || halvings == most_halvings) return of_piece<nodes>(side, shift, from, to);
        const double middle = 0.5 * (from + to);
        return along(side, shift, from, middle, halvings + 1) + along(side, shift, middle, to, halvings + 1);
    }

    template<std::size_t count>
    [[nodiscard]] double of_piece(const OutlineSide& side, double shift, double from, double to) const {
        static constexpr auto rule = gauss_legendre<count>();
        double sum = 0.0;
        for (const QuadratureNode& node : rule) {
            const double t = 0.5 * (from + to + (to - from) * node.at);
            const glm::dvec3 at = side.at(t);
            const glm::dvec3 apart = direction_ - at;
            const double u = 0.5 * glm::dot(apart, apart);
            const double sine_square = u * (2.0 - u);
            if (!(sine_square > 0.0)) continue;
            sum += node.weight * (lobe_.integral(u) + shift) * glm::dot(glm::cross(direction_, at), side.step(t)) /
                   sine_square;
        }
        return 0.5 * (to - from) * sum;
    }

    const GgxLobe& lobe_;
    glm::dvec3 direction_;
};

} // namespace gonio::detail
