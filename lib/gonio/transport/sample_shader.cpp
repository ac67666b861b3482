#include <gonio/light/light_color.hpp>
#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/material_description.hpp>
#include <gonio/scene/probe_light.hpp>
#include <gonio/transport/sample_shader.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <type_traits>
#include <variant>

namespace gonio::detail {

namespace {

std::array<float*, 3> pointers(std::array<std::vector<float>, 3>& channels, std::size_t count) {
    std::array<float*, 3> to{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        channels[channel].resize(count);
        to[channel] = channels[channel].data();
    }
    return to;
}

// The guards of 1 cm that renderers use in 1/d², as factors on the intensity of a light without size.
void guard(IrradianceMethod method, const shading::Surfaces& surfaces, const shading::LightConstants& light,
           std::vector<float>& cd) {
    constexpr float square_cm = 1e-4F;
    if (method != IrradianceMethod::frostbite && method != IrradianceMethod::ue4) return;
    for (std::size_t i = 0; i < surfaces.count; ++i) {
        float d2 = 0.0F;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float way = light.position[axis] - surfaces.position[axis][i];
            d2 += way * way;
        }
        cd[i] *= method == IrradianceMethod::frostbite ? d2 / std::max(d2, square_cm) : d2 / (d2 + square_cm);
    }
}

shading::Surfaces surfaces_of(const SurfaceSamples& samples, std::size_t first, std::size_t count) {
    shading::Surfaces surfaces;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        surfaces.position[axis] = samples.position[axis].data() + first;
        surfaces.normal[axis] = samples.normal[axis].data() + first;
        surfaces.view[axis] = samples.view[axis].data() + first;
    }
    surfaces.count = count;
    return surfaces;
}

transport::Receivers receivers(const shading::Surfaces& surfaces) {
    return {{surfaces.position[0], surfaces.position[1], surfaces.position[2]},
            {surfaces.normal[0], surfaces.normal[1], surfaces.normal[2]},
            surfaces.count};
}

template<class Core>
constexpr bool has_lobe = requires {
    requires Core::lobe != shading::LobeKind::none;
};

// Of the material's lobe, the narrower one if it has a coat; nothing for a material without a lobe.
std::optional<double> lobe_alpha(const CoreMaterial& material) {
    return std::visit(
        []<class Core>(const Core& core) -> std::optional<double> {
            if constexpr (std::is_same_v<Core, shading::Coated> || has_lobe<Core>)
                return shading::lobe_alpha(core);
            else
                return std::nullopt;
        },
        material);
}

bool is_grey(const Material& material) {
    bool grey = true;
    std::visit(
        [&]<class M>(const M& m) {
            for_each_key<M>([&](const auto& key) {
                const auto& value = m.*key.member;
                if constexpr (std::is_same_v<std::decay_t<decltype(value)>, glm::dvec3>)
                    grey = grey && value.x == value.y && value.y == value.z;
            });
        },
        base_of(material));
    return grey;
}

} // namespace

void SampleShader::shade(const LitLight& light, const SurfaceSamples& samples, std::size_t first, std::size_t count,
                         const float* weight) {
    const LightingOptions& options = scene_.options;
    const shading::Surfaces surfaces = surfaces_of(samples, first, count);
    const std::array<float*, 3> rgb = pointers(rgb_, count);
    if (options.illuminance) lx_.resize(count);
    if (options.method == IrradianceMethod::reference && !light.is_punctual)
        return integrate(light, samples, first, weight);

    shading::LightConstants constants = light.constants;
    for (int axis = 0; axis < 3; ++axis)
        constants.position[axis] = static_cast<float>(light.reach.center[axis] - samples.anchor[axis]);
    if (light.pattern) {
        intensity_.resize(count);
        light.pattern->evaluate({{surfaces.position[0], surfaces.position[1], surfaces.position[2]}, count},
                                samples.anchor, scene_.intensity, intensity_.data());
        if (light.is_punctual) guard(options.method, surfaces, constants, intensity_);
        constants.intensity_cd = intensity_.data();
    }
    if (light.luminance) find_luminance(light, surfaces, samples, constants);
    scene_.kernels.shade(surfaces, constants, scene_.materials[samples.surface], rgb.data());
    const bool approximated = light.approximation.has_value();
    if (options.illuminance || approximated) {
        lx_.resize(count);
        scene_.kernels.irradiance(surfaces, constants, lx_.data());
    }
    if (approximated) approximate(light, surfaces, constants, samples.surface);
    if (light.is_punctual) return;
    const auto luminance_nt = static_cast<float>(light.light.luminance.value);
    if (options.illuminance)
        for (std::size_t i = 0; i < count; ++i)
            lx_[i] *= luminance_nt * (light.luminance ? share_[i] : 1.0F);
    if (!light.pattern) return;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel)
            rgb_[channel][i] *= intensity_[i];
        if (options.illuminance) lx_[i] *= intensity_[i];
    }
}

