#include <gonio/base/unit_text.hpp>
#include <gonio/figures/figure_rules.hpp>
#include <gonio/plot/data_sheet.hpp>
#include <gonio/plot/diagram.hpp>
#include <gonio/plot/opening_diagram.hpp>
#include <gonio/plot/page_font.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace gonio {

using namespace plot_detail;

namespace {

constexpr double row_gap_pt = 12.0;
constexpr double diagram_px = 372.0; // width that diagrams of half a page are drawn for
constexpr double names_pt = 84.0;    // column of the names in a list
constexpr std::size_t most_lamps = 3;

// Three digits or the whole number, never an exponent below a million.
std::string amount(double value) {
    return value >= 100.0 && value < 1e6 ? fmt::format("{:.0f}", value) : rounded(value, 3);
}

std::string degrees_text(const std::optional<double>& angle) {
    return angle ? fmt::format("{:.1f}°", *angle) : std::string("none");
}

std::string both_planes(const std::optional<double>& c0_deg, const std::optional<double>& c90_deg) {
    const std::string c0 = degrees_text(c0_deg);
    const std::string c90 = degrees_text(c90_deg);
    return c0 == c90 ? c0 : fmt::format("{} in C0–C180, {} in C90–C270", c0, c90);
}

// The lumens first: types are long.
std::string lamp_text(const DeclaredLamps& lamp) {
    const std::string flux = lamp.flux_lm ? fmt::format("{} lm, ", amount(*lamp.flux_lm)) : std::string();
    return fmt::format("{}{} × {}", flux, std::abs(lamp.count), lamp.type.empty() ? "lamp" : lamp.type);
}

// "3000 K"; words stay as they are.
std::string with_unit(const std::string& stated, std::string_view unit) {
    const bool is_number = !stated.empty() && std::all_of(stated.begin(), stated.end(), [](unsigned char c) {
        return (c >= '0' && c <= '9') || c == '.' || c == ' ';
    });
    return is_number ? fmt::format("{} {}", stated, unit) : stated;
}

constexpr std::string_view not_stated = "not stated";

std::string or_not_stated(const std::string& text) {
    return text.empty() ? std::string(not_stated) : text;
}

std::vector<SheetLine> data_lines(const DataSheetContent& content) {
    const ProfileFacts& facts = content.facts;
    std::vector<SheetLine> lines;
    const auto line = [&](std::string name, std::string value) {
        lines.push_back({std::move(name), std::move(value)});
    };
    line("Manufacturer", or_not_stated(content.maker));
    line("Catalogue number", or_not_stated(content.catalogue_number));
    for (std::size_t i = 0; i < facts.lamps.size() && i < most_lamps; ++i)
        line(i == 0 ? "Lamps" : "", lamp_text(facts.lamps[i]));
    if (facts.lamps.size() > most_lamps) line("", fmt::format("and {} more", facts.lamps.size() - most_lamps));
    line("Luminous flux", fmt::format("{} lm{}", amount(facts.flux_lm),
                                      facts.declared_flux_lm ? std::string() : std::string(", absolute photometry")));
    line("Power", facts.input_w ? fmt::format("{} W", rounded(*facts.input_w, 4)) : std::string(not_stated));
    const std::optional<double> efficacy = facts.efficacy_lm_per_w();
    line("Efficacy", efficacy ? fmt::format("{} lm/W", rounded(*efficacy, 3)) : std::string("none: no watts"));
    line("Colour temperature", or_not_stated(with_unit(content.cct, "K")));
    line("Colour rendering", or_not_stated(content.cri));
    const Peak& peak = facts.peak;
    line("Peak intensity", facts.symmetry == Symmetry::axial
                               ? fmt::format("{} cd at γ {}°", amount(peak.intensity.value), rounded(peak.gamma_deg, 3))
                               : fmt::format("{} cd at C {}°, γ {}°", amount(peak.intensity.value),
                                             rounded(peak.c_deg, 3), rounded(peak.gamma_deg, 3)));
    line("Beam angle", both_planes(facts.beam_deg, facts.beam_c90_deg));
    line("Field angle", both_planes(facts.field_deg, facts.field_c90_deg));
    line("Photometry", fmt::format("{} {}, type {}", facts.format, facts.version, facts.photometry));
    if (!content.report.empty()) line("Measurement", content.report);
    if (!content.date.empty()) line("Date", content.date);
    return lines;
}

template<class T, class Write>
SheetLine figure_line(std::string name, const Figure<T>& figure, std::string_view rule, const Write& write) {
    if (!figure) return {std::move(name), fmt::format("none: {}", figure.error())};
    return {std::move(name), write(*figure), std::string(rule_of_figure(rule))};
}

std::string class_text(std::string_view letter, int number) {
    return number > 0 ? fmt::format("{}{}", letter, number) : "no class";
}

std::string cie_code_text(const CieFluxCode& code) {
    std::string text;
    const auto add = [&](const std::optional<double>& part) {
        text += (text.empty() ? "" : " ") + (part ? fmt::format("{:.0f}", 100.0 * *part) : std::string("-"));
    };
    for (const std::optional<double>& part : code.within)
        add(part);
    add(code.downward);
    add(code.light_output_ratio);
    return text;
}

std::string nits(double value) {
    return value >= 1e6 ? rounded(value, 3) : fmt::format("{:.0f}", value);
}

SheetLine output_line(const LuminaireFigures& figures) {
    return figure_line("Light output ratio", figures.output, "light_output_ratios", [](const OutputRatios& ratios) {
        return fmt::format("{:.2f}: {:.2f} down, {:.2f} up", ratios.all, ratios.downward, ratios.upward);
    });
}

std::string one_ugr(double ugr) {
    return std::isfinite(ugr) ? fmt::format("{:.1f}", ugr) : std::string("–");
}

// That by which luminaires are compared: 4H × 8H, 70/50/20.
std::string reference_ugr(const UgrTable& table) {
    const auto* const room = std::find_if(ugr_rooms.begin(), ugr_rooms.end(),
                                          [](const UgrRoom& each) { return each.across == 4 && each.along == 8; });
    const auto& row = table.at(static_cast<std::size_t>(room - ugr_rooms.begin()));
    return fmt::format("{} crosswise, {} endwise, 4H × 8H", one_ugr(row[0]), one_ugr(row[ugr_reflectances.size()]));
}

SheetLine luminance_line(const LuminaireFigures& figures) {
    return figure_line("Greatest luminance", figures.luminances, "luminances", [](const LuminanceDiagram& diagram) {
        return fmt::format("{} / {} / {} cd/m² at 65 / 75 / 85°", nits(diagram.greatest_nt(65)),
                           nits(diagram.greatest_nt(75)), nits(diagram.greatest_nt(85)));
    });
}

SheetLine upward_line(const LuminaireFigures& figures) {
    return figure_line("Upward light", figures.upward_share, "upward_light_ratio",
                       [](double share) { return fmt::format("{:.1f} % (ULR)", 100.0 * share); });
}

std::vector<SheetLine> indoor_lines(const DataSheetContent& content) {
    const LuminaireFigures& figures = content.figures;
    std::vector<SheetLine> lines;
    lines.push_back(figure_line("UGR " + to_text(ugr_reflectances[0]), figures.ugr, "ugr_table", reference_ugr));
    lines.push_back(luminance_line(figures));
    lines.push_back(output_line(figures));
    lines.push_back(figure_line("Distribution", figures.distribution, "distribution_class",
                                [](char letter) { return std::string(1, letter); }));
    lines.push_back(upward_line(figures));
    lines.push_back({"Flux code", cie_code_text(content.facts.cie_code), "CIE 52:1982"});
    return lines;
}

std::vector<SheetLine> outdoor_lines(const DataSheetContent& content) {
    const LuminaireFigures& figures = content.figures;
    std::vector<SheetLine> lines;
    lines.push_back(figure_line("BUG rating", figures.bug, "bug", [](const BugRating& rating) {
        return to_text(rating) + (rating.glare == rating.glare_type_v
                                      ? std::string()
                                      : fmt::format(", or {} as type V", to_text(rating, true)));
    }));
    lines.push_back(figure_line("Intensity class", figures.intensity_class, "luminous_intensity_class",
                                [](int number) { return class_text("G*", number); }));
    lines.push_back(figure_line("of the lamps", figures.intensity_class_lamp, "luminous_intensity_class_lamps",
                                [](int number) { return class_text("G*", number); }));
    lines.push_back(figure_line("Glare index", figures.glare, "glare_index", [](const GlareIndex& index) {
        return fmt::format("{}, {} cd/m at 85°", class_text("D", index.glare_index_class), rounded(index.cd_per_m, 4));
    }));
    lines.push_back(figure_line("Cut-off", figures.cut_off_class, "cut_off",
                                [](CutOff cut_off) { return std::string(to_text(cut_off)); }));
    lines.push_back(upward_line(figures));
    lines.push_back(output_line(figures));
    return lines;
}

// ---------------------------------------------------------------------------------------------------------------------

class Sheet {
public:
    Sheet(const DataSheetContent& content, const DataSheetOptions& options)
        : content_(content),
          is_outdoor_(options.use == LuminaireUse::automatic ? looks_outdoor(content.facts)
                                                             : options.use == LuminaireUse::outdoor),
          height_m_(options.height_m.value_or(is_outdoor_ ? 8.0 : 3.0)) {
        const bool has_name = !content.name.empty();
        furniture_ = {options.paper,
                      "Photometric data sheet",
                      content.maker,
                      has_name ? content.name : content.catalogue_number,
                      has_name ? content.catalogue_number : std::string(),
                      content.file};
        if (furniture_.title.empty()) furniture_.title = content.file;
    }

