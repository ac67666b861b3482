#include <gonio/base/amount_range.hpp>
#include <gonio/light/light.hpp>
#include <gonio/light/light_image.hpp>
#include <gonio/light/light_parts.hpp>
#include <gonio/light/luminaire.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/light/shape_traits.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/web.hpp>

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace gonio {

namespace {

bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Pictures and engines store all of these as 32-bit floats.
Result<void> check_amount(const Light& light) {
    const auto check = [](double value, const char* quantity, const char* unit) -> Result<void> {
        if (in_amount_range(value)) return {};
        return fail(
            "USE0106",
            fmt::format("the light has a {} of {} {}, above {} {}", quantity, value, unit, greatest_amount, unit),
            "its amount is too large, or too large for its size");
    };
    if (Result<void> checked = check(light.intensity.value, "luminous intensity", "cd"); !checked) return checked;
    if (Result<void> checked = check(light.luminance.value, "luminance", "cd/m2"); !checked) return checked;
    if (Result<void> checked = check(light.illuminance.value, "illuminance", "lx"); !checked) return checked;
    const double size = with_traits(light.shape, [](const auto& kind, auto traits) { return traits.largest(kind); });
    if (!in_amount_range(size))
        return fail("USE0106", fmt::format("a light of {} m is larger than {} m", size, greatest_amount));
    if (std::isfinite(light.web_scale)) return {};
    return fail(Failure::usage, "the profile is too dark to be scaled to an amount",
                "its greatest intensity is almost 0");
}

} // namespace

Candelas Light::intensity_towards(const glm::dvec3& direction) const {
    if (parts != nullptr && body == nullptr) {
        Candelas sum;
        for (const Light& part : *parts)
            sum = sum + part.intensity_towards(direction);
        return sum;
    }
    const glm::dvec3 local = frame.to_local(direction);
    if (const auto* profile = std::get_if<ProfileShape>(&shape))
        return Candelas(web_scale * profile->web->candela(local));
    const double share = with_traits(shape, [&](const auto& kind, auto traits) { return traits.shown(kind, local); });
    if (!(share > 0.0)) return {};
    if (emission != nullptr) return intensity * (share * luminance_share(direction));
    if (image != nullptr) return intensity * (share * image_share(shape, *image, local));
    const Web* const mask = mask_of(shape).web;
    return intensity * (mask != nullptr ? share * web_scale * mask->candela(local) : share);
}

double Light::luminance_share(const glm::dvec3& direction) const {
    if (emission != nullptr) {
        const glm::dvec3 local = emission->luminaire.to_local(direction);
        const double projected_m2 = emission->body->projected_area_m2(local);
        return projected_m2 > 0.0 ? std::fmax(web_scale * emission->web->candela(local) / projected_m2, 0.0) : 0.0;
    }
    if (image != nullptr) return image->mean();
    const Web* const mask = mask_of(shape).web;
    return mask != nullptr ? std::fmax(web_scale * mask->candela(frame.to_local(direction)), 0.0) : 1.0;
}

double Light::luminance_share_at(const glm::dvec3& viewer, const glm::dvec3& toward) const {
    const auto* const rect = std::get_if<RectShape>(&shape);
    if (image == nullptr || rect == nullptr) return luminance_share(-toward);
    const glm::dvec3 from = frame.to_local(viewer - frame.origin);
    const glm::dvec3 along = frame.to_local(toward);
    if (along.z == 0.0) return image->mean();
    const double t = -from.z / along.z;
    return image->pixel(place_on(*rect, from.x + t * along.x, from.y + t * along.y));
}

bool Light::has_pattern() const {
    return emission != nullptr || image != nullptr || mask_of(shape).web != nullptr;
}

Result<Light> resolve_light(LightDescription description, Diagnostics& diagnostics) {
    return resolve_light(std::move(description), diagnostics, {});
}

Result<Light> resolve_light(LightDescription description, Diagnostics& diagnostics, const OpeningBodies& known) {
    if (!finite(description.position)) return fail("USE0106", "a light's position must be finite");
    if (!finite(description.direction) || !(glm::length(description.direction) > 0.0))
        return fail("USE0106", "a light's direction must be finite and not zero");
    if (!finite(description.up)) return fail("USE0106", "a light's up must be finite");
    if (description.range && !(description.range->value > 0.0))
        return fail("USE0106", "a light's range must be greater than 0");
    if (!(description.level >= 0.0 && description.level <= 1.0))
        return fail("USE0106", "a light's level must lie in 0 to 1");
    if (Result<void> loaded = load_profile(description.shape, diagnostics); !loaded) return pass_on(loaded);

    Light light;
    light.name = std::move(description.name);
    light.shape = std::move(description.shape);
    light.color = description.color;
    light.range = description.range;
    light.emitted_by = description.emitted_by;
    light.frame = aimed_frame(description.position, description.direction, description.up);
    const double c = std::cos(description.rotation.value);
    const double s = std::sin(description.rotation.value);
    const glm::dvec3 x = light.frame.x;
    const glm::dvec3 y = light.frame.y;
    light.frame.x = c * x + s * y;
    light.frame.y = c * y - s * x;

    const auto* profile = std::get_if<ProfileShape>(&light.shape);
    if (!description.intensity) {
        if (profile == nullptr)
            return fail("USE0104", std::string("a ") + kind_of(light.shape) + " light needs an intensity",
                        class_of(light.shape) == ShapeClass::sun ? "for example 100klx" : "for example 800lm");
        light.intensity = peak(*profile->web).intensity * description.level;
        light.web_scale = description.level;
        give_body(light, diagnostics, known);
        if (Result<void> placed = place_parts(light); !placed) return pass_on(placed);
        return light;
    }
    Result<Emission> emission = emission_of(light.shape, *description.intensity);
    if (!emission) return pass_on(emission);
    light.intensity = emission->intensity * description.level;
    light.luminance = emission->luminance * description.level;
    light.illuminance = emission->illuminance * description.level;
    if (profile != nullptr) light.web_scale = light.intensity / peak(*profile->web).intensity;
    const Mask mask = mask_of(light.shape);
    if (mask.web != nullptr) light.web_scale = 1.0 / peak(*mask.web).intensity.value;
    if (mask.image != nullptr) light.image = mask.image->luminance();
    if (Result<void> checked = check_amount(light); !checked) return pass_on(checked);
    give_body(light, diagnostics, known);
    if (Result<void> placed = place_parts(light); !placed) return pass_on(placed);
    return light;
}

Result<void> add_resolved(std::vector<LightDescription> descriptions, std::vector<Light>& lights,
                          Diagnostics& diagnostics) {
    for (LightDescription& description : descriptions) {
        Result<Light> light = resolve_light(std::move(description), diagnostics);
        if (!light) return pass_on(light);
        lights.push_back(std::move(*light));
    }
    return {};
}

} // namespace gonio
