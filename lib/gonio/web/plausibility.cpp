#include <gonio/base/charconv.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/make_profile.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/plausibility.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/zones.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace gonio {

namespace {

constexpr double sun_nt = 1.6e9;

// The findings, each at the field that it concerns.
class Findings {
public:
    Findings(const Profile& profile, int lamp_set) : profile_(profile), lamp_set_(lamp_set) {}

    void add(WebCode code, ProfileField field, std::string message, std::string hint = {}) {
        found_.add_at(location_of(profile_, field), code, std::move(message), std::move(hint));
    }

    // At the lamp set that is being checked.
    void add_of_lamps(WebCode code, ProfileField field, std::string message, std::string hint = {}) {
        const bool sets = std::holds_alternative<LdtFile>(profile_.file);
        found_.add_at(location_of_lamps(profile_, field, sets ? lamp_set_ : 1), code, std::move(message),
                      std::move(hint));
    }

    // At one of the ten direct ratios, each of which is on a separate line.
    void add_of_ratio(WebCode code, std::size_t ratio, std::string message) {
        Location location = location_of(profile_, ProfileField::direct_ratios);
        if (ratio > 0 && location.line > 0) {
            location.line += static_cast<std::uint32_t>(ratio);
            location.column = 0;
        }
        found_.add_at(std::move(location), code, std::move(message));
    }

