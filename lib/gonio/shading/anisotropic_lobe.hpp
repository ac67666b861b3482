// The lobe of ggx_anisotropic.hpp on a surface, in the form that area lights evaluate (gloss.hpp).
#pragma once

#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/ggx_anisotropic.hpp>
#include <gonio/shading/gloss.hpp>
#include <gonio/shading/kernels_specular.hpp>
#include <gonio/shading/ltc_lobe.hpp>
#include <gonio/shading/vec2.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

namespace gonio::shading {

// The direction of α_x on a surface. Where the normal is `across` the tangent, before it is turned, is the first axis
// of TangentFrame.
template<class S>
struct Grain {
    vec3<S> across; // of any length; the tangent before it is turned is across × n
    S cosine, sine; // of the angle by which the tangent is turned about the normal, counter-clockwise from outside

    // The tangent, unit.
    GONIO_FORCE_INLINE vec3<S> along(vec3<S> n) const {
        const vec3<S> way = cross(across, n);
        const S square = dot(way, way);
        constexpr double least = __is_same(S, double) ? 1e-24 : 1e-12;
        const auto known = square > S(least) * dot(across, across);
        const vec3<S> x =
            select(known, way * (S(1) / simd::sqrt(simd::select(known, square, S(1)))), TangentFrame<S>(n).x);
        return x * cosine + cross(n, x) * sine;
    }
    GONIO_FORCE_INLINE TangentFrame<S> frame(vec3<S> n) const { return {along(n), n}; }
};

// A lobe in the frame of a receiver, whose z is the normal.
template<class S>
struct AnisotropicGgxInFrame {
    static constexpr bool is_even = false;

    AnisotropicAlpha<S> alphas;
    vec2<S> tangent;
    S alpha; // the mean of both

    // In the frame of tangent and normal.
    GONIO_FORCE_INLINE vec3<S> turned(vec3<S> p) const {
        return {simd::mul_add(p.x, tangent.x, p.y * tangent.y), simd::mul_add(p.y, tangent.x, -(p.x * tangent.y)), p.z};
    }
    // As those of GgxLobe.
    GONIO_FORCE_INLINE S value(vec3<S> l, vec3<S> v, const HalfVector<S>& h) const {
        return distribution_ggx(turned(h.sum), h.square, alphas, alphas) * visibility_ggx(turned(l), turned(v), alphas);
    }
    GONIO_FORCE_INLINE S albedo_share(S /*n_dot_v*/) const { return S(1); }
    GONIO_FORCE_INLINE S width(vec2<S> direction) const {
        const vec3<S> p = turned({direction.x, direction.y, S(0)});
        const S a = alphas.x * p.x;
        const S b = alphas.y * p.y;
        return simd::sqrt(simd::mul_add(a, a, b * b));
    }

    struct Slopes {
        S xx, xy, yx, yy;

        GONIO_FORCE_INLINE vec2<S> operator()(vec2<S> slope) const {
            return {simd::mul_add(xx, slope.x, xy * slope.y), simd::mul_add(yx, slope.x, yy * slope.y)};
        }
    };
    GONIO_FORCE_INLINE Slopes slopes() const {
        const S by_x = S(1) / alphas.x;
        const S by_y = S(1) / alphas.y;
        return {tangent.x * by_x, tangent.y * by_x, -(tangent.y * by_y), tangent.x * by_y};
    }

    // Whether a lobe is so thin that its bent ridge matters.
    GONIO_FORCE_INLINE simd::mask_of<S> is_thin() const {
        return simd::max(alphas.x, alphas.y) > S(3) * simd::min(alphas.x, alphas.y);
    }
    // The transformed cosine of the isotropic lobe that is as wide in the plane of n and v, narrowed or widened across
    // it and sheared: the slopes of half vectors then have the covariance (a b; b c)/2 of this lobe, with
    // a = α_x² t_x² + α_y² t_y² and so on, instead of a (1 0; 0 1)/2. n·v and ‖n×v‖ as for ltc_ggx().
    GONIO_FORCE_INLINE LtcLobe<S, true> cosine(S n_dot_v, S sine) const {
        const S along = even_alpha();
        return stretched(ltc_ggx(along, n_dot_v, sine), along);
    }
    // α of that isotropic lobe.
    GONIO_FORCE_INLINE S even_alpha() const { return width({S(1), S(0)}); }
    GONIO_FORCE_INLINE LtcLobe<S, true> stretched(const LtcLobe<S>& even, S along) const {
        const S inverse_area = S(1) / (alphas.x * alphas.y);
        return {even.m00,
                even.m02,
                even.m11 * (along * along * inverse_area),
                even.m20,
                even.m22,
                even.horizon_x,
                even.horizon_z,
                even.albedo,
                even.grazing,
                {-(covariance() * inverse_area)}};
    }
    // The direction of the smaller α after that transform, unit.
    GONIO_FORCE_INLINE vec2<S> across_ridge() const {
        const S along = even_alpha();
        const S inverse = S(1) / along;
        const auto is_wider_along = alphas.x >= alphas.y;
        const vec2<S> across = select(is_wider_along, vec2<S>{-tangent.y, tangent.x} * alphas.y, tangent * alphas.x);
        const S sheared = simd::mul_add(along * along, across.y, -(covariance() * across.x));
        return {across.x * inverse, sheared * inverse / (alphas.x * alphas.y)};
    }

private:
    // b of cosine().
    GONIO_FORCE_INLINE S covariance() const {
        return (alphas.x - alphas.y) * (alphas.x + alphas.y) * (tangent.x * tangent.y);
    }
};

// `alpha`, the mean of both, is the lobe's width for what does not depend on its direction.
template<class S>
struct AnisotropicGgxLobe {
    AnisotropicAlpha<S> alphas;
    Grain<S> grain;
    S alpha;

    GONIO_FORCE_INLINE SpecularTerms<S> operator()(vec3<S> n, vec3<S> l, vec3<S> v, S widened) const {
        const TangentFrame<S> frame = grain.frame(n);
        const S more = simd::max(widened - alpha, S(0));
        return specular_ggx(FacetPose<S>(frame, l, v), alphas, {alphas.x + more, alphas.y + more});
    }
    GONIO_FORCE_INLINE AnisotropicGgxInFrame<S> in(const LtcFrame<S>& frame) const {
        const vec3<S> t = grain.along(frame.z);
        return {alphas, {dot(frame.x, t), dot(frame.y, t)}, alpha};
    }
};

// The lobe that the constants describe, the same in every lane.
template<class S>
GONIO_FORCE_INLINE AnisotropicGgxLobe<S> lobe_of(const AnisotropicLobeConstants& constants) {
    const AnisotropicAlpha<S> alphas{simd::max(S(constants.alpha[0]), S(minimum_alpha)),
                                     simd::max(S(constants.alpha[1]), S(minimum_alpha))};
    const Grain<S> grain{{S(constants.across[0]), S(constants.across[1]), S(constants.across[2])},
                         S(constants.cosine),
                         S(constants.sine)};
    return {alphas, grain, alphas.mean()};
}
// Rounded to float.
template<class T>
GONIO_FORCE_INLINE AnisotropicLobeConstants constants_of(const AnisotropicGgxLobe<T>& lobe) {
    const auto number = [](T value) { return static_cast<float>(value); };
    const Grain<T>& grain = lobe.grain;
    return {{number(lobe.alphas.x), number(lobe.alphas.y)},
            {number(grain.across.x), number(grain.across.y), number(grain.across.z)},
            number(grain.cosine),
            number(grain.sine)};
}

} // namespace gonio::shading
