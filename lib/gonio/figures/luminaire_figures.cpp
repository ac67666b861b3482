#include <gonio/figures/luminaire_figures.hpp>
#include <gonio/web/direct_ratios.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/radiometric.hpp>
#include <gonio/web/zones.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace gonio {

namespace {

bool is_eulumdat(const Profile& profile) {
    return std::holds_alternative<LdtFile>(profile.file);
}

// Whether C0 of the web looks across the luminaire.
bool has_c0_across(const Profile& profile, AzimuthConvention azimuth) {
    return azimuth == AzimuthConvention::as_written ? is_eulumdat(profile) : azimuth == AzimuthConvention::eulumdat;
}

// The opening in the frame of a web that the azimuth turned by +90° (LM-63 to EULUMDAT) or −90°.
Opening opening_in_web(const Profile& profile, AzimuthConvention azimuth) {
    Opening opening = opening_of(profile);
    if (has_c0_across(profile, azimuth) == is_eulumdat(profile)) return opening;
    std::swap(opening.size_m.x, opening.size_m.y);
    auto& sides = opening.side_heights_m;
    std::rotate(sides.begin(), sides.begin() + (is_eulumdat(profile) ? 1 : 3), sides.end());
    if (opening.shape == OpeningShape::horizontal_cylinder)
        opening.shape = OpeningShape::horizontal_cylinder_across;
    else if (opening.shape == OpeningShape::horizontal_cylinder_across)
        opening.shape = OpeningShape::horizontal_cylinder;
    return opening;
}

// A figure for every light that goes anywhere.
template<class T, class Make>
void make_figure(Figure<T>& figure, const std::string& why_not, const Make& make) {
    figure = why_not.empty() ? Figure<T>(make()) : Figure<T>(no_figure(why_not));
}

} // namespace

LuminaireFigures luminaire_figures(const Profile& profile, const Web& web, const ResolveOptions& resolve,
                                   const FiguresOptions& options) {
    LuminaireFigures figures;
    figures.crosswise_c_deg = has_c0_across(profile, resolve.azimuth) ? 0.0 : -90.0;
    const std::array<Lumens, 18> zones = ten_degree_zones(web);
    double down_lm = 0.0;
    double up_lm = 0.0;
    for (std::size_t i = 0; i < zones.size(); ++i)
        (i < 9 ? down_lm : up_lm) += zones[i].value;
    const double flux_lm = down_lm + up_lm;
    const std::optional<double> declared_lm = declared_flux_lm(profile, resolve);
    const Lumens lamps(declared_lm.value_or(flux_lm));

    std::string dark;
    if (const std::string unit = radiometric_unit(profile); !unit.empty() && !resolve.as_candela)
        dark = "the file states " + unit + ", not candela";
    else if (!(flux_lm > 0.0))
        dark = "the profile is dark";
    const std::string no_lamps =
        !dark.empty() || lamps.value > 0.0 ? dark : std::string("the file states no lumens of its lamps");
    const std::string no_down = !dark.empty() || down_lm > 0.0 ? dark : std::string("no light goes down");

    const Opening opening = opening_in_web(profile, resolve.azimuth);
    UgrOptions ugr{0.25, options.ugr_interpolation, figures.crosswise_c_deg};
    make_figure(figures.ugr, dark, [&] { return ugr_table(web, opening, ugr); });
    ugr.spacing = 1.0;
    make_figure(figures.ugr_sh1, dark, [&] { return ugr_table(web, opening, ugr); });
    make_figure(figures.ugr_correction, no_lamps, [&] { return 8.0 * std::log10(lamps.value / 1000.0); });
    make_figure(figures.luminances, dark, [&] { return luminance_diagram(web, opening); });
    make_figure(figures.coefficients, no_lamps, [&] { return utilisation_coefficients(zones, lamps); });
    make_figure(figures.direct_ratios, no_down, [&] { return direct_ratios(web); });
    make_figure(figures.factors, no_lamps, [&] {
        return utilisation_factors(zones, figures.direct_ratios.value_or(std::array<double, 10>{}), lamps);
    });
    make_figure(figures.output, no_lamps, [&] {
        return OutputRatios{flux_lm / lamps.value, down_lm / lamps.value, up_lm / lamps.value};
    });
    make_figure(figures.upward_share, dark, [&] { return up_lm / flux_lm; });
    make_figure(figures.distribution, dark, [&] { return distribution_class(down_lm / flux_lm); });
    make_figure(figures.bug, dark, [&] {
        return bug_rating(luminaire_classification(web, street_side_c_deg(profile, web, resolve.azimuth)));
    });
    const HighAngles high = high_angles(web);
    make_figure(figures.cut_off_class, no_lamps, [&] { return cut_off(high, lamps); });
    make_figure(figures.intensity_class, dark, [&] { return luminous_intensity_class(high, Lumens(flux_lm)); });
    make_figure(figures.intensity_class_lamp, no_lamps, [&] { return luminous_intensity_class(high, lamps); });
    make_figure(figures.glare, dark, [&] { return glare_index(web, opening); });
    return figures;
}

} // namespace gonio
