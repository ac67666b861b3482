// The body of kernels_angles.hpp for one scalar: double or simd::doubles. Included only by kernels_angles_<set>.cpp;
// the rule of shading/kernels_impl.hpp applies here too.
#pragma once

#include <gonio/simd/doubles_math.hpp>
#include <gonio/simd/packet.hpp>
#include <gonio/web/kernels_angles.hpp>

#include <cstddef>

namespace gonio::web_detail::detail {

template<class S>
void angles_deg(std::size_t count, const double* y, const double* x, double* deg) {
    simd::for_each_packet<simd::Packet<S>>(count, [&](const simd::Packet<S>& packet) {
        packet.store(simd::angle_deg(packet.load(y), packet.load(x)), deg);
    });
}

} // namespace gonio::web_detail::detail
