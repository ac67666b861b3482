// One tile of a picture: its points under every light that may reach them.
#pragma once

#include <gonio/preview/detail/tile_samples.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/transport/lit_scene.hpp>
#include <gonio/transport/point_form.hpp>
#include <gonio/transport/sample_shader.hpp>
#include <gonio/transport/soft_shadow.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace gonio::detail {

// Adds to the pixels of this tile in the picture, in the order of the lights, and to the `stats` and the `partial`
// lights passed to it.
class LitTile {
public:
    LitTile(const LitScene& scene, const RenderOptions& options, const RayScene& rays, int left, int top,
            Rendering& picture, RenderStats& stats, std::vector<PartialLight>& partial);

    void light_up();

private:
    struct Far;
    struct Group { // chunks of one surface that a light may reach
        const SurfaceSamples* samples;
        std::vector<std::uint32_t> chunks;
    };

    void show_emitters();
    void show_sky();
    void show_subjects();
    void add(std::uint32_t pixel, const glm::dvec3& nt);
    // `surface` emits the light, or no_surface.
    void add_part(const TileSamples::EmitterShare& seen, std::size_t surface, const glm::dvec3& rgb);
    void add_to_part(const SurfaceSamples& samples, std::size_t i, const glm::vec3& nt);
    void complete_parts();
    void count_samples();
    void add_surroundings();
    void add(const SurfaceSamples& samples, std::size_t i, const glm::vec3& nt, float lx);
    std::vector<std::uint32_t> candidates() const;
    bool find_groups(const LitLight& light);
    void find_shadows(const LitLight& light);
    void find_edges();
    // The share of a light that reaches a point: of its illuminance, and of the luminance that the surface shows.
    struct Visible {
        float lx = 1.0F;
        glm::vec3 rgb{1.0F};

        bool is_none() const { return lx == 0.0F && rgb == glm::vec3(0.0F); }
    };
    // One for each point of a surface; valid until the next call.
    const std::vector<Visible>& visible_at(const LitLight& light, std::size_t surface, const ShadowPoints& points);
    void find_centers();
    void shade(const LitLight& light, const Group& group);
    // What the shader gave a chunk, through what is `visible` of the light.
    void gather(const SurfaceSamples& samples, const SurfaceSamples::Chunk& chunk, const Visible* visible);
    // What was gathered becomes part of the picture.
    void add_gathered();
    // The chunks of a group that are so far from the light that it may be seen from its centre are left for later.
    void set_aside(std::uint32_t index, Group& group);
    void shade_far();
    void find_forms(Far& far);
    // Whether the light as a point, or from its centre, stays within the error at every point of the chunk; adds it if
    // so.
    bool adds_as_point(const Far& far, const SurfaceSamples::Chunk& chunk);
    bool adds_from_center(const LitLight& light, std::size_t of_surface, const SurfaceSamples::Chunk& chunk);
    // The same for what the shader gave with a bound.
    bool adds_shaded(std::size_t of_surface, const SurfaceSamples::Chunk& chunk);
    void shade_edges(const LitLight& light);

    const LitScene& scene_;
    const RenderOptions& options_;
    TileSamples tile_;
    Rendering& picture_;
    RenderStats& stats_;
    std::vector<PartialLight>& partial_;
    std::vector<glm::vec3> glossy_; // of the samples of a surface [nt], all lobes
    SampleShader shader_;

    // What a surface that emits a partial light reflects in that part of the pixel.
    struct Reflected {
        float share = 0.0F; // of the pixel
        glm::vec3 nt{0.0F}; // its contribution to the pixel
    };
    std::map<std::pair<std::uint32_t, std::size_t>, Reflected> reflected_; // by pixel and surface
    std::vector<std::size_t> part_surfaces_;                               // of each of partial_

    // Of all samples of a surface: three channels [nt], and lux if they are asked for.
    using Amounts = std::array<std::vector<float>, 4>;
    std::size_t channels() const { return options_.illuminance ? 4 : 3; }
    const std::vector<float>& shaded(std::size_t channel) const; // what the shader gave last
    // What the samples of each surface of the tile have got so far. Added to the pixels after the last light: most
    // lights reach whole chunks, whose sums are in packs.
    std::vector<Amounts> gathered_;
    // Every so many points of a chunk, which are closer together: two rows of pixels.
    static constexpr std::size_t of_part = 16;
    static constexpr std::size_t most_parts = 4;
    struct ChunkPart {
        SampleBounds points;
        ViewBounds views;
    };
    // With RenderOptions::error: how far what was gathered may be from the exact light, and what bounds that.
    struct Known {
        Amounts error;
        std::optional<LobeVariation> lobe;
        std::vector<std::vector<ChunkPart>> parts; // of each chunk; made when it is first asked for
    };
    std::vector<Known> known_; // for each surface of the tile
    // A light and a chunk far away.
    struct Far {
        double part; // radius of the light over the distance
        std::uint32_t light;
        std::uint32_t surface; // of the tile's
        std::uint32_t chunk;
        // Of the light as a point, for each part of the chunk, or for all of it.
        struct Forms {
            std::array<PointForm, most_parts> of_parts{};
            std::size_t of_each = 0; // points
            bool are_bounded = false;
            double most_lx = std::numeric_limits<double>::infinity();
        };
        Forms forms;
    };
    std::vector<Far> far_;

    // For the light that is being added:
    std::vector<Group> groups_;
    bool is_shadowed_ = false;
    SoftShadow soft_shadow_;
    // The centres that show each surface, and the same as points.
    struct Centers {
        std::size_t surface;
        std::vector<std::uint32_t> index;
        ShadowPoints points;
    };
    std::vector<Centers> centers_;        // made for the first light with shadows
    std::vector<Visible> center_visible_; // for each centre; 1 where no surface is visible
    ShadowPoints within_;                 // points of pixels on outlines
    std::vector<Visible> visible_at_;
    std::vector<std::uint8_t> on_shadow_edge_; // for each centre
    std::vector<std::size_t> edges_;           // the centres on a shadow edge
    std::vector<float> weight_;
    std::vector<Visible> visible_;
};

} // namespace gonio::detail
