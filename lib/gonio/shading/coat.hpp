// A clear coat over any material: one GGX lobe with f0 = 0.04 on top (an index of refraction of 1.5), and what it
// leaves of the material below. It has no thickness: nothing is refracted sideways or absorbed.
//
//     f = f_coat + T(l, v) f_base
//
// E(μ) is the directional albedo of the coat (ggx_albedo.hpp), Ē its mean over the hemisphere. Light from l passes the
// coat with 1 − E(l), and leaves it towards v with 1 − E(v). Of what the base scatters inside, the coat throws a share
// e back, of which the base reflects R, and so on:
//
//     T = (1 − E(l))(1 − E(v)) Σ (R e)ⁿ = (1 − E(l))(1 − E(v))/(1 − R e). (physical)
//
// A matte base forgets the direction, so e = Ē and R is its albedo. This is the albedo scaling of Kulla and Conty
// (2017) for a coat. A white Lambertian base reflects exactly all light. A base with a lobe keeps the direction: a
// mirror has l and v at the same angle, e = E(l) = E(v) and R = F. Between the two e = min(E(l), E(v)). Then T ≤ min(1
// − E(l), 1 − E(v)), since (1 − m)/(1 − R m) ≤ 1, and so for every base with an albedo A(v) ≤ 1
//
//     E(v) + ∫ T f_base n·l dl ≤ E(v) + (1 − E(v)) A(v) ≤ 1.
//
// No reciprocal T that depends on l and v alone can be greater for all bases, as one of them reflects all light from l
// to v. A coated mirror has the exact E + (1 − E)² F/(1 − F E). All of this is reciprocal. A base that reflects more
// than it gets, as some of the list do at grazing angles, remains above 1 by no more than (1 − E) times as much.
//
// The other two orders take Fresnel's reflectance of one microfacet for that of the coat, F = Schlick's at l·h:
//
//     T = (1 − F)²    Unreal Engine 4 (B. Karis, from 2014 on) (ue4) T = 1 − F       Filament, "Physically Based
//     Rendering in Filament" (Guy and Agopian 2018)               (filament)
//
// Both are reciprocal and reflect more light than they get at grazing angles: README.md. They are kept for comparison.
#pragma once

#include <gonio/shading/brdf_eon.hpp>
#include <gonio/shading/brdf_frostbite.hpp>
#include <gonio/shading/brdf_lobes.hpp>
#include <gonio/shading/brdf_sample.hpp>
#include <gonio/shading/coat_order.hpp>
#include <gonio/shading/ggx.hpp>
#include <gonio/shading/ggx_albedo.hpp>
#include <gonio/shading/gloss.hpp>
#include <gonio/shading/vec3.hpp>
#include <gonio/simd/math.hpp>

namespace gonio::shading {

inline constexpr double coat_f0 = 0.04;

template<class S>
struct CoatNumbers {
    GgxAlbedo<S> albedo; // holds α too
    S amount;            // what it reflects is multiplied by it, [0, 1]
    S shine;             // of its lobe: the amount, or 0 without specular lobes
    vec3<S> gain;        // 1/(1 − R e) of the part of the base without a lobe
    vec3<S> wide;        // R of that part where it is a wide lobe, else 0
};
template<class S>
struct Coat : CoatNumbers<S> {
    CoatOrder order;
};

// What the coat leaves of the base: T = both·gain, or both/(1 − R·least) for a lobe.
template<class S>
struct CoatPass {
    S both;
    S least; // e

