// A tile of the picture as points on surfaces: rays are cast once, then the points are lit by every light.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/detail/rays_from.hpp>
#include <gonio/scene/emissive_lights.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/transport/light_tree.hpp>
#include <gonio/transport/surface_samples.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gonio::detail {

inline constexpr int tile_size = 32;   // pixels
inline constexpr int block_size = 8;   // pixels; their points on one surface form a chunk
inline constexpr int edge_samples = 4; // along each side of a pixel on an outline
inline constexpr int square_size = 4;  // pixels; what changes little may be computed at the corners

// What a camera ray hit.
struct Seen {
    enum class What : std::uint8_t { nothing, emitter, surface };

    What what = What::nothing;
    std::uint32_t light = 0; // of the emitter
    Hit hit;
    glm::dvec3 view{0.0}; // unit, towards the eye
};

// What every ray of a picture is tested against.
struct RayScene {
    const Stage& stage;
    std::span<const Light> lights;
    const CameraRays& rays;
    const LightTree& bodies;      // of the lights that have a surface which is not the stage's
    const EmittedLights& emitted; // by surfaces of the stage
    int width = 0;
    int height = 0;
};

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
        glm::dvec3 view; // unit, towards the eye
    };
    glm::dvec3 eye() const { return scene_.rays.ray(0.0, 0.0).origin; }
    const std::vector<EmitterShare>& emitters() const { return emitters_; }

    // The share of a pixel that shows nothing of the stage.
    struct OpenShare {
        std::uint32_t pixel;
        float share;
        glm::dvec3 direction; // unit, from the eye
    };
    const std::vector<OpenShare>& open() const { return open_; }

    // Centres of the tile's pixels and of one more pixel on each side, in rows of `stride`.
    const std::vector<Seen>& centers() const { return centers_; }
    std::ptrdiff_t stride() const { return stride_; }

    // Whether the pixel of this centre is the mean of several points, because an outline crosses it.
    bool on_outline(std::size_t center) const { return on_outline_[center] != 0; }

    // Points of a pixel on an outline or a shadow edge; cast at the first request, valid until the next call.
    using FineSamples = std::array<Seen, std::size_t{edge_samples} * edge_samples>;
    const FineSamples& fine(std::size_t center);

    std::uint32_t pixel_of(std::size_t center) const;

private:
    void look_through_centers();
    // What rays_ meet.
    void look(std::span<Seen> seen);
    void find_lights(const Ray& ray, Seen& seen) const;
    void find_outlines();
    void collect();
    void add(const Seen& seen, std::uint32_t pixel, double share, std::int32_t center);
    void bound_surfaces();

    const RayScene& scene_;
    int left_, top_, right_, bottom_;
    std::ptrdiff_t stride_;
    std::vector<std::uint32_t> seen_surfaces_; // those that the tile's rays may meet
    std::vector<std::uint32_t> seen_lights_;   // lights with bodies that they may meet
    RaysFrom rays_; // those that are being cast
    FirstMet first_;
    std::vector<Seen> centers_;
    std::vector<std::uint8_t> on_outline_;
    std::vector<std::int32_t> fine_index_;
    std::vector<FineSamples> fine_;
    std::vector<SurfaceSamples> surfaces_;
    std::vector<EmitterShare> emitters_;
    std::vector<OpenShare> open_;
};

} // namespace gonio::detail
