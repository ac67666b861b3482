// The light of sky and stage by the methods of engines (SurroundingsMethod), for comparison.
#pragma once

#include <gonio/ibl/irradiance_sh.hpp>
#include <gonio/ibl/prefilter.hpp>
#include <gonio/ibl/split_sum_table.hpp>
#include <gonio/scene/core_material.hpp>
#include <gonio/transport/lighting_options.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gonio::detail {

class NamedSurroundings {
public:
    // Null for `exact`, and for a method of the open sky without a sky. `materials` are those of the surfaces. Uses
    // these options: surroundings, sky, probe, threads.
    static std::shared_ptr<const NamedSurroundings> of(const LightingOptions& options,
                                                       std::span<const CoreMaterial> materials);

    bool has_diffuse() const { return harmonics_.has_value() || irradiance_.has_value(); }
    bool has_glossy() const { return sky_levels_.has_value() || probe_ != nullptr; }

    // Illuminance by the sky, RGB [lx]; of methods that have it.
    glm::dvec3 sky_lx(const glm::dvec3& normal) const;

    // A lobe of a surface's material.
    struct Lobe {
        std::size_t surface;
        double alpha;
        glm::dvec3 albedo; // directional, towards this view
    };
    // The luminance that the lobe shows, RGB [cd/m²]; of methods that have it. Normal and view are unit.
    glm::dvec3 glossy(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec3& view,
                      const Lobe& lobe) const;

private:
    // Of Schlick's reflectance, per channel; nothing where a material has no such lobe or several.
    struct Reflectance {
        glm::dvec3 f0;
        double f90;
    };

    SurroundingsMethod method_ = SurroundingsMethod::exact;
    std::optional<IrradianceSh> harmonics_;
    std::optional<EnvironmentMap> irradiance_; // over π
    std::optional<PrefilteredEnvironment> sky_levels_;
    std::optional<SplitSumTable> table_;
    std::vector<std::optional<Reflectance>> reflectances_; // by surface
    std::shared_ptr<const LocalProbe> probe_;
};

} // namespace gonio::detail
