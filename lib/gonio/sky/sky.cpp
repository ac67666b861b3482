#include <gonio/base/amount_range.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/sky/sky.hpp>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>
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

Calibration calibration_of(const SkyAmount& amount) {
    switch (amount.measure) {
    case SkyMeasure::horizontal:
        return {Calibration::Of::illuminance, amount.value, up};
    case SkyMeasure::zenith:
        return {Calibration::Of::zenith_luminance, amount.value, up};
    case SkyMeasure::mean:
        break;
    }
    return {Calibration::Of::mean_luminance, amount.value, up};
}

} // namespace

Sky::Sky(Nits uniform, const glm::dvec3& color) : color_(color), scale_(uniform.value) {}

glm::dvec3 Sky::radiance(const glm::dvec3& direction) const {
    if (image_)
        return scale_ *
               image_->radiance(rotation_.value == 0.0 ? direction : turned(direction, Radians(-rotation_.value)));
    if (!cie_) return scale_ * color_;
    if (direction.z < 0.0) return ground_ * color_;
    return scale_ * cie_->relative(direction) * color_;
}

std::vector<glm::dvec3> Sky::irradiance(std::span<const glm::dvec3> normals, unsigned threads) const {
    std::vector<std::size_t> order(normals.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::tie(normals[a].x, normals[a].y, normals[a].z) < std::tie(normals[b].x, normals[b].y, normals[b].z);
    });
    std::vector<glm::dvec3> different;
    std::vector<std::size_t> which(normals.size());
    for (const std::size_t i : order) {
        if (different.empty() || normals[i] != different.back()) different.push_back(normals[i]);
        which[i] = different.size() - 1;
    }
    const std::vector<glm::dvec3> of_each = irradiance_of_each(std::move(different), threads);
    std::vector<glm::dvec3> results;
    results.reserve(normals.size());
    for (const std::size_t index : which)
        results.push_back(of_each[index]);
    return results;
}

std::vector<glm::dvec3> Sky::irradiance_of_each(std::vector<glm::dvec3> normals, unsigned threads) const {
    if (image_) {
        for (glm::dvec3& normal : normals)
            normal = turned(normal, Radians(-rotation_.value));
        normals = image_->irradiance(normals, threads);
        for (glm::dvec3& lx : normals)
            lx *= scale_;
    } else {
        for (glm::dvec3& normal : normals)
            normal = irradiance(normal);
    }
    return normals;
}

glm::dvec3 Sky::irradiance(const glm::dvec3& normal, unsigned threads) const {
    if (image_) return scale_ * image_->irradiance(turned(normal, Radians(-rotation_.value)), threads);
    if (!cie_) return std::numbers::pi * scale_ * color_;
    const double below = 0.5 * std::numbers::pi * (1.0 - normal.z) * ground_;
    return (scale_ * cie_->illuminance(normal) + below) * color_;
}

Nits Sky::zenith() const {
    return Nits(image_ ? glm::dot(radiance(up), rec709_luminance) : scale_);
}

Nits Sky::mean(unsigned threads) const {
    if (image_) return Nits(glm::dot(light(threads), rec709_luminance) / (4.0 * std::numbers::pi));
    return Nits(cie_ ? scale_ * cie_->mean() : scale_);
}

glm::dvec3 Sky::light(unsigned threads) const {
    if (image_) return scale_ * image_->light(threads);
    if (!cie_) return 4.0 * std::numbers::pi * scale_ * color_;
    return 2.0 * std::numbers::pi * (mean().value + ground_) * color_;
}

Result<Sky> resolve_sky(const SkyDescription& description, std::shared_ptr<const EnvironmentMap> image,
                        unsigned threads) {
    Sky sky;
    if (std::holds_alternative<ImageSkyKind>(description.kind)) {
        if (!image) return fail(Failure::internal, "the image of the sky has not been read");
        sky.image_ = std::move(image);
        sky.rotation_ = description.rotation;
        sky.scale_ = 1.0;
        if (description.amount) {
            Result<double> factor = calibration(*sky.image_, calibration_of(*description.amount), threads);
            if (!factor) return pass_on(factor);
            sky.scale_ = *factor;
        }
        return sky;
    }
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
