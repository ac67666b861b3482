// The body of kernels.hpp for one set of operations on doubles. Included only by kernels_<set>.cpp.
#pragma once

#include <gonio/bake/kernels.hpp>
#include <gonio/simd/native.hpp>
#include <gonio/simd/pack.hpp>
#include <gonio/simd/scalar.hpp>

#include <cstddef>
#include <cstdint>

namespace gonio::bake::detail {

// One double at a time.
struct ScalarDoubles {
    using V = double;
    using Bits = std::int64_t;
    static constexpr std::size_t lanes = 1;

    GONIO_FORCE_INLINE static V max(V a, V b) { return a > b ? a : b; }
    GONIO_FORCE_INLINE static V min(V a, V b) { return a < b ? a : b; }
    GONIO_FORCE_INLINE static V to_float(V x, float* texels) {
        *texels = static_cast<float>(x);
        return static_cast<double>(*texels);
    }
    GONIO_FORCE_INLINE static double lane(V x, std::size_t /*which*/) { return x; }
    GONIO_FORCE_INLINE static V ascending() { return 0.0; }
};

// A register of doubles of an instruction set; `Native` has the operations that vector extensions lack.
template<class Isa>
struct NativeDoubles {
    using Native = simd::Native<Isa>;
    using V = typename Native::half_double;
    static constexpr std::size_t lanes = Isa::lanes / 2;
    using Bits [[gnu::vector_size(8 * lanes)]] = std::int64_t;

    GONIO_FORCE_INLINE static V max(V a, V b) { return Native::max(a, b); }
    GONIO_FORCE_INLINE static V min(V a, V b) { return Native::min(a, b); }
    GONIO_FORCE_INLINE static V to_float(V x, float* texels) {
        const auto single = Native::narrow(x, x);
        __builtin_memcpy(texels, &single, lanes * sizeof(float));
        return Native::low(single);
    }
    GONIO_FORCE_INLINE static double lane(V x, std::size_t which) { return x[which]; }
    GONIO_FORCE_INLINE static V ascending() {
        V x{};
        for (std::size_t i = 0; i < lanes; ++i)
            x[i] = static_cast<double>(i);
        return x;
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

template<class D>
GONIO_FORCE_INLINE typename D::V absolute(typename D::V x) {
    const typename D::Bits magnitude = typename D::Bits{} + INT64_MAX;
    return __builtin_bit_cast(typename D::V, __builtin_bit_cast(typename D::Bits, x) & magnitude);
}

// Rounds to the nearest multiple of `step`, a power of two, ties to even: the sum drops the lower bits.
template<class D>
GONIO_FORCE_INLINE typename D::V to_multiple(typename D::V x, typename D::V step) {
    const typename D::V room = step * 0x1.8p52;
    return (x + room) - room;
}

// as_stored() of texture.hpp, and the texels themselves.
template<class D, TexelType type>
GONIO_FORCE_INLINE typename D::V stored(typename D::V value, float* texels) {
    using V = typename D::V;
    if constexpr (type == TexelType::float32) {
        return D::to_float(value, texels);
    } else if constexpr (type == TexelType::half) {
        const V single = D::to_float(value, texels);
        // 11 bits; the last is at least 2⁻²⁴.
        const typename D::Bits exponent = typename D::Bits{} + 0x7FF0000000000000;
        const V power =
            D::max(__builtin_bit_cast(V, __builtin_bit_cast(typename D::Bits, single) & exponent), all<D>(0x1p-14));
        const V rounded = to_multiple<D>(single, power * 0x1p-10);
        // Infinite beyond 65504, otherwise nothing is added.
        const V beyond = D::max(rounded - 65504.0, all<D>(0.0)) * 1e300 * 1e300;
        return D::to_float(rounded + beyond, texels);
    } else {
        constexpr double steps = type == TexelType::uint16 ? 65535.0 : 255.0;
        const V kept = to_multiple<D>(D::min(value, all<D>(1.0)) * steps, all<D>(1.0)) / steps;
        D::to_float(kept, texels);
        return kept;
    }
}

// Eight sums and maxima, of the texels k with the same k mod 8: this number does not depend on the width.
inline constexpr std::size_t strands = 8;

template<class D, TexelType type>
RampTotals store(const Ramp& ramp, float* texels, std::size_t count) {
    using V = typename D::V;
    constexpr std::size_t registers = strands / D::lanes;
    V sum[registers] = {};
    V error[registers] = {};
    V rounding[registers] = {};
    V least[registers] = {};
    const V ascending = D::ascending();
    for (std::size_t begin = 0; begin < count; begin += strands) {
        const bool whole = begin + strands <= count;
        float last[strands];
        float* const to = whole ? texels + begin : last;
        for (std::size_t r = 0; r < registers; ++r) {
            V k = ascending + static_cast<double>(begin + r * D::lanes);
            V counts = all<D>(1.0);
            if (!whole) {
                // Past the end, repeat the last texel with a weight of 0.
                counts = D::max(D::min(static_cast<double>(count) - k, all<D>(1.0)), all<D>(0.0));
                k = D::min(k, all<D>(static_cast<double>(count - 1)));
            }
            const V exact = k * ramp.mean_step + ramp.mean;
            const V wanted = D::max(exact, all<D>(0.0));
            const V kept = stored<D, type>(wanted, to + r * D::lanes);
            sum[r] = sum[r] + (whole ? kept : kept * counts);
            error[r] = D::max(absolute<D>(kept - (k * ramp.center_step + ramp.center)), error[r]);
            rounding[r] = D::max(absolute<D>(kept - wanted), rounding[r]);
            least[r] = D::min(exact, least[r]);
        }
        if (!whole) __builtin_memcpy(texels + begin, last, (count - begin) * sizeof(float));
    }
    RampTotals totals;
    for (std::size_t strand = 0; strand < strands; ++strand) {
        const std::size_t r = strand / D::lanes;
        const std::size_t lane = strand % D::lanes;
        const auto keep = [](double a, double b, bool larger) { return larger == (a > b) ? a : b; };
        totals.sum += D::lane(sum[r], lane);
        totals.error = keep(D::lane(error[r], lane), totals.error, true);
        totals.rounding = keep(D::lane(rounding[r], lane), totals.rounding, true);
        totals.least = keep(D::lane(least[r], lane), totals.least, false);
    }
    return totals;
}

template<class D>
RampTotals store_any(const Ramp& ramp, TexelType type, float* texels, std::size_t count) {
    switch (type) {
    case TexelType::half:
        return store<D, TexelType::half>(ramp, texels, count);
    case TexelType::uint16:
        return store<D, TexelType::uint16>(ramp, texels, count);
    case TexelType::uint8:
        return store<D, TexelType::uint8>(ramp, texels, count);
    case TexelType::float32:
        break;
    }
    return store<D, TexelType::float32>(ramp, texels, count);
}

} // namespace gonio::bake::detail
