// The parts that add up to a picture: the share of each light, and the parts that surfaces reflect.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/preview/render.hpp>

#include <cstddef>
#include <functional>
#include <span>

namespace gonio {

// The picture with all lights dark: black, or only what the options add, such as a sky.
Result<Rendering> render_unlit(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                               const RenderOptions& options);

// Calls `use` with what each light alone adds to the picture of all of them, in their order: the light on surfaces, and
// the light itself where the camera sees it. The other lights stay in place but are dark, so that the shares and
// `unlit` (the result of render_unlit() with the same arguments) add up to the picture, to float rounding. Costs one
// picture per light. Stops at the first failure of render() or of `use`.
Result<void> render_each_light(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                               const RenderOptions& options, const Rendering& unlit,
                               const std::function<Result<void>(std::size_t light, Rendering share)>& use);

// A picture of all lights as three parts that add up to it, to float rounding.
struct PictureParts {
    Image emission_nt; // lights that are visible themselves
    Image diffuse_nt;
    Image specular_nt; // includes all the light from a GGX with multiple scattering
};

// `picture` is the result of render() with the same arguments. Renders two more pictures.
Result<PictureParts> picture_parts(const Image& picture, Stage stage, std::span<const Light> lights,
                                   const Camera& camera, const RenderOptions& options);

} // namespace gonio
