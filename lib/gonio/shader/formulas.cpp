// Every formula runs once here, to be recorded: the core's functions are called, since inlined they are twice as large.
#define GONIO_INLINE_BY_SIZE
#include <gonio/shader/exact_irradiance.hpp>
#include <gonio/shader/formulas.hpp>
#include <gonio/shader/highlights.hpp>
#include <gonio/shader/light_sampling.hpp>
#include <gonio/shader/parameters.hpp>
// After the recording scalar.
#include <gonio/shading/brdf_blinn.hpp>
#include <gonio/shading/brdf_eon.hpp>
#include <gonio/shading/brdf_frostbite.hpp>
#include <gonio/shading/brdf_ggx.hpp>
#include <gonio/shading/brdf_gltf.hpp>
#include <gonio/shading/brdf_kulla_conty.hpp>
#include <gonio/shading/brdf_lambert.hpp>
#include <gonio/shading/brdf_ue4.hpp>
#include <gonio/shading/falloff.hpp>
#include <gonio/shading/irradiance_area.hpp>
#include <gonio/shading/irradiance_named.hpp>
#include <gonio/shading/irradiance_sphere_named.hpp>
#include <gonio/shading/occlusion.hpp>
#include <gonio/shading/shade.hpp>

#include <array>
#include <numbers>
#include <string>
#include <type_traits>

namespace gonio::shader {

namespace {

void sun_exact(Function& f) {
    core::SunLight<S> light{};
    light.toward = f.unit("toward", "unit, from the receiver to the sun's centre");
    light.sine = f.size("sin_radius", "sine of the sun's angular radius, 0.0047 for the sun of the sky");
    light.cosine = f.size("cos_radius", "cosine of it");
    f.returns(core::detail::irradiance(light, light.toward, normal_of(f)));
}

// Point and spot: illuminance per candela.

struct Punctual {
    Vector to_light, normal;
    explicit Punctual(Function& f)
        : to_light(f.vector("to_light", "[m] from the receiver to the light")), normal(normal_of(f)) {}

    S illuminance(Function& f) const {
        const core::Direction<S> d = core::direction(to_light, normal);
        name_direction(f, d);
        const S inverse = d.scale * d.inverse_distance;
        return simd::max(d.n_dot_l, S(0)) * inverse * inverse;
    }
};

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

struct Spot : Punctual {
    Vector aim;
    S inner, outer;
    explicit Spot(Function& f)
        : Punctual(f),
          aim(f.unit("aim", "unit, from the light along its beam")),
          inner(f.size("inner", "[rad] half angle of full intensity, in [0, outer]")),
          outer(f.size("outer", "[rad] half angle of the beam's edge, in [0, pi]")) {}

