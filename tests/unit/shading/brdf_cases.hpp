// Every material with parameters that reach its corners, for the tests that apply to all.
#pragma once

#include <gonio/shading/brdf.hpp>
#include <gonio/shading/coat.hpp>

#include "poses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace brdf_cases {

using gonio::shading::vec3;
using poses::Vec;

template<class S>
vec3<S> to(Vec a) {
    return {static_cast<S>(a.x), static_cast<S>(a.y), static_cast<S>(a.z)};
}

// A coat over one base, as a material of its own.
template<class S, template<class> class Base>
struct CoatOver {
    Base<S> base;
    gonio::shading::Coat<S> coat;
};
template<class S, template<class> class Base>
vec3<S> diffuse_part(const CoatOver<S, Base>& m, vec3<S> n, vec3<S> l, vec3<S> v) {
    return coated_diffuse_part(m.coat, m.base, n, l, v);
}
template<class S, template<class> class Base>
vec3<S> specular_part(const CoatOver<S, Base>& m, vec3<S> n, vec3<S> l, vec3<S> v, S widening) {
    return coated_specular_part(m.coat, m.base, n, l, v, widening);
}
template<class S, template<class> class Base>
vec3<S> brdf(const CoatOver<S, Base>& m, vec3<S> n, vec3<S> l, vec3<S> v) {
    return diffuse_part(m, n, l, v) + specular_part(m, n, l, v, S(0));
}
template<class S, template<class> class Base>
S lobe_alpha(const CoatOver<S, Base>& m) {
    return gonio::simd::min(lobe_alpha(m.base), coat_alpha(m.coat));
}
template<class S, template<class> class Base>
S pdf_brdf(const CoatOver<S, Base>& m, vec3<S> n, vec3<S> v, vec3<S> l) {
    return coated_pdf(m.coat, m.base, n, v, l);
}
template<class S, template<class> class Base>
auto sample_brdf(const CoatOver<S, Base>& m, vec3<S> n, vec3<S> v, vec3<S> u) {
    return coated_sample(m.coat, m.base, n, v, u);
}
template<class S, template<class> class Base>
CoatOver<S, Base> coated(const Base<S>& base, double amount, double smoothness,
                         gonio::shading::CoatOrder order = gonio::shading::CoatOrder::physical) {
    return {base, gonio::shading::coat_over(base, S(amount), S(smoothness), order)};
}

// The smaller α of a lobe.
template<class M>
double least_alpha(const M& material) {
    return lobe_alpha(material);
}
inline double least_alpha(const gonio::shading::Anisotropic<double>& material) {
    return std::min(material.alphas.x, material.alphas.y);
}

// Calls visit(name, make) for each case; make(S()) is the material with scalar S.
template<class Visit>
void each(const Visit& visit) {
    namespace g = gonio::shading;
    const Vec red{0.8, 0.4, 0.2};
    for (const double albedo : {0.0, 0.5, 1.0})
        visit(fmt::format("lambert {}", albedo), [=]<class S>(S) {
            return g::Lambert<S>{{S(albedo), S(albedo), S(albedo)}};
        });
    for (const double alpha : {0.0, 1e-4, 0.03, 0.2, 1.0}) {
        visit(fmt::format("ggx {}", alpha), [=]<class S>(S) {
            return g::Ggx<S>{{S(red.x), S(red.y), S(1)}, S(alpha)};
        });
        visit(fmt::format("kulla-conty {}", alpha), [=]<class S>(S) {
            return g::kulla_conty_material<S>({S(red.x), S(red.y), S(1)}, S(alpha));
        });
    }
    for (const double smoothness : {0.0, 0.5, 0.8, 1.0}) {
        const double roughness = 1.0 - smoothness;
        visit(fmt::format("frostbite {}", smoothness), [=]<class S>(S) {
            return g::frostbite_material<S>({S(red.x), S(red.y), S(red.z)}, S(smoothness), S(0.25), S(0.5));
        });
        visit(fmt::format("ue4 {}", smoothness), [=]<class S>(S) {
            return g::ue4_material<S>({S(red.x), S(red.y), S(red.z)}, S(0.25), S(roughness), S(0.5), S(0.9));
        });
        visit(fmt::format("gltf {}", smoothness), [=]<class S>(S) {
            return g::gltf_material<S>({S(red.x), S(red.y), S(red.z)}, S(0.25), S(roughness));
        });
        for (const double wet : {0.0, 1.0}) {
            if (wet > 0.0 && smoothness >= 0.5) continue; // no pores to fill
            visit(fmt::format("blinn {} wet {}", smoothness, wet), [=]<class S>(S) {
                return g::blinn_material<S>({S(red.x), S(red.y), S(red.z)}, {S(0.04), S(0.3), S(1)}, S(smoothness),
                                            S(wet));
            });
        }
    }
    for (const auto& [along, across] : {std::pair{0.9, 0.1}, {0.03, 0.4}, {1e-4, 0.2}, {1.4, 1e-4}})
        visit(fmt::format("anisotropic {} {}", along, across), [along = along, across = across, red]<class S>(S) {
            // Beside a lobe that is next to nothing, glTF's diffuse part shows that l·h of opposite directions is
            // reciprocal to fewer digits.
            const double diffuse = along < 1e-3 || across < 1e-3 ? 0.0 : 1.0;
            return g::Anisotropic<S>{{S(diffuse * red.x), S(diffuse * red.y), S(diffuse * red.z)},
                                     {S(0.04), S(0.3), S(1)},
                                     S(1),
                                     {S(along), S(across)},
                                     {{S(0.3), S(-0.2), S(0.9)}, S(0.8), S(0.6)}};
        });
    for (const double roughness : {0.0, 0.3, 1.0})
        visit(fmt::format("eon {}", roughness), [=]<class S>(S) {
            return g::Eon<S>{{S(red.x), S(red.y), S(1)}, S(roughness)};
        });
    using Order = g::CoatOrder;
    for (const double smoothness : {0.0, 0.5, 0.9}) {
        visit(fmt::format("lambert, coat {}", smoothness), [=]<class S>(S) {
            return coated(g::Lambert<S>{{S(red.x), S(red.y), S(1)}}, 1.0, smoothness);
        });
        visit(fmt::format("frostbite, coat {}", smoothness), [=]<class S>(S) {
            return coated(g::frostbite_material<S>({S(red.x), S(red.y), S(1)}, S(0.3), S(0.25), S(0.5)), 0.7,
                          smoothness);
        });
        visit(fmt::format("kulla-conty, coat {}", smoothness), [=]<class S>(S) {
            return coated(g::kulla_conty_material<S>({S(red.x), S(red.y), S(1)}, S(0.5)), 1.0, smoothness);
        });
    }
    visit("eon, coat of ue4", []<class S>(S) {
        return coated(g::Eon<S>{{S(0.8), S(0.4), S(1)}, S(0.5)}, 1.0, 0.2, Order::ue4);
    });
    visit("blinn, coat of filament", []<class S>(S) {
        return coated(g::blinn_material<S>({S(0.8), S(0.4), S(0.2)}, {S(0.04), S(0.3), S(1)}, S(0.2), S(0)), 0.5, 0.4,
                      Order::filament);
    });
}

} // namespace brdf_cases
