// Every formula runs once here, to be recorded: the core's functions are called, since inlined they are twice as large.
#define GONIO_INLINE_BY_SIZE
#include <gonio/shader/exact_irradiance.hpp>
#include <gonio/shader/formulas.hpp>
#include <gonio/shader/materials.hpp>
#include <gonio/shader/parameters.hpp>
#include <gonio/shader/punctual_lights.hpp>
#include <gonio/shader/sources.hpp>
// After the recording scalar.
#include <gonio/shading/shade.hpp>

#include <array>
#include <numbers>
#include <span>
#include <string_view>
#include <type_traits>

namespace gonio::shader {

namespace {

// Luminance per candela of a point light or a spot.
template<class Light, auto material>
void shade_punctual(Function& f) {
    const Light light(f);
    const Vector view = f.unit("view", "unit, from the surface to the eye");
    const auto of = material(f);
    const core::Direction<S> d = core::direction(light.to_light, light.normal);
    const Vector l = d.scaled * d.inverse_distance;
    f.label("l", l);
    const Vector result = brdf_of(f, of, {light.normal, l, view}) * light.illuminance(f);
    if constexpr (std::is_same_v<Light, Spot>)
        f.returns(result * core::lobe_frostbite(light.theta(f), light.inner, light.outer));
    else
        f.returns(result);
}

// Luminance of a matte surface per luminance of an area light.
template<class Light, void (*stages)(Function&, const Light&)>
void shade_lambert(Function& f) {
    const Light light(f);
    const Vector albedo = color_of(f, "albedo");
    stages(f, light);
    for (Stage& stage : f.stages)
        stage.value = (albedo * (S::of(stage.value) * S(std::numbers::inv_pi))).node();
    f.result = Type::vector;
}

// The same for a material with a highlight: the diffuse part by the exact irradiance, the highlight by a representative
// point.
template<class Light, void (*stages)(Function&, const Light&), auto material>
void shade_area(Function& f) {
    const Light light(f);
    const Vector view = f.unit("view", "unit, from the surface to the eye");
    const auto of = material(f);
    const core::SurfacePoint<S> point{{S(0), S(0), S(0)}, light.normal, view};
    const Vector highlight =
        core::detail::glossy_part<core::SpecularMethod::representative_point>(point, light.as_light(), of);
    const Vector diffuse = core::diffuse_part(of, light.normal, light.normal, view);
    f.label("highlight", highlight);
    f.label("diffuse", diffuse);
    stages(f, light);
    for (Stage& stage : f.stages)
        stage.value = (diffuse * S::of(stage.value) + highlight).node();
    f.result = Type::vector;
    const NodeId last = f.stages.back().value;
    if (f.stages.front().value == last) f.stages = {{no_node, last, {}}}; // there is no diffuse part
}

// The rows of the list. Errors are what the test in tests/unit/shader prints, rounded up.

constexpr Formula shade_point_row(std::string_view material, std::string_view function, std::string_view title,
                                  std::string_view source, double error, void (*record)(Function&)) {
    return {{"shade", "point", "inverse-square", material, {}},
            function,
            title,
            "luminance [cd/m2] of red, green and blue per intensity of the light [cd]",
            source,
            {error, error},
            "the result + 0.1 / (square of the distance)",
            {},
            record};
}
constexpr Formula shade_spot_row(std::string_view material, std::string_view function, std::string_view title,
                                 std::string_view source, double error, void (*record)(Function&)) {
    Formula formula = shade_point_row(material, function, title, source, error, record);
    formula.names.light = "spot";
    formula.names.method = "frostbite";
    return formula;
}
constexpr Formula shade_area_row(std::string_view light, std::string_view function, std::string_view title,
                                 std::string_view source, ShaderError error, void (*record)(Function&)) {
    return {{"shade", light, "exact", "lambert", {}},
            function,
            title,
            "luminance of red, green and blue per luminance of the light",
            source,
            error,
            "the result + 0.1 * (angle [rad] that the light subtends)",
            "nearer to the light than a tenth of its size",
            record};
}
constexpr Formula highlight_row(std::string_view light, std::string_view material, std::string_view function,
                                std::string_view title, ShaderError error, void (*record)(Function&)) {
    return {{"shade", light, "representative-point", material, {}},
            function,
            title,
            "luminance of red, green and blue per luminance of the light",
            "exact irradiance; highlight by the representative point of Karis, Real Shading in Unreal Engine 4, 2013",
            error,
            "the result + 0.1 * (angle [rad] that the light subtends)",
            is_flat(light) ? "nearer to the light than a tenth of its size, where the method jumps"
                           : "nearer to the light than a tenth of its size",
            record};
}

constexpr std::array all{
    shade_point_row("lambert", "point_shade_lambert", "A Lambert surface under a point light.", "Lambert 1760", 5e-7,
                    shade_punctual<Punctual, lambert>),
    shade_point_row("eon", "point_shade_eon", "An EON surface under a point light.", eon_paper, 3e-6,
                    shade_punctual<Punctual, eon>),
    shade_point_row("frostbite", "point_shade_frostbite", "Frostbite's material under a point light.", frostbite_notes,
                    8e-6, shade_punctual<Punctual, frostbite>),
    shade_point_row("ue4", "point_shade_ue4", "Unreal Engine 4's material under a point light.", karis, 5e-6,
                    shade_punctual<Punctual, ue4>),
    shade_point_row("gltf", "point_shade_gltf", "The material of glTF 2.0 under a point light.", khronos, 6e-6,
                    shade_punctual<Punctual, gltf>),
    shade_point_row("blinn", "point_shade_blinn", "The material of Remember Me under a point light.", remember_me, 7e-5,
                    shade_punctual<Punctual, blinn>),
    shade_point_row("ggx", "point_shade_ggx", "A GGX surface under a point light.", heitz, 4e-5,
                    shade_punctual<Punctual, ggx>),
    shade_point_row("ggx-anisotropic", "point_shade_ggx_anisotropic", "An anisotropic GGX surface under a point light.",
                    heitz, 7e-6, shade_punctual<Punctual, ggx_anisotropic>),
    shade_point_row("kulla-conty", "point_shade_kulla_conty",
                    "GGX with light scattered several times under a point light.", kulla_and_conty, 4e-5,
                    shade_punctual<Punctual, kulla_conty>),
    shade_spot_row("lambert", "spot_shade_lambert", "A Lambert surface under a spot that fades as in Frostbite.",
                   "Lambert 1760", 5e-6, shade_punctual<Spot, lambert>),
    shade_spot_row("eon", "spot_shade_eon", "An EON surface under a spot that fades as in Frostbite.", eon_paper, 4e-6,
                   shade_punctual<Spot, eon>),
    shade_spot_row("frostbite", "spot_shade_frostbite", "Frostbite's material under a spot that fades as in Frostbite.",
                   frostbite_notes, 4e-6, shade_punctual<Spot, frostbite>),
    shade_spot_row("ue4", "spot_shade_ue4", "Unreal Engine 4's material under a spot that fades as in Frostbite.",
                   karis, 5e-6, shade_punctual<Spot, ue4>),
    shade_spot_row("gltf", "spot_shade_gltf", "The material of glTF 2.0 under a spot that fades as in Frostbite.",
                   khronos, 4e-6, shade_punctual<Spot, gltf>),
    shade_spot_row("blinn", "spot_shade_blinn", "The material of Remember Me under a spot that fades as in Frostbite.",
                   remember_me, 1e-5, shade_punctual<Spot, blinn>),
    shade_spot_row("ggx", "spot_shade_ggx", "A GGX surface under a spot that fades as in Frostbite.", heitz, 5e-6,
                   shade_punctual<Spot, ggx>),
    shade_spot_row("ggx-anisotropic", "spot_shade_ggx_anisotropic",
                   "An anisotropic GGX surface under a spot that fades as in Frostbite.", heitz, 2e-5,
                   shade_punctual<Spot, ggx_anisotropic>),
    shade_spot_row("kulla-conty", "spot_shade_kulla_conty",
                   "GGX with light scattered several times under a spot that fades as in Frostbite.", kulla_and_conty,
                   5e-6, shade_punctual<Spot, kulla_conty>),
    shade_area_row("sphere", "sphere_shade_lambert", "A Lambert surface under a uniform sphere, exact.", snyder,
                   {3e-7, 4e-6}, shade_lambert<Sphere, sphere_stages>),
    shade_area_row("disk", "disk_shade_lambert", "A Lambert surface under a uniform one-sided disk, exact.",
                   lambert_integral, {9e-7, 2e-5}, shade_lambert<Disk, disk_stages>),
    shade_area_row("rect", "rect_shade_lambert", "A Lambert surface under a uniform one-sided rectangle, exact.",
                   lambert_integral, {2e-6, 2e-5}, shade_lambert<Rectangle, rectangle_stages>),
    shade_area_row("tube", "tube_shade_lambert", "A Lambert surface under a uniform tube, exact.", lambert_integral,
                   {9e-7, 7e-6}, shade_lambert<Tube, tube_stages>),
    highlight_row("sphere", "ue4", "sphere_shade_ue4", "Unreal Engine 4's material under a uniform sphere.",
                  {2e-4, 2e-4}, shade_area<Sphere, sphere_stages, ue4>),
    highlight_row("sphere", "blinn", "sphere_shade_blinn", "The material of Remember Me under a uniform sphere.",
                  {2e-5, 2e-5}, shade_area<Sphere, sphere_stages, blinn>),
    highlight_row("sphere", "ggx", "sphere_shade_ggx", "A GGX surface under a uniform sphere.", {2e-3, 2e-3},
                  shade_area<Sphere, sphere_stages, ggx>),
    highlight_row("disk", "ue4", "disk_shade_ue4", "Unreal Engine 4's material under a uniform one-sided disk.",
                  {2e-4, 3e-2}, shade_area<Disk, disk_stages, ue4>),
    highlight_row("disk", "blinn", "disk_shade_blinn", "The material of Remember Me under a uniform one-sided disk.",
                  {2e-5, 7e-4}, shade_area<Disk, disk_stages, blinn>),
    highlight_row("disk", "ggx", "disk_shade_ggx", "A GGX surface under a uniform one-sided disk.", {6e-5, 2e-1},
                  shade_area<Disk, disk_stages, ggx>),
    highlight_row("rect", "ue4", "rect_shade_ue4", "Unreal Engine 4's material under a uniform one-sided rectangle.",
                  {3e-5, 2e-1}, shade_area<Rectangle, rectangle_stages, ue4>),
    highlight_row("rect", "blinn", "rect_shade_blinn",
                  "The material of Remember Me under a uniform one-sided rectangle.", {7e-7, 4e-2},
                  shade_area<Rectangle, rectangle_stages, blinn>),
    highlight_row("rect", "ggx", "rect_shade_ggx", "A GGX surface under a uniform one-sided rectangle.", {7e-5, 2e-1},
                  shade_area<Rectangle, rectangle_stages, ggx>),
    highlight_row("tube", "ue4", "tube_shade_ue4", "Unreal Engine 4's material under a uniform tube.", {1e-4, 1e-4},
                  shade_area<Tube, tube_stages, ue4>),
    highlight_row("tube", "blinn", "tube_shade_blinn", "The material of Remember Me under a uniform tube.",
                  {9e-6, 2e-5}, shade_area<Tube, tube_stages, blinn>),
    highlight_row("tube", "ggx", "tube_shade_ggx", "A GGX surface under a uniform tube.", {1e-4, 3e-4},
                  shade_area<Tube, tube_stages, ggx>),
};

} // namespace

std::span<const Formula> formulas_of_shading() {
    return all;
}

} // namespace gonio::shader