void SampleShader::shade_from_center(const LitLight& light, const SurfaceSamples& samples, std::size_t first,
                                     std::size_t count) {
    const shading::Surfaces surfaces = surfaces_of(samples, first, count);
    shading::LightConstants constants = light.constants;
    for (int axis = 0; axis < 3; ++axis)
        constants.position[axis] = static_cast<float>(light.reach.center[axis] - samples.anchor[axis]);
    const std::array<float*, 3> rgb = pointers(rgb_, count);
    scene_.kernels.shade(surfaces, constants, scene_.materials[samples.surface], rgb.data());
    light.luminance->from_center(receivers(surfaces), samples.anchor,
                                 lobe_alpha(scene_.core_materials[samples.surface]), scene_.intensity, share_,
                                 share_error_);
    // What a uniform luminance gives times the bound; 0 where that is nothing, even without a bound.
    const auto times = [count](std::vector<float>& values, std::vector<float>& errors, const std::vector<float>& share,
                               const std::vector<float>& error, float scale) {
        errors.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            const float uniform = scale * values[i];
            errors[i] = uniform > 0.0F ? uniform * error[i] : 0.0F;
            values[i] = uniform * share[i];
        }
    };
    for (std::size_t channel = 0; channel < 3; ++channel)
        times(rgb_[channel], rgb_error_[channel], share_, share_error_, 1.0F);
    if (!scene_.options.illuminance) return;
    lx_.resize(count);
    scene_.kernels.irradiance(surfaces, constants, lx_.data());
    times(lx_, lx_error_, share_, share_error_, static_cast<float>(light.light.luminance.value));
}

void SampleShader::shade_as_point(const LitLight& light, std::span<const PointForm> forms, std::size_t of_form,
                                  const SurfaceSamples& samples, std::size_t first, std::size_t count) {
    const shading::Surfaces surfaces = surfaces_of(samples, first, count);
    shading::LightConstants constants = light.constants;
    constants.kind = shading::LightConstants::Kind::punctual;
    for (int axis = 0; axis < 3; ++axis) {
        constants.position[axis] = static_cast<float>(light.reach.center[axis] - samples.anchor[axis]);
        constants.color[axis] = static_cast<float>(light.light.color[axis]);
    }
    // What a candela gives is multiplied by the candela afterwards: where the web is dark its error is not.
    intensity_.assign(count, static_cast<float>(light.light.luminance.value));
    constants.intensity_cd = intensity_.data();
    scene_.kernels.shade(surfaces, constants, scene_.materials[samples.surface], pointers(rgb_, count).data());
    share_.resize(count);
    light.luminance->candela({{surfaces.position[0], surfaces.position[1], surfaces.position[2]}, count},
                             samples.anchor, scene_.intensity, share_.data());
    share_error_.resize(count);
    for (std::size_t k = 0; k * of_form < count; ++k) {
        const auto of_share = static_cast<float>(forms[k].share);
        const auto of_cd = static_cast<float>(forms[k].cd);
        for (std::size_t i = k * of_form; i < std::min((k + 1) * of_form, count); ++i)
            share_error_[i] = of_share * share_[i] + of_cd;
    }
    const auto times = [count, this](std::vector<float>& of_candela, std::vector<float>& errors) {
        errors.resize(count);
        float* const value = of_candela.data();
        float* const error = errors.data();
        const float* const cd = share_.data();
        const float* const cd_error = share_error_.data();
        for (std::size_t i = 0; i < count; ++i) {
            error[i] = value[i] * cd_error[i];
            value[i] *= cd[i];
        }
    };
    for (std::size_t channel = 0; channel < 3; ++channel)
        times(rgb_[channel], rgb_error_[channel]);
    if (!scene_.options.illuminance) return;
    lx_.resize(count);
    scene_.kernels.irradiance(surfaces, constants, lx_.data());
    times(lx_, lx_error_);
}

void SampleShader::illuminate(const LitLight& light, const SurfaceSamples& samples) {
    const std::size_t count = samples.size();
    shading::Surfaces surfaces;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        surfaces.position[axis] = samples.position[axis].data();
        surfaces.normal[axis] = samples.normal[axis].data();
    }
    surfaces.count = count;
    shading::LightConstants constants = light.constants;
    for (int axis = 0; axis < 3; ++axis)
        constants.position[axis] = static_cast<float>(light.reach.center[axis] - samples.anchor[axis]);
    if (light.pattern) {
        intensity_.resize(count);
        light.pattern->evaluate({{surfaces.position[0], surfaces.position[1], surfaces.position[2]}, count},
                                samples.anchor, scene_.intensity, intensity_.data());
        constants.intensity_cd = intensity_.data();
    }
    lx_.resize(count);
    scene_.kernels.irradiance(surfaces, constants, lx_.data());
    if (light.is_punctual) return;
    if (light.luminance) {
        light.luminance->evaluate(receivers(surfaces), samples.anchor, scene_.luminance, scene_.intensity, share_);
        for (std::size_t i = 0; i < count; ++i)
            lx_[i] *= share_[i];
    }
    const auto luminance_nt = static_cast<float>(light.light.luminance.value);
    for (std::size_t i = 0; i < count; ++i)
        lx_[i] *= luminance_nt * (light.pattern ? intensity_[i] : 1.0F);
}

