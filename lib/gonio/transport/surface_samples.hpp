// Points on one surface of a stage, in the arrays that the kernels read.
#pragma once

#include <gonio/transport/sample_bounds.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gonio::detail {

struct SurfacePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0}; // unit
    glm::dvec3 view{0.0};   // unit, towards the eye; not read where only irradiance is computed
};

struct SurfaceSamples {
    struct Chunk {
        std::size_t first = 0;
        std::size_t count = 0;
        SampleBounds bounds;
    };

    std::size_t surface = 0;
    glm::dvec3 anchor{0.0}; // positions are relative to it, so that all are near 0
    std::array<std::vector<float>, 3> position;
    std::array<std::vector<float>, 3> normal;
    std::array<std::vector<float>, 3> view;
    std::vector<float> share;         // of its pixel
    std::vector<std::uint32_t> pixel; // of a picture, or any other number of whoever adds the points
    std::vector<std::int32_t> center; // index of the tile's centre that it belongs to; −1 for other points of a pixel
    std::vector<Chunk> chunks;
    BoundsBuilder bounds_builder;
    SampleBounds bounds; // of all samples, and of the surface points at the pixels around the tile

    std::size_t size() const { return pixel.size(); }
    glm::dvec3 position_of(std::size_t i) const {
        return anchor + glm::dvec3(position[0][i], position[1][i], position[2][i]);
    }
    glm::dvec3 normal_of(std::size_t i) const { return {normal[0][i], normal[1][i], normal[2][i]}; }
    glm::dvec3 view_of(std::size_t i) const { return {view[0][i], view[1][i], view[2][i]}; }
    void reserve(std::size_t count);
    void add(const SurfacePoint& point, std::uint32_t of_pixel, double share_of_pixel, std::int32_t of_center);
    // Whole pixels, a rectangle of a picture and of a tile's centres.
    struct PixelBlock {
        std::uint32_t first_pixel;
        std::int32_t first_center;
        std::size_t columns;
        std::size_t rows;
        std::uint32_t pixels_of_row; // of the picture
        std::int32_t centers_of_row; // of the tile
    };
    // Adds pixels, row by row, whose positions, normals and views the caller sets, and returns the index of the first.
    // Its position is the anchor if there is none yet.
    std::size_t add_pixels(const glm::dvec3& first_position, const PixelBlock& block);
    // Makes a chunk of the points added since the last one.
    void finish_chunk();
};

// Points of a picture on one surface in squares: what changes little within one may be computed at its corners.
struct SampleSquares {
    static constexpr std::uint32_t none = 0xffffffffU;
    struct Within {
        std::uint32_t square = none;
        float u = 0.0F, v = 0.0F; // between its corners, in [0, 1)
    };

    SurfaceSamples corners;                            // of all squares
    std::vector<std::array<std::uint32_t, 4>> squares; // their corners: u changes first
    std::vector<Within> of_sample;                     // of the samples that the squares are made for
};

} // namespace gonio::detail