    S theta(Function& f) const {
        const S angle = core::angle_from_aim(aim, to_light * S(-1));
        f.label("theta", angle);
        return angle;
    }
};

template<S (*lobe)(S, S, S)>
void spot(Function& f) {
    const Spot light(f);
    const S theta = light.theta(f);
    f.returns(light.illuminance(f) * lobe(theta, light.inner, light.outer));
}

// Materials: f [1/sr] for light from l, seen from v.

struct Ways {
    Vector n, l, v;
};

core::Lambert<S> lambert(Function& f) {
    return {color_of(f, "albedo")};
}
core::Eon<S> eon(Function& f) {
    const Vector albedo = color_of(f, "albedo");
    return {albedo, share_of(f, "roughness")};
}
core::Frostbite<S> frostbite(Function& f) {
    const Vector base = color_of(f, "base_color");
    const S smoothness = share_of(f, "smoothness");
    const S metallic = share_of(f, "metallic");
    return core::frostbite_material(base, smoothness, metallic,
                                    share_of(f, "reflectance", "[0, 1]; 0.5 is a reflectance of 0.04"));
}
core::Ue4<S> ue4(Function& f) {
    const Vector base = color_of(f, "base_color");
    const S metallic = share_of(f, "metallic");
    const S roughness = share_of(f, "roughness");
    const S specular = share_of(f, "specular", "[0, 1]; 0.5 is a reflectance of 0.04");
    return core::ue4_material(base, metallic, roughness, specular, share_of(f, "cavity", "[0, 1]; 1 for none"));
}
core::Gltf<S> gltf(Function& f) {
    const Vector base = color_of(f, "base_color");
    const S metallic = share_of(f, "metallic");
    return core::gltf_material(base, metallic, share_of(f, "roughness"));
}
core::Blinn<S> blinn(Function& f) {
    const Vector albedo = color_of(f, "albedo");
    const Vector f0 = color_of(f, "f0", "[0, 1], reflectance at normal incidence");
    const S smoothness = share_of(f, "smoothness");
    return core::blinn_material(albedo, f0, smoothness, share_of(f, "wetness"));
}
core::Ggx<S> ggx(Function& f) {
    const Vector f0 = color_of(f, "f0", "[0, 1], reflectance at normal incidence");
    return {f0, share_of(f, "alpha", "[0, 1], the square of a roughness")};
}

// Kulla and Conty's material for one pair of directions, with numbers of a table (`gonio bake --table kulla-conty`) in
// the place of its polynomials. The core finds the functions below by their argument.
template<class T>
struct LookedUpKullaConty {
    core::Ggx<T> single; // what is scattered once
    T loss_of_light, loss_of_view, mean_loss;
};
template<class T>
core::vec3<T> diffuse_part(const LookedUpKullaConty<T>& of, core::vec3<T> n, core::vec3<T> l, core::vec3<T> v) {
    return core::diffuse_part(of.single, n, l, v);
}
template<class T>
core::vec3<T> specular_part(const LookedUpKullaConty<T>& of, core::vec3<T> n, core::vec3<T> l, core::vec3<T> v,
                            T widening) {
    return core::specular_part(of.single, n, l, v, widening) +
           core::detail::wide_lobe(
               core::multiple_scattering_factor(of.single.f0, of.mean_loss), n, l, v,
               [&](T /*n_dot_l*/) { return of.loss_of_light; }, [&](T /*n_dot_v*/) { return of.loss_of_view; });
}
template<class T>
core::Lobes<T> lobes(const LookedUpKullaConty<T>& of, T n_dot_v) {
    return core::detail::kulla_conty_lobes(of.single.f0, of.single.alpha, of.loss_of_view, n_dot_v);
}
LookedUpKullaConty<S> kulla_conty(Function& f) {
    const core::Ggx<S> single = ggx(f);
    const S of_light = share_of(f, "albedo_light", "albedo of the table at n.l and the roughness");
    const S of_view = share_of(f, "albedo_view", "albedo of the table at n.v and the roughness");
    const S mean = share_of(f, "mean_albedo", "mean_albedo of the table at the roughness");
    return {single, S(1) - of_light, S(1) - of_view, S(1) - mean};
}

// GGX with a grain: f of red, green and blue.
struct GrainedGgx {
    Vector f0;
    GrainParameters grain;
    explicit GrainedGgx(Function& f) : f0(color_of(f, "f0", "[0, 1], reflectance at normal incidence")), grain(f) {}
};
GrainedGgx ggx_anisotropic(Function& f) {
    return GrainedGgx(f);
}
core::FacetPose<S> facet_pose(const GrainedGgx& material, Vector n, Vector l, Vector v) {
    return {core::TangentFrame<S>(material.grain.tangent, n), l, v};
}
Vector brdf_of(Function& f, const GrainedGgx& material, const Ways& ways) {
    const core::FacetPose<S> pose = facet_pose(material, ways.n, ways.l, ways.v);
    f.label("l_of_surface", pose.l, "In the frame of tangent, bitangent and normal.");
    f.label("v_of_surface", pose.v);
    f.label("h", pose.h);
    const core::AnisotropicAlpha<S>& alphas = material.grain.alphas;
    return core::reflected_part(material.f0, S(1), core::specular_ggx(pose, alphas, alphas));
}
template<class Material>
Vector brdf_of(Function& f, const Material& material, const Ways& ways) {
    const S n_dot_l = dot(ways.n, ways.l);
    const S n_dot_v = dot(ways.n, ways.v);
    const Vector h = core::normalized(ways.l + ways.v);
    f.label("n_dot_l", n_dot_l);
    f.label("n_dot_v", n_dot_v);
    f.label("h", h);
    f.label("n_dot_h", dot(ways.n, h));
    f.label("l_dot_h", dot(ways.l, h));
    f.label("lit", simd::both(core::above_surface(n_dot_l), core::above_surface(n_dot_v)));
    return core::brdf(material, ways.n, ways.l, ways.v);
}

template<auto material>
void brdf(Function& f) {
    const Vector n = f.unit("n", "unit, the surface's normal");
    const Vector l = f.unit("l", "unit, to the light");
    const Vector v = f.unit("v", "unit, to the eye");
    const auto of = material(f);
    f.returns(brdf_of(f, of, {n, l, v}));
}

// A direction towards the light, and the density of such directions.
template<class Material>
Vector sampled(const Material& material, Vector n, Vector v, Vector u) {
    return core::sample_brdf(material, n, v, u).l;
}
Vector sampled(const GrainedGgx& material, Vector n, Vector v, Vector u) {
    const core::TangentFrame<S> frame(material.grain.tangent, n);
    return frame.to_world(core::reflected_direction_ggx(frame.to_local(v), material.grain.alphas, u.x, u.y));
}
template<auto material>
void sample(Function& f) {
    const Vector n = f.unit("n", "unit, the surface's normal");
    const Vector v = f.unit("v", "unit, to the eye");
    const Vector u = f.vector("u", "three random numbers, each in [0, 1)");
    f.returns(sampled(material(f), n, v, u));
}
template<class Material>
S density_of(const Material& material, Vector n, Vector v, Vector l) {
    return core::pdf_brdf(material, n, v, l);
}
S density_of(const GrainedGgx& material, Vector n, Vector v, Vector l) {
    return core::pdf_reflected_ggx(facet_pose(material, n, l, v), material.grain.alphas);
}
template<auto material>
void density(Function& f) {
    const Vector n = f.unit("n", "unit, the surface's normal");
    const Vector v = f.unit("v", "unit, to the eye");
    const Vector l = f.unit("l", "unit, to the light");
    f.returns(density_of(material(f), n, v, l));
}

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

// Changes what is returned in every stage.
template<class Change>
void change_results(Function& f, const Change& change) {
    for (Stage& stage : f.stages)
        stage.value = change(S::of(stage.value)).node;
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

template<class Light, void (*stages)(Function&, const Light&)>
void exact(Function& f) {
    stages(f, Light(f));
}

// occlusion.hpp, for each stage.
template<class Light, void (*stages)(Function&, const Light&)>
void visibility(Function& f) {
    stages(f, Light(f));
    change_results(f, [](S e) { return simd::min(simd::max(S(1) - e * S(std::numbers::inv_pi), S(0)), S(1)); });
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

// The rows of the table. Errors are what the test in tests/unit/shader prints, rounded up.

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
// In poses for errors α is at least 0.01: the peak of a narrower lobe depends on the last digits of the directions.
constexpr bool has_ggx(std::string_view material) {
    return material != "lambert" && material != "eon" && material != "blinn";
}

constexpr Formula brdf_row(std::string_view material, std::string_view function, std::string_view title,
                           std::string_view source, double error, void (*record)(Function&)) {
    return {{"brdf", {}, {}, material, {}},
            function,
            title,
            "f [1/sr] of red, green and blue, and 0 where n.l or n.v is not above 0",
            source,
            {error, error},
            has_ggx(material) ? "f + 0.1/sr, where the alpha of GGX is at least 0.01" : "f + 0.1/sr",
            {},
            record};
}
constexpr Formula sample_row(std::string_view material, std::string_view function, std::string_view title,
                             std::string_view source, double error, void (*record)(Function&)) {
    return {{"sample", {}, {}, material, {}},
            function,
            title,
            "a unit direction to the light; it may lie below the surface, where the BRDF is 0",
            source,
            {error, error},
            has_ggx(material) ? "each component + 0.1, where the alpha of GGX is at least 0.01"
                              : "each component + 0.1",
            {},
            record};
}
constexpr Formula density_row(std::string_view material, std::string_view function, std::string_view title,
                              std::string_view source, double error, void (*record)(Function&)) {
    return {{"pdf", {}, {}, material, {}},
            function,
            title,
            "the density [1/sr] of that direction, and 0 where n.v is not above 0",
            source,
            {error, error},
            has_ggx(material) ? "the density + 0.1/sr, where the alpha of GGX is at least 0.01"
                              : "the density + 0.1/sr",
            {},
            record};
}
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
constexpr Formula highlight_row(std::string_view light, std::string_view material, std::string_view function,
                                std::string_view title, ShaderError error, void (*record)(Function&)) {
    return {{"shade", light, "representative-point", material, {}},
            function,
            title,
            "luminance of red, green and blue per luminance of the light",
            "exact irradiance; highlight by the representative point of Karis, Real Shading in Unreal Engine 4, 2013",
            error,
            "the result + 0.1 * (angle [rad] that the light subtends)",
            light == "disk" || light == "rect" ? "nearer to the light than a tenth of its size, where the method jumps"
                                               : "nearer to the light than a tenth of its size",
            record};
}
constexpr Formula ltc_row(std::string_view light, std::string_view method, std::string_view material,
                          std::string_view function, std::string_view title, std::string_view source, ShaderError error,
                          void (*record)(Function&)) {
    return {{"shade", light, method, material, {}},
            function,
            title,
            "luminance of red, green and blue per luminance of the light",
            source,
            error,
            "the result + 0.1 * (angle [rad] that the light subtends)",
            light == "disk" || light == "rect"
                ? "nearer to the light than a tenth of its size, where float decides on which side of its plane one is"
                : "nearer to the light than a tenth of its size",
            record};
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
            light == "disk" || light == "rect"
                ? "the density, at least 0.01 rad off the light's plane and where the last digits of the direction do "
                  "not decide whether it meets the light"
                : "the density, where the last digits of the direction do not decide whether it meets the light",
            error.near > error.apart ? "nearer to the light than a tenth of its size" : "",
            record};
}
constexpr Formula roughness_row(std::string_view material, std::string_view function, std::string_view title,
                                std::string_view source, double error, void (*record)(Function&)) {
    return {{"roughness", {}, {}, material, {}},
            function,
            title,
            "the roughness [0, 1.3] of the isotropic lobe that is as wide in the plane of normal and view; above 1 it "
            "counts as 1",
            source,
            {error, error},
            "the result + 0.1",
            {},
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

constexpr std::string_view snyder = "Snyder 1996; Lagarde and de Rousiers 2014; without their cotangents";
constexpr std::string_view lambert_integral = "Lambert's contour integral (Photometria, 1760), clipped to the horizon";
constexpr std::string_view frostbite_notes = "Lagarde and de Rousiers, Moving Frostbite to Physically Based Rendering, "
                                             "2014; misprints corrected";
constexpr std::string_view karis = "Karis, Real Shading in Unreal Engine 4, 2013";
constexpr std::string_view inverse_square_law = "Inverse square law";
constexpr std::string_view khronos = "Khronos, glTF 2.0 Specification, appendix B";
constexpr std::string_view eon_paper = "Portsmouth, Kutz and Hill, EON, JCGT 14(1), 2025";
constexpr std::string_view remember_me = "Lagarde and Harduin, The Art of Remember Me, 2013";
constexpr std::string_view heitz = "Heitz, JCGT 3(2), 2014; Schlick 1994";

constexpr std::string_view kulla_and_conty =
    "Kulla and Conty, Revisiting Physically Based Shading at Imageworks, 2017. Albedos: gonio bake --table kulla-conty";
constexpr std::string_view visible_normals_or_cosine =
    "Dupuy and Benyoub, Sampling Visible GGX Normals with Spherical Caps, 2023, and cosine sampling. albedo_view: "
    "gonio bake --table kulla-conty";

constexpr std::string_view by_rows =
    "the lobe summed over rows of points that the transformed cosine of Heitz et al., ACM TOG 35(4), 2016, places, and "
    "corrected by its exact share. leaning and reflected: gonio bake --table ltc-ggx";
constexpr std::string_view exact_and_by_rows =
    "the diffuse part by the exact irradiance; the lobe summed over rows of points that the transformed cosine of "
    "Heitz et al., ACM TOG 35(4), 2016, places, and corrected by its exact share. leaning and reflected: gonio bake "
    "--table ltc-ggx";
constexpr std::string_view mean_and_by_rows =
    "the diffuse part by the exact irradiance and the mean of its factor over points of the light; the lobe summed "
    "over rows of points that the transformed cosine of Heitz et al., ACM TOG 35(4), 2016, places, and corrected by "
    "its exact share. leaning and reflected: gonio bake --table ltc-ggx";
constexpr std::string_view by_stretched_rows =
    "the lobe summed over rows of points that a transformed cosine places: that of the isotropic lobe as wide in the "
    "plane of normal and view, stretched and sheared. leaning and reflected: gonio bake --table ltc-ggx";
constexpr std::string_view by_share =
    "Heitz et al., ACM TOG 35(4), 2016; the lobe keeps its sign, the light is clipped once, and points of the light "
    "correct it. leaning and reflected: gonio bake --table ltc-ggx";

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

constexpr std::string_view visible_normals =
    "Dupuy and Benyoub, Sampling Visible GGX Normals with Spherical Caps, 2023";

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
    brdf_row("lambert", "lambert_brdf", "Lambert: the same luminance in every direction.", "Lambert 1760", 9e-8,
             brdf<lambert>),
    brdf_row("eon", "eon_brdf", "EON: Oren-Nayar that keeps its energy.", eon_paper, 3e-5, brdf<eon>),
    brdf_row("frostbite", "frostbite_brdf", "The material of Frostbite: renormalised Disney diffuse and GGX.",
             frostbite_notes, 1e-5, brdf<frostbite>),
    brdf_row("ue4", "ue4_brdf", "The material of Unreal Engine 4: Lambert and GGX.", karis, 2e-5, brdf<ue4>),
    brdf_row("gltf", "gltf_brdf", "The metallic-roughness material of glTF 2.0.", khronos, 1e-5, brdf<gltf>),
    brdf_row("blinn", "blinn_brdf", "The material of Remember Me: Lambert, a cosine power, and water.", remember_me,
             2e-5, brdf<blinn>),
    brdf_row("ggx", "ggx_brdf", "GGX alone, single scattering, with height-correlated shadowing.", heitz, 2e-5,
             brdf<ggx>),
    brdf_row("ggx-anisotropic", "ggx_anisotropic_brdf",
             "GGX that is rougher along one direction of the surface than across it.", heitz, 3e-5,
             brdf<ggx_anisotropic>),
    brdf_row("kulla-conty", "kulla_conty_brdf",
             "GGX with the light that is scattered several times between its facets, by Kulla and Conty.",
             kulla_and_conty, 4e-5, brdf<kulla_conty>),
    sample_row("lambert", "lambert_sample", "A direction to the light for the BRDF of Lambert, by importance.",
               "Cosine sampling", 5e-6, sample<lambert>),
    density_row("lambert", "lambert_pdf", "The density of the directions of lambert_sample.", "Cosine sampling", 2e-7,
                density<lambert>),
    sample_row("eon", "eon_sample", "A direction to the light for the BRDF of EON, by importance.",
               "A mixture of cosine and uniform sampling", 4e-6, sample<eon>),
    density_row("eon", "eon_pdf", "The density of the directions of eon_sample.",
                "A mixture of cosine and uniform sampling", 2e-7, density<eon>),
    sample_row("frostbite", "frostbite_sample",
               "A direction to the light for the BRDF of Frostbite's material, by importance.", visible_normals, 2e-4,
               sample<frostbite>),
    density_row("frostbite", "frostbite_pdf", "The density of the directions of frostbite_sample.", visible_normals,
                2e-6, density<frostbite>),
    sample_row("ue4", "ue4_sample",
               "A direction to the light for the BRDF of Unreal Engine 4's material, by importance.", visible_normals,
               4e-4, sample<ue4>),
    density_row("ue4", "ue4_pdf", "The density of the directions of ue4_sample.", visible_normals, 2e-6, density<ue4>),
    sample_row("gltf", "gltf_sample",
               "A direction to the light for the BRDF of the material of glTF 2.0, by importance.", visible_normals,
               2e-4, sample<gltf>),
    density_row("gltf", "gltf_pdf", "The density of the directions of gltf_sample.", visible_normals, 2e-6,
                density<gltf>),
    sample_row("blinn", "blinn_sample",
               "A direction to the light for the BRDF of the material of Remember Me, by importance.", visible_normals,
               7e-5, sample<blinn>),
    density_row("blinn", "blinn_pdf", "The density of the directions of blinn_sample.", visible_normals, 7e-6,
                density<blinn>),
    sample_row("ggx", "ggx_sample", "A direction to the light for the BRDF of GGX, by importance.", visible_normals,
               4e-5, sample<ggx>),
    density_row("ggx", "ggx_pdf", "The density of the directions of ggx_sample.", visible_normals, 2e-6, density<ggx>),
    sample_row("ggx-anisotropic", "ggx_anisotropic_sample",
               "A direction to the light for the BRDF of anisotropic GGX, by importance.", visible_normals, 5e-5,
               sample<ggx_anisotropic>),
    density_row("ggx-anisotropic", "ggx_anisotropic_pdf", "The density of the directions of ggx_anisotropic_sample.",
                visible_normals, 8e-6, density<ggx_anisotropic>),
    sample_row("kulla-conty", "kulla_conty_sample",
               "A direction to the light for the BRDF of Kulla and Conty, by importance.", visible_normals_or_cosine,
               1e-4, sample<kulla_conty>),
    density_row("kulla-conty", "kulla_conty_pdf", "The density of the directions of kulla_conty_sample.",
                visible_normals_or_cosine, 2e-6, density<kulla_conty>),
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
    ltc_row("sphere", "ltc", "ggx", "sphere_shade_ggx_ltc", "A GGX surface under a uniform sphere.", by_rows,
            {3e-4, 3e-4}, highlight_ltc<Sphere>),
    ltc_row("disk", "ltc", "ggx", "disk_shade_ggx_ltc", "A GGX surface under a uniform one-sided disk.", by_rows,
            {2e-2, 2e-1}, highlight_ltc<Disk>),
    ltc_row("rect", "ltc", "ggx", "rect_shade_ggx_ltc", "A GGX surface under a uniform one-sided rectangle.", by_rows,
            {5e-5, 1}, highlight_ltc<Rectangle>),
    ltc_row("tube", "ltc", "ggx", "tube_shade_ggx_ltc", "A GGX surface under a uniform tube.", by_rows, {2e-4, 3e-4},
            highlight_ltc<Tube>),
    ltc_row("sphere", "ltc-share", "ggx", "sphere_shade_ggx_ltc_share", "A GGX surface under a uniform sphere.",
            by_share, {2e-3, 2e-3}, highlight_by_share<Sphere>),
    ltc_row("disk", "ltc-share", "ggx", "disk_shade_ggx_ltc_share", "A GGX surface under a uniform one-sided disk.",
            by_share, {3e-2, 3e-1}, highlight_by_share<Disk>),
    ltc_row("rect", "ltc-share", "ggx", "rect_shade_ggx_ltc_share",
            "A GGX surface under a uniform one-sided rectangle.", by_share, {3e-5, 2}, highlight_by_share<Rectangle>),
    ltc_row("tube", "ltc-share", "ggx", "tube_shade_ggx_ltc_share", "A GGX surface under a uniform tube.", by_share,
            {1e-3, 1e-3}, highlight_by_share<Tube>),
    ltc_row("sphere", "ltc", "ggx-anisotropic", "sphere_shade_ggx_anisotropic_ltc",
            "An anisotropic GGX surface under a uniform sphere.", by_stretched_rows, {6e-5, 6e-4},
            highlight_anisotropic<Sphere>),
    ltc_row("disk", "ltc", "ggx-anisotropic", "disk_shade_ggx_anisotropic_ltc",
            "An anisotropic GGX surface under a uniform one-sided disk.", by_stretched_rows, {2e-5, 7e-1},
            highlight_anisotropic<Disk>),
    ltc_row("rect", "ltc", "ggx-anisotropic", "rect_shade_ggx_anisotropic_ltc",
            "An anisotropic GGX surface under a uniform one-sided rectangle.", by_stretched_rows, {1e-5, 2e-3},
            highlight_anisotropic<Rectangle>),
    ltc_row("tube", "ltc", "ggx-anisotropic", "tube_shade_ggx_anisotropic_ltc",
            "An anisotropic GGX surface under a uniform tube.", by_stretched_rows, {7e-3, 2e-2},
            highlight_anisotropic<Tube>),
    ltc_row("sphere", "ltc", "ue4", "sphere_shade_ue4_ltc", "Unreal Engine 4's material under a uniform sphere.",
            exact_and_by_rows, {2e-4, 2e-4}, shade_ltc<Sphere, sphere_stages, ue4>),
    ltc_row("disk", "ltc", "ue4", "disk_shade_ue4_ltc", "Unreal Engine 4's material under a uniform one-sided disk.",
            exact_and_by_rows, {3e-3, 6e-3}, shade_ltc<Disk, disk_stages, ue4>),
    ltc_row("rect", "ltc", "ue4", "rect_shade_ue4_ltc",
            "Unreal Engine 4's material under a uniform one-sided rectangle.", exact_and_by_rows, {4e-5, 5e-4},
            shade_ltc<Rectangle, rectangle_stages, ue4>),
    ltc_row("tube", "ltc", "ue4", "tube_shade_ue4_ltc", "Unreal Engine 4's material under a uniform tube.",
            exact_and_by_rows, {2e-4, 2e-4}, shade_ltc<Tube, tube_stages, ue4>),
    ltc_row("sphere", "ltc", "gltf", "sphere_shade_gltf_ltc", "The material of glTF 2.0 under a uniform sphere.",
            mean_and_by_rows, {2e-4, 4e-4}, shade_ltc<Sphere, sphere_stages, gltf>),
    ltc_row("disk", "ltc", "gltf", "disk_shade_gltf_ltc", "The material of glTF 2.0 under a uniform one-sided disk.",
            mean_and_by_rows, {2e-2, 4e-2}, shade_ltc<Disk, disk_stages, gltf>),
    ltc_row("rect", "ltc", "gltf", "rect_shade_gltf_ltc",
            "The material of glTF 2.0 under a uniform one-sided rectangle.", mean_and_by_rows, {3e-5, 8e-1},
            shade_ltc<Rectangle, rectangle_stages, gltf>),
    ltc_row("tube", "ltc", "gltf", "tube_shade_gltf_ltc", "The material of glTF 2.0 under a uniform tube.",
            mean_and_by_rows, {1e-4, 2e-4}, shade_ltc<Tube, tube_stages, gltf>),
    ltc_row("sphere", "ltc", "frostbite", "sphere_shade_frostbite_ltc", "Frostbite's material under a uniform sphere.",
            mean_and_by_rows, {3e-4, 3e-4}, shade_ltc<Sphere, sphere_stages, frostbite>),
    ltc_row("disk", "ltc", "frostbite", "disk_shade_frostbite_ltc",
            "Frostbite's material under a uniform one-sided disk.", mean_and_by_rows, {2e-2, 2e-1},
            shade_ltc<Disk, disk_stages, frostbite>),
    ltc_row("rect", "ltc", "frostbite", "rect_shade_frostbite_ltc",
            "Frostbite's material under a uniform one-sided rectangle.", mean_and_by_rows, {9e-5, 4e-3},
            shade_ltc<Rectangle, rectangle_stages, frostbite>),
    ltc_row("tube", "ltc", "frostbite", "tube_shade_frostbite_ltc", "Frostbite's material under a uniform tube.",
            mean_and_by_rows, {3e-4, 3e-3}, shade_ltc<Tube, tube_stages, frostbite>),
    roughness_row("ggx-anisotropic", "ggx_anisotropic_roughness",
                  "Where an anisotropic lobe reads the table of isotropic ones.", heitz, 4e-7, anisotropic_roughness),
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

std::span<const Formula> formulas() {
    return all;
}

Function recorded(const Formula& formula) {
    Function function;
    function.name = formula.function;
    const Recording recording(function.graph);
    formula.record(function);
    function.mark_unused_parameters();
    return function;
}

} // namespace gonio::shader