    DataSheet compose() {
        first_page();
        is_outdoor_ ? outdoor_page() : indoor_page();
        sheet_.is_outdoor = is_outdoor_;
        return std::move(sheet_);
    }

private:
    static constexpr std::size_t pages = 2;

    void keep(SheetPage page) {
        sheet_.replaced += page.replaced();
        sheet_.pages.push_back(page.take());
    }

    void web_diagram(SheetPage& page, const Area& box, std::string_view kind, double across_px) const {
        page.diagram(box, across_px, [&](int width_px, int height_px) -> Result<Drawing> {
            const PlottedWeb plotted{page_text(content_.file).text, content_.web};
            PlotOptions options;
            options.width_px = width_px;
            options.height_px = height_px;
            options.mounting_height_m = height_m_;
            options.has_facts = false;
            options.has_bands = false;
            const Result<const DiagramKind*> found = find_diagram(kind);
            if (!found) return Unexpected(found.error());
            return (*found)->draw({&plotted, 1}, options);
        });
    }

    // A heading and below it a diagram of the web.
    void titled_diagram(SheetPage& page, Area area, std::string_view title, std::string_view kind, double across_px,
                        std::string_view rule = {}) const {
        area.top = page.heading(area, title, rule);
        web_diagram(page, area, kind, across_px);
    }

