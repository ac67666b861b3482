// Where formulas come from, for those that several lists name.
#pragma once

#include <string_view>

namespace gonio::shader {

inline constexpr std::string_view snyder = "Snyder 1996; Lagarde and de Rousiers 2014; without their cotangents";
inline constexpr std::string_view lambert_integral =
    "Lambert's contour integral (Photometria, 1760), clipped to the horizon";
inline constexpr std::string_view frostbite_notes =
    "Lagarde and de Rousiers, Moving Frostbite to Physically Based Rendering, 2014; misprints corrected";
inline constexpr std::string_view karis = "Karis, Real Shading in Unreal Engine 4, 2013";
inline constexpr std::string_view inverse_square_law = "Inverse square law";
inline constexpr std::string_view khronos = "Khronos, glTF 2.0 Specification, appendix B";
inline constexpr std::string_view eon_paper = "Portsmouth, Kutz and Hill, EON, JCGT 14(1), 2025";
inline constexpr std::string_view remember_me = "Lagarde and Harduin, The Art of Remember Me, 2013";
inline constexpr std::string_view heitz = "Heitz, JCGT 3(2), 2014; Schlick 1994";
inline constexpr std::string_view kulla_and_conty =
    "Kulla and Conty, Revisiting Physically Based Shading at Imageworks, 2017. Albedos: gonio bake --table kulla-conty";

} // namespace gonio::shader
