// Illuminance, luminance and reflectance of many points on the widest vector unit: pieces of columns that stay in the
// first cache, on all threads. Nothing of Python: compiled for speed, where the rest is glue.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/material.hpp>

#include "columns.hpp"

#include <cstddef>
#include <vector>

namespace gonio::python {

struct Points {
    Vectors positions; // [m]
    Vectors normals;   // of any length > 0
    std::size_t count;
};

// Whether the packs compute this light as the closed form does: a uniform surface of one part, or a point.
bool fits_packs_alone(const Light& light);

// [lx], one per point, of such lights together.
void illuminance_in_packs(const std::vector<Light>& lights, const Points& points, unsigned threads, float* lx);

// The Y of the colours towards an eye [cd/m²], highlights by ltc.
void luminance_in_packs(const std::vector<Light>& lights, const Points& points, const glm::dvec3& eye,
                        const Material& material, unsigned threads, float* nits);

// In the frame of the surface, of any length > 0.
struct WaysOfLight {
    Vectors to_light;
    Vectors to_eye;
    std::size_t count;
};

// [1/sr], three for each pair: in rows, or in columns one after the other.
void reflectance_in_packs(const Material& material, const WaysOfLight& ways, bool by_columns, unsigned threads,
                          float* rgb);

} // namespace gonio::python