    std::string at_height() const { return fmt::format("{} m high", rounded(height_m_, 4)); }

    void first_page() {
        SheetPage page(furniture_, 1, pages);
        const Area left = page.left_half();
        const Area right = page.right_half();
        const double height = page.area().height() - 2.0 * row_gap_pt;
        const double second = left.top + 0.35 * height + row_gap_pt;
        const double third = second + 0.34 * height + row_gap_pt;
        const auto row = [](Area area, double top, double bottom) {
            area.top = top;
            area.bottom = bottom;
            return area;
        };

        Area data = row(left, left.top, second - row_gap_pt);
        data.top = page.heading(data, "Luminaire");
        page.list(data, data_lines(content_), names_pt, 2);
        titled_diagram(page, row(right, right.top, second - row_gap_pt), "Luminous intensity", "polar", diagram_px);
        titled_diagram(page, row(left, second, third - row_gap_pt), "Luminous intensity by angle", "cartesian",
                       diagram_px);
        if (is_outdoor_)
            opening(page, row(right, second, third - row_gap_pt));
        else
            titled_diagram(page, row(right, second, third - row_gap_pt), "Beam cone", "cone", 450.0,
                           fmt::format("down to {} m", rounded(height_m_, 4)));

        Area figures = row(is_outdoor_ ? page.area() : right, third, page.area().bottom);
        if (!is_outdoor_) opening(page, row(left, third, page.area().bottom));
        figures.top = page.heading(figures, is_outdoor_ ? "Classes" : "Figures");
        page.list(figures, is_outdoor_ ? outdoor_lines(content_) : indoor_lines(content_), names_pt, 3);
        keep(std::move(page));
    }

    void opening(SheetPage& page, const Area& area) const {
        Area box = area;
        box.top = page.heading(area, "Luminous opening");
        page.diagram(box, diagram_px, [&](int width_px, int height_px) {
            return opening_diagram(content_.opening, width_px, height_px);
        });
    }

    // A heading and a table of a figure, or the reason that there is none. Moves the top of the area.
    template<class T, class Make>
    void figure_table(SheetPage& page, Area& area, std::string_view title, std::string_view rule,
                      const Figure<T>& figure, const Make& make) const {
        area.top = page.heading(area, title, rule_of_figure(rule));
        area.top = figure ? page.table(area, make(*figure))
                          : page.paragraph({area.left, area.top + 1.0}, area.width(),
                                           fmt::format("None: {}.", figure.error()), body_pt, soft_ink, 2);
        area.top += row_gap_pt;
    }

