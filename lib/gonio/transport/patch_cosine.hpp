// The mean over a patch of the cosine at which it sees a direction, in closed form.
#pragma once

#include <gonio/base/frame.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace gonio::detail {

class PatchCosine {
public:
    PatchCosine() = default;
    // Of a flat patch.
    explicit PatchCosine(const glm::dvec3& normal) : out_(normal) {}
    // Of a patch of a surface that is round about Z of the frame. `normal`: in its middle; `half_turn`: from there to
    // its sides [rad], below π/2. Along the axis all of it has the rise of the middle.
    PatchCosine(const Frame& axis, const glm::dvec3& normal, double half_turn)
        : half_turn_(half_turn),
          sin_half_(std::sin(half_turn)),
          cos_half_(std::cos(half_turn)),
          of_middle_(sin_half_ / half_turn) {
        const glm::dvec3 local = axis.to_local(normal);
        out_ = local.x * axis.x + local.y * axis.y;
        aside_ = local.y * axis.x - local.x * axis.y;
        along_ = local.z * axis.z;
    }

    // Of max(cos θ, 0) towards a unit direction.
    double mean(const glm::dvec3& towards) const {
        // A cos(m + t) + B, with t from −half to half of the turn.
        const double a_cos_m = glm::dot(out_, towards);
        const double a_sin_m = glm::dot(aside_, towards);
        const double b = glm::dot(along_, towards);
        const double at_low = a_cos_m * cos_half_ + a_sin_m * sin_half_ + b;
        const double at_high = a_cos_m * cos_half_ - a_sin_m * sin_half_ + b;
        // Where neither the direction nor its opposite is within the turn, the least and the greatest cosine are at the
        // sides.
        const double a2 = a_cos_m * a_cos_m + a_sin_m * a_sin_m;
        const bool is_aside = a_cos_m * a_cos_m <= a2 * cos_half_ * cos_half_;
        if (std::min(at_low, at_high) >= 0.0 && (is_aside || a_cos_m >= 0.0)) return a_cos_m * of_middle_ + b;
        if (std::max(at_low, at_high) <= 0.0 && (is_aside || a_cos_m <= 0.0)) return 0.0;
        return of_lit_part(std::sqrt(a2), std::atan2(a_sin_m, a_cos_m), b); // never of a flat patch
    }

private:
    double of_lit_part(double a, double m, double b) const;

    glm::dvec3 out_{0.0}, aside_{0.0}, along_{0.0};
    double half_turn_ = 0.0;
    double sin_half_ = 0.0, cos_half_ = 1.0;
    double of_middle_ = 1.0; // the mean of the cosine over that in the middle
};

} // namespace gonio::detail
