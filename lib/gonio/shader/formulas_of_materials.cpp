// Every formula runs once here, to be recorded: the core's functions are called, since inlined they are twice as large.
#define GONIO_INLINE_BY_SIZE
#include <gonio/shader/formulas.hpp>
#include <gonio/shader/materials.hpp>
#include <gonio/shader/parameters.hpp>
#include <gonio/shader/sources.hpp>

#include <array>
#include <span>
#include <string_view>

namespace gonio::shader {

namespace {

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

// The rows of the list. Errors are what the test in tests/unit/shader prints, rounded up.

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

constexpr std::string_view visible_normals_or_cosine =
    "Dupuy and Benyoub, Sampling Visible GGX Normals with Spherical Caps, 2023, and cosine sampling. albedo_view: "
    "gonio bake --table kulla-conty";
constexpr std::string_view visible_normals =
    "Dupuy and Benyoub, Sampling Visible GGX Normals with Spherical Caps, 2023";

constexpr std::array all{
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
};

} // namespace

std::span<const Formula> formulas_of_materials() {
    return all;
}

} // namespace gonio::shader
