// The lobe of a BRDF as a linearly transformed cosine: a matrix that maps directions to a space where the lobe is a
// cosine.
//
// E. Heitz, J. Dupuy, S. Hill, D. Neubelt, "Real-Time Polygonal-Light Shading with Linearly Transformed Cosines", ACM
// Transactions on Graphics 35(4), 2016. The table comes from this tree (fit/ltc.cpp). A lobe here keeps its sign: it is
// normalised to 1 over the receiver's hemisphere z > 0, and where z' < 0 within it, it is (slightly) negative. So the
// share of a lobe that a light covers is one contour integral over the outline clipped at z = 0, and nothing is clipped
// after the transform. Everything is finite for finite input.
#pragma once

#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/ltc_table.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

#include <cstddef>

namespace gonio::shading {

// What a lobe without symmetry about the plane of n and v adds to y': `factor` times x'.
template<class S, bool sheared>
struct LtcShear {
    GONIO_FORCE_INLINE S operator()(S /*x*/, S y) const { return y; }
    GONIO_FORCE_INLINE S undone(S /*x*/, S y) const { return y; }
};
template<class S>
struct LtcShear<S, true> {
    S factor;

    GONIO_FORCE_INLINE S operator()(S x, S y) const { return simd::mul_add(factor, x, y); }
    GONIO_FORCE_INLINE S undone(S x, S y) const { return simd::mul_add(-factor, x, y); }
};

// In the frame x (towards which the mirrored view leans), y, z (the normal): x' = m00 x + m02 z, y' = m11 y, z' = m20 x
// + m22 z. That of an anisotropic surface is sheared too.
template<class S, bool sheared = false>
struct LtcLobe {
    S m00, m02, m11, m20, m22;
    S horizon_x, horizon_z; // unit normal of the horizon in the transformed space; its y is 0
    S albedo;               // directional albedo for F = 1
    S grazing;              // for F = (1 − l·h)⁵; 0 for a diffuse lobe
    [[no_unique_address]] LtcShear<S, sheared> shear{};

