// Highlights of lights with a size, recorded: a lobe summed over rows of points, or a share that points correct; and
// materials whose lobe is such a highlight, with their diffuse part.
#pragma once

#include <gonio/shader/parameters.hpp>
// After the recording scalar.
#include <gonio/shading/anisotropic_lobe.hpp>
#include <gonio/shading/brdf_frostbite.hpp>
#include <gonio/shading/shade.hpp>
#include <gonio/shading/specular_by_share.hpp>
#include <gonio/shading/specular_ltc.hpp>

#include <string>
#include <string_view>
#include <type_traits>

namespace gonio::shader {

// What every highlight takes, and its luminance per luminance of the light.
template<class Light>
struct Highlight {
    Light light;
    Vector view, f0;
    S f90;

    explicit Highlight(Function& f)
        : light(f),
          view(f.unit("view", "unit, from the surface to the eye")),
          f0(color_of(f, "f0", "[0, 1], reflectance at normal incidence")),
          f90(share_of(f, "f90", "[0, 1], reflectance at grazing incidence; 1 for most surfaces")) {}

    Vector luminance(const core::SpecularLuminance<S>& found) const {
        return (f0 + (Vector{f90, f90, f90} - f0) * found.grazing) * found.scale;
    }
};

// A transformed cosine by its six numbers, which come from a table (`gonio bake --table ltc-ggx`).
struct CosineNumbers {
    Vector leaning, reflected;

    // `where` says at which place of the table they are.
    CosineNumbers(Function& f, std::string_view where)
        : leaning(f.vector("leaning", where)),
          reflected(f.vector("reflected", "slant, albedo and grazing of the table at the same place")) {}

    core::LtcLobe<S> cosine(S alpha, S n_dot_v, S sine) const {
        const S mu = simd::min(simd::max(n_dot_v, S(0)), S(1));
        return core::detail::lobe_from(leaning.x, leaning.y, leaning.z, reflected.x, reflected.y, reflected.z, alpha,
                                       mu, sine);
    }
};

// GGX under an area light by linearly transformed cosines.
template<class Light>
struct CosineHighlight : Highlight<Light> {
    S roughness;
    CosineNumbers numbers;
    core::GgxLobe<S> lobe;

    explicit CosineHighlight(Function& f)
        : Highlight<Light>(f),
          roughness(share_of(f, "roughness", "linear, [0, 1]: alpha is its square")),
          numbers(f, "along, raised and across of the table at n.v and the roughness"),
          lobe{simd::max(roughness * roughness, S(core::minimum_alpha))} {}

