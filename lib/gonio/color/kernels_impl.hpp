// The bodies of the kernels, for one scalar: locus.hpp over arrays. Included only by kernels_<set>.cpp.
//
// Only templates with S in their name may be instantiated from here: code compiled for a wide instruction set must not
// be a function that other files could call.
#pragma once

#include <gonio/color/kernels.hpp>
#include <gonio/color/locus.hpp>
#include <gonio/simd/packet.hpp>

#include <cstddef>

namespace gonio::color::detail {

template<class S>
GONIO_FORCE_INLINE void constants(const RgbConstants& from, RgbRows<S>& to) {
    for (int i = 0; i < 3; ++i) {
        to.a[i] = S(from.a[i]);
        to.b[i] = S(from.b[i]);
        to.c[i] = S(from.c[i]);
    }
}

template<class S>
GONIO_FORCE_INLINE void store_rgb(const simd::Packet<S>& packet, const RgbOf<S>& color, float* const rgb[3]) {
    packet.store(color.r, rgb[0]);
    packet.store(color.g, rgb[1]);
    packet.store(color.b, rgb[2]);
}

// T / 1000 K if the temperature is in range, else NaN, which propagates to every result.
template<class S>
GONIO_FORCE_INLINE S kilokelvin(S temperature) {
    const S known =
        simd::select(simd::both(temperature >= S(800), temperature <= S(1e6F)), temperature, S(__builtin_nanf("")));
    return known * S(1e-3F);
}
template<class S>
GONIO_FORCE_INLINE S t_of(S temperature) {
    return S(1) / kilokelvin(temperature);
}

template<class S>
void uv_prime_any(const float* temperature_k, std::size_t count, float* const uv_prime[2]) {
    simd::for_each_packet<simd::Packet<S>>(count, [&](const simd::Packet<S>& packet) {
        const LocusJet<S> at = locus_jet<0>(t_of(packet.load(temperature_k)));
        packet.store(at.u, uv_prime[0]);
        packet.store(at.v, uv_prime[1]);
    });
}

template<class S>
void planckian_any(const float* temperature_k, std::size_t count, const RgbConstants& space, float* const rgb[3]) {
    RgbRows<S> rows;
    constants(space, rows);
    simd::for_each_packet<simd::Packet<S>>(count, [&](const simd::Packet<S>& packet) {
        store_rgb(packet, planckian_rgb(rows, kilokelvin(packet.load(temperature_k))), rgb);
    });
}

template<class S>
void cct_any(const float* temperature_k, const float* duv, std::size_t count, const RgbConstants& space,
             float* const rgb[3]) {
    RgbRows<S> rows;
    constants(space, rows);
    simd::for_each_packet<simd::Packet<S>>(count, [&](const simd::Packet<S>& packet) {
        const S offset = packet.load(duv);
        const S greatest = S(0.1F);
        const S known =
            simd::select(simd::both(offset >= -greatest, offset <= greatest), offset, S(__builtin_nanf("")));
        store_rgb(packet, off_locus_rgb(rows, t_of(packet.load(temperature_k)), known), rgb);
    });
}

template<class S>
void krystek_any(const float* temperature_k, std::size_t count, const RgbConstants& space, float* const rgb[3]) {
    RgbRows<S> rows;
    constants(space, rows);
    simd::for_each_packet<simd::Packet<S>>(count, [&](const simd::Packet<S>& packet) {
        store_rgb(packet, krystek_rgb(rows, packet.load(temperature_k)), rgb);
    });
}

template<class S>
constexpr Kernels kernels_of(simd::InstructionSet set, const char* name) {
    return {set, name, simd::Traits<S>::lanes, uv_prime_any<S>, planckian_any<S>, cct_any<S>, krystek_any<S>};
}

// The kernel tables, each in the file that is compiled for its set.
extern const Kernels kernels_scalar;
extern const Kernels kernels_sse2;
extern const Kernels kernels_avx2;
extern const Kernels kernels_avx512;
extern const Kernels kernels_neon;
extern const Kernels kernels_wasm128;

} // namespace gonio::color::detail
