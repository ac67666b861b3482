#include <gonio/base/unit_text.hpp>
#include <gonio/sky/detail/angle_pair.hpp>
#include <gonio/sky/sky_direction.hpp>

#include <fmt/format.h>

namespace gonio {

Result<SkyAngles> parse_sky_angles(std::string_view text, std::string_view what) {
    Result<detail::AnglePair> pair = detail::parse_angle_pair(text, what, "azimuth/elevation", "180/40");
    if (!pair) return pass_on(pair);
    if (!(pair->second_deg >= -90.0 && pair->second_deg <= 90.0))
        return fail("USE0106",
                    fmt::format("the elevation of {} must lie between -90 and 90 degrees, not {}", what,
                                shortest(pair->second_deg)),
                    "the azimuth comes first, counted from north over east: 180/40 is in the south");
    return SkyAngles{pair->first_deg, pair->second_deg};
}

} // namespace gonio
