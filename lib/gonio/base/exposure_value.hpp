// Exposure values at ISO 100 (ISO 2720): EV of a luminance, with the calibration constant K = 12.5 of a reflected-light
// meter, and of an illuminance, with C = 250 of an incident-light meter. S is float or double.
#pragma once

#include <cmath>
#include <numbers>

#pragma GCC visibility push(default)
namespace gonio {

// L = 2^(EV−3), in cd/m².
template<class S>
S luminance_of_ev(S ev) {
    return std::exp2(ev) / S(8);
}

// Needs L > 0; 0 gives −∞. The 8 goes inside the logarithm, so that values near 0 EV keep their digits.
template<class S>
S ev_of_luminance(S nits) {
    return std::log2(S(8) * nits);
}

// E = 2.5 · 2^EV, in lx.
template<class S>
S illuminance_of_ev(S ev) {
    return S(2.5) * std::exp2(ev);
}

// Needs E > 0; 0 gives −∞. Near 0 EV, log2(1 + x) of the exact x.
template<class S>
S ev_of_illuminance(S lux) {
    const S excess = lux - S(2.5);
    if (std::abs(excess) < S(1)) return std::log1p(excess / S(2.5)) * std::numbers::log2e_v<S>;
    return std::log2(lux / S(2.5));
}

} // namespace gonio
#pragma GCC visibility pop
