// Printed by fit/ggx_mean_cosine.cpp: where Schlick's weight has its mean over what GGX facets reflect.
#pragma once

#include <cstddef>

// clang-format off
namespace gonio::shading::detail {

inline constexpr std::size_t ggx_mean_cosine_of_z = 8;
inline constexpr std::size_t ggx_mean_cosine_of_root = 10;

// μ̂ = μ + α z Σᵢ Σⱼ c[i][j] Tᵢ(2z − 1) Tⱼ(2√α − 1), z = α/(μ + α), T Chebyshev's polynomials.
// Largest error of B = S (1 − μ̂)⁵ for 1e-4 ≤ α ≤ 1: 1.2e-03, from μ = 0.01 on 8.9e-04.
inline constexpr float ggx_mean_cosine_terms[ggx_mean_cosine_of_z * ggx_mean_cosine_of_root] = {
    4.490586F, 4.494052F, 8.491690F, 2.467416F, -0.225664F,
    -1.999545F, -1.789786F, -1.339519F, -0.551760F, -0.147328F,
    -4.619323F, -13.142187F, -13.303998F, -5.581079F, 1.056488F,
    3.256507F, 3.425558F, 2.322371F, 1.025169F, 0.245901F,
    3.941429F, 10.716529F, 10.091661F, 4.035861F, -0.786565F,
    -2.384134F, -2.534569F, -1.677501F, -0.741031F, -0.157128F,
    -2.841564F, -6.864655F, -6.301876F, -2.306669F, 0.456257F,
    1.411203F, 1.496815F, 0.970111F, 0.417901F, 0.074056F,
    1.496883F, 3.486489F, 3.082370F, 1.037490F, -0.213906F,
    -0.644861F, -0.693151F, -0.433005F, -0.179223F, -0.023078F,
    -0.559355F, -1.329839F, -1.140588F, -0.334047F, 0.066059F,
    0.220771F, 0.236205F, 0.142910F, 0.053894F, 0.003539F,
    0.129425F, 0.354734F, 0.284202F, 0.069602F, -0.012582F,
    -0.048599F, -0.055522F, -0.029951F, -0.010447F, 0.000563F,
    -0.017422F, -0.043942F, -0.045145F, 0.001117F, -0.005632F,
    0.009677F, 0.004131F, 0.004495F, 0.000204F, -0.000050F,
};

} // namespace gonio::shading::detail
// clang-format on