    Diagnostics take() { return found_.take(); }

private:
    const Profile& profile_;
    int lamp_set_;
    web_detail::Losses found_{profile_.source};
};

std::string_view shown(Photometry photometry) {
    return photometry == Photometry::c ? "C" : "H";
}

// The flux that a coarse table stands for is not known better than two ways of integrating it agree: the interpolant's
// and the zonal method, which the makers of files use. The one that is nearer to what the file states is compared.
double nearest_flux(const Web& web, double light_lm, double stated_lm) {
    const double zonal = zonal_flux(web).value;
    return std::clamp(stated_lm, std::min(light_lm, zonal), std::max(light_lm, zonal));
}

void check_flux(const ProfileHeader& header, const Web& web, double integral_lm, Findings& says) {
    double light_lm = integral_lm;
    if (header.lamp_flux_lm && *header.lamp_flux_lm > 0.0) {
        light_lm = nearest_flux(web, integral_lm, *header.lamp_flux_lm);
        const double ratio = light_lm / *header.lamp_flux_lm;
        if (ratio > 1.02)
            says.add_of_lamps("WEB0301", ProfileField::lamp_flux,
                              fmt::format("the table gives {:.6g} lm, the lamps {:.6g} lm: {:.3g} times as much",
                                          light_lm, *header.lamp_flux_lm, ratio));
        if (ratio > 0.0 && ratio < 0.1)
            says.add_of_lamps("WEB0302", ProfileField::lamp_flux,
                              fmt::format("the table gives {:.6g} lm, the lamps {:.6g} lm: {:.2g} of them", light_lm,
                                          *header.lamp_flux_lm, ratio));
    }
    if (header.input_watts == 0.0) says.add_of_lamps("WEB0305", ProfileField::input_watts, "the input power is 0 W");
    if (!(header.input_watts > 0.0)) return;
    const double efficacy = light_lm / header.input_watts;
    const std::string message =
        fmt::format("{:.6g} lm from {:.6g} W: {:.4g} lm/W", light_lm, header.input_watts, efficacy);
    if (efficacy > 300.0 && header.input_watts == 1.0)
        says.add_of_lamps("WEB0318", ProfileField::input_watts, message, "write 0 if the watts are not known");
    else if (efficacy > 683.0)
        says.add_of_lamps("WEB0303", ProfileField::input_watts, message, "compare the input watts with the lamp's");
    else if (efficacy > 300.0)
        says.add_of_lamps("WEB0304", ProfileField::input_watts, message, "compare the input watts with the lamp's");
}

void check_opening(const LuminousOpening& opening, double bright_cd, Findings& says) {
    const std::array sizes{opening.width_m, opening.length_m, opening.height_m};
    const auto measures = [&](double scale, std::string_view unit) {
        return fmt::format("{:.4g} x {:.4g} x {:.4g} {}", scale * sizes[0], scale * sizes[1], scale * sizes[2], unit);
    };
    for (const double size : sizes) {
        if (size == 0.0 || (size >= 0.5e-3 && size <= 50.0)) continue;
        says.add("WEB0306", ProfileField::opening, "the luminous opening measures " + measures(1.0, "m"),
                 "compare the file's unit of length with the sizes");
        return;
    }
    // Longer luminaires than 4 m are rare, and as wide as that there are none.
    if (*std::max_element(sizes.begin(), sizes.end()) > 4.0) {
        const bool in_two = std::count_if(sizes.begin(), sizes.end(), [](double size) { return size > 4.0; }) > 1;
        says.add("WEB0319", ProfileField::opening, "the luminous opening measures " + measures(1.0, "m"),
                 in_two ? "in centimetres it would be " + measures(0.01, "m")
                        : "compare the file's unit of length with the sizes");
        return;
    }
    const double area = std::max(
        {opening.width_m * opening.length_m, opening.width_m * opening.height_m, opening.length_m * opening.height_m});
    const bool box = opening.shape == OpeningShape::rectangle || opening.shape == OpeningShape::box;
    const double luminance = bright_cd / (area * (box ? 1.0 : std::numbers::pi / 4.0));
    if (area > 0.0 && luminance > sun_nt)
        says.add("WEB0307", ProfileField::opening,
                 fmt::format("{:.4g} cd from {:.3g} m2: {:.2g} cd/m2", bright_cd, area, luminance),
                 "compare the file's unit of length with the sizes");
}

// A value more than `times` as great as each of its neighbours in the table. A pole is one direction on every plane.
void check_lone_values(const Web& web, double bright_cd, Findings& says) {
    const std::size_t columns = web.horizontal_deg().size();
    const std::size_t rows = web.vertical_deg().size();
    if (rows < 3) return;
    const double times = columns == 1 ? 10.0 : 5.0;
    const bool closed = web.photometry() == Photometry::c && web.stored_symmetry() == Symmetry::none &&
                        web.horizontal_deg().back() - web.horizontal_deg().front() >= 360.0 - 1e-9;
    for (std::size_t i = 0; i < columns; ++i) {
        for (std::size_t j = 1; j + 1 < rows; ++j) {
            const double value = web.column(i)[j];
            if (value < 0.2 * bright_cd) continue;
            double around = std::max(web.column(i)[j - 1], web.column(i)[j + 1]);
            if (i > 0) around = std::max(around, web.column(i - 1)[j]);
            if (i + 1 < columns) around = std::max(around, web.column(i + 1)[j]);
            if (closed && i == 0) around = std::max(around, web.column(columns - 2)[j]);
            if (closed && i + 1 == columns) around = std::max(around, web.column(1)[j]);
            if (value <= times * around) continue;
            const bool c = web.photometry() == Photometry::c;
            says.add("WEB0308", ProfileField::intensity,
                     fmt::format("{:.6g} cd at {} {:.6g}, {} {:.6g}, but no more than {:.4g} cd beside it", value,
                                 shown(web.photometry()), web.horizontal_deg()[i], c ? "gamma" : "V",
                                 web.vertical_deg()[j], around));
            return;
        }
    }
}

double brightest_row(const Web& web, std::size_t row) {
    double bright = 0.0;
    for (std::size_t i = 0; i < web.horizontal_deg().size(); ++i)
        bright = std::max(bright, web.column(i)[row]);
    return bright;
}

void check_edges(const Web& web, double bright_cd, Findings& says) {
    const bool c = web.photometry() == Photometry::c;
    const double first = web.vertical_deg().front();
    const double last = web.vertical_deg().back();
    const auto look = [&](double at_cd, std::string_view axis, double angle_deg, ProfileField field) {
        if (at_cd <= 0.1 * bright_cd) return;
        says.add("WEB0309", field,
                 fmt::format("the table ends at {} {:.6g}, where the light has {:.0f} % of its peak", axis, angle_deg,
                             100.0 * at_cd / bright_cd));
    };
    if (c) {
        if (first > 0.0) look(brightest_row(web, 0), "gamma", first, ProfileField::first_vertical);
        if (last < 180.0)
            look(brightest_row(web, web.vertical_deg().size() - 1), "gamma", last, ProfileField::last_vertical);
        return;
    }
    const auto brightest_column = [&](std::size_t column) {
        return *std::max_element(web.column(column).begin(), web.column(column).end());
    };
    const std::span<const double> h = web.horizontal_deg();
    const Symmetry symmetry = web.stored_symmetry();
    const bool h_mirrored = mirrored_in_90_270(symmetry);
    const bool v_mirrored = mirrored_in_0_180(symmetry);
    if (!v_mirrored && first > -90.0) look(brightest_row(web, 0), "V", first, ProfileField::first_vertical);
    if (last < 90.0) look(brightest_row(web, web.vertical_deg().size() - 1), "V", last, ProfileField::last_vertical);
    if (!h_mirrored && h.front() > -90.0) look(brightest_column(0), "H", h.front(), ProfileField::first_horizontal);
    if (h.back() < 90.0) look(brightest_column(h.size() - 1), "H", h.back(), ProfileField::last_horizontal);
}

void check_planes(const Web& web, Findings& says) {
    if (web.photometry() != Photometry::c) return;
    const Symmetry found = detected_symmetry(web);
    if (found != web.stored_symmetry() && found != Symmetry::none)
        says.add("WEB0311", ProfileField::first_horizontal,
                 fmt::format("stored with symmetry {}, but the light has {}", to_text(web.stored_symmetry()),
                             to_text(found)));
}

void check_color(const ProfileHeader& header, Findings& says) {
    const std::optional<double> cct = leading_number(keyword_text(header, "_CCT"));
    const std::optional<double> cri = leading_number(keyword_text(header, "_CRI"));
    // Some files combine the first digits of both: 830 is 3000 K with an index of 80 to 89.
    const bool code = cct && *cct >= 700.0 && *cct < 1000.0;
    if (cct && *cct != 0.0 && !code && (*cct < 1000.0 || *cct > 25000.0))
        says.add_of_lamps("WEB0317", ProfileField::color_temperature,
                          fmt::format("a colour temperature of {:.6g} K", *cct));
    if (cri && *cri > 100.0)
        says.add_of_lamps("WEB0317", ProfileField::color_rendering,
                          fmt::format("a colour rendering index of {:.6g}", *cri));
}

void check_ldt_fields(const LdtFile& file, const ProfileHeader& header, const Web& web, const ResolveOptions& options,
                      double light_lm, Findings& says) {
    const LdtLampSet& lamps = file.lamp_sets[static_cast<std::size_t>(options.lamp_set) - 1];
    if (!(lamps.flux_lm > 0.0))
        says.add_of_lamps("WEB0315", ProfileField::lamp_flux, fmt::format("the lamps give {:.6g} lm", lamps.flux_lm));
    if (light_lm > 0.0) {
        const double downward = 100.0 * zone_flux(web, 0.0, 90.0).value / light_lm;
        if (std::abs(downward - file.downward_flux_percent) > 2.0)
            says.add("WEB0312", ProfileField::downward_flux,
                     fmt::format("the downward flux fraction is {:.4g} %, but that of the table is {:.4g} %",
                                 file.downward_flux_percent, downward));
    }
    if (lamps.flux_lm > 0.0 && light_lm > 0.0 && file.light_output_ratio_percent != 0.0) {
        const double stated_lm = lamps.flux_lm * file.light_output_ratio_percent / 100.0;
        const double ratio = 100.0 * nearest_flux(web, light_lm, stated_lm) / lamps.flux_lm;
        if (std::abs(ratio - file.light_output_ratio_percent) > 2.0)
            says.add("WEB0313", ProfileField::light_output_ratio,
                     fmt::format("the light output ratio is {:.4g} %, but that of the table is {:.4g} %",
                                 file.light_output_ratio_percent, ratio));
    }
    for (std::size_t i = 0; i < file.direct_ratios.size(); ++i) {
        const double ratio = file.direct_ratios[i];
        const double before = i > 0 ? file.direct_ratios[i - 1] : 0.0;
        if (ratio >= 0.0 && ratio <= 1.0 && ratio >= before - 1e-3) continue;
        says.add_of_ratio("WEB0314", i,
                          i > 0 && ratio < before
                              ? fmt::format("direct ratio {} is {:.4g}, the one before {:.4g}", i + 1, ratio, before)
                              : fmt::format("direct ratio {} is {:.4g}", i + 1, ratio));
        break;
    }
    const double length = header.length_m * 1000.0;
    const double width = header.width_m * 1000.0;
    // A round luminaire has a width of 0; a housing without a size was not specified.
    const bool longer =
        length > 0.0 && file.luminous_length_mm > length * 1.001 && file.luminous_length_mm > width * 1.001;
    const bool wider = length > 0.0 && width > 0.0 && file.luminous_width_mm > std::max(length, width) * 1.001;
    if (longer || wider)
        says.add("WEB0316", ProfileField::opening,
                 fmt::format("a luminous area of {:.6g} x {:.6g} mm in a luminaire of {:.6g} x {:.6g} mm",
                             file.luminous_length_mm, file.luminous_width_mm, length, width));
}

} // namespace

Diagnostics check_plausibility(const Profile& profile, const Web& web, const ResolveOptions& options) {
    Findings says(profile, options.lamp_set);
    const ProfileHeader header = header_of(profile, options);
    const double light_lm = flux(web).value;
    const double bright_cd = peak(web).intensity.value;
    check_flux(header, web, light_lm, says);
    check_opening(header.opening, bright_cd, says);
    if (bright_cd > 0.0) {
        check_lone_values(web, bright_cd, says);
        check_edges(web, bright_cd, says);
        check_planes(web, says);
    }
    check_color(header, says);
    if (const auto* ldt = std::get_if<LdtFile>(&profile.file))
        check_ldt_fields(*ldt, header, web, options, light_lm, says);
    return says.take();
}

} // namespace gonio
