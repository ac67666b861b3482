// The body of kernels_angles.hpp for one set of operations on doubles. Included only by kernels_angles_<set>.cpp.
#pragma once

#include <gonio/simd/pack.hpp>
#include <gonio/simd/scalar.hpp>
#include <gonio/web/kernels_angles.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::web_detail::detail {

// One double at a time.
struct ScalarDoubles {
    using V = double;
    static constexpr std::size_t lanes = 1;

    GONIO_FORCE_INLINE static V less_than(V a, V b, V if_true, V if_false) { return a < b ? if_true : if_false; }
};

// A register of doubles of an instruction set.
template<class Isa>
struct NativeDoubles {
    static constexpr std::size_t lanes = Isa::lanes / 2;
    using V [[gnu::vector_size(8 * lanes)]] = double;
    using Bits [[gnu::vector_size(8 * lanes)]] = std::int64_t;

    GONIO_FORCE_INLINE static V less_than(V a, V b, V if_true, V if_false) {
        const Bits mask = a < b;
        return __builtin_bit_cast(V, (__builtin_bit_cast(Bits, if_true) & mask) |
                                         (__builtin_bit_cast(Bits, if_false) & ~mask));
    }
};

// The doubles that correspond to a scalar of the other kernels.
template<class S>
struct DoublesFor;
template<>
struct DoublesFor<float> {
    using type = ScalarDoubles;
};
template<class Isa>
struct DoublesFor<simd::pack<float, Isa>> {
    using type = NativeDoubles<Isa>;
};
template<class S>
using DoublesOf = typename DoublesFor<S>::type;

template<class D>
GONIO_FORCE_INLINE typename D::V all(double x) {
    return typename D::V{} + x;
}

// atan2(y, x) in degrees. Beyond tan 22.5°, the angle from 45° is found instead: its tangent is (u − 1)/(u + 1). The
// rational function for tangents up to 0.66 is that of S. L. Moshier's Cephes library (atan.c, 1995): 2e-16.
template<class D>
GONIO_FORCE_INLINE typename D::V angle_deg(typename D::V y, typename D::V x) {
    using V = typename D::V;
    constexpr double pi = 3.141592653589793;
    const V zero = all<D>(0.0);
    const V up = D::less_than(y, zero, -y, y);
    const V along = D::less_than(x, zero, -x, x);
    const V low = D::less_than(up, along, up, along);
    const V high = D::less_than(up, along, along, up);
    const V limit = 0.41421356237309503 * high;
    const V t = D::less_than(limit, low, low - high, low) / D::less_than(limit, low, low + high, high);
    const V z = t * t;
    V p = -8.750608600031904122785e-1 * z - 1.615753718733365076637e1;
    p = p * z - 7.500855792314704667340e1;
    p = p * z - 1.228866684490136173410e2;
    p = p * z - 6.485021904942025371773e1;
    V q = z + 2.485846490142306297962e1;
    q = q * z + 1.650270098316988542046e2;
    q = q * z + 4.328810604912902668951e2;
    q = q * z + 4.853903996359136964868e2;
    q = q * z + 1.945506571482613964425e2;
    V angle = t * (z * p / q) + t;
    angle = D::less_than(limit, low, angle + 0.25 * pi, angle);
    angle = D::less_than(along, up, 0.5 * pi - angle, angle);
    angle = D::less_than(x, zero, pi - angle, angle);
    angle = D::less_than(y, zero, -angle, angle);
    return angle * (180.0 / pi);
}

template<class D>
void angles_deg(std::size_t count, const double* y, const double* x, double* deg) {
    using V = typename D::V;
    std::size_t i = 0;
    for (; i + D::lanes <= count; i += D::lanes) {
        V a, b;
        __builtin_memcpy(&a, y + i, sizeof(V));
        __builtin_memcpy(&b, x + i, sizeof(V));
        const V angle = angle_deg<D>(a, b);
        __builtin_memcpy(deg + i, &angle, sizeof(V));
    }
    if (i == count) return;
    // The rest, with a repeated last pair.
    double last_y[D::lanes];
    double last_x[D::lanes];
    for (std::size_t lane = 0; lane < D::lanes; ++lane) {
        const std::size_t from = i + lane < count ? i + lane : count - 1;
        last_y[lane] = y[from];
        last_x[lane] = x[from];
    }
    V a, b;
    __builtin_memcpy(&a, last_y, sizeof(V));
    __builtin_memcpy(&b, last_x, sizeof(V));
    const V angle = angle_deg<D>(a, b);
    double last[D::lanes];
    __builtin_memcpy(last, &angle, sizeof(V));
    for (std::size_t lane = 0; i + lane < count; ++lane)
        deg[i + lane] = last[lane];
}

} // namespace gonio::web_detail::detail
