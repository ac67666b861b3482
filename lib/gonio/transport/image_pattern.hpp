// A rectangle with an image as weights at points of it, for many receivers at once.
//
// The rectangle is divided into tiles, these into quarters, and so on. Within a tile that is smaller than its distance
// the light that reaches a receiver from a place is a smooth function of the place. It is interpolated between 4×4
// nodes of a Gauss–Legendre rule, and the integral of each of the interpolating polynomials times the image is a weight
// that depends on the image alone. So the sum over nodes is as accurate for an image as the rule is for a uniform
// light.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/light/light_image.hpp>
#include <gonio/transport/kernels_luminance.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace gonio::detail {

class ImagePattern {
public:
    // Images with more pixels than the smallest tiles can show are averaged first.
    ImagePattern(const RectShape& rect, const ImagePlane& image);

    // The mean of the image over the rectangle as each receiver sees it, in [0, 1]; 0 where none of it is above the
    // receiver's horizon. Positions are relative to `anchor`. Receivers in groups of 16 share their tiles.
    void evaluate(const Light& light, const transport::Receivers& receivers, const glm::dvec3& anchor,
                  const transport::LuminanceKernels& kernels, float* share) const;

private:
    static constexpr std::size_t nodes_of_tile = 16;

    struct Level {
        std::size_t columns = 0;
        std::size_t rows = 0;
        std::size_t first = 0; // of its tiles, row by row
    };

    double half_x_;
    double half_y_;
    std::vector<Level> levels_;
    // Of all tiles, 16 each: places on the rectangle [m], and weights, with the image and of a uniform light [m²].
    std::vector<float> x_, y_, image_, uniform_;
};

} // namespace gonio::detail