    GONIO_FORCE_INLINE vec3<S> operator()(vec3<S> p) const {
        const S x = simd::mul_add(m00, p.x, m02 * p.z);
        return {x, shear(x, m11 * p.y), simd::mul_add(m20, p.x, m22 * p.z)};
    }
    GONIO_FORCE_INLINE S determinant() const { return m11 * simd::mul_add(m00, m22, -(m02 * m20)); }
    // The square of the most by which it stretches a length in the plane of x' and y'.
    GONIO_FORCE_INLINE S stretch2_across() const {
        const S along2 = simd::mul_add(m00, m00, m02 * m02);
        if constexpr (sheared)
            return simd::mul_add(m11, m11, simd::mul_add(shear.factor * shear.factor, along2, along2));
        else
            return simd::max(along2, m11 * m11);
    }
    GONIO_FORCE_INLINE vec3<S> horizon() const { return {horizon_x, S(0), horizon_z}; }
};

namespace detail {

// The lobe of an entry's six numbers (LtcEntry), for n·v = μ and ‖n×v‖ = s; `width` is α, or 1 for a diffuse lobe.
template<class S>
GONIO_FORCE_INLINE LtcLobe<S> lobe_from(S along, S raised, S across, S slant, S albedo, S grazing, S width, S mu, S s) {
    constexpr double least = 1e-18;
    LtcLobe<S> lobe;
    lobe.m00 = simd::max(simd::mul_add(along, mu, raised * s * s), S(least));
    lobe.m02 = simd::mul_add(raised, mu, -along) * s;
    lobe.m11 = across;
    lobe.m20 = width * slant * s;
    lobe.m22 = width;
    const S inverse = S(1) / simd::sqrt(simd::mul_add(lobe.m00, lobe.m00, lobe.m20 * lobe.m20));
    lobe.horizon_x = -(lobe.m20 * inverse);
    lobe.horizon_z = lobe.m00 * inverse;
    lobe.albedo = albedo;
    lobe.grazing = grazing;
    return lobe;
}

// Interpolates between the four entries about (x, y), both in [0, 1], by their columns and rows.
template<class S>
GONIO_FORCE_INLINE LtcLobe<S> interpolated_lobe(const LtcEntry* table, std::size_t size, S x, S y, S width, S mu, S s) {
    using T = simd::value_of<S>;
    constexpr std::size_t lanes = simd::Traits<S>::lanes;
    constexpr std::size_t fields = 6;
    T at_x[lanes];
    T at_y[lanes];
    T corners[4][fields][lanes];
    const auto last = static_cast<double>(size - 1);
    const S scaled_x = simd::min(simd::max(x, S(0)), S(1)) * S(last);
    const S scaled_y = simd::min(simd::max(y, S(0)), S(1)) * S(last);
    simd::store(scaled_x, &at_x[0]);
    simd::store(scaled_y, &at_y[0]);
    T first_x[lanes];
    T first_y[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        auto column = static_cast<std::size_t>(at_x[lane]);
        auto row = static_cast<std::size_t>(at_y[lane]);
        if (column > size - 2) column = size - 2;
        if (row > size - 2) row = size - 2;
        first_x[lane] = static_cast<T>(column);
        first_y[lane] = static_cast<T>(row);
        const LtcEntry* const corner = table + row * size + column;
        for (std::size_t k = 0; k < 4; ++k) {
            const LtcEntry& e = corner[(k & 1U) + (k >> 1U) * size];
            const float values[fields] = {e.along, e.raised, e.across, e.slant, e.albedo, e.grazing};
            for (std::size_t f = 0; f < fields; ++f)
                corners[k][f][lane] = static_cast<T>(values[f]);
        }
    }
    S from_x, from_y;
    simd::load(&first_x[0], from_x);
    simd::load(&first_y[0], from_y);
    const S share_x = scaled_x - from_x;
    const S share_y = scaled_y - from_y;
    const auto field = [&](std::size_t f) {
        S c00, c10, c01, c11;
        simd::load(&corners[0][f][0], c00);
        simd::load(&corners[1][f][0], c10);
        simd::load(&corners[2][f][0], c01);
        simd::load(&corners[3][f][0], c11);
        const S low = simd::mul_add(share_x, c10 - c00, c00);
        const S high = simd::mul_add(share_x, c11 - c01, c01);
        return simd::mul_add(share_y, high - low, low);
    };
    return lobe_from(field(0), field(1), field(2), field(3), field(4), field(5), width, mu, s);
}

} // namespace detail

// √(1 − c²).
template<class S>
GONIO_FORCE_INLINE S sine_of_cosine(S cosine) {
    return simd::sqrt(simd::max((S(1) - cosine) * (S(1) + cosine), S(0)));
}

// GGX with height-correlated Smith shadowing. α is clamped to [1e-4, 1], n·v to [0, 1]. `sine` is ‖n×v‖: where n·v is
// near 1, `sine` determines the mirrored direction to the last digit, and n·v does not.
template<class S>
GONIO_FORCE_INLINE LtcLobe<S> ltc_ggx(S alpha, S n_dot_v, S sine) {
    const S a = simd::min(simd::max(alpha, S(1e-4)), S(1));
    const S mu = simd::min(simd::max(n_dot_v, S(0)), S(1));
    return detail::interpolated_lobe(&ltc_ggx_table[0], ltc_ggx_size, simd::sqrt(a), simd::sqrt(mu), a, mu, sine);
}
template<class S>
GONIO_FORCE_INLINE LtcLobe<S> ltc_ggx(S alpha, S n_dot_v) {
    return ltc_ggx(alpha, n_dot_v, sine_of_cosine(n_dot_v));
}

// The lobes of one α, for arrays of surface points with the same α: each lookup interpolates between two entries
// instead of four.
template<class S>
class LtcGgxOfAlpha {
public:
    explicit LtcGgxOfAlpha(simd::value_of<S> alpha)
        : alpha_(simd::min(simd::max(alpha, simd::value_of<S>(1e-4)), simd::value_of<S>(1))) {
        const simd::value_of<S> x = simd::sqrt(alpha_) * simd::value_of<S>(ltc_ggx_size - 1);
        auto column = static_cast<std::size_t>(x);
        if (column > ltc_ggx_size - 2) column = ltc_ggx_size - 2;
        const simd::value_of<S> share = x - static_cast<simd::value_of<S>>(column);
        for (std::size_t row = 0; row < ltc_ggx_size; ++row)
            between(&ltc_ggx_table[row * ltc_ggx_size + column], share, &rows_[row][0]);
    }