    auto cosine_of() const {
        return [this](S n_dot_v, S sine) { return numbers.cosine(lobe.alpha, n_dot_v, sine); };
    }
};

template<class Pose>
void label_pose(Function& f, const Pose& pose) {
    f.label("n_dot_v", pose.n_dot_v);
    f.label("x", pose.frame.x, "The lobe's frame: x towards which the mirrored view leans, y, and the normal.");
    f.label("y", pose.frame.y);
    f.label("sine", pose.frame.sine, "Of the angle between normal and view.");
    f.label("m00", pose.cosine.m00, "The matrix that makes the lobe a cosine.");
    f.label("m02", pose.cosine.m02);
    f.label("m20", pose.cosine.m20);
    f.label("m22", pose.cosine.m22);
    f.label("center", pose.points.patch.center);
    f.label("size2", pose.size2, "Of the light after the transform.");
    f.label("distance2", pose.distance2);
}

// The sums at points in loops, and what their bodies compute.
inline void label_sums(Function& f, const core::detail::PointSums<S>& sums, std::string_view prefix,
                       std::string_view note) {
    const auto label = [&](std::string_view name, S value, std::string_view text = {}) {
        f.label(std::string(prefix) + std::string(name), value, text);
    };
    label("value", sums.value, note);
    label("grazing", sums.grazing);
}
template<class Points>
void label_points(Function& f, const Points& points, Vector v) {
    points.for_each([&](Vector p, S strength) {
        f.label("p", p);
        f.label("strength", strength);
        const S inverse = S(1) / simd::sqrt(simd::max(dot(p, p), S(1e-18)));
        f.label("inverse", inverse);
        f.label("l", p * inverse);
        const auto h = core::half_vector(p * inverse, v);
        f.label("l_dot_h", h.l_dot_h);
    });
}

// specular_ltc.hpp, in stages: nothing, points of the light, rows of points.
template<class Highlight, template<class> class Lobe, class CosineOf>
void rows_stages(Function& f, const Highlight& highlight, const Lobe<S>& lobe, const CosineOf& cosine_of) {
    const auto& light = highlight.light;
    const Vector view = highlight.view;
    const auto of = light.as_light();
    const auto pose_now = [&] { return core::detail::lobe_pose(of, light.to_center, light.normal, view, cosine_of); };
    const auto any_pose = pose_now();
    const auto [small, dark] = core::detail::lobe_cases(any_pose, of, light.to_center);
    label_pose(f, any_pose);
    f.label("small", small);
    f.label("dark", dark);
    const Vector none{S(0), S(0), S(0)};
    f.early(dark, S::of(none.node()), "Nothing of the light is above the horizon, or the surface is not seen.");

    const auto pose = pose_now(); // of an eye that sees the surface
    label_points(f, pose.points, pose.v);
    const auto sums = core::detail::point_sums(pose.points, lobe, pose.cosine, pose.v);
    label_sums(f, sums, "points_", "The lobe itself at points of the light, which are enough for a small one.");
    const auto by_points = core::detail::as_luminance(sums.value, core::detail::grazing_share(sums));
    f.early(small, S::of(highlight.luminance(by_points).node()), "Small against the lobe.");

    const auto region = core::detail::region_of(pose.cosine, pose.points, of, pose.frame, light.to_center);
    using Region = std::remove_cv_t<decltype(region)>;
    using Cosine = std::remove_cvref_t<decltype(pose.cosine)>;
    const core::detail::RowPoints<S, Region, Lobe<S>, Cosine> rows(region, pose.cosine, lobe, pose.v);
    label_points(f, rows, pose.v);
    label_sums(f, core::detail::point_sums(rows, lobe, pose.cosine, pose.v), "rows_",
               "Along rows of points that the cosine places in the light: the lobe itself.");
    f.returns(highlight.luminance(core::specular_ltc(of, light.to_center, light.normal, view, lobe, cosine_of)));
}
template<class Light>
void highlight_ltc(Function& f) {
    const CosineHighlight<Light> of(f);
    rows_stages(f, of, of.lobe, of.cosine_of());
}

// Where a material's lobe reads the table.
template<template<class> class Material>
inline constexpr std::string_view place_of_lobe = "along, raised and across of the table at n.v and the roughness";
template<>
inline constexpr std::string_view place_of_lobe<core::Frostbite> =
    "along, raised and across of the table at n.v and the roughness, which is 1 - smoothness";

// A material with a GGX lobe under an area light.
template<class Light, template<class> class Material>
struct ShadedByLtc {
    Light light;
    Vector view;
    Material<S> material;
    Vector diffuse; // its luminance

