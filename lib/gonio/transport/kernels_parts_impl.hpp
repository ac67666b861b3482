// The bodies of kernels_parts.hpp, for one scalar: double or simd::doubles. Included only by kernels_parts_<set>.cpp;
// the rule of shading/kernels_impl.hpp applies here too.
#pragma once

#include <gonio/shading/vec3.hpp>
#include <gonio/simd/doubles_math.hpp>
#include <gonio/simd/packet.hpp>
#include <gonio/transport/kernels_parts.hpp>

#include <cstddef>
#include <numbers>

namespace gonio::transport::detail {

using shading::vec3;

// Not fused, so that every set gives the same bits.
template<class S>
GONIO_FORCE_INLINE S plain_dot(const vec3<S>& a, const vec3<S>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// atan(√t)/√t for t from 0 to 0.31, by the seventh convergent of Gauss's continued fraction, to 1e-9. With all digits,
// pictures with bounced light take up to a twentieth longer.
template<class S>
GONIO_FORCE_INLINE S atan_ratio(S t) {
    const S above = S(1.0) + t * (S(23.0 / 15.0) + t * (S(383.0 / 585.0) + t * S(5053.0 / 75075.0)));
    const S below = S(1.0) + t * (S(28.0 / 15.0) + t * (S(14.0 / 13.0) + t * (S(28.0 / 143.0) + t * S(7.0 / 1287.0))));
    return above / below;
}

// The angle that an edge subtends over its length, times `p_s_n`. The ends of an edge are p ± s, so their dot product
// is p² − s² and their cross product 2 p×s.
template<class S>
GONIO_FORCE_INLINE S edge(S pp, S ps, S ss, S p_s_n) {
    const S along = pp - ss;
    const S tangent2 = simd::max(S(4.0) * (pp * ss - ps * ps), S(0.0)) / (along * along);
    return atan_ratio(tangent2) / along * p_s_n;
}

template<class S>
void shares(const FlatParts& parts, const PartShares& to) {
    const vec3<S> x{S(parts.x[0]), S(parts.x[1]), S(parts.x[2])};
    const vec3<S> y{S(parts.y[0]), S(parts.y[1]), S(parts.y[2])};
    const S y_x_n(parts.x[1] * parts.y[0] - parts.x[0] * parts.y[1]); // y·(x×n), where n is Z
    simd::for_each_packet<simd::Packet<S>>(parts.count, [&](const simd::Packet<S>& packet) {
        const vec3<S> t{packet.load(parts.middle[0]), packet.load(parts.middle[1]), packet.load(parts.middle[2])};
        const S half_u = packet.load(parts.half_side[0]);
        const S half_v = packet.load(parts.half_side[1]);
        const S tx = plain_dot(t, x);
        const S ty = plain_dot(t, y);
        // u and v are half of the sides.
        const S tt = plain_dot(t, t);
        const S tu = half_u * tx;
        const S tv = half_v * ty;
        const S t_u_n = half_u * (t.x * x.y - t.y * x.x);
        const S t_v_n = half_v * (t.x * y.y - t.y * y.x);
        const S v_u_n = half_u * half_v * y_x_n; // −u·(v×n)
        const S uu = half_u * half_u;
        const S vv = half_v * half_v;
        const S sum =
            edge(tt - S(2.0) * tv + vv, tu, uu, t_u_n - v_u_n) + edge(tt + S(2.0) * tu + uu, tv, vv, t_v_n - v_u_n) -
            edge(tt + S(2.0) * tv + vv, tu, uu, t_u_n + v_u_n) - edge(tt - S(2.0) * tu + uu, tv, vv, t_v_n + v_u_n);
        const S share = packet.load(parts.factor) * simd::abs(sum) * S(std::numbers::inv_pi);
        packet.store(share, to.share);
        // How the form factor of a small piece changes along the sides.
        const S of_height = S(1.0) / t.z;
        const S of_distance2 = S(4.0) / tt;
        const auto moment = [&](std::size_t side, S axis_z, S along, S half_side) {
            const S half = packet.load(parts.half[side]);
            const S steepness = S(1.0 / 3.0) * half_side * (axis_z * of_height - of_distance2 * along);
            packet.store(share * (packet.load(parts.at[side]) + half * steepness), to.moment[side]);
        };
        moment(0, x.z, tx, half_u);
        moment(1, y.z, ty, half_v);
    });
}

extern const PartKernels kernels_parts_scalar;
extern const PartKernels kernels_parts_sse2;
extern const PartKernels kernels_parts_avx2;
extern const PartKernels kernels_parts_avx512;
extern const PartKernels kernels_parts_neon;
extern const PartKernels kernels_parts_wasm128;

} // namespace gonio::transport::detail
