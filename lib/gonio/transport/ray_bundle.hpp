// What points of a stage see: fixed bundles of rays, and links to small parts of surfaces that rays would miss. They
// depend on the stage and on where lights are alone, so they are made once for all amounts, colours and bounces.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/transport/bundle_caster.hpp>
#include <gonio/transport/patches.hpp>
#include <gonio/transport/ray_caster.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

namespace gonio::detail {

// The end of a ray that meets a part of a small solid which a link stands for.
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
    glm::dvec3 rgb() const { return {value[0], value[1], value[2]}; }
};

// A sum that stays in one register.
class SentSum {
public:
    void add(const Sent& sent) { four_ += four(sent); }
    void add(float weight, const Sent& sent) { four_ += weight * four(sent); }
    glm::dvec3 rgb() const { return {four_[0], four_[1], four_[2]}; }
    // By the sum of the fourth numbers, which must not be 0.
    glm::vec3 mean() const { return glm::vec3(four_[0], four_[1], four_[2]) / four_[3]; }
    float weight() const { return four_[3]; }
    bool is_empty() const { return weight() == 0.0F; }

private:
    using Four [[gnu::vector_size(16)]] = float;
    static Four four(const Sent& sent) {
        Four four;
        std::memcpy(&four, sent.value, sizeof four);
        return four;
    }
    Four four_ = {};
};

// How much what rays carry of each patch changes over it, along u and v. With means alone, light that is brighter in
// the nearer part of a patch would weigh too little, by 1 % on a ceiling beside a lit wall.
struct SentSlope {
    Sent along_u, along_v;
};
struct SentSlopes {
    std::vector<SentSlope> by_rays; // by patch
    // By sender, of what links carry; none where that is all the same. Of a cell close to a light, the moments [m]
    // about the middle of what its links carry.
    std::vector<SentSlope> by_links;
    const SentSlope& of_links(std::uint32_t sender) const { return (by_links.empty() ? by_rays : by_links)[sender]; }
};
SentSlopes slopes_of(const Patches& patches, std::span<const glm::dvec3> sent);

// A patch, or (from the number of patches on) a cell or (after those) a group of cells, and the illuminance at the
// receiver for what it sends.
struct Link {
    std::uint32_t sender = 0;
    float share = 0.0F; // cosθ cosθ' A/(π d²)
};

// Of a patch that is close: the moments of its form factor about its middle, in sides. Of a cell, the slopes of the
// form factor [1/m].
struct LinkSlope {
    std::uint32_t sender = 0;
    float along_u = 0.0F;
    float along_v = 0.0F;
};

struct Receivers {
    struct Place {
        glm::dvec3 position{0.0};
        glm::dvec3 normal{0.0};
        std::size_t own = RayEnd::nothing; // as RayCaster::cast()
        bool left_out = false;
        std::size_t ray_factor = 1; // times the rays of others
        bool is_fine = false;       // asks by many rays which parts of bright patches are seen
        bool is_coarse = false;     // what it gathers need not be exact: links stand for more of each solid
    };
    std::vector<Place> places;
};

class Bundles {
public:
    Bundles() = default;
    // One bundle of `rays` times its factor for each place; those left out get none.
    Bundles(const Stage& stage, const Patches& patches, std::span<const Receivers::Place> places, std::size_t rays,
            unsigned threads, simd::InstructionSet set);

    // The sum of sent · share, by sender; by every `step`th ray.
    glm::dvec3 gathered(std::size_t place, std::span<const Sent> sent, std::size_t step = 1) const;

    // What slopes add to it.
    glm::dvec3 gathered(std::size_t place, const SentSlopes& slopes) const;

    // The sum of the shares of all senders of a chart.
    double of_chart(std::size_t place, std::size_t chart) const {
        return static_cast<double>(of_charts_[place * charts_ + chart]);
    }
    // The mean over the rays of a place of what comes along those that leave the stage; `along` by ray.
    glm::dvec3 leaving(std::size_t place, std::span<const glm::dvec3> along) const;
    // The share of the rays that meet nothing which sends light.
    double escaping(std::size_t place) const;
    std::size_t memory() const;

    // Of the rays of a place that has any, about the axes of frame_about() its normal.
    const DirectionArrays& directions(std::size_t place) const {
        const std::size_t rays = ends(place).size();
        return *std::find_if(directions_.begin(), directions_.end(),
                             [rays](const DirectionArrays& of) { return of.size() == rays; });
    }
    // Where each ray ends, or `linked`, `no_patch` or `back_side`; empty for a place that is left out.
    std::span<const PatchPoint> ends(std::size_t place) const {
        return std::span(ends_).subspan(first_end_[place], first_end_[place + 1] - first_end_[place]);
    }
    std::span<const Link> links(std::size_t place) const { return of_place(&OfBlock::links, first_link_, place); }

private:
    // The links of this many places stay together as they were made: all in one array would be copied once more.
    static constexpr std::size_t places_together = 64;
    struct OfBlock {
        std::vector<Link> links;
        std::vector<LinkSlope> slopes;
    };
    template<class Element>
    std::span<const Element> of_place(std::vector<Element> OfBlock::*of, const std::vector<std::uint32_t>& first,
                                      std::size_t place) const {
        const std::size_t block = place / places_together;
        return std::span(blocks_[block].*of)
            .subspan(first[place] - first[block * places_together], first[place + 1] - first[place]);
    }
    std::span<const LinkSlope> link_slopes(std::size_t place) const {
        return of_place(&OfBlock::slopes, first_link_slope_, place);
    }

    std::vector<DirectionArrays> directions_; // for each number of rays
    std::vector<std::size_t> first_end_;      // by place, and the end of the last
    std::vector<PatchPoint> ends_;
    std::vector<OfBlock> blocks_;
    std::size_t charts_ = 0;
    std::vector<float> of_charts_;
    std::vector<std::uint32_t> first_link_;       // by place, and the end of the last, in all blocks
    std::vector<std::uint32_t> first_link_slope_; // the same
};

// What each patch sends, followed by the mean of each cell and of each group of cells, in the order that senders are
// numbered.
std::vector<Sent> by_sender(const Patches& patches, std::span<const glm::dvec3> of_patches);

} // namespace gonio::detail
