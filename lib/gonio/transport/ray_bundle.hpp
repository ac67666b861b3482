// What points of a stage see: fixed bundles of rays, and links to small parts of solids that rays would miss. They
// depend on the stage alone, so they are made once for all lights, colours and bounces.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/transport/bundle_caster.hpp>
#include <gonio/transport/patches.hpp>
#include <gonio/transport/ray_caster.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gonio::detail {

// The end of a ray that meets a part of a solid which a link stands for.
inline constexpr std::uint32_t linked = 0xfffffffeU;

// Directions about +Z with the density cosθ/π: a spiral of the golden angle over the unit disk (H. Vogel, 1979), so
// that the mean of a luminance over them, times π, is its illuminance.
std::vector<glm::dvec3> cosine_directions(std::size_t count);

// Two directions at right angles to a unit normal, which is Z.
Frame frame_about(const glm::dvec3& origin, const glm::dvec3& normal);

// What a patch sends, per channel: four floats, which processors add at once.
struct alignas(16) Sent {
    float value[4] = {};

    Sent() = default;
    explicit Sent(const glm::dvec3& rgb)
        : value{static_cast<float>(rgb.x), static_cast<float>(rgb.y), static_cast<float>(rgb.z), 0.0F} {}
    void add(const Sent& other) {
        for (int i = 0; i < 4; ++i)
            value[i] += other.value[i];
    }
    glm::dvec3 rgb() const { return {value[0], value[1], value[2]}; }
};

// A patch, or (from the number of patches on) a cell, and the illuminance at the receiver for what it sends.
struct Link {
    std::uint32_t sender = 0;
    float share = 0.0F; // cosθ cosθ' A/(π d²)
};

struct Receivers {
    struct Place {
        glm::dvec3 position{0.0};
        glm::dvec3 normal{0.0};
        std::size_t own = RayEnd::nothing; // as RayCaster::cast()
        bool left_out = false;
    };
    std::vector<Place> places;
};

class Bundles {
public:
    Bundles() = default;
    // One bundle of `rays` for each place; those left out get none.
    Bundles(const Stage& stage, const Patches& patches, std::span<const Receivers::Place> places, std::size_t rays,
            unsigned threads, simd::InstructionSet set);

    // Of senders that are patches, and then cells, the sum of sent · share.
    glm::dvec3 gathered(std::size_t place, std::span<const Sent> sent) const;

    // The sum of the shares of all patches and cells of a chart.
    double of_chart(std::size_t place, std::size_t chart) const {
        return static_cast<double>(of_charts_[place * charts_ + chart]);
    }
    std::size_t rays() const { return rays_; }
    // The mean over the rays of what comes along those that leave the stage; `along` by ray.
    glm::dvec3 leaving(std::size_t place, std::span<const glm::dvec3> along) const;
    // The share of the rays that meet nothing which sends light.
    double escaping(std::size_t place) const;
    std::size_t memory() const {
        return ends_.size() * sizeof(std::uint32_t) + links_.size() * sizeof(Link) + of_charts_.size() * sizeof(float);
    }

    // Of each ray the patch that it ends on, or `linked`, `no_patch` or `back_side`.
    std::span<const std::uint32_t> ends(std::size_t place) const {
        return std::span(ends_).subspan(place * rays_, rays_);
    }
    std::span<const Link> links(std::size_t place) const {
        return std::span(links_).subspan(first_link_[place], first_link_[place + 1] - first_link_[place]);
    }

private:
    std::size_t rays_ = 1;
    std::vector<std::uint32_t> ends_;
    std::vector<Link> links_;
    std::size_t charts_ = 0;
    std::vector<float> of_charts_;
    std::vector<std::uint32_t> first_link_; // by place, and the end of the last
};

// What each patch sends, followed by the mean of each cell, in the order that senders are numbered.
std::vector<Sent> with_cells(const Patches& patches, std::span<const glm::dvec3> of_patches);

} // namespace gonio::detail