    void indoor_page() {
        const LuminaireFigures& figures = content_.figures;
        SheetPage page(furniture_, 2, pages);
        Area area = page.area();
        figure_table(page, area, "UGR, corrected for the luminaire's flux", "ugr_table", figures.ugr, ugr_rows);
        if (figures.ugr && figures.ugr_correction) {
            area.top = page.paragraph({area.left, area.top - row_gap_pt + 1.0}, area.width(),
                                      fmt::format("X across the line of sight, Y along it, in heights H of the "
                                                  "luminaires above the eye. Less {:.1f}: the table for lamps of "
                                                  "1000 lm.",
                                                  *figures.ugr_correction),
                                      small_pt, soft_ink, 1) +
                       row_gap_pt - 2.0;
        }
        figure_table(page, area, "Luminance in cd/m²", "luminances", figures.luminances, luminance_rows);
        figure_table(page, area, "Utilisation factors", "utilisation_factors", figures.factors,
                     [&](const UtilisationFactors& factors) { return factor_rows(factors, figures.direct_ratios); });
        if (figures.factors) // else of the same reason
            figure_table(page, area, "Coefficients of utilisation", "coefficients_of_utilisation", figures.coefficients,
                         coefficient_rows);
        keep(std::move(page));
    }

    static SheetTable ugr_rows(const UgrTable& ugr) {
        SheetTable table;
        table.first_pt = 76.0;
        table.groups = {ugr_reflectances.size() + 1};
        const auto percent = [](double share) { return fmt::format("{:.0f}", 100.0 * share); };
        std::vector<std::string> views{"Viewed"};
        std::vector<std::string> ceiling{"Ceiling %"};
        std::vector<std::string> walls{"Walls %"};
        std::vector<std::string> floor{"Floor %"};
        for (const std::string_view view : {"crosswise", "endwise"})
            for (std::size_t i = 0; i < ugr_reflectances.size(); ++i) {
                views.emplace_back(i == ugr_reflectances.size() / 2 ? view : std::string_view());
                ceiling.push_back(percent(ugr_reflectances[i].ceiling));
                walls.push_back(percent(ugr_reflectances[i].walls));
                floor.push_back(percent(ugr_reflectances[i].floor));
            }
        table.head = {std::move(views), std::move(ceiling), std::move(walls), std::move(floor)};
        for (std::size_t i = 0; i < ugr_rooms.size(); ++i) {
            std::vector<std::string> cells{fmt::format("X {}H, Y {}H", ugr_rooms.at(i).across, ugr_rooms.at(i).along)};
            for (const double value : ugr.at(i))
                cells.push_back(one_ugr(value));
            table.rows.push_back(std::move(cells));
        }
        return table;
    }

    static SheetTable luminance_rows(const LuminanceDiagram& diagram) {
        constexpr std::size_t every = 3; // 45°
        SheetTable table;
        table.first_pt = 76.0;
        std::vector<std::string> head{"γ"};
        for (std::size_t plane = 0; plane < luminance_planes; plane += every)
            head.push_back(fmt::format("C{}", 15 * plane));
        head.emplace_back("greatest");
        table.head = {std::move(head)};
        for (std::size_t row = 0; row < luminance_gammas_deg.size(); ++row) {
            const double gamma = luminance_gammas_deg.at(row);
            if (gamma != 65.0 && gamma != 75.0 && gamma != 85.0) continue;
            std::vector<std::string> cells{fmt::format("{:.0f}°", gamma)};
            for (std::size_t plane = 0; plane < luminance_planes; plane += every)
                cells.push_back(nits(diagram.nt.at(row).at(plane)));
            cells.push_back(nits(diagram.greatest_nt(gamma)));
            table.rows.push_back(std::move(cells));
        }
        return table;
    }

    static SheetTable factor_rows(const UtilisationFactors& factors, const Figure<std::array<double, 10>>& direct) {
        SheetTable table;
        table.first_pt = 76.0;
        std::vector<std::string> head{"Room index k"};
        for (const RoomReflectances& reflectances : utilisation_reflectances)
            head.push_back(to_text(reflectances));
        head.emplace_back("direct ratio");
        table.head = {std::move(head)};
        for (std::size_t row = 0; row < factors.size(); ++row) {
            std::vector<std::string> cells{rounded(room_indices.at(row), 3)};
            for (const double factor : factors.at(row))
                cells.push_back(fmt::format("{:.2f}", factor));
            cells.push_back(direct ? fmt::format("{:.2f}", direct->at(row)) : std::string("–"));
            table.rows.push_back(std::move(cells));
        }
        return table;
    }

