// The light of a sky on the surfaces of a stage, past all that stands on it.
//
// The nodes of an ExchangeGeometry sum up what comes along those of their rays that leave the stage; between nodes it
// is interpolated. What the sum of all rays lacks to the illuminance of an open plane is added to flat surfaces in
// proportion to the rays that leave, so an open one has no error. README.md has that of others.
#pragma once

#include <gonio/light/light.hpp>
#include <gonio/scene/stage.hpp>
#include <gonio/sky/blurred_sky.hpp>
#include <gonio/transport/lighting_options.hpp>
#include <gonio/transport/node_tree.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace gonio {

class Interreflection;

} // namespace gonio

namespace gonio::detail {

class ExchangeGeometry;

class SkyLight {
public:
    // Uses these options: sky, shadows, threads. The geometry must have rays of nodes.
    SkyLight(const LightingOptions& options, std::shared_ptr<const ExchangeGeometry> geometry);

    // That of `indirect`, which may be null, or else one without what only bounces need. Null for a dark sky.
    static std::shared_ptr<const SkyLight> on(const Stage& stage, std::span<const Light> lights,
                                              const LightingOptions& options, const Interreflection* indirect);

    // Illuminance of a point of a surface, RGB [lx].
    glm::dvec3 on_surface(std::size_t surface, int face, const glm::dvec3& position) const;

    // The same by node of the geometry.
    std::span<const NodeValue> nodes_lx() const { return lx_; }

    const std::shared_ptr<const ExchangeGeometry>& geometry() const { return geometry_; }
    const BlurredSky& sky() const { return sky_; }

private:
    std::shared_ptr<const ExchangeGeometry> geometry_;
    BlurredSky sky_;
    std::vector<NodeValue> lx_;
};

// The same at any point, with `rays` rays of its own; `normal` is unit, and `open_lx` the illuminance of an open plane
// with it. Uses these options: shadows, instruction_set.
glm::dvec3 sky_light_at(const BlurredSky& sky, const LightingOptions& options, const ExchangeGeometry& geometry,
                        const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec3& open_lx,
                        std::size_t rays);

} // namespace gonio::detail
