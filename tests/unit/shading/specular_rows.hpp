// The stored reference values of GGX specular reflection of area lights (specular.csv), as lights.
#pragma once

#include <gonio/shading/shade.hpp>

#include "../reference_rows.hpp"
#include "poses.hpp"

#include <string>
#include <vector>

namespace specular {

using gonio::shading::DiskLight;
using gonio::shading::RectangleLight;
using gonio::shading::SphereLight;
using gonio::shading::TubeLight;
using gonio::shading::vec3;

struct Row {
    std::string shape; // "sphere", "disk", "rect", "tube"
    poses::Vec center, axis, across, normal, view;
    double p, q; // radius, or width; height, or length
    double alpha, luminance;
};

inline std::vector<Row> rows(const std::string& kind = {}) {
    std::vector<Row> rows;
    for (const auto& [shape, v] : gonio::test::specular_rows(kind))
        rows.push_back({shape,
                        {v[0], v[1], v[2]},
                        {v[3], v[4], v[5]},
                        {v[6], v[7], v[8]},
                        {v[11], v[12], v[13]},
                        {v[14], v[15], v[16]},
                        v[9],
                        v[10],
                        v[17],
                        v[18]});
    return rows;
}

template<class S>
vec3<S> vec(poses::Vec v) {
    return {static_cast<S>(v.x), static_cast<S>(v.y), static_cast<S>(v.z)};
}

// Calls work(light) with the row's light, positioned around the origin.
template<class S, class Work>
auto with_light(const Row& row, const Work& work) {
    const vec3<S> zero{S(0), S(0), S(0)};
    const vec3<S> one{S(1), S(1), S(1)};
    const vec3<S> axis = vec<S>(row.axis);
    const S p = static_cast<S>(row.p);
    const S q = static_cast<S>(row.q);
    if (row.shape == "sphere") return work(SphereLight<S>{zero, one, p, S(0)});
    if (row.shape == "disk") return work(DiskLight<S>{zero, one, axis, p, S(0), false});
    if (row.shape == "rect") return work(RectangleLight<S>{zero, one, axis, vec<S>(row.across), p, q, S(0), false});
    return work(TubeLight<S>{zero, one, axis, p, q, S(0)});
}

} // namespace specular
