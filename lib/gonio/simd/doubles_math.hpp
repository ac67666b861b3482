// Elementary functions of a double or of doubles<Isa>, with the same bits on all sets. math.hpp has those of floats,
// and the C library's for single doubles.
#pragma once

#include <gonio/simd/doubles.hpp>

namespace gonio::simd {

// arcsin x for x in [−1, 1], within 2 ulp: x + x r(x²) to 1/2, and π/2 − 2 arcsin √((1−x)/2) beyond. The rational
// function r is the one of FreeBSD's msun (e_asin.c), within 2⁻⁵⁸.
template<class S>
GONIO_FORCE_INLINE S arc_sine(S x) {
    constexpr double over[] = {1.66666666666666657415e-01,  -3.25565818622400915405e-01, 2.01212532134862925881e-01,
                               -4.00555345006794114027e-02, 7.91534994289814532176e-04,  3.47933107596021167570e-05};
    constexpr double under[] = {1.0, -2.40339491173441421878e+00, 2.02094576023350569471e+00,
                                -6.88283971605453293030e-01, 7.70381505559019352791e-02};
    constexpr double half_pi = 1.57079632679489661923;
    const S size = abs(x);
    const auto is_small = size <= S(0.5);
    const S z = select(is_small, x * x, S(0.5) * (S(1) - size));
    S p(over[5]);
    for (int i = 4; i >= 0; --i)
        p = p * z + S(over[i]);
    S q(under[4]);
    for (int i = 3; i >= 0; --i)
        q = q * z + S(under[i]);
    const S root = select(is_small, size, sqrt(z));
    const S small = root + root * (z * p / q);
    return copysign(select(is_small, small, S(half_pi) - S(2) * small), x);
}

} // namespace gonio::simd
