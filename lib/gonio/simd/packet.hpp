// Arrays in packets of one scalar's lanes; the last packet may be partly filled. Included where kernels are compiled
// for a set.
#pragma once

#include <gonio/simd/doubles.hpp>
#include <gonio/simd/pack.hpp>

#include <cstddef>

namespace gonio::simd {

// One packet of the arrays: full, or the first `count` lanes with the last of them repeated.
template<class S>
struct Packet {
    using scalar = S;
    std::size_t first;
    std::size_t count;

    GONIO_FORCE_INLINE S load(const value_of<S>* from) const {
        S value;
        if (count == Traits<S>::lanes) {
            simd::load(from + first, value);
        } else {
            simd::load_partial(from + first, count, value);
        }
        return value;
    }
    GONIO_FORCE_INLINE void store(S value, value_of<S>* to) const {
        if (count == Traits<S>::lanes) {
            simd::store(value, to + first);
        } else {
            simd::store_partial(value, to + first, count);
        }
    }
};

// Calls work(packet) for each packet of `count` elements; P is Packet or a class derived from it.
template<class P, class Work>
GONIO_FORCE_INLINE void for_each_packet(std::size_t count, const Work& work) {
    constexpr std::size_t lanes = Traits<typename P::scalar>::lanes;
    P packet;
    packet.first = 0;
    packet.count = lanes;
    for (; packet.first + lanes <= count; packet.first += lanes)
        work(packet);
    packet.count = count - packet.first;
    if (packet.count > 0) work(packet);
}

} // namespace gonio::simd
