// The luminance of a luminaire by direction: its intensity over the area that its opening shows.
#pragma once

#include <gonio/figures/figure.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/web/web.hpp>

#include <array>

#pragma GCC visibility push(default)
namespace gonio {

// The directions of a diagram: the γ of glare limits (CIE 29.2, EN 12464-1), C every 15°.
inline constexpr std::array<double, 9> luminance_gammas_deg{45, 50, 55, 60, 65, 70, 75, 80, 85};
inline constexpr std::size_t luminance_planes = 24;

// Luminances in cd/m².
struct LuminanceDiagram {
    std::array<std::array<double, luminance_planes>, luminance_gammas_deg.size()> nt{}; // a row for each γ

    // Mean of two opposite planes, C and C + 180°, by γ: the lines of Söllner's diagram. C is a multiple of 15°.
    std::array<double, luminance_gammas_deg.size()> mean_of_planes_nt(int c_deg) const;

    // The greatest over C, at γ of 65, 75 or 85: screens that face a luminaire (EN 12464-1, 4.9).
    double greatest_nt(double gamma_deg) const;
};

// The opening is in the frame of the web. There is none without an opening, or if it has no area towards one of these
// directions in which it shines.
Figure<LuminanceDiagram> luminance_diagram(const Web& web, const Opening& opening);

} // namespace gonio
#pragma GCC visibility pop
