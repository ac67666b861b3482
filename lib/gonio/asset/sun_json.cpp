#include <gonio/asset/detail/sun_json.hpp>
#include <gonio/sky/sky_direction.hpp>

namespace gonio::detail {

Json to_json(const std::optional<SunLight>& sun) {
    if (!sun) return {};
    const SkyAngles at = sky_angles_of(sun->direction);
    return {{"azimuth_deg", at.azimuth_deg},
            {"elevation_deg", at.elevation_deg},
            {"illuminance_lx", sun->illuminance.value},
            {"diameter_deg", to_degrees(sun->diameter)},
            {"color", Json::array({sun->color.x, sun->color.y, sun->color.z})}};
}

} // namespace gonio::detail
