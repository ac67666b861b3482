// Materials with the parameters that their functions take, and their BRDFs, recorded.
#pragma once

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

namespace gonio::shader {

// Materials: f [1/sr] for light from l, seen from v.

struct Ways {
    Vector n, l, v;
};

inline core::Lambert<S> lambert(Function& f) {
    return {color_of(f, "albedo")};
}
inline core::Eon<S> eon(Function& f) {
    const Vector albedo = color_of(f, "albedo");
    return {albedo, share_of(f, "roughness")};
}
inline core::Frostbite<S> frostbite(Function& f) {
    const Vector base = color_of(f, "base_color");
    const S smoothness = share_of(f, "smoothness");
    const S metallic = share_of(f, "metallic");
    return core::frostbite_material(base, smoothness, metallic,
                                    share_of(f, "reflectance", "[0, 1]; 0.5 is a reflectance of 0.04"));
}
inline core::Ue4<S> ue4(Function& f) {
    const Vector base = color_of(f, "base_color");
    const S metallic = share_of(f, "metallic");
    const S roughness = share_of(f, "roughness");
    const S specular = share_of(f, "specular", "[0, 1]; 0.5 is a reflectance of 0.04");
    return core::ue4_material(base, metallic, roughness, specular, share_of(f, "cavity", "[0, 1]; 1 for none"));
}
inline core::Gltf<S> gltf(Function& f) {
    const Vector base = color_of(f, "base_color");
    const S metallic = share_of(f, "metallic");
    return core::gltf_material(base, metallic, share_of(f, "roughness"));
}
inline core::Blinn<S> blinn(Function& f) {
    const Vector albedo = color_of(f, "albedo");
    const Vector f0 = color_of(f, "f0", "[0, 1], reflectance at normal incidence");
    const S smoothness = share_of(f, "smoothness");
    return core::blinn_material(albedo, f0, smoothness, share_of(f, "wetness"));
}
inline core::Ggx<S> ggx(Function& f) {
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
inline LookedUpKullaConty<S> kulla_conty(Function& f) {
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
inline GrainedGgx ggx_anisotropic(Function& f) {
    return GrainedGgx(f);
}
inline core::FacetPose<S> facet_pose(const GrainedGgx& material, Vector n, Vector l, Vector v) {
    return {core::TangentFrame<S>(material.grain.tangent, n), l, v};
}
inline Vector brdf_of(Function& f, const GrainedGgx& material, const Ways& ways) {
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

} // namespace gonio::shader
