// The path-traced reference, in passes that refine it: it checks the preview's closed forms and shadow ratios.
//
// A pass draws one point of each pixel and, for each light with a size, one direction towards the light and one of the
// material's own, weighed by the balance heuristic (E. Veach and L. Guibas, SIGGRAPH 1995); whether a light is seen is
// a ray. So each pass is an unbiased picture, anti-aliased and with shadows, that shares neither the closed forms nor
// the shadows of render(). Lights without size and their shadows are exact at each point, as masks on lights with a
// size are. Points and directions are additive recurrences in seven dimensions (M. Roberts, "The Unreasonable
// Effectiveness of Quasirandom Sequences", 2018), turned by a number of the pixel and the light's own: the bytes after
// a pass do not depend on threads.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/result.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/core_material.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace gonio {

class ReferencePicture {
public:
    // Stage and lights must outlive it. Of the options the size, `shadows` (hard or soft: true ones), `illuminance` and
    // `threads` are read. Fails as render().
    static Result<ReferencePicture> begin(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                                          const RenderOptions& options);

    // Rows may be left out when `stop` says so, which is asked from all threads, once a row; the next pass takes them.
    void add_pass(const std::function<bool()>& stop = {});

    // Of the row that has the fewest.
    std::size_t passes() const;

    // The remaining error of the picture, relative: half the mean difference between the pictures of the even and the
    // odd passes, over the mean of both; of what surfaces show. 1 before each row has two, 0 of a picture without
    // light. An estimate: the pictures of few passes may agree by chance.
    double error_estimate() const;

    // As far as it is; rows without a pass are black.
    Rendering picture() const;

private:
    ReferencePicture(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                     const RenderOptions& options);

    struct Pixel {
        glm::vec3 surface[2] = {glm::vec3(0.0F), glm::vec3(0.0F)}; // sums of the even and of the odd passes [nt]
        glm::vec3 emitter{0.0F};
        float illuminance_lx = 0.0F;
        bool shows_light = false;
    };
    void sample(Pixel& pixel, int x, int y, std::size_t pass) const;

    const Stage* stage_;
    std::span<const Light> lights_;
    RenderOptions options_;
    CameraRays rays_;
    std::vector<CoreMaterial> materials_; // one for each surface
    std::vector<std::uint8_t> is_dark_;   // of each light
    std::vector<Pixel> pixels_;
    std::vector<std::size_t> row_passes_;
};

} // namespace gonio
