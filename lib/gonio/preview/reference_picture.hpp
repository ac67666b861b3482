// The path-traced reference, in passes that refine it. It is used to check the preview's closed forms and shadow
// ratios.
//
// A pass samples one point of each pixel and, for each light with a size, one direction towards the light and one from
// the material, weighted by the balance heuristic (E. Veach and L. Guibas, SIGGRAPH 1995); a ray decides whether the
// light is visible. So each pass is an unbiased picture, anti-aliased and with shadows, that shares neither the closed
// forms nor the shadows of render(). Lights without size and their shadows are exact at each point, and so are masks on
// lights with a size and the profiles of luminous openings. With bounces each pass also follows a path over the stage
// (path_tracer.hpp). The bytes after a pass do not depend on the number of threads.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/result.hpp>
#include <gonio/light/light_parts.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/emissive_lights.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace gonio {

namespace detail {
class PathTracer;
}

class ReferencePicture {
public:
    // Stage and lights must outlive the picture. Uses these options: the size, `shadows` (hard or soft: exact ones),
    // `bounces`, `sky`, `specular`, `illuminance` and `threads`. Fails as render() does.
    static Result<ReferencePicture> begin(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                                          const RenderOptions& options);

    // Skips rows once `stop` returns true; it is called from all threads, once per row. The next pass takes the skipped
    // rows.
    void add_pass(const std::function<bool()>& stop = {});

    // The number of passes of the row with the fewest.
    std::size_t passes() const;

    // The remaining relative error of the surfaces in the picture: half the mean difference between the pictures of the
    // even and the odd passes, over the mean of both. 1 until each row has two passes; 0 for a picture without light.
    // An estimate: the pictures of few passes may agree by chance.
    double error_estimate() const;

    // The picture so far; rows without a pass are black.
    Rendering picture() const;

private:
    ReferencePicture(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                     const RenderOptions& options);

    struct Pixel {
        glm::vec3 surface[2] = {glm::vec3(0.0F), glm::vec3(0.0F)}; // sums of the even and the odd passes [nt]
        glm::vec3 emitter{0.0F};
        float illuminance_lx = 0.0F;
        bool shows_light = false;
    };
    void sample(Pixel& pixel, int x, int y, std::size_t pass) const;
    std::vector<std::uint8_t> subjects() const; // Rendering::shows_subject

    const Stage* stage_;
    std::shared_ptr<const ShiningLights> shining_;
    std::span<const Light> lights_; // of `shining_`
    RenderOptions options_;
    CameraRays rays_;
    EmittedLights emitted_;
    std::vector<Pixel> pixels_;
    std::vector<std::size_t> row_passes_;
    std::shared_ptr<const detail::PathTracer> tracer_;
};

} // namespace gonio
