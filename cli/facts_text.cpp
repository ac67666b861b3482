#include "facts_text.hpp"

#include <gonio/base/unit_text.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace gonio::cli {

namespace {

// "disk, 0.12 m", "rectangle, 0.6 × 1.2 m"
std::string opening_text(const LuminousOpening& opening) {
    std::string text = to_text(opening.shape);
    const char* separator = ", ";
    for (const double size : {opening.width_m, opening.length_m, opening.height_m}) {
        if (size == 0.0) continue;
        text += separator + rounded(size);
        separator = " × ";
    }
    return opening.shape == OpeningShape::point ? text : text + " m";
}

} // namespace

std::string amount_text(double value) {
    return value >= 100.0 ? rounded(std::round(value)) : rounded(value, 3);
}

std::string degrees_or_none(const std::optional<double>& angle) {
    return angle ? fmt::format("{:.1f}°", *angle) : std::string("none");
}

std::vector<FactLine> fact_lines(const ProfileFacts& facts) {
    std::vector<FactLine> lines;
    const auto line = [&](std::string_view name, std::string value) { lines.push_back({name, std::move(value)}); };
    line("format", fmt::format("{} {}, type {}", facts.format, facts.version, facts.photometry));
    line("grid", facts.photometry == 'C'
                     ? fmt::format("{} C-planes × {} gamma angles", facts.planes, facts.gammas)
                     : fmt::format("{} horizontal × {} vertical angles", facts.planes, facts.gammas));
    line("symmetry", facts.symmetry == facts.declared_symmetry
                         ? std::string(to_text(facts.symmetry))
                         : fmt::format("{} (declared {})", to_text(facts.symmetry), to_text(facts.declared_symmetry)));
    const std::string& lm = facts.flux_unit;
    line("flux",
         fmt::format("{} {} (zonal {} {}, declared {})", rounded(facts.flux_lm), lm, rounded(facts.zonal_flux_lm), lm,
                     facts.declared_flux_lm ? fmt::format("{} {}", rounded(*facts.declared_flux_lm), lm)
                                            : std::string("none: absolute photometry")));
    line("peak", fmt::format("{} {} at C {}°, gamma {}°", rounded(facts.peak.intensity.value), facts.intensity_unit,
                             rounded(facts.peak.c_deg), rounded(facts.peak.gamma_deg)));
    line("beam", fmt::format("{} in C0–C180, {} in C90–C270", degrees_or_none(facts.beam_deg),
                             degrees_or_none(facts.beam_c90_deg)));
    line("field", fmt::format("{} in C0–C180, {} in C90–C270", degrees_or_none(facts.field_deg),
                              degrees_or_none(facts.field_c90_deg)));
    if (facts.photometry != 'C' && facts.nema_horizontal && facts.nema_vertical)
        line("NEMA", fmt::format("type {}H × {}V", *facts.nema_horizontal, *facts.nema_vertical));
    if (facts.flux_lm > 0.0) {
        const auto percent = [&](std::size_t low, std::size_t high) {
            return fmt::format("{:.0f} %", std::abs(100.0 * facts.zone_lm(low, high) / facts.flux_lm));
        };
        line("zones", fmt::format("0–30° {}, 30–60° {}, 60–90° {}, above 90° {}", percent(0, 30), percent(30, 60),
                                  percent(60, 90), percent(90, 180)));
    }
    for (const DeclaredLamps& lamp : facts.lamps) {
        std::string value = fmt::format("{} ×", lamp.count);
        if (!lamp.type.empty()) value += " " + lamp.type;
        if (lamp.flux_lm) value += fmt::format(", {} {}", rounded(*lamp.flux_lm), facts.flux_unit);
        if (lamp.cct_k) value += fmt::format(", {} K", rounded(*lamp.cct_k));
        line("lamps", value);
    }
    if (const std::optional<double> of_input = facts.efficacy_lm_per_w())
        line("input", fmt::format("{} W, {} lm/W", rounded(*facts.input_w), rounded(*of_input, 4)));
    else if (facts.input_w)
        line("input", fmt::format("{} W", rounded(*facts.input_w)));
    line("opening", opening_text(facts.opening));
    if (facts.point_distance_m)
        line("far field", fmt::format("a point is within 1 % from {} m on", rounded(*facts.point_distance_m, 2)));
    return lines;
}

std::vector<FactLine> more_fact_lines(const ProfileFacts& facts) {
    std::vector<FactLine> lines;
    const auto line = [&](std::string_view name, std::string value) { lines.push_back({name, std::move(value)}); };
    const auto number = [](const std::optional<double>& value, int digits) {
        return value ? rounded(*value, digits) : std::string("none");
    };
    line("centre beam", fmt::format("{} {}", rounded(facts.center_beam.value), facts.intensity_unit));
    line("CIE beam", fmt::format("{} in C0–C180, {} in C90–C270", degrees_or_none(facts.cie_beam_deg),
                                 degrees_or_none(facts.cie_beam_c90_deg)));
    if (facts.photometry == 'C' && facts.nema_horizontal && facts.nema_vertical)
        line("NEMA", fmt::format("type {}H × {}V", *facts.nema_horizontal, *facts.nema_vertical));
    std::string code;
    const auto add = [&](const std::optional<double>& part) {
        code += (code.empty() ? "" : " ") + (part ? fmt::format("{:.0f}", 100.0 * *part) : std::string("-"));
    };
    for (const std::optional<double>& part : facts.cie_code.within)
        add(part);
    add(facts.cie_code.downward);
    add(facts.cie_code.light_output_ratio);
    line("CIE code", code);
    line("spacing",
         fmt::format("{} along C0, {} along C90, {} diagonal (times the height)", number(facts.spacing.along_c0, 3),
                     number(facts.spacing.along_c90, 3), number(facts.spacing.diagonal, 3)));
    const auto zones = [&](std::string_view side, const std::array<Lumens, 4>& lumens) {
        constexpr std::array names{"L", "M", "H", "VH"};
        std::string list;
        for (std::size_t i = 0; i < names.size(); ++i)
            list += fmt::format("{}{}{} {}", i == 0 ? "" : ", ", side, names[i], rounded(lumens[i].value, 4));
        return list;
    };
    line("LCS front", fmt::format("{} {}, on the side of C{}", zones("F", facts.classes.front), facts.flux_unit,
                                  rounded(facts.street_side_c_deg)));
    line("LCS back", fmt::format("{} {}", zones("B", facts.classes.back), facts.flux_unit));
    line("LCS up", fmt::format("UL {}, UH {} {}", rounded(facts.classes.up_low.value, 4),
                               rounded(facts.classes.up_high.value, 4), facts.flux_unit));
    return lines;
}

} // namespace gonio::cli