    Vector luminance(const core::SpecularLuminance<S>& found) const {
        return diffuse + core::gloss(material)({found.scale, found.grazing});
    }
};

// What depends on a point of the light in the mean of a diffuse factor (shade.hpp).
template<class Light>
void label_diffuse_points(Function& f, const Light& light) {
    std::string_view note = "Points of the light, for the mean of the diffuse factor.";
    core::detail::points_of(light.as_light(), core::detail::SameFrame{}, light.to_center)
        .for_each([&](Vector p, S strength) {
            f.label("to_point", p, note);
            note = {}; // once: a tube has more of them outside its loop
            const S inverse = S(1) / simd::sqrt(simd::max(dot(p, p), S(1e-18)));
            f.label("inverse_way", inverse);
            f.label("toward", p * inverse);
            const S cosine = simd::max(dot(light.normal, p * inverse), S(0));
            f.label("weight", strength * inverse * inverse * inverse * cosine);
        });
}

// shade.hpp by the method ltc: the exact irradiance, which `stages` records, times the diffuse factor or its mean, and
// the lobe in stages.
template<class Light, void (*stages)(Function&, const Light&), template<class> class Material>
void shade_by_rows(Function& f, const Light& light, Vector view, const Material<S>& material) {
    const CosineNumbers numbers(f, place_of_lobe<Material>);
    stages(f, light);
    f.join_stages();
    const S irradiance = S::of(f.stages.back().value);
    f.stages.clear();
    f.label("irradiance", irradiance);
    if constexpr (Material<S>::scattering != core::Scattering::uniform) label_diffuse_points(f, light);
    const core::SurfacePoint<S> point{{S(0), S(0), S(0)}, light.normal, view};
    const Vector diffuse = core::scattered_parts(point, light.as_light(), material, irradiance).diffuse;
    f.label("diffuse", diffuse);
    const ShadedByLtc<Light, Material> shaded{light, view, material, diffuse};
    const auto lobe = core::gloss(material).lobe;
    rows_stages(f, shaded, lobe, [&](S n_dot_v, S sine) { return numbers.cosine(lobe.alpha, n_dot_v, sine); });
}
template<class Light, void (*stages)(Function&, const Light&), auto material>
void shade_ltc(Function& f) {
    const Light light(f);
    const Vector view = f.unit("view", "unit, from the surface to the eye");
    shade_by_rows<Light, stages>(f, light, view, material(f));
}

// The lobe of anisotropic_lobe.hpp in the frame of a receiver.
inline core::AnisotropicGgxInFrame<S> lobe_in_frame(const GrainParameters& grain, Vector normal, Vector view) {
    const core::LtcFrame<S> frame = core::ltc_frame(normal, view);
    return {grain.alphas, {dot(frame.x, grain.tangent), dot(frame.y, grain.tangent)}, grain.alphas.mean()};
}
template<class Light>
void highlight_anisotropic(Function& f) {
    const Highlight<Light> of(f);
    const GrainParameters grain(f);
    const CosineNumbers numbers(f, "along, raised and across of the table at n.v and ggx_anisotropic_roughness");
    const core::AnisotropicGgxInFrame<S> lobe = lobe_in_frame(grain, of.light.normal, of.view);
    const S even_alpha = lobe.even_alpha();
    f.label("even_alpha", even_alpha, "Of the isotropic lobe that is as wide in the plane of normal and view.");
    rows_stages(f, of, lobe, [&](S n_dot_v, S sine) {
        return lobe.stretched(numbers.cosine(even_alpha, n_dot_v, sine), even_alpha);
    });
}
inline void anisotropic_roughness(Function& f) {
    const Vector normal = f.unit("normal", "unit, the receiver's");
    const Vector view = f.unit("view", "unit, from the surface to the eye");
    const GrainParameters grain(f);
    f.returns(simd::sqrt(lobe_in_frame(grain, normal, view).even_alpha()));
}

// specular_by_share.hpp.
template<class Light>
void highlight_by_share(Function& f) {
    const CosineHighlight<Light> of(f);
    // The simple case.
    const auto light = of.light.as_light();
    const auto pose = core::detail::lobe_pose(light, of.light.to_center, of.light.normal, of.view, of.cosine_of());
    constexpr double alone = core::detail::ltc_points_alone[0];
    const auto small = pose.size2 < S(alone * alone) * pose.distance2;
    const auto dark = pose.is_below();
    const auto sums = core::detail::point_sums(pose.points, of.lobe, pose.cosine, pose.v);
    label_pose(f, pose);
    f.label("small", small);
    f.label("dark", dark);
    f.label("by_points", sums.value, "The lobe itself at points of the light.");
    f.early(simd::either(small, dark), S::of(of.luminance(core::detail::points_alone(sums, dark)).node()),
            "Small against the lobe, or below the horizon: the points are enough.");
    f.returns(of.luminance(
        core::specular_by_share(light, of.light.to_center, of.light.normal, of.view, of.lobe, of.cosine_of())));
}

} // namespace gonio::shader
