// Elementary functions of a double or of doubles<Isa>, with the same bits on all sets. math.hpp has those of floats,
// and the C library's for single doubles.
#pragma once

#include <gonio/simd/doubles.hpp>

namespace gonio::simd {

// arcsin x for x in [−1, 1], within 2 ulp: x + x r(x²) to 1/2, and π/2 − 2 arcsin √((1−x)/2) beyond. The rational
// function r is the one of FreeBSD's msun (e_asin.c), within 2⁻⁵⁸. For floats, too, where all sets should have the same
// bits: math.hpp's arcsine is fused.
template<class S>
GONIO_FORCE_INLINE S arc_sine(S x) {
    constexpr double over[] = {1.66666666666666657415e-01,  -3.25565818622400915405e-01, 2.01212532134862925881e-01,
                               -4.00555345006794114027e-02, 7.91534994289814532176e-04,  3.47933107596021167570e-05};
    constexpr double under[] = {1.0, -2.40339491173441421878e+00, 2.02094576023350569471e+00,
                                -6.88283971605453293030e-01, 7.70381505559019352791e-02};
    constexpr double half_pi = 1.57079632679489661923;
    const auto number = [](double of) { return S(static_cast<value_of<S>>(of)); };
    const S size = abs(x);
    const auto is_small = size <= S(0.5);
    const S z = select(is_small, x * x, S(0.5) * (S(1) - size));
    S p = number(over[5]);
    for (int i = 4; i >= 0; --i)
        p = p * z + number(over[i]);
    S q = number(under[4]);
    for (int i = 3; i >= 0; --i)
        q = q * z + number(under[i]);
    const S root = select(is_small, size, sqrt(z));
    const S small = root + root * (z * p / q);
    return copysign(select(is_small, small, number(half_pi) - S(2) * small), x);
}

// The angle of (x, y) from +X towards +Y in degrees, in [−180°, 180°], within 1e-13° of atan2; the sign of y, 0 for
// y = −0. NaN where both are 0, one is infinite or NaN. Beyond tan 22.5° the angle from 45° is found instead, whose
// tangent is (u − 1)/(u + 1). The rational function for tangents up to 0.66 is that of S. L. Moshier's Cephes library
// (atan.c, 1995), within 2e-16.
template<class S>
GONIO_FORCE_INLINE S angle_deg(S y, S x) {
    constexpr double pi = 3.14159265358979323846;
    constexpr double over[] = {-8.750608600031904122785e-1, -1.615753718733365076637e1, -7.500855792314704667340e1,
                               -1.228866684490136173410e2, -6.485021904942025371773e1};
    constexpr double under[] = {2.485846490142306297962e1, 1.650270098316988542046e2, 4.328810604912902668951e2,
                                4.853903996359136964868e2, 1.945506571482613964425e2};
    const S up = abs(y);
    const S along = abs(x);
    const auto is_steep = along < up;
    const S low = select(is_steep, along, up);
    const S high = select(is_steep, up, along);
    const auto is_beyond = S(0.41421356237309503) * high < low;
    const S t = select(is_beyond, low - high, low) / select(is_beyond, low + high, high);
    const S z = t * t;
    S p(over[0]);
    S q = z + S(under[0]);
    for (int i = 1; i < 5; ++i) {
        p = p * z + S(over[i]);
        q = q * z + S(under[i]);
    }
    S angle = t * (z * p / q) + t;
    angle = select(is_beyond, angle + S(0.25 * pi), angle);
    angle = select(is_steep, S(0.5 * pi) - angle, angle);
    angle = select(x < S(0), S(pi) - angle, angle);
    angle = select(y < S(0), -angle, angle);
    return angle * S(180.0 / pi);
}

} // namespace gonio::simd
