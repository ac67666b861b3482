// Every formula runs once here, to be recorded: the core's functions are called, since inlined they are twice as large.
#define GONIO_INLINE_BY_SIZE
#include <gonio/shader/exact_irradiance.hpp>
#include <gonio/shader/formulas.hpp>
#include <gonio/shader/light_sampling.hpp>
#include <gonio/shader/parameters.hpp>
#include <gonio/shader/punctual_lights.hpp>
#include <gonio/shader/sources.hpp>
// After the recording scalar.
#include <gonio/shading/irradiance_area.hpp>
#include <gonio/shading/irradiance_named.hpp>
#include <gonio/shading/irradiance_sphere_named.hpp>
#include <gonio/shading/occlusion.hpp>

#include <array>
#include <numbers>
#include <span>
#include <string_view>

namespace gonio::shader {

namespace {

void sun_exact(Function& f) {
    core::SunLight<S> light{};
    light.toward = f.unit("toward", "unit, from the receiver to the sun's centre");
    light.sine = f.size("sin_radius", "sine of the sun's angular radius, 0.0047 for the sun of the sky");
    light.cosine = f.size("cos_radius", "cosine of it");
    f.returns(core::detail::irradiance(light, light.toward, normal_of(f)));
}

S inverse_range_of(Function& f) {
    return f.size("inverse_range", "[1/m] of the range; 0 for none");
}

void point_inverse_square(Function& f) {
    const Punctual light(f);
    f.returns(light.illuminance(f));
}
void point_window_squared(Function& f) {
    const Punctual light(f);
    const S inverse_range = inverse_range_of(f);
    f.returns(light.illuminance(f) * core::window_squared(length(light.to_light), inverse_range));
}
void point_window_gltf(Function& f) {
    const Punctual light(f);
    const S inverse_range = inverse_range_of(f);
    f.returns(light.illuminance(f) * core::window_gltf(length(light.to_light), inverse_range));
}

template<S (*lobe)(S, S, S)>
void spot(Function& f) {
    const Spot light(f);
    const S theta = light.theta(f);
    f.returns(light.illuminance(f) * lobe(theta, light.inner, light.outer));
}

template<class Light, void (*stages)(Function&, const Light&)>
void exact(Function& f) {
    stages(f, Light(f));
}

template<S (*method)(Vector, S, Vector)>
void sphere_by(Function& f) {
    const Sphere light(f);
    f.returns(method(light.to_center, light.radius, light.normal));
}
template<S (*method)(Vector, Vector, S, Vector)>
void disk_by(Function& f) {
    const Disk light(f);
    f.returns(method(light.to_center, light.axis, light.radius, light.normal));
}
template<S (*method)(Vector, Vector, Vector, S, S, Vector)>
void rectangle_by(Function& f) {
    const Rectangle light(f);
    f.returns(method(light.to_center, light.axis, light.width_direction, light.width, light.height, light.normal));
}
template<S (*method)(Vector, Vector, S, S, Vector)>
void tube_by(Function& f) {
    const Tube light(f);
    f.returns(method(light.to_center, light.axis, light.radius, light.length, light.normal));
}

// occlusion.hpp, for each stage.
template<class Light, void (*stages)(Function&, const Light&)>
void visibility(Function& f) {
    stages(f, Light(f));
    for (Stage& stage : f.stages)
        stage.value = simd::min(simd::max(S(1) - S::of(stage.value) * S(std::numbers::inv_pi), S(0)), S(1)).node;
}

// The rows of the list. Errors are what the test in tests/unit/shader prints, rounded up.

constexpr std::string_view of_irradiance = "E/L + 0.1 * (angle [rad] that the light subtends)";

constexpr Formula irradiance(std::string_view light, std::string_view method, std::string_view function,
                             std::string_view title, std::string_view source, ShaderError error,
                             void (*record)(Function&)) {
    return {{"irradiance", light, method, {}, {}},
            function,
            title,
            "E/L [sr]: irradiance [lx] per luminance of the light [cd/m2]",
            source,
            error,
            of_irradiance,
            error.near > error.apart ? "nearer to the light than a tenth of its size" : "",
            record};
}
constexpr Formula punctual(std::string_view light, std::string_view method, std::string_view function,
                           std::string_view title, std::string_view source, double error, void (*record)(Function&)) {
    return {{"irradiance", light, method, {}, {}},
            function,
            title,
            "E/I [1/m2]: illuminance [lx] per intensity of the light [cd]",
            source,
            {error, error},
            "E/I + 0.1 / (square of the distance)",
            {},
            record};
}
constexpr Formula light_sample_row(std::string_view light, std::string_view function, std::string_view title,
                                   std::string_view source, ShaderError error, void (*record)(Function&)) {
    return {{"sample", light, {}, {}, {}},
            function,
            title,
            "a direction, as long as 1/pdf [sr]: the mean of f(l) * length over many of them is the integral of f over "
            "the light's solid angle; 0 where none of it is seen",
            source,
            error,
            "each component + 0.1 * (square of the angle [rad] that the light subtends), where the last digits of the "
            "random numbers do not choose another part of the light",
            error.near > error.apart ? "nearer to the light than a tenth of its size" : "",
            record};
}
constexpr Formula light_density_row(std::string_view light, std::string_view function, std::string_view title,
                                    std::string_view source, ShaderError error, void (*record)(Function&)) {
    return {{"pdf", light, {}, {}, {}},
            function,
            title,
            "the density [1/sr] of that direction, and 0 where it misses the light",
            source,
            error,
            is_flat(light)
                ? "the density, at least 0.01 rad off the light's plane and where the last digits of the direction do "
                  "not decide whether it meets the light"
                : "the density, where the last digits of the direction do not decide whether it meets the light",
            error.near > error.apart ? "nearer to the light than a tenth of its size" : "",
            record};
}
constexpr Formula visibility_row(std::string_view shadow_of, std::string_view function, std::string_view title,
                                 std::string_view source, ShaderError error, void (*record)(Function&)) {
    return {{"visibility", {}, "exact", {}, shadow_of},
            function,
            title,
            "share of a uniform sky's irradiance that is left, in [0, 1]",
            source,
            error,
            "the result + 0.1 * (angle [rad] that it subtends)",
            "nearer to it than a tenth of its size",
            record};
}

constexpr std::string_view uniform_cone = "Uniform in the solid angle of the cone";
constexpr std::string_view urena =
    "Urena, Fajardo and King, An Area-Preserving Parametrization for Spherical Rectangles, Computer Graphics Forum "
    "32(4), 2013; far ones by area";
constexpr std::string_view spherical_ellipse =
    "uniform along the radius of the spherical ellipse, and within a few percent around it, by a table of 16 steps; "
    "after Guillen et al., Area-Preserving Parameterizations for Spherical Ellipses, Computer Graphics Forum 36(4), "
    "2017";
constexpr std::string_view tube_parts =
    "a mixture of its ends' cones and of the rectangle between the lines where the tangent planes touch";

constexpr std::array all{
    irradiance("sphere", "exact", "sphere_irradiance", "Irradiance of a uniform sphere, exact, horizon included.",
               snyder, {2e-6, 7e-6}, exact<Sphere, sphere_stages>),
    irradiance("sphere", "frostbite", "sphere_irradiance_frostbite",
               "Irradiance of a sphere as in Frostbite: the tilted sphere with clamped cosines.", frostbite_notes,
               {2e-6, 2e-5}, sphere_by<core::irradiance_sphere_frostbite<S>>),
    irradiance("sphere", "ue4", "sphere_irradiance_ue4",
               "Irradiance of a sphere as in Unreal Engine 4: a point at its centre.", karis, {1e-5, 5e-6},
               sphere_by<core::irradiance_sphere_ue4<S>>),
    irradiance("sphere", "point", "sphere_irradiance_point",
               "Irradiance of a sphere as if it were a point: exact above the horizon.", inverse_square_law,
               {1e-5, 5e-6}, sphere_by<core::irradiance_sphere_point<S>>),
    irradiance("disk", "exact", "disk_irradiance", "Irradiance of a uniform one-sided disk, exact, horizon included.",
               lambert_integral, {2e-6, 9e-5}, exact<Disk, disk_stages>),
    irradiance("disk", "frostbite", "disk_irradiance_frostbite",
               "Irradiance of a disk as in Frostbite: the cap of a facing disk times a cosine.", frostbite_notes,
               {2e-6, 3e-6}, disk_by<core::irradiance_disk_frostbite<S>>),
    irradiance("disk", "point", "disk_irradiance_point", "Irradiance of a disk as if it were a point at its centre.",
               inverse_square_law, {2e-6, 9e-6}, disk_by<core::irradiance_disk_point<S>>),
    irradiance("rect", "exact", "rect_irradiance",
               "Irradiance of a uniform one-sided rectangle, exact, horizon included.", lambert_integral, {4e-6, 3e-5},
               exact<Rectangle, rectangle_stages>),
    irradiance("rect", "frostbite", "rect_irradiance_frostbite",
               "Irradiance of a rectangle as in Frostbite: solid angle times the mean cosine of five points.",
               frostbite_notes, {1e-5, 2e-3}, rectangle_by<core::irradiance_rectangle_frostbite<S>>),
    irradiance("rect", "point", "rect_irradiance_point",
               "Irradiance of a rectangle as if it were a point at its centre.", inverse_square_law, {8e-7, 1e-5},
               rectangle_by<core::irradiance_rectangle_point<S>>),
    irradiance("tube", "exact", "tube_irradiance",
               "Irradiance of a uniform tube with hemispherical ends, exact, horizon included.", lambert_integral,
               {4e-6, 2e-5}, exact<Tube, tube_stages>),
    irradiance("tube", "frostbite", "tube_irradiance_frostbite",
               "Irradiance of a tube as in Frostbite: a facing rectangle and the nearest sphere.", frostbite_notes,
               {3e-5, 9e-4}, tube_by<core::irradiance_tube_frostbite<S>>),
    irradiance("tube", "ue4", "tube_irradiance_ue4",
               "Irradiance of a tube as in Unreal Engine 4: an isotropic line with the tube's flux.", karis,
               {3e-6, 6e-3}, tube_by<core::irradiance_tube_ue4<S>>),
    irradiance("tube", "point", "tube_irradiance_point", "Irradiance of a tube as if it were a point at its centre.",
               inverse_square_law, {6e-7, 1e-5}, tube_by<core::irradiance_tube_point<S>>),
    irradiance("sun", "exact", "sun_irradiance", "Irradiance of a uniform cone of directions, exact, horizon included.",
               snyder, {7e-7, 7e-7}, sun_exact),
    punctual("point", "inverse-square", "point_illuminance", "Illuminance by a point light.", inverse_square_law, 6e-7,
             point_inverse_square),
    punctual("point", "window-squared", "point_illuminance_window_squared",
             "Illuminance by a point light that fades to 0 at its range, as in Frostbite and Unreal Engine 4.", karis,
             2e-6, point_window_squared),
    punctual("point", "window-gltf", "point_illuminance_window_gltf",
             "Illuminance by a point light that fades to 0 at its range, as in KHR_lights_punctual.",
             "Khronos, KHR_lights_punctual", 3e-6, point_window_gltf),
    punctual("spot", "frostbite", "spot_illuminance_frostbite",
             "Illuminance by a spot that fades with the squared cosine, as in Frostbite, glTF and Filament.",
             frostbite_notes, 2e-5, spot<core::lobe_frostbite<S>>),
    punctual("spot", "hard", "spot_illuminance_hard", "Illuminance by a spot with a hard edge.", inverse_square_law,
             5e-7, spot<core::lobe_hard<S>>),
    punctual("spot", "linear-cos", "spot_illuminance_linear_cos",
             "Illuminance by a spot that fades linearly in the cosine.", inverse_square_law, 1e-5,
             spot<core::lobe_linear_cos<S>>),
    punctual("spot", "smoothstep-cos", "spot_illuminance_smoothstep_cos",
             "Illuminance by a spot that fades by a smooth step in the cosine, as in pbrt and Cycles.",
             inverse_square_law, 2e-5, spot<core::lobe_smoothstep_cos<S>>),
    punctual("spot", "linear-angle", "spot_illuminance_linear_angle",
             "Illuminance by a spot that fades linearly in the angle, as in Mitsuba.", inverse_square_law, 1e-5,
             spot<core::lobe_linear_angle<S>>),
    punctual("spot", "smoothstep-angle", "spot_illuminance_smoothstep_angle",
             "Illuminance by a spot that fades by a smooth step in the angle, as in UsdLux.", inverse_square_law, 2e-5,
             spot<core::lobe_smoothstep_angle<S>>),
    light_sample_row("sphere", "sphere_sample", "A random direction towards a sphere.", uniform_cone, {8e-6, 8e-6},
                     sample_light<Sphere>),
    light_density_row("sphere", "sphere_pdf", "The density of the directions of sphere_sample.", uniform_cone,
                      {2e-6, 2e-6}, light_density<Sphere>),
    light_sample_row("disk", "disk_sample", "A random direction towards either side of a disk.", spherical_ellipse,
                     {7e-6, 7e-6}, sample_light<Disk>),
    light_density_row("disk", "disk_pdf", "The density of the directions of disk_sample.", spherical_ellipse,
                      {2e-5, 2e-5}, light_density<Disk>),
    light_sample_row("rect", "rect_sample", "A random direction towards either side of a rectangle.", urena,
                     {5e-4, 5e-4}, sample_light<Rectangle>),
    light_density_row("rect", "rect_pdf", "The density of the directions of rect_sample.", urena, {1e-3, 1e-3},
                      light_density<Rectangle>),
    light_sample_row("tube", "tube_sample", "A random direction towards a tube with hemispherical ends.", tube_parts,
                     {1e-4, 3e-3}, sample_light<Tube>),
    light_density_row("tube", "tube_pdf", "The density of the directions of tube_sample.", tube_parts, {3e-3, 3e-3},
                      light_density<Tube>),
    visibility_row("sphere", "sky_visibility_sphere", "What a sphere leaves of a uniform sky, exact.",
                   "1 - E/(pi L) of a sphere that emits L", {8e-7, 6e-6}, visibility<Sphere, sphere_stages>),
    visibility_row("capsule", "sky_visibility_capsule",
                   "What a cylinder with hemispherical ends leaves of a uniform sky, exact.",
                   "1 - E/(pi L) of a capsule that emits L", {5e-7, 2e-5}, visibility<Tube, tube_stages>),
};

} // namespace

std::span<const Formula> formulas_of_lights() {
    return all;
}

} // namespace gonio::shader