void SampleShader::find_luminance(const LitLight& light, const shading::Surfaces& surfaces,
                                  const SurfaceSamples& samples, shading::LightConstants& constants) {
    light.luminance->evaluate(receivers(surfaces), samples.anchor, scene_.luminance, scene_.intensity, share_);
    constants.share = share_.data();
    const std::optional<double> alpha = lobe_alpha(scene_.core_materials[samples.surface]);
    if (!alpha) return;
    light.luminance->along_lobes(surfaces, samples.anchor, *alpha, scene_.luminance, scene_.intensity, share_,
                                 glossy_share_);
    constants.lobe_share = glossy_share_.data();
}

// Replaces the exact irradiance by the approximated one, in the diffuse part and in `lx_`.
void SampleShader::approximate(const LitLight& light, const shading::Surfaces& surfaces,
                               const shading::LightConstants& constants, std::size_t surface) {
    const std::size_t count = surfaces.count;
    approximate_lx_.resize(count);
    shading::LightConstants side = constants;
    side.two_sided = false;
    scene_.kernels.approximate_irradiance(surfaces, side, *light.approximation, approximate_lx_.data());
    if (constants.two_sided) {
        side_lx_.resize(count);
        for (float& along : side.axis)
            along = -along;
        scene_.kernels.approximate_irradiance(surfaces, side, *light.approximation, side_lx_.data());
        for (std::size_t i = 0; i < count; ++i)
            approximate_lx_[i] += side_lx_[i];
    }
    const shading::MaterialConstants& diffuse = scene_.diffuse_materials[surface];
    if (diffuse.kind == shading::kind_of<shading::Lambert> && !diffuse.coat.is_on) {
        const auto albedo = shading::material_of<shading::Lambert, float>(diffuse).albedo;
        const float channels[3] = {albedo.x, albedo.y, albedo.z};
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const float of_lux = channels[channel] * std::numbers::inv_pi_v<float> * constants.color[channel];
            std::vector<float>& nt = rgb_[channel];
            for (std::size_t i = 0; i < count; ++i)
                nt[i] = std::max(nt[i] + of_lux * (approximate_lx_[i] - lx_[i]), 0.0F);
        }
    } else {
        // A diffuse part proportional to the irradiance: scaled by the ratio of the two irradiances.
        scene_.kernels.shade(surfaces, constants, diffuse, pointers(diffuse_, count).data());
        for (std::size_t i = 0; i < count; ++i) {
            if (!(lx_[i] > 0.0F)) continue;
            const float change = approximate_lx_[i] / lx_[i] - 1.0F;
            for (std::size_t channel = 0; channel < 3; ++channel)
                rgb_[channel][i] = std::max(rgb_[channel][i] + diffuse_[channel][i] * change, 0.0F);
        }
    }
    std::swap(lx_, approximate_lx_);
}

// The quadrature gives Y; for a coloured material each channel is computed with a light of that channel alone.
void SampleShader::integrate(const LitLight& light, const SurfaceSamples& samples, std::size_t first,
                             const float* weight) {
    const std::size_t count = rgb_[0].size();
    // For a Lambertian diffuse part the closed form is enough.
    const auto* const matte = std::get_if<shading::Lambert<double>>(&scene_.core_materials[samples.surface]);
    const Material material = matte != nullptr ? Material(LambertMaterial{vec(matte->albedo)})
                                               : scene_.stage.surfaces[samples.surface].material;
    const ProbeWay way{IrradianceMethod::reference, scene_.options.goal};
    const bool grey = is_grey(material);
    Light colored = light.light;
    for (std::size_t i = 0; i < count; ++i) {
        if (scene_.options.illuminance) lx_[i] = 0.0F;
        for (std::vector<float>& channel : rgb_)
            channel[i] = 0.0F;
        if (weight[i] == 0.0F) continue;
        const glm::dvec3 position = samples.position_of(first + i);
        const glm::dvec3 normal = glm::normalize(samples.normal_of(first + i));
        const glm::dvec3 view = glm::normalize(samples.view_of(first + i));
        const ProbeShare share = illuminance_of(light.light, position, normal, way);
        bool converged = share.converged;
        if (scene_.options.illuminance) lx_[i] = static_cast<float>(share.illuminance_lx);
        const auto y_of = [&](const glm::dvec3& color) {
            colored.color = color;
            const ProbeShine shine = luminance_of(colored, position, normal, {material, view}, share, way);
            converged = converged && shine.converged;
            return scene_.options.specular ? shine.luminance.total().value : shine.luminance.diffuse.value;
        };
        const double y = grey ? y_of(glm::dvec3(1.0)) : 0.0;
        for (int channel = 0; channel < 3; ++channel) {
            glm::dvec3 alone(0.0);
            alone[channel] = 1.0 / rec709_luminance[channel];
            const double nt = (grey ? y : y_of(alone)) * light.light.color[channel];
            rgb_[static_cast<std::size_t>(channel)][i] = static_cast<float>(nt);
        }
        if (!converged) ++not_converged_;
    }
}

} // namespace gonio::detail
