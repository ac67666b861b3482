// Camera rays that are cast together, and what each of them meets.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/preview/kernels_camera.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/emissive_lights.hpp>
#include <gonio/scene/rays_from.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/transport/light_tree.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio::detail {

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
    const preview::CameraKernels& kernels;
};

class SeenRays {
public:
    explicit SeenRays(const RayScene& scene) : scene_(scene) {}

    // Rays from the eye, whose directions the caller sets.
    RaysFrom& begin(std::size_t count);
    // Rays through rows of a picture, each through a first point and those so many pixels beside it.
    void begin_grid(double left, double top, std::size_t columns, std::size_t rows);
    // `surfaces` and `lights`: the numbers of those that any of the rays may meet; lights in their order.
    void cast(std::span<const std::uint32_t> surfaces, std::span<const std::uint32_t> lights);

    std::size_t size() const { return kind_.size(); }
    bool is_surface(std::size_t i) const { return kind_[i] >= surface; }
    bool is_emitter(std::size_t i) const { return kind_[i] == emitter; }
    std::size_t surface_of(std::size_t i) const { return static_cast<std::size_t>(first_.number[i]); }
    std::uint32_t light_of(std::size_t i) const { return static_cast<std::uint32_t>(first_.number[i]); }
    // Whether a ray sees this surface of the stage, or else this light.
    bool shows(std::size_t i, bool of_stage, std::uint32_t number) const {
        return (of_stage ? is_surface(i) : is_emitter(i)) && first_.number[i] == number;
    }
    int face_of(std::size_t i) const { return kind_[i] - surface; }
    bool show_the_same(std::size_t i, std::size_t j) const {
        return kind_[i] == kind_[j] && first_.number[i] == first_.number[j];
    }
    glm::dvec3 view_of(std::size_t i) const { return -rays_.at(i).direction; }
    glm::dvec3 position_of(std::size_t i) const { return rays_.origin + first_.distance[i] * rays_.at(i).direction; }
    glm::dvec3 normal_of(std::size_t i) const;
    // Of the rays [first, first + count), by axis: their positions less the anchor, and the views.
    void put_positions(std::size_t first, std::size_t count, const glm::dvec3& anchor, float* const (&to)[3]) const;
    void put_views(std::size_t first, std::size_t count, float* const (&to)[3]) const;
    // Of a grid with so many columns, 1 for those within it that show something else than one of the four beside them,
    // else 0. Leaves out the first and last row and column.
    void put_changes(std::size_t columns, std::span<std::uint8_t> to) const;
    Seen at(std::size_t i) const;

private:
    // Of a surface: the number of its face is added.
    static constexpr std::uint8_t nothing = 0, emitter = 1, surface = 2;

    // The rays [first, first + count).
    preview::CameraRayArrays arrays(std::size_t first, std::size_t count) const;
    void find_faces();
    void find_lights(std::span<const std::uint32_t> lights);

    const RayScene& scene_;
    RaysFrom rays_;
    FirstMet first_; // by the number of a surface, or of a light
    std::vector<std::uint8_t> kind_;
};

} // namespace gonio::detail
