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
        const auto inside = simd::either(distance < radius, !(distance > S(0)));
        const S outside = simd::select(inside, S(1), distance); // a distance that divides
        const S s = simd::min(radius / outside, S(1));
        const S kappa = simd::sqrt(simd::max((outside - radius) * (outside + radius), S(0))) / outside;
        height_ = simd::select(inside, S(2), s * s / (S(1) + kappa));
        axis_ = select(inside, vec3<S>{S(0), S(0), S(1)}, center * (S(1) / outside));
    }

    // All directions, and those on the side of a plane through the receiver that the unit `axis` points to.
    static SphereSampler all_around() { return SphereSampler({S(0), S(0), S(1)}, S(2), Cap()); }
    static SphereSampler hemisphere(vec3<S> axis) { return SphereSampler(axis, S(1), Cap()); }

    friend SphereSampler select(simd::mask_of<S> condition, const SphereSampler& if_true,
                                const SphereSampler& if_false) {
        return SphereSampler(shading::select(condition, if_true.axis_, if_false.axis_),
                             simd::select(condition, if_true.height_, if_false.height_), Cap());
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

    simd::mask_of<S> contains(vec3<S> direction) const {
        const vec3<S> off = direction - axis_; // |off|² = 2 (1 − cos)
        return dot(off, off) <= S(2) * height_;
    }

    S pdf(vec3<S> direction) const { return simd::select(contains(direction), S(1) / solid_angle(), S(0)); }

private:
    struct Cap {};
    SphereSampler(vec3<S> axis, S height, Cap /*by these*/) : axis_(axis), height_(height) {}

    vec3<S> axis_;
    S height_; // 1 − cos σ
};

} // namespace gonio::shading
