// Web + header → LM-63.
#include <gonio/profile/opening_code.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/make_profile.hpp>
#include <gonio/web/portable_text.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace gonio::web_detail {

namespace {

bool since_2002(IesVersion version) {
    return version == IesVersion::lm63_2002 || version == IesVersion::lm63_2019;
}

// Four keywords are mandatory since 2002.
void add_required_keywords(IesFile& file, Losses& losses) {
    std::string added;
    for (const std::string_view name : {"MANUFAC", "ISSUEDATE", "TESTLAB", "TEST"}) {
        const bool found = std::any_of(file.keywords.begin(), file.keywords.end(),
                                       [&](const IesKeyword& keyword) { return same_keyword(keyword.name, name); });
        if (found) continue;
        file.keywords.insert(file.keywords.begin(), {std::string(name), "unknown"});
        added = fmt::format("[{}]{}{}", name, added.empty() ? "" : ", ", added);
    }
    if (!added.empty())
        losses.add("WEB0215",
                   fmt::format("required by {} but missing in the source: {}", to_text(file.version), added));
}

// Editions differ in the name of the date, and since 1991 every line needs a keyword.
void take_keywords(IesFile& file, const ProfileHeader& header) {
    bool has_issue_date = false;
    for (const IesKeyword& keyword : header.keywords)
        has_issue_date = has_issue_date || same_keyword(keyword.name, "ISSUEDATE");
    for (IesKeyword keyword : header.keywords) {
        if (keyword.name.empty()) {
            if (keyword.text.empty()) continue;
            keyword.name = "OTHER";
        }
        if (same_keyword(keyword.name, "MORE")) keyword.name = "OTHER"; // it does not continue another keyword
        if (since_2002(file.version) && !has_issue_date && same_keyword(keyword.name, "DATE")) {
            keyword.name = "ISSUEDATE";
            has_issue_date = true;
        }
        file.keywords.push_back(std::move(keyword));
    }
}

void report_header_losses(const ProfileHeader& header, const IesFile& file, Losses& losses) {
    std::string fields;
    const auto left_out = [&](bool there, const char* name) {
        if (there) fields += fmt::format("{}{}", fields.empty() ? "" : ", ", name);
    };
    const bool same_size = header.length_m == header.opening.length_m && header.width_m == header.opening.width_m;
    left_out((header.length_m != 0.0 || header.width_m != 0.0 || header.height_m != 0.0) && !same_size, "housing");
    left_out(!header.file_name.empty(), "file name");
    left_out(header.has_ratios, "direct ratios");
    left_out(header.tilt_deg != 0.0, "tilt");
    if (!fields.empty()) losses.add("WEB0210", fmt::format("left out of {}: {}", to_text(file.version), fields));
}

void make_portable(IesFile& file, const Web& web, Losses& losses) {
    for (std::vector<double>* const list : {&file.vertical_deg, &file.horizontal_deg, &file.candela})
        for (double& value : *list)
            value = std::abs(value) < 1e-9 ? 0.0 : rounded_to(value, 9); // more digits than single precision keeps
    const double lamps = file.lamp_count;
    file.lamp_count = 1;
    // Some loaders reject absolute files, and some use the lumens as the amount of light.
    const double declared = file.lumens_per_lamp;
    file.lumens_per_lamp = std::max(0.01, std::round(flux(web).value * 100.0) / 100.0);
    if (declared < 0.0)
        losses.add("WEB0213",
                   fmt::format("absolute photometry, written with the table's flux, {} lm", file.lumens_per_lamp));
    else if (std::abs(declared * lamps - file.lumens_per_lamp) > 0.001 * file.lumens_per_lamp)
        losses.add("WEB0213", fmt::format("the lamps' {} lm written as the table's flux, {} lm", declared * lamps,
                                          file.lumens_per_lamp));
    bool changed = false;
    for (IesKeyword& keyword : file.keywords) {
        changed = make_ascii(keyword.name) || changed;
        changed = make_ascii(keyword.text) || changed;
        keyword.text = in_lines_of(keyword.text, 132 - 2 - keyword.name.size() - 3, 132 - 2 - 7);
    }
    if (changed) losses.add("WEB0212", "accented letters and other characters were converted to ASCII");
}

} // namespace

IesFile make_ies(const Web& web, const ProfileHeader& header, IesRequest request, Losses& losses) {
    IesFile file;
    file.version = request.version;
    take_keywords(file, header);
    if (since_2002(file.version)) add_required_keywords(file, losses);
    file.lamp_count = header.lamp_count;
    file.lumens_per_lamp = header.lamp_flux_lm ? *header.lamp_flux_lm / header.lamp_count : -1.0;
    file.input_watts = header.input_watts;
    if (request.version == IesVersion::lm63_2019) file.field_12 = header.file_generation_type;
    const LuminousOpening written = set_opening(file, header.opening);
    if (written.shape != header.opening.shape)
        losses.add("WEB0209",
                   fmt::format("the luminous opening, a {}, has no code in {}: written as a {}",
                               to_text(header.opening.shape), to_text(file.version), to_text(written.shape)));
    report_other_losses(header, request.version == IesVersion::lm63_2019, losses);
    report_header_losses(header, file, losses);

    file.photometry = web.photometry();
    const bool any_half = request.version == IesVersion::lm63_1995;
    Grid grid = lm63_grid(web,
                          request.portable ? Lm63Planes::full_turn
                          : any_half       ? Lm63Planes::any_half
                                           : Lm63Planes::half_from_0,
                          losses);
    file.vertical_deg = std::move(grid.vertical_deg);
    file.horizontal_deg = std::move(grid.horizontal_deg);
    file.candela = std::move(grid.candela);
    if (request.portable) make_portable(file, web, losses);
    return file;
}

} // namespace gonio::web_detail
