#include <gonio/base/amount_range.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/sky/sky.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <numbers>
#include <variant>

namespace gonio {

namespace {

constexpr glm::dvec3 up{0.0, 0.0, 1.0};

// The relative luminance to which an amount of 1 corresponds: E/Lz, 1 or mean/Lz.
double relative_amount(const CieSky& sky, SkyMeasure measure) {
    switch (measure) {
    case SkyMeasure::horizontal:
        return sky.illuminance(up);
    case SkyMeasure::zenith:
        return 1.0;
    case SkyMeasure::mean:
        break;
    }
    return sky.mean();
}

} // namespace

Sky::Sky(Nits uniform, const glm::dvec3& color) : color_(color), scale_(uniform.value) {}

glm::dvec3 Sky::radiance(const glm::dvec3& direction) const {
    if (!cie_) return scale_ * color_;
    if (direction.z < 0.0) return ground_ * color_;
    return scale_ * cie_->relative(direction) * color_;
}

glm::dvec3 Sky::irradiance(const glm::dvec3& normal) const {
    if (!cie_) return std::numbers::pi * scale_ * color_;
    const double below = 0.5 * std::numbers::pi * (1.0 - normal.z) * ground_;
    return (scale_ * cie_->illuminance(normal) + below) * color_;
}

Nits Sky::zenith() const {
    return Nits(scale_);
}

Nits Sky::mean() const {
    return Nits(cie_ ? scale_ * cie_->mean() : scale_);
}

glm::dvec3 Sky::light() const {
    if (!cie_) return 4.0 * std::numbers::pi * scale_ * color_;
    return 2.0 * std::numbers::pi * (mean().value + ground_) * color_;
}

Result<Sky> resolve_sky(const SkyDescription& description) {
    Sky sky;
    sky.color_ = description.color;
    double on_ground_lx = 0.0; // sky and sun together
    if (const auto* const daylight = std::get_if<DaylightSkyKind>(&description.kind)) {
        SkyAngles at = daylight->refraction ? apparent_solar_position(daylight->place, daylight->time)
                                            : solar_position(daylight->place, daylight->time);
        if (!(at.elevation_deg > 0.0))
            return fail("USE0106",
                        fmt::format("the sun is {} degrees below the horizon at this place and time",
                                    rounded(-at.elevation_deg, 3)),
                        "check the zone of the time, and that east is positive in place=LATITUDE/LONGITUDE; there is "
                        "no daylight at night");
        const WeatherRow& weather = info_of(daylight->weather);
        const DaylightAvailability light =
            daylight_availability(at.elevation_deg, daylight->time.day_of_year(), daylight->weather);
        const glm::dvec3 direction = turned(direction_of(at), description.rotation);
        Result<const CieSkyType*> type = find_cie_sky(weather.cie_type);
        if (!type) return pass_on(type);
        sky.cie_.emplace(**type, direction);
        sky.scale_ = light.sky.value / sky.cie_->illuminance(up);
        if (weather.shows_sun) sky.sun_ = SunLight{direction, light.sun, daylight->sun_color, sun_diameter};
        on_ground_lx = light.sky.value + light.sun.value * direction.z;
    } else {
        const SkyAmount amount = description.amount.value_or(SkyAmount());
        if (const auto* const cie = std::get_if<CieSkyKind>(&description.kind)) {
            sky.cie_.emplace(*cie->type, turned(direction_of(cie->sun), description.rotation));
            sky.scale_ = amount.value / relative_amount(*sky.cie_, amount.measure);
            on_ground_lx = sky.scale_ * sky.cie_->illuminance(up);
        } else {
            sky.scale_ = amount.measure == SkyMeasure::horizontal ? amount.value * std::numbers::inv_pi : amount.value;
        }
    }
    sky.ground_ = description.ground * on_ground_lx * std::numbers::inv_pi;
    if (!in_amount_range(sky.scale_))
        return fail("USE0106", fmt::format("the luminance of the sky is above {} cd/m2", greatest_amount));
    return sky;
}

} // namespace gonio
