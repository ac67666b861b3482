// How much the intensity of a web can change with direction: upper bounds by the angle from an axis, by inequality.
//
// All types of goniometer have spherical coordinates. With C for the longitude and γ for the angle from the axis, which
// is the nadir for type C, a horizontal axis for types A and B, a web is linear in C and in γ within a cell of its
// grid. So in a cell |∂I/∂γ| is greatest on an edge along γ, and |∂I/∂C|/sinγ at an end of such an edge; at a pole
// where all planes agree the latter stays finite. The slope S of a direction is the greatest length of the gradient of
// the cells near it: along the arc from a direction to another, intensities change by at most S times its length.
//
// Along a great circle with the arc length s, I'' within a cell comes from the curves of γ and C alone, |γ''| ≤ cotγ
// and |C''| ≤ cotγ/sinγ, and from the twist ∂²I/∂γ∂C with 2|γ'C'| ≤ 1/sinγ. Where the circle crosses a line of the
// grid, I' jumps by |γ'| times the jump of ∂I/∂γ, or by |C'| ≤ 1/sinγ times that of ∂I/∂C. A circle that crosses a line
// of γ twice turns back between, so that |γ'| ≤ 2η cotγ at both places, if 2η is the length of the arc. If this is
// shorter than the cells, it meets one line of γ and one of C at most, and
//
//   |I(η) + I(−η) − 2 I(0)| ≤ η J + η² Q.
//
// Where the web jumps, as at the last γ if it is not dark there, there is no bound.
#pragma once

#include <gonio/web/web.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace gonio::detail {

class WebVariation {
public:
    // The arc to which the bounds hold at most [rad].
    static constexpr double reach_rad = 0.05;

    struct Bounds {
        double slope = 0.0;    // S [cd/rad], for arcs up to reach_rad; infinite where there is none
        double kink = 0.0;     // J [cd/rad]
        double curve = 0.0;    // Q [cd/rad²]
        double bend_rad = 0.0; // the greatest η of J and Q; 0 where they are no bounds, as at the poles
        double most = 0.0;     // intensity, up to reach_rad away [cd]
    };

    // No bounds at all for a web that ends at a longitude at which it is not dark.
    explicit WebVariation(const Web& web);

    bool is_bounded() const { return is_bounded_; } // anywhere

    // In the frame of the web, unit.
    const glm::dvec3& axis() const { return axis_; }
    // At directions with this cosine of the angle from the axis, in [−1, 1].
    const Bounds& at(double cosine) const { return bounds_[bin_of(is_mirrored_ ? -std::abs(cosine) : cosine)]; }
    // Over all cosines in a range.
    Bounds over(double least, double most) const;

private:
    static constexpr std::size_t bins = 128; // uniform in the cosine
    static std::size_t bin_of(double cosine) {
        const double bin = 0.5 * (1.0 - cosine) * static_cast<double>(bins);
        return bin >= static_cast<double>(bins - 1) ? bins - 1 : bin > 0.0 ? static_cast<std::size_t>(bin) : 0;
    }

    glm::dvec3 axis_{0.0, 0.0, -1.0};
    bool is_mirrored_ = false; // across the plane that is perpendicular to the axis
    bool is_bounded_ = false;
    std::array<Bounds, bins> bounds_{};
};

} // namespace gonio::detail