    GONIO_FORCE_INLINE S lobe(S reflectance) const { return both / (S(1) - simd::min(reflectance, S(1)) * least); }
    // Of the part without a lobe.
    GONIO_FORCE_INLINE vec3<S> scattered(const Coat<S>& coat) const {
        return {coat.gain.x * lobe(coat.wide.x), coat.gain.y * lobe(coat.wide.y), coat.gain.z * lobe(coat.wide.z)};
    }
    // A lobe with its reflectance.
    GONIO_FORCE_INLINE vec3<S> reflected(vec3<S> f0, S f90, S factor, SpecularTerms<S> terms) const {
        const auto channel = [&](S f) {
            const S reflectance = factor * simd::mul_add(f90 - f, terms.grazing, f);
            return terms.scale * reflectance * lobe(reflectance);
        };
        return {channel(f0.x), channel(f0.y), channel(f0.z)};
    }
};

template<class S>
GONIO_FORCE_INLINE S coat_alpha(const Coat<S>& coat) {
    return coat.albedo.loss.alpha;
}
// The share of light that the coat reflects, by the cosine.
template<class S>
GONIO_FORCE_INLINE S coat_albedo(const Coat<S>& coat, S cosine) {
    return coat.amount * coat.albedo(simd::min(simd::max(cosine, S(0)), S(1)), S(coat_f0), S(1));
}
// The lobe on top.
template<class S>
GONIO_FORCE_INLINE S coat_reflected(const Coat<S>& coat, SpecularTerms<S> terms) {
    return coat.shine * terms.scale * simd::mul_add(S(1.0 - coat_f0), terms.grazing, S(coat_f0));
}

// For the albedos of both directions.
template<class S>
GONIO_FORCE_INLINE CoatPass<S> coat_pass(S towards_light, S towards_eye) {
    return {(S(1) - towards_light) * (S(1) - towards_eye), simd::min(towards_light, towards_eye)};
}
// `grazing` is (1 − l·h)⁵; for the orders `ue4` and `filament`.
template<class S>
GONIO_FORCE_INLINE CoatPass<S> coat_pass_of_facet(const Coat<S>& coat, S grazing) {
    const S left = S(1) - coat.amount * simd::mul_add(S(1.0 - coat_f0), grazing, S(coat_f0));
    return {coat.order == CoatOrder::ue4 ? left * left : left, S(0)};
}
template<class S>
GONIO_FORCE_INLINE CoatPass<S> coat_pass(const Coat<S>& coat, S n_dot_l, S n_dot_v, S grazing) {
    if (coat.order == CoatOrder::physical) return coat_pass(coat_albedo(coat, n_dot_l), coat_albedo(coat, n_dot_v));
    return coat_pass_of_facet(coat, grazing);
}

namespace detail {

// The albedo of the part of a base that forgets the direction, R of each channel.
template<class S, template<class> class Material>
GONIO_FORCE_INLINE vec3<S> matte_albedo(const Material<S>& base) {
    if constexpr (requires { base.albedo; })
        return base.albedo;
    else
        return {S(0), S(0), S(0)};
}
// How much of Ē the coat throws back of what the matte part scatters, at least, over all views. Seen along the normal,
// a rough EON and a smooth Disney diffuse scatter less towards grazing directions than Lambert.
template<class S, template<class> class Material>
GONIO_FORCE_INLINE S least_return(const Material<S>& base) {
    if constexpr (__is_same(Material<S>, Eon<S>))
        return simd::mul_add(base.roughness, S(-0.09), S(1));
    else if constexpr (__is_same(Material<S>, Frostbite<S>))
        return simd::mul_add(base.linear_roughness, S(0.16), S(0.84));
    else
        return S(1);
}
// Schlick's reflectance, its mean over the hemisphere, of a base whose lobe has a wide lobe beside it.
template<class S, template<class> class Material>
GONIO_FORCE_INLINE vec3<S> wide_reflectance(const Material<S>& base) {
    const auto mean_of = [](S f) { return simd::mul_add(S(1) - f, S(1.0 / 21.0), f); };
    if constexpr (Material<S>::lobe == LobeKind::ggx_and_more)
        return {mean_of(base.f0.x), mean_of(base.f0.y), mean_of(base.f0.z)};
    else
        return {S(0), S(0), S(0)};
}

template<class S>
GONIO_FORCE_INLINE SpecularTerms<S> coat_lobe(const Coat<S>& coat, vec3<S> n, vec3<S> l, vec3<S> v, S widening) {
    const S alpha = coat_alpha(coat);
    return specular_ggx(n, l, v, alpha, widened_alpha(alpha, widening));
}
template<class S>
GONIO_FORCE_INLINE S facet_weight(vec3<S> l, vec3<S> v) {
    return schlick_weight(simd::min(simd::max(dot(l, normalized(l + v)), S(0)), S(1)));
}

} // namespace detail

// A coat over `base`; amount and smoothness in [0, 1], α = (1 − smoothness)².
template<class S, template<class> class Material>
GONIO_FORCE_INLINE Coat<S> coat_over(const Material<S>& base, S amount, S smoothness, CoatOrder order) {
    const S roughness = S(1) - smoothness;
    Coat<S> coat{{ggx_albedo(roughness * roughness), amount, amount, {S(1), S(1), S(1)}, {S(0), S(0), S(0)}}, order};
    if (order != CoatOrder::physical) return coat;
    const S back = amount * coat.albedo.mean(S(coat_f0), S(1)) * detail::least_return(base);
    const vec3<S> matte = detail::matte_albedo(base);
    const auto gain = [&](S albedo) { return S(1) / (S(1) - back * simd::min(albedo, S(1))); };
    coat.gain = {gain(matte.x), gain(matte.y), gain(matte.z)};
    coat.wide = detail::wide_reflectance(base);
    return coat;
}

// The parts of a coated material; brdf_sample.hpp says what each is. The coat itself counts as specular.
template<class S, template<class> class Material>
GONIO_FORCE_INLINE vec3<S> coated_diffuse_part(const Coat<S>& coat, const Material<S>& base, vec3<S> n, vec3<S> l,
                                               vec3<S> v) {
    const CoatPass<S> pass = coat_pass(coat, dot(n, l), dot(n, v), detail::facet_weight(l, v));
    return diffuse_part(base, n, l, v) * pass.scattered(coat);
}
template<class S, template<class> class Material>
GONIO_FORCE_INLINE vec3<S> coated_specular_part(const Coat<S>& coat, const Material<S>& base, vec3<S> n, vec3<S> l,
                                                vec3<S> v, S widening) {
    const S shine = coat_reflected(coat, detail::coat_lobe(coat, n, l, v, widening));
    vec3<S> sum{shine, shine, shine};
    if constexpr (Material<S>::lobe != LobeKind::none) {
        const auto glossy = gloss(base);
        const S alpha = widened_alpha(glossy.lobe.alpha, widening);
        const SpecularTerms<S> terms = glossy.lobe(n, l, v, alpha);
        const CoatPass<S> pass = coat_pass(coat, dot(n, l), dot(n, v), terms.grazing);
        sum = sum + pass.reflected(glossy.f0, glossy.f90, glossy.factor, terms);
        if constexpr (Material<S>::lobe == LobeKind::ggx_and_more)
            sum = sum + multiple_scattering(base, n, l, v) * pass.scattered(coat);
    }
    return sum;
}

namespace detail {

// How often the coat's lobe is sampled: by what it reflects towards the mirrored view, at least one sample in ten of
// either.
template<class S, template<class> class Material>
GONIO_FORCE_INLINE S coat_share(const Coat<S>& coat, const Material<S>& base, S n_dot_v) {
    const S of_coat = coat.shine * coat.albedo(simd::min(simd::max(n_dot_v, S(0)), S(1)), S(coat_f0), S(1));
    S of_base = mean(matte_albedo(base));
    if constexpr (Material<S>::lobe != LobeKind::none) of_base = of_base + mean(gloss(base).f0) * gloss(base).factor;
    const S left = (S(1) - of_coat) * simd::min(of_base, S(1));
    const S share = of_coat / simd::max(of_coat + left, S(1e-6));
    return simd::select(coat.shine > S(0), simd::min(simd::max(share, S(0.1)), S(0.9)), S(0));
}

} // namespace detail

// The density of coated_sample [1/sr].
template<class S, template<class> class Material>
GONIO_FORCE_INLINE S coated_pdf(const Coat<S>& coat, const Material<S>& base, vec3<S> n, vec3<S> v, vec3<S> l) {
    const S share = detail::coat_share(coat, base, dot(n, v));
    return simd::mul_add(share, pdf_reflected_ggx(n, v, l, coat_alpha(coat)), (S(1) - share) * pdf_brdf(base, n, v, l));
}
template<class S, template<class> class Material>
GONIO_FORCE_INLINE BrdfSample<S> coated_sample(const Coat<S>& coat, const Material<S>& base, vec3<S> n, vec3<S> v,
                                               vec3<S> u) {
    const S share = detail::coat_share(coat, base, dot(n, v));
    const auto of_coat = u.z < share;
    const TangentFrame<S> frame(n);
    const vec3<S> mirrored = frame.to_world(reflected_direction_ggx(frame.to_local(v), coat_alpha(coat), u.x, u.y));
    const S rest = simd::min(simd::max((u.z - share) / (S(1) - share), S(0)), S(0.99999994));
    const vec3<S> l = select(of_coat, mirrored, sample_brdf(base, n, v, {u.x, u.y, rest}).l);
    return {l, coated_pdf(coat, base, n, v, l)};
}

} // namespace gonio::shading
