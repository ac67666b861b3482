// The second factor of the split sum (B. Karis, "Real Shading in Unreal Engine 4", 2013): what a glossy surface
// reflects of uniform light, as A F0 + B F90 under Schlick's reflectance.
//
//     A = ∫ (1 − Fc) D G/(4 n·v) dω,  B = ∫ Fc D G/(4 n·v) dω,  Fc = (1 − v·h)⁵
//
// by quadrature over half vectors, to 1e-7. α = r². n·v in (0, 1], linear roughness r in [0, 1]: outside, NaN.
#pragma once

#include <gonio/base/result.hpp>

#include <cstdint>
#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// Which renderer's BRDF is integrated.
enum class SplitSumModel : std::uint8_t {
    ggx,      // height-correlated Smith (E. Heitz, JCGT 3(2), 2014): Filament
    ue4,      // Smith apart for light and eye, with Schlick's form at k = α/2 (Karis 2013)
    frostbite // as ggx, and the diffuse part of S. Lagarde and C. de Rousiers, 2014
};

// A model by its name in text.
struct SplitSumModelInfo {
    std::string_view name; // "ggx"
    SplitSumModel model;
    std::string_view summary;
};

// All of them, and the one of a model.
std::span<const SplitSumModelInfo> split_sum_models();
const SplitSumModelInfo& info_of(SplitSumModel model);

// Fails (usage) on an unknown name.
Result<SplitSumModel> parse_split_sum_model(std::string_view text);

// The reflectance under uniform light: F0 scale + bias.
struct SplitSum {
    double scale = 0.0;   // A: the factor of F0
    double bias = 0.0;    // B: the factor of F90
    double diffuse = 0.0; // of frostbite: the albedo of the renormalised Disney diffuse part for a base colour of 1

    // What is reflected of uniform light by F0 = F90 = 1, scattered once.
    [[nodiscard]] double albedo() const { return scale + bias; }
};

// By quadrature; n_dot_v and the linear roughness in [0, 1].
SplitSum split_sum(double n_dot_v, double roughness, SplitSumModel model = SplitSumModel::ggx);

// The mean of albedo() over uniform light, 2 ∫ E(μ) μ dμ, to 1e-6.
double mean_albedo(double roughness, SplitSumModel model = SplitSumModel::ggx);

// Light that is scattered more than once, under uniform light. All give 1 for F0 = 1.
enum class MultipleScattering : std::uint8_t {
    none,
    filament,    // × 1 + F0 (1/E − 1) (Filament)
    kulla_conty, // + (1 − E) F² Ē/(1 − F (1 − Ē)), F the mean reflectance (C. Kulla and A. Conty, 2017)
    fdez_aguera  // + (1 − E) (A F0 + B) F/(1 − F (1 − E)) (C. Fdez-Agüera, JCGT 8(1), 2019)
};

// A scheme by its name in text.
struct MultipleScatteringInfo {
    std::string_view name; // "kulla-conty"
    MultipleScattering scheme;
    std::string_view summary;
};

// All of them, and the one of a scheme.
std::span<const MultipleScatteringInfo> multiple_scattering_schemes();
const MultipleScatteringInfo& info_of(MultipleScattering scheme);

// Fails (usage) on an unknown name.
Result<MultipleScattering> parse_multiple_scattering(std::string_view text);

// What a surface with this F0 (F90 = 1) reflects of uniform light. `mean` is mean_albedo() of its roughness.
double specular_albedo(double f0, const SplitSum& sum, double mean, MultipleScattering scheme);

} // namespace gonio
#pragma GCC visibility pop
