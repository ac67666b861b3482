// What reaches receivers anywhere on a stage: the share of each light that its objects leave, the light of the sky, and
// indirect light.
#pragma once

#include <gonio/base/diagnostics.hpp>
#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/sky/blurred_sky.hpp>
#include <gonio/transport/interreflection.hpp>
#include <gonio/transport/lighting_options.hpp>

#include <memory>
#include <span>
#include <vector>

namespace gonio {

namespace detail {
class ExchangeGeometry;
struct LitScene;
} // namespace detail

class ReceiverLight {
public:
    // Stage, lights and options must outlive it. Uses these options: shadows, bounces, sky, threads, instruction_set.
    // Fails as Interreflection::of().
    static Result<ReceiverLight> on(const Stage& stage, std::span<const Light> lights, const LightingOptions& options);

    ReceiverLight(ReceiverLight&& other) noexcept;
    ReceiverLight& operator=(ReceiverLight&& other) noexcept;
    ~ReceiverLight();

    struct Shares {
        std::vector<double> visible;     // [receiver][light]: the share of its illuminance, in [0, 1]
        std::vector<double> sky_lx;      // [receiver]; 0 without a sky
        std::vector<double> indirect_lx; // [receiver]; 0 without bounces
    };
    // The normals of the receivers may have any length > 0.
    Shares at(std::span<const Receiver> receivers) const;

private:
    ReceiverLight(std::unique_ptr<detail::LitScene> scene, std::unique_ptr<Interreflection> indirect,
                  std::shared_ptr<const detail::ExchangeGeometry> geometry);

    std::unique_ptr<detail::LitScene> scene_;
    std::vector<std::size_t> faces_;            // of each light: how many of the scene's lights are its faces, or 1
    std::unique_ptr<Interreflection> indirect_; // null without bounces
    // Null where there is neither light that bounced nor a sky that something may hide.
    std::shared_ptr<const detail::ExchangeGeometry> geometry_;
    BlurredSky sky_; // none without a geometry
};

// A warning for each surface that receivers lie in, or behind if it is a plane: the first of them, counted from 1, and
// how many. What lies on a surface and faces away from it is not in it.
Diagnostics check_receivers(const Stage& stage, std::span<const Receiver> receivers);

} // namespace gonio