    // As ltc_ggx(α, n·v, ‖n×v‖), within rounding.
    GONIO_FORCE_INLINE LtcLobe<S> operator()(S n_dot_v, S sine) const {
        constexpr std::size_t lanes = simd::Traits<S>::lanes;
        constexpr auto last = static_cast<double>(ltc_ggx_size - 1);
        const S mu = simd::min(simd::max(n_dot_v, S(0)), S(1));
        simd::value_of<S> at[lanes];
        simd::value_of<S> found[fields][lanes];
        simd::store(simd::sqrt(mu) * S(last), &at[0]);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            auto row = static_cast<std::size_t>(static_cast<int>(at[lane]));
            if (row > ltc_ggx_size - 2) row = ltc_ggx_size - 2;
            const simd::value_of<S> share = at[lane] - static_cast<simd::value_of<S>>(static_cast<int>(row));
            const simd::value_of<S>* const low = &rows_[row][0];
            for (std::size_t f = 0; f < fields; ++f)
                found[f][lane] = low[f] + share * (low[f + padded] - low[f]);
        }
        S value[fields];
        for (std::size_t f = 0; f < fields; ++f)
            simd::load(&found[f][0], value[f]);
        return detail::lobe_from(value[0], value[1], value[2], value[3], value[4], value[5], S(alpha_), mu, sine);
    }

private:
    static constexpr std::size_t fields = 6;
    static constexpr std::size_t padded = 8;

    // An entry and the next one.
    GONIO_FORCE_INLINE static void between(const LtcEntry* at, float share, float* to) {
        using Together [[gnu::vector_size(padded * sizeof(float))]] = float;
        static_assert(sizeof(Together) == sizeof(LtcEntry));
        Together low, high;
        __builtin_memcpy(&low, &at[0], sizeof low);
        __builtin_memcpy(&high, &at[1], sizeof high);
        const Together found = low + share * (high - low);
        __builtin_memcpy(to, &found, sizeof found);
    }
    GONIO_FORCE_INLINE static void between(const LtcEntry* at, double share, double* to) {
        const auto put = [&](std::size_t f, float low, float high) {
            to[f] = static_cast<double>(low) + share * (static_cast<double>(high) - static_cast<double>(low));
        };
        put(0, at[0].along, at[1].along);
        put(1, at[0].raised, at[1].raised);
        put(2, at[0].across, at[1].across);
        put(3, at[0].slant, at[1].slant);
        put(4, at[0].albedo, at[1].albedo);
        put(5, at[0].grazing, at[1].grazing);
    }

    simd::value_of<S> alpha_;
    simd::value_of<S> rows_[ltc_ggx_size][padded] = {};
};

// The renormalised Disney diffuse of albedo 1 (brdf_frostbite.hpp); the linear roughness is clamped to [0, 1].
template<class S>
GONIO_FORCE_INLINE LtcLobe<S> ltc_diffuse(S linear_roughness, S n_dot_v) {
    const S mu = simd::min(simd::max(n_dot_v, S(0)), S(1));
    return detail::interpolated_lobe(&ltc_diffuse_table[0], ltc_diffuse_size, linear_roughness, simd::sqrt(mu), S(1),
                                     mu, sine_of_cosine(mu));
}

// The axes x, y, z of the lobe's frame, and ‖n×v‖.
template<class S>
struct LtcFrame {
    vec3<S> x, y, z;
    S sine;

    GONIO_FORCE_INLINE vec3<S> operator()(vec3<S> p) const { return {dot(x, p), dot(y, p), dot(z, p)}; }
};

// `normal` and `view` (towards the eye) are unit. x is any vector perpendicular to the normal where both are the same.
template<class S>
GONIO_FORCE_INLINE LtcFrame<S> ltc_frame(vec3<S> normal, vec3<S> view) {
    const vec3<S> away = normal * dot(normal, view) - view;
    const vec3<S> leaning = away - normal * dot(normal, away);
    const S square = dot(leaning, leaning);
    constexpr double least = __is_same(S, double) ? 1e-28 : 1e-12;
    const auto upright = square < S(least);
    const vec3<S> x =
        select(upright, TangentFrame<S>(normal).x, leaning * (S(1) / simd::sqrt(simd::max(square, S(least)))));
    return {x, cross(normal, x), normal, simd::sqrt(square)};
}

} // namespace gonio::shading
