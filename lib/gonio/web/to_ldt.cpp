// Web + header → EULUMDAT.
#include <gonio/profile/opening_code.hpp>
#include <gonio/web/direct_ratios.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/make_profile.hpp>
#include <gonio/web/zones.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace gonio::web_detail {

namespace {

// The planes over 0° to 360°, without the last, and the table of those that Isym stores.
struct LdtTable {
    int symmetry = 0;
    std::vector<double> planes_deg;
    Grid stored;
};

// Isym 0. Readers see no plane at 360° and close the circle with the first plane across a gap of at most one step.
LdtTable all_planes(const Web& web, Losses& losses) {
    Grid grid = full_turn(web);
    if (web.stored_symmetry() != Symmetry::none)
        losses.add("WEB0208", fmt::format("symmetry {} written out as {} planes over the full turn",
                                          to_text(web.stored_symmetry()), grid.horizontal_deg.size() - 1));
    if (grid.dark_sector)
        losses.add("WEB0207", "the planes do not cover the full turn: the dark sector is written as planes of zeros");
    if (grid.jump_at_zero) {
        losses.add("WEB0214", fmt::format("the planes at 0 and 360 degrees differ: that at 360 is written at {}",
                                          360.0 - dark_step_deg));
        step_before_the_turn(grid);
    }
    double widest = 0.0;
    for (std::size_t i = 1; i + 1 < grid.horizontal_deg.size(); ++i)
        widest = std::max(widest, grid.horizontal_deg[i] - grid.horizontal_deg[i - 1]);
    if (360.0 - grid.horizontal_deg[grid.horizontal_deg.size() - 2] > widest) halve_last_cell(grid);
    grid.horizontal_deg.pop_back();
    grid.candela.resize(grid.candela.size() - grid.rows());
    return {0, grid.horizontal_deg, std::move(grid)};
}

// Isym 3 stores C270 through C0 to C90: the web's planes from 270° down to 90°, mirrored to the other side.
LdtTable half_from_270(const Web& web) {
    LdtTable table{3, {}, stored_grid(web)};
    Grid& grid = table.stored;
    const std::size_t rows = grid.rows();
    for (std::size_t i = 0, j = grid.horizontal_deg.size() - 1; i < j; ++i, --j)
        std::swap_ranges(grid.candela.begin() + static_cast<std::ptrdiff_t>(i * rows),
                         grid.candela.begin() + static_cast<std::ptrdiff_t>((i + 1) * rows),
                         grid.candela.begin() + static_cast<std::ptrdiff_t>(j * rows));
    for (const double c : web.planes_deg()) {
        table.planes_deg.push_back(c);
        if (c > 90.0 && c < 270.0) table.planes_deg.push_back(c <= 180.0 ? 180.0 - c : 540.0 - c);
    }
    std::sort(table.planes_deg.begin(), table.planes_deg.end());
    return table;
}

LdtTable table_of(const Web& web, Losses& losses) {
    const Symmetry symmetry = web.stored_symmetry();
    if (symmetry == Symmetry::axial) {
        LdtTable table{1, {0.0}, stored_grid(web)};
        return table;
    }
    if (symmetry == Symmetry::none || !reaches_its_ends(web)) return all_planes(web, losses);
    if (symmetry == Symmetry::bilateral_90_270) return half_from_270(web);
    LdtTable table{symmetry == Symmetry::quadrant ? 4 : 2, {}, stored_grid(web)};
    const std::vector<double>& stored = table.stored.horizontal_deg;
    const auto add_mirrored = [&](double about) {
        const std::vector<double> half = table.planes_deg;
        for (std::size_t i = half.size() - 1; i-- > 0;)
            table.planes_deg.push_back(2.0 * about - half[i]);
    };
    table.planes_deg = stored;
    if (symmetry == Symmetry::quadrant) add_mirrored(90.0);
    add_mirrored(180.0);
    table.planes_deg.pop_back(); // 360 is 0
    return table;
}

std::string one_line(std::string_view text) {
    std::string line(text);
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line;
}

// The keywords that EULUMDAT has fields for; everything else is reported as left out.
void take_texts(LdtFile& file, LdtLampSet& lamps, const ProfileHeader& header, Losses& losses) {
    struct Field {
        std::string* text;
        std::array<std::string_view, 4> names; // the first one that exists is used
    };
    const std::array fields{
        Field{&file.company, {"MANUFAC"}},
        Field{&file.luminaire_name, {"LUMINAIRE"}},
        Field{&file.luminaire_number, {"LUMCAT"}},
        Field{&file.report_number, {"TEST"}},
        Field{&file.date_user, {"ISSUEDATE", "DATE", "TESTDATE"}},
        Field{&lamps.lamp_type, {"LAMP", "LAMPCAT"}},
        Field{&lamps.color_temperature, {"_CCT", "CCT", "COLORTEMP", "_COLORTEMP"}},
        Field{&lamps.color_rendering, {"_CRI", "CRI", "_RA"}},
    };
    std::vector<bool> used(header.keywords.size(), false);
    for (const Field& field : fields) {
        bool found = false;
        for (const std::string_view name : field.names) {
            for (std::size_t i = 0; !found && !name.empty() && i < header.keywords.size(); ++i) {
                if (used[i] || !same_keyword(header.keywords[i].name, name)) continue;
                *field.text = one_line(header.keywords[i].text);
                used[i] = true;
                found = true;
            }
        }
    }
    std::vector<std::pair<std::string, int>> left; // names and their counts
    for (std::size_t i = 0; i < used.size(); ++i) {
        const IesKeyword& keyword = header.keywords[i];
        if (used[i] || keyword.text.empty()) continue;
        const std::string name = keyword.name.empty() ? "a label" : "[" + keyword.name + "]";
        const auto known =
            std::find_if(left.begin(), left.end(), [&](const auto& entry) { return entry.first == name; });
        if (known == left.end())
            left.emplace_back(name, 1);
        else
            ++known->second;
    }
    std::string list;
    for (const auto& [name, count] : left)
        list += fmt::format("{}{}{}", list.empty() ? "" : ", ", name, count > 1 ? fmt::format(" ×{}", count) : "");
    if (!list.empty()) losses.add("WEB0201", fmt::format("keywords left out: {}", list));
}

void take_housing(LdtFile& file, const ProfileHeader& header) {
    const bool given = header.length_m != 0.0 || header.width_m != 0.0 || header.height_m != 0.0;
    const auto millimeters = [](double meters) { return std::round(meters * 1e9) / 1e6; };
    file.length_mm = given ? millimeters(header.length_m) : file.luminous_length_mm;
    file.width_mm = given ? millimeters(header.width_m) : file.luminous_width_mm;
    file.height_mm = given ? millimeters(header.height_m) : file.luminous_height_c0_mm;
}

} // namespace

