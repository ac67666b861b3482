#include "figures_text.hpp"

#include <gonio/base/unit_text.hpp>
#include <gonio/figures/figure_rules.hpp>

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string_view>

namespace gonio::cli {

namespace {

// "  LOR         0.87, …"
std::string line(std::string_view name, std::string_view value) {
    return fmt::format("  {:<12}{}\n", name, value);
}

std::string no_figure_line(std::string_view name, const std::string& reason) {
    return line(name, fmt::format("none: {}", reason));
}

// "\nUGR, CIE 190:2010, …"
std::string heading(std::string_view title, std::string_view figure) {
    return fmt::format("\n  {} ({})\n", title, rule_of_figure(figure));
}

// Each cell as wide as its column's head, and two more.
template<class Columns>
std::string head(std::string_view first, const Columns& columns) {
    std::string text = fmt::format("  {:<10}", first);
    for (const RoomReflectances& reflectances : columns)
        text += fmt::format("{:>10}", to_text(reflectances));
    return text + "\n";
}

std::string ugr_text(const UgrTable& table, std::string_view title, std::string_view figure) {
    std::string text = heading(title, figure);
    text += fmt::format("  {:<10}{:>45}{:>45}\n", "", "crosswise", "endwise");
    text += fmt::format("  {:<10}", "X × Y");
    for (int i = 0; i < 2; ++i)
        for (const RoomReflectances& reflectances : ugr_reflectances)
            text += fmt::format("{:>9}", to_text(reflectances));
    text += "\n";
    for (std::size_t row = 0; row < ugr_rooms.size(); ++row) {
        text += fmt::format("  {:<10}", fmt::format("{}H × {}H", ugr_rooms[row].across, ugr_rooms[row].along));
        for (const double ugr : table[row])
            text += std::isfinite(ugr) ? fmt::format("{:>9.1f}", ugr) : fmt::format("{:>9}", "-");
        text += "\n";
    }
    return text;
}

std::string luminances_text(const LuminanceDiagram& diagram) {
    std::string text = heading("luminance in cd/m²", "luminances");
    text += fmt::format("  {:<10}", "gamma");
    constexpr std::size_t every = 3; // 45°
    for (std::size_t plane = 0; plane < luminance_planes; plane += every)
        text += fmt::format("{:>10}", fmt::format("C{}", 15 * plane));
    text += "\n";
    for (std::size_t row = 0; row < luminance_gammas_deg.size(); ++row) {
        text += fmt::format("  {:<10}", fmt::format("{}°", luminance_gammas_deg[row]));
        for (std::size_t plane = 0; plane < luminance_planes; plane += every)
            text += fmt::format("{:>10.0f}", diagram.nt[row][plane]);
        text += "\n";
    }
    return text;
}

template<class Rows, class Columns>
std::string factors_text(std::string_view title, std::string_view figure, std::string_view first, const Rows& rows,
                         const Columns& columns, const auto& row_name) {
    std::string text = heading(title, figure) + head(first, columns);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        text += fmt::format("  {:<10}", row_name(row));
        for (const double factor : rows[row])
            text += fmt::format("{:>10.3f}", factor);
        text += "\n";
    }
    return text;
}

std::string class_text(std::string_view letter, int number) {
    return number > 0 ? fmt::format("{}{}", letter, number) : "no class";
}

} // namespace

std::string figures_text(const LuminaireFigures& figures) {
    std::string text;
    if (figures.output)
        text += line("LOR", fmt::format("{:.3f}, downward {:.3f}, upward {:.3f} of the lamps' flux",
                                        figures.output->all, figures.output->downward, figures.output->upward));
    else
        text += no_figure_line("LOR", figures.output.error());
    if (figures.distribution && figures.upward_share)
        text += line("class", fmt::format("DIN 5040 {}, {:.1f} % upward (ULR)", *figures.distribution,
                                          100.0 * *figures.upward_share));
    else
        text += no_figure_line("class", figures.distribution.error());
    if (figures.bug)
        text +=
            line("BUG", to_text(*figures.bug) + (figures.bug->glare == figures.bug->glare_type_v
                                                     ? std::string()
                                                     : ", or " + to_text(*figures.bug, true) + " if it is of type V"));
    else
        text += no_figure_line("BUG", figures.bug.error());
    if (figures.cut_off_class)
        text += line("cut-off", to_text(*figures.cut_off_class));
    else
        text += no_figure_line("cut-off", figures.cut_off_class.error());
    if (figures.intensity_class)
        text +=
            line("intensity",
                 fmt::format("EN 13201-2 {} by the luminaire's flux{}", class_text("G*", *figures.intensity_class),
                             figures.intensity_class_lamp
                                 ? fmt::format(", {} by the lamps'", class_text("G*", *figures.intensity_class_lamp))
                                 : std::string()));
    else
        text += no_figure_line("intensity", figures.intensity_class.error());
    if (figures.glare)
        text += line("glare index",
                     fmt::format("EN 13201-2 {}, {} cd/m at 85°", class_text("D", figures.glare->glare_index_class),
                                 rounded(figures.glare->cd_per_m, 4)));
    else
        text += no_figure_line("glare index", figures.glare.error());
    if (figures.direct_ratios) {
        std::string ratios;
        for (const double ratio : *figures.direct_ratios)
            ratios += fmt::format("{}{:.3f}", ratios.empty() ? "" : " ", ratio);
        text += line("direct", ratios + " at k 0.6 to 5");
    } else {
        text += no_figure_line("direct", figures.direct_ratios.error());
    }
    if (figures.ugr && figures.ugr_correction)
        text +=
            line("UGR", fmt::format("{:+.2f} for the lamps' flux is in these tables; subtract it for lamps of 1000 lm",
                                    *figures.ugr_correction));
    if (figures.ugr)
        text += ugr_text(*figures.ugr, "UGR", "ugr_table");
    else
        text += no_figure_line("UGR", figures.ugr.error());
    if (figures.ugr_sh1) text += ugr_text(*figures.ugr_sh1, "UGR", "ugr_table_sh1");
    if (figures.luminances)
        text += luminances_text(*figures.luminances);
    else
        text += no_figure_line("luminance", figures.luminances.error());
    if (figures.factors)
        text +=
            factors_text("utilisation factors", "utilisation_factors", "k", *figures.factors, utilisation_reflectances,
                         [](std::size_t row) { return fmt::format("{}", room_indices.at(row)); });
    else
        text += no_figure_line("utilisation", figures.factors.error());
    if (figures.coefficients)
        text += factors_text("coefficients of utilisation", "coefficients_of_utilisation", "RCR", *figures.coefficients,
                             cu_reflectances, [](std::size_t row) { return fmt::format("{}", row); });
    return text;
}

} // namespace gonio::cli
