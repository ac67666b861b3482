// The parts that add up to a picture: the share of each light, and the parts that its surfaces reflect.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/preview/render.hpp>

#include <cstddef>
#include <functional>
#include <span>

namespace gonio {

// The picture with all of its lights dark: black, or what else the options add to it, as an ambient sky.
Result<Rendering> render_unlit(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                               const RenderOptions& options);

// Hands over what each light alone adds to the picture of all of them, in their order: what it lights, and itself where
// the camera sees it. The others stand where they stand, dark, so that the shares and `unlit`, which is that of
// render_unlit() with the same arguments, add up to the picture, to the rounding of floats. As costly as a picture for
// each. Stops at the first failure: render()'s, or that of `use`.
Result<void> render_each_light(const Stage& stage, std::span<const Light> lights, const Camera& camera,
                               const RenderOptions& options, const Rendering& unlit,
                               const std::function<Result<void>(std::size_t light, Rendering share)>& use);

// A picture of all lights in three that add up to it, to the rounding of floats.
struct PictureParts {
    Image emission_nt; // lights that are seen themselves
    Image diffuse_nt;
    Image specular_nt; // of a GGX that scatters more than once all of it
};

// `picture` is that of render() with the same arguments. Two more of them.
Result<PictureParts> picture_parts(const Image& picture, Stage stage, std::span<const Light> lights,
                                   const Camera& camera, const RenderOptions& options);

} // namespace gonio