    static SheetTable coefficient_rows(const UtilisationCoefficients& coefficients) {
        SheetTable table;
        table.first_pt = 44.0;
        table.size_pt = 6.2;
        table.line_pt = 8.8;
        std::vector<std::string> ceiling{"Ceiling %"};
        std::vector<std::string> walls{"Walls %"};
        for (const RoomReflectances& reflectances : cu_reflectances) {
            ceiling.push_back(fmt::format("{:.0f}", 100.0 * reflectances.ceiling));
            walls.push_back(fmt::format("{:.0f}", 100.0 * reflectances.walls));
        }
        table.head = {std::move(ceiling), std::move(walls)};
        for (std::size_t row = 0; row < coefficients.size(); ++row) {
            std::vector<std::string> cells{fmt::format("RCR {}", row)};
            for (const double factor : coefficients.at(row))
                cells.push_back(fmt::format("{:.2f}", factor));
            table.rows.push_back(std::move(cells));
        }
        return table;
    }

    void outdoor_page() {
        SheetPage page(furniture_, 2, pages);
        // A square, in the middle.
        Area isolux = page.area();
        const double tables_pt = 130.0;
        isolux.bottom -= tables_pt + row_gap_pt;
        Area box = isolux;
        box.top = page.heading(isolux, "Illuminance on the ground", at_height() + ", in lx");
        const double spare = std::max(0.0, box.width() - box.height());
        box.left += 0.5 * spare;
        box.right -= 0.5 * spare;
        web_diagram(page, box, "isolux", 700.0);
        const double top = isolux.bottom + row_gap_pt;
        Area left = page.left_half();
        Area right = page.right_half();
        left.top = right.top = top;
        left.top = page.heading(left, "Luminaire classification", "IES TM-15-11");
        page.table(left, classification_rows());
        right.top = page.heading(right, "Flux by zone");
        page.table(right, zone_rows());
        keep(std::move(page));
    }

    std::vector<std::string> lumen_cells(std::string name, double lumens) const {
        const double total = content_.facts.flux_lm;
        return {std::move(name), amount(lumens),
                total > 0.0 ? fmt::format("{:.1f}", std::abs(100.0 * lumens / total)) : std::string("–")};
    }

    SheetTable classification_rows() const {
        const LuminaireClassification& classes = content_.facts.classes;
        SheetTable table;
        table.first_pt = 110.0;
        table.head = {{fmt::format("Street side C{}", rounded(content_.facts.street_side_c_deg, 3)), "lm", "%"}};
        constexpr std::array zones{"low, 0–30°", "medium, 30–60°", "high, 60–80°", "very high, 80–90°"};
        for (const bool is_front : {true, false})
            for (std::size_t i = 0; i < zones.size(); ++i)
                table.rows.push_back(lumen_cells(fmt::format("{} {}", is_front ? "Front" : "Back", zones.at(i)),
                                                 (is_front ? classes.front : classes.back).at(i).value));
        table.rows.push_back(lumen_cells("Up low, 90–100°", classes.up_low.value));
        table.rows.push_back(lumen_cells("Up high, 100–180°", classes.up_high.value));
        return table;
    }

    SheetTable zone_rows() const {
        SheetTable table;
        table.first_pt = 80.0;
        table.head = {{"γ", "lm", "%"}};
        for (std::size_t low = 0; low < 180; low += 10) {
            const double lumens = content_.facts.zone_lm(low, low + 10);
            if (low >= 90) break;
            table.rows.push_back(lumen_cells(fmt::format("{}–{}°", low, low + 10), lumens));
        }
        table.rows.push_back(lumen_cells("90–180°", content_.facts.zone_lm(90, 180)));
        return table;
    }

    const DataSheetContent& content_;
    bool is_outdoor_;
    double height_m_;
    SheetFurniture furniture_;
    DataSheet sheet_;
};

} // namespace

DataSheet data_sheet(const DataSheetContent& content, const DataSheetOptions& options) {
    return Sheet(content, options).compose();
}

bool looks_outdoor(const ProfileFacts& facts) {
    if (!(facts.flux_lm > 0.0) || facts.zone_lm(0, 90) < 0.85 * facts.flux_lm) return false;
    const bool is_alike = facts.symmetry == Symmetry::axial || facts.symmetry == Symmetry::quadrant;
    return facts.peak.gamma_deg >= (is_alike ? 60.0 : 50.0) && facts.peak.gamma_deg <= 85.0;
}

} // namespace gonio
