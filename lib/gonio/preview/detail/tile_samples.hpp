// A tile of the picture as points on surfaces: rays are cast once, then the points are lit by every light.
#pragma once

#include <gonio/preview/detail/seen_rays.hpp>
#include <gonio/transport/surface_samples.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gonio::detail {

inline constexpr int tile_size = 32;   // pixels
inline constexpr int block_size = 8;   // pixels; their points on one surface form a chunk
inline constexpr int edge_samples = 4; // along each side of a pixel on an outline
inline constexpr int square_size = 4;  // pixels; what changes little may be computed at the corners

class ThinLights;

class TileSamples {
public:
    TileSamples(const RayScene& scene, int left, int top);

    int left() const { return left_; }
    int top() const { return top_; }
    int right() const { return right_; }
    int bottom() const { return bottom_; }

    // By surface; only the visible ones.
    const std::vector<SurfaceSamples>& surfaces() const { return surfaces_; }

    // Squares of pixels whose corners all show the face of a surface that the pixels in them do.
    SampleSquares squares_of(const SurfaceSamples& samples) const;

    // The share of a pixel that shows a light itself, alone or as a surface of the stage.
    struct EmitterShare {
        std::uint32_t pixel;
        std::uint32_t light;
        float share;
        float widening;  // as of a PartialLight
        glm::dvec3 view; // unit, towards the eye
    };
    glm::dvec3 eye() const { return scene_.rays.eye(); }
    const std::vector<EmitterShare>& emitters() const { return emitters_; }

    // The share of a pixel that shows nothing of the stage.
    struct OpenShare {
        std::uint32_t pixel;
        float share;
        glm::dvec3 direction; // unit, from the eye
    };
    const std::vector<OpenShare>& open() const { return open_; }

    // Centres of the tile's pixels and of one more pixel on each side, in rows of `stride`.
    const SeenRays& centers() const { return centers_; }
    std::ptrdiff_t stride() const { return stride_; }

    // Whether the pixel of this centre is the mean of several points, because an outline crosses it.
    bool on_outline(std::size_t center) const { return (mixed_[center] & outline) != 0; }

    // The part of a centre's pixel that no thin light covers, in [0, 1].
    float share_of(std::size_t center) const { return thin_of_pixel_.empty() ? 1.0F : thin_of_pixel_[center].left; }

    // Points of a pixel on an outline or a shadow edge, past thin lights; cast at the first request, valid until the
    // next call.
    using FineSamples = std::array<Seen, std::size_t{edge_samples} * edge_samples>;
    const FineSamples& fine(std::size_t center);

    std::uint32_t pixel_of(std::size_t center) const;
    std::size_t center_at(int x, int y) const { // of a pixel of the tile
        return static_cast<std::size_t>((y - top_ + 1) * stride_ + x - left_ + 1);
    }

private:
    void look_through_centers();
    void find_outlines();
    // Which points of thin lights nothing hides, and what they leave of their pixels.
    void look_at(const ThinLights& thin);
    void collect();
    SurfaceSamples& samples_of(std::size_t surface);
    // The centres of a rectangle as whole pixels, which all show the same.
    void add_block(std::size_t first, std::size_t columns, std::size_t rows);
    void add_mixed_rows(std::size_t first, std::size_t columns, std::size_t rows);
    void add_thin_lights(std::size_t center);
    void add(const Seen& seen, std::uint32_t pixel, double share, std::int32_t center, float widening = 1.0F);
    void bound_surfaces();

    const RayScene& scene_;
    int left_, top_, right_, bottom_;
    std::ptrdiff_t stride_;
    std::vector<std::uint32_t> seen_surfaces_; // those that the tile's rays may meet
    std::vector<std::uint32_t> seen_lights_;   // lights with bodies that they may meet
    SeenRays centers_;
    SeenRays within_pixel_; // the rays of one pixel that are being cast
    struct ThinOfPixel {    // of thin_seen_
        std::uint32_t first = 0, count = 0;
        float left = 1.0F; // of the pixel
    };
    std::vector<ThinOfPixel> thin_of_pixel_; // by centre; empty without thin lights
    struct ThinSeen {
        Seen seen;
        float share; // of the pixel
        float widening;
    };
    std::vector<ThinSeen> thin_seen_;
    static constexpr std::uint8_t outline = 1, thin_light = 2;
    std::vector<std::uint8_t> mixed_; // by centre: why its pixel shows more than that, or 0
    std::vector<std::int32_t> fine_index_;
    std::vector<FineSamples> fine_;
    std::vector<SurfaceSamples> surfaces_;
    std::vector<EmitterShare> emitters_;
    std::vector<OpenShare> open_;
};

} // namespace gonio::detail
