// Directions towards a sphere, or any circular cap: uniform over its solid angle.
#pragma once

#include <gonio/shading/sample_light.hpp>

#include <numbers>

namespace gonio::shading {

// 1 − cos σ is computed from sin²σ, so that far spheres keep their digits. From inside, all directions meet the sphere;
// on its surface, the hemisphere about the centre.
template<class S>
class SphereSampler {
public:
    SphereSampler(vec3<S> center, S radius) {
        const S distance = length(center);
        if (distance < radius || !(distance > S(0))) {
            height_ = S(2);
            axis_ = {S(0), S(0), S(1)};
        } else {
            const S s = simd::min(radius / distance, S(1));
            const S kappa = simd::sqrt(simd::max((distance - radius) * (distance + radius), S(0))) / distance;
            height_ = s * s / (S(1) + kappa);
            axis_ = center * (S(1) / distance);
        }
    }

    // The directions on the side of a plane through the receiver that the unit `axis` points to.
    static SphereSampler hemisphere(vec3<S> axis) {
        SphereSampler half({S(0), S(0), S(0)}, S(1));
        half.axis_ = axis;
        half.height_ = S(1);
        return half;
    }

    S solid_angle() const { return S(2.0 * std::numbers::pi) * height_; }

    LightSample<S> sample(S u0, S u1) const {
        const S fallen = u0 * height_;
        const S sine = simd::sqrt(simd::max(fallen * (S(2) - fallen), S(0)));
        const S phi = S(2.0 * std::numbers::pi) * u1;
        const detail::Across<S> across(axis_);
        const vec3<S> off = across.x * (sine * simd::cos(phi)) + across.y * (sine * simd::sin(phi));
        return {normalized(axis_ * (S(1) - fallen) + off), S(1) / solid_angle()};
    }

    bool contains(vec3<S> direction) const {
        const vec3<S> off = direction - axis_; // |off|² = 2 (1 − cos)
        return dot(off, off) <= S(2) * height_;
    }

    S pdf(vec3<S> direction) const { return contains(direction) ? S(1) / solid_angle() : S(0); }

private:
    vec3<S> axis_;
    S height_; // 1 − cos σ
};

} // namespace gonio::shading