LdtFile make_ldt(const Web& web, const ProfileHeader& header, Losses& losses) {
    LdtFile file;
    LdtLampSet lamps;
    take_texts(file, lamps, header, losses);
    file.file_name = header.file_name;
    file.tilt_deg = header.tilt_deg;
    const LuminousOpening written = set_opening(file, header.opening);
    if (written.shape != header.opening.shape)
        losses.add("WEB0209", fmt::format("the luminous opening, a {}, has no code in EULUMDAT: written as a {}",
                                          to_text(header.opening.shape), to_text(written.shape)));
    take_housing(file, header);
    report_other_losses(header, false, losses);

    // cd/klm of the lamps, or of the luminaire itself in absolute photometry, which a negative number of lamps
    // indicates.
    const double light_lm = flux(web).value;
    const bool absolute = !(header.lamp_flux_lm && *header.lamp_flux_lm > 0.0);
    lamps.flux_lm = !absolute ? *header.lamp_flux_lm : light_lm > 0.0 ? light_lm : 1000.0;
    lamps.lamp_count = absolute ? -header.lamp_count : header.lamp_count;
    lamps.input_watts = header.input_watts;
    file.lamp_sets = {lamps};
    file.light_output_ratio_percent = absolute ? 100.0 : 100.0 * light_lm / lamps.flux_lm;
    file.downward_flux_percent = light_lm > 0.0 ? 100.0 * zone_flux(web, 0.0, 90.0).value / light_lm : 0.0;
    const auto short_percent = [](double percent) { return std::round(percent * 100.0) / 100.0; };
    file.light_output_ratio_percent = short_percent(file.light_output_ratio_percent);
    file.downward_flux_percent = short_percent(file.downward_flux_percent);
    for (const double ratio : direct_ratios(web))
        file.direct_ratios.push_back(std::round(ratio * 1e4) / 1e4);

    LdtTable table = table_of(web, losses);
    const double first = table.stored.vertical_deg.front();
    const double last = table.stored.vertical_deg.back();
    if (extend_vertical(table.stored, first >= 90.0 ? 90.0 : 0.0, last <= 90.0 ? 90.0 : 180.0))
        losses.add("WEB0206", fmt::format("gamma angles {} to {} extended with zeros to {} to {}", first, last,
                                          table.stored.vertical_deg.front(), table.stored.vertical_deg.back()));
    // Steps that differ by less than a thousandth of a degree count as uniform for readers, which compute the angles
    // from the step.
    file.symmetry = table.symmetry;
    file.plane_count = static_cast<int>(table.planes_deg.size());
    file.plane_step_deg = even_step(table.planes_deg, 1e-3);
    file.planes_deg = std::move(table.planes_deg);
    file.gamma_count = static_cast<int>(table.stored.rows());
    file.gamma_step_deg = even_step(table.stored.vertical_deg, 1e-3);
    file.gammas_deg = std::move(table.stored.vertical_deg);
    file.candela_per_klm = std::move(table.stored.candela);
    for (double& value : file.candela_per_klm)
        value = rounded_to(value / lamps.flux_lm * 1000.0, 14);
    const bool is_long = file.luminous_width_mm > 0.0 && file.luminous_length_mm >= 3.0 * file.luminous_width_mm;
    file.type_indicator = header.type_indicator.value_or(file.symmetry == 1 ? 1 : is_long ? 2 : 3);
    return file;
}

} // namespace gonio::web_detail
