#include <gonio/light/light.hpp>
#include <gonio/web/metrics.hpp>

#include <cmath>
#include <utility>

namespace gonio {

namespace {

bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

Candelas Light::intensity_towards(const glm::dvec3& direction) const {
    if (const auto* profile = std::get_if<ProfileShape>(&shape))
        return Candelas(web_scale * profile->web->candela(frame.to_local(direction)));
    return intensity;
}

Result<Light> resolve_light(LightDescription description, Diagnostics& diagnostics) {
    if (!finite(description.position)) return fail(Failure::usage, "a light's position must be finite");
    if (!finite(description.direction) || !(glm::length(description.direction) > 0.0))
        return fail(Failure::usage, "a light's direction must be finite and not zero");
    if (!finite(description.up)) return fail(Failure::usage, "a light's up must be finite");
    if (description.range && !(description.range->value > 0.0))
        return fail(Failure::usage, "a light's range must be greater than 0");
    if (Result<void> loaded = load_profile(description.shape, diagnostics); !loaded) return pass_on(loaded);

    Light light;
    light.name = std::move(description.name);
    light.shape = std::move(description.shape);
    light.color = description.color;
    light.range = description.range;
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
            return fail(Failure::usage, std::string("a ") + kind_of(light.shape) + " light needs an intensity",
                        "give for example 800lm");
        light.intensity = peak(*profile->web).intensity;
        return light;
    }
    Result<Candelas> intensity = intensity_of(light.shape, *description.intensity);
    if (!intensity) return pass_on(intensity);
    light.intensity = *intensity;
    if (profile != nullptr) light.web_scale = *intensity / peak(*profile->web).intensity;
    if (std::holds_alternative<SphereShape>(light.shape)) {
        const Result<double> nits = express(light.shape, *intensity, {find_unit("nt"), std::nullopt});
        if (!nits) return Unexpected(nits.error());
        light.luminance = Nits(*nits);
    }
    return light;
}

} // namespace gonio
