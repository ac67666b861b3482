// Filament: a module for its WebAssembly that makes the lights, Y up.
//
// A point of φ lm emits φ/4π cd. A SPOT of φ lm emits φ/π cd on its axis whatever its cone, and falls as glTF's: the
// square of a linear function of the cosine. A sun is in lux; a scene has one. Colours are linear. Every light has a
// falloff radius, whose window is ours. Filament has no profiles: a light of the same flux stands for one. Images of
// skies are KTX files that its tool cmgen filters.
#include <gonio/asset/detail/same_flux.hpp>
#include <gonio/asset/detail/scene_text.hpp>

#include <fmt/format.h>

#include <numbers>

namespace gonio::asset_detail {

namespace {

using std::numbers::pi;

constexpr const char* helper_text = R"js(
function light(Filament, type, color, intensity, settings) {
    const builder = Filament.LightManager.Builder(Filament.LightManager$Type[type]);
    builder.color(color).intensity(intensity);
    for (const [name, values] of Object.entries(settings)) builder[name](...values);
    return builder;
}
)js";

std::string vector(const glm::dvec3& v) {
    return "[" + triple(v) + "]";
}

std::string entry(const SceneLight& light, const SceneContent& scene) {
    const std::string color = vector(light.color);
    const std::string aim = vector(y_up(-light.frame.z));
    if (light.kind == LightKind::sun)
        return fmt::format("light(Filament, 'SUN', {}, {}, {{ direction: [{}], sunAngularRadius: [{}] }})", color,
                           light.lux, aim, 0.5 * light.diameter * 180.0 / pi);
    const std::string where =
        fmt::format("position: [{}], falloff: [{}]", vector(y_up(light.frame.origin)), reach_of(light));
    const auto point = [&](double intensity) {
        return fmt::format("light(Filament, 'POINT', {}, {}, {{ {} }})", color, 4.0 * pi * intensity, where);
    };
    const auto spot = [&](double intensity, double inner, double outer) {
        return fmt::format("light(Filament, 'SPOT', {}, {}, {{ {}, direction: [{}], spotLightCone: [{}, {}] }})", color,
                           pi * intensity, where, aim, inner, outer);
    };
    if (light.kind == LightKind::spot) return spot(light.intensity, light.inner, light.outer);
    if (light.kind != LightKind::profile) return point(light.intensity);
    const MeasuredLight& profile = scene.profiles[light.profile];
    const SameFlux same = same_flux(profile);
    const double intensity = same.intensity * light.intensity / profile.peak.value; // in the scene's unit
    return same.is_point ? point(intensity) : spot(intensity, same.inner, same.outer);
}

} // namespace

std::vector<AssetFile> filament_files(const SceneContent& scene) {
    std::string list;
    for (const SceneLight& light : scene.lights)
        list += fmt::format("        [{}, {}],\n", quoted(light.name), entry(light, scene));
    return {{scene.name + ".js",
             fmt::format("// {}\n{}\n"
                         "// New lights in the scene: their entities by name. Y up, units in a metre: {}. A light "
                         "without a range of\n// its own ends where this takes away at most {} lx.\n"
                         "export function makeLights(Filament, engine, scene) {{\n    const builders = [\n{}    ];\n"
                         "    return Object.fromEntries(builders.map(([name, builder]) => {{\n"
                         "        const entity = Filament.EntityManager.get().create();\n"
                         "        builder.build(engine, entity);\n"
                         "        scene.addEntity(entity);\n"
                         "        return [name, entity];\n"
                         "    }}));\n}}\n",
                         scene.description, helper_text, scene.units_per_meter, window_loss_lx, list),
             {}}};
}

} // namespace gonio::asset_detail
