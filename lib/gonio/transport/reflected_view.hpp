// What a glossy surface shows of the lit stage around it, and of the sky.
#pragma once

#include <gonio/sky/blurred_sky.hpp>
#include <gonio/transport/bundle_caster.hpp>
#include <gonio/transport/interreflection.hpp>
#include <gonio/transport/lobe_rays.hpp>
#include <gonio/transport/surface_samples.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace gonio::detail {

class ExchangeGeometry;

// One for each thread. Lights themselves are not seen: their highlights are direct light.
class ReflectedView {
public:
    // Without `indirect`, surfaces are black; without `sky`, what is around the stage is. They must outlive it.
    ReflectedView(const ExchangeGeometry& geometry, const Interreflection* indirect, const BlurredSky* sky,
                  simd::InstructionSet set);

    // The luminance that the lobe of the samples' surface reflects [nt], for samples [first, first + count).
    const std::vector<glm::vec3>& luminance(const SurfaceSamples& samples, std::size_t first, std::size_t count,
                                            const LobeRays& lobe);

private:
    const ExchangeGeometry& geometry_;
    const Interreflection* indirect_;
    const BlurredSky* sky_;
    ScatteredCaster caster_;
    std::vector<LobeRay> rays_;
    std::array<std::vector<float>, 3> origin_, direction_;
    std::vector<glm::vec3> weight_;
    std::vector<float> ray_width_; // [rad]
    std::vector<std::uint32_t> of_sample_;
    std::vector<PatchPlace> ends_;
    std::vector<float> width_m_;        // of the surface of each chart, where it is thinnest
    std::vector<glm::vec3> all_, kept_; // weights, by sample
    std::vector<glm::vec3> luminance_;
};

} // namespace gonio::detail
