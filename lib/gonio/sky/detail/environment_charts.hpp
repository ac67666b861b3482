// The parts of a layout in which texels are cells between two families of planes through the centre: faces of a cube,
// octants, and slices of a lat-long between two meridians.
#pragma once

#include <gonio/sky/detail/spherical_polygon.hpp>
#include <gonio/sky/environment_layout.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>

namespace gonio::detail {

// A face of a cube at a place of the picture: the direction of a point is middle + s across + t down, s and t from −1
// at the left and top to 1.
struct CubeFace {
    glm::dvec3 middle;
    glm::dvec3 across;
    glm::dvec3 down;
    int column; // of the picture, in faces
    int row;
};

// The six faces of a cube layout.
const std::array<CubeFace, 6>& cube_faces(EnvironmentLayout layout);

// The face that a texel lies in; nullptr for a corner of a cross.
const CubeFace* face_of(EnvironmentLayout layout, int side, TexelIndex texel);

// A texel as convex polygons. Those of neighbours share their sides exactly, so that all of them cover the sphere once.
struct TexelPolygons {
    std::array<SphericalPolygon, 2> part;
    std::size_t count = 0;
};

// Of a cube or an octahedral texel; for a lat-long, of slice `slice` of `slices` into which meridians divide it: its
// parallels are chords there.
TexelPolygons polygons_of(const EnvironmentGrid& grid, TexelIndex texel, int slice = 0, int slices = 1);

// The number of slices with which a lat-long texel's polygons have its solid angle within 2e-6: 2048 in the picture. 1
// for other layouts.
int slices_of(const EnvironmentGrid& grid);

} // namespace gonio::detail
