#include "profile_section.hpp"

#include <gonio/base/file.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/light/profile_facts.hpp>
#include <gonio/plot/diagram.hpp>
#include <gonio/plot/svg.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/repetitions.hpp>

#include "../facts_text.hpp"
#include "diagnostics_list.hpp"
#include "html.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

struct DiagramSize {
    int width_px;
    int height_px;
};
constexpr DiagramSize usual_size{380, 330};
constexpr DiagramSize size_of_cone{440, 382}; // the same shape; it has a table
constexpr std::size_t most_keywords = 60;
constexpr std::size_t longest_text = 600; // bytes of a keyword

std::string section_name(std::size_t number) {
    return fmt::format("profile-{}", number);
}

std::string begin_section(const std::string& file, const std::string& title, std::size_t number) {
    return fmt::format("<section class=\"profile\" id=\"{0}\" aria-labelledby=\"{0}-title\">\n"
                       "<h2 id=\"{0}-title\">{1}</h2>\n<p class=\"file\">{2}</p>\n",
                       section_name(number), html_start(title, longest_text), html(file));
}

std::string first_cell(const std::string& label, std::size_t number) {
    return fmt::format(R"(<th scope="row"><a href="#{}">{}</a></th>)", section_name(number), html(label));
}

std::string cell(const std::string& text, std::string_view style) {
    return fmt::format("<td class=\"{}\">{}</td>", style, text.empty() ? "–" : html_start(text, longest_text));
}

// "35.0° / none": in C0–C180 and in C90–C270.
std::string both_planes(const std::optional<double>& c0_deg, const std::optional<double>& c90_deg) {
    const std::string along = degrees_or_none(c0_deg);
    const std::string across = degrees_or_none(c90_deg);
    return along == across ? along : fmt::format("{} / {}", along, across);
}

std::string row_of(const std::string& label, std::size_t number, const std::string& luminaire,
                   const ProfileFacts& facts, const Diagnostics& diagnostics) {
    const std::optional<double> efficacy = facts.efficacy_lm_per_w();
    return fmt::format(
        "<tr>{}{}{}{}{}{}{}{}{}{}</tr>\n", first_cell(label, number), cell(luminaire, "name"),
        cell(fmt::format("{} {}", facts.format, facts.version), "short"),
        cell(fmt::format("{} {}", amount_text(facts.flux_lm), facts.flux_unit), "number"),
        cell(fmt::format("{} {}", amount_text(facts.peak.intensity.value), facts.intensity_unit), "number"),
        cell(both_planes(facts.beam_deg, facts.beam_c90_deg), "number"),
        cell(both_planes(facts.field_deg, facts.field_c90_deg), "number"),
        cell(facts.input_w ? fmt::format("{} W", rounded(*facts.input_w, 4)) : std::string(), "number"),
        cell(efficacy ? fmt::format("{} lm/W", rounded(*efficacy, 3)) : std::string(), "number"),
        cell(diagnostics_count(diagnostics), "counts"));
}

std::string facts_table(const ProfileFacts& facts) {
    std::string table = "<table class=\"facts\"><caption>Facts</caption><tbody>\n";
    for (const std::vector<FactLine>& lines : {fact_lines(facts), more_fact_lines(facts)})
        for (const FactLine& line : lines)
            table += fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", html(line.name),
                                 html_start(line.value, longest_text));
    return table + "</tbody></table>\n";
}

// The keywords by LM-63's names, to which the fields of the other formats are mapped.
std::string keywords_table(const ProfileHeader& header) {
    if (header.keywords.empty()) return {};
    std::string table = "<table class=\"facts keywords\"><caption>Keywords</caption><tbody>\n";
    std::size_t shown = 0;
    for (const IesKeyword& keyword : header.keywords) {
        if (shown == most_keywords) break;
        ++shown;
        table += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td></tr>\n",
                             keyword.name.empty() ? "–" : html_start(keyword.name, longest_text),
                             html_start(keyword.text, longest_text));
    }
    table += "</tbody></table>\n";
    if (shown < header.keywords.size())
        table += fmt::format("<p>and {} more keywords</p>\n", header.keywords.size() - shown);
    return table;
}

std::string zones_table(const ProfileFacts& facts) {
    std::string table = fmt::format("<table class=\"zones\"><caption>Flux by zone</caption>"
                                    "<thead><tr><th scope=\"col\">γ</th><th scope=\"col\">{}</th>"
                                    "<th scope=\"col\">%</th><th scope=\"col\">sum %</th></tr></thead><tbody>\n",
                                    html(facts.flux_unit));
    const double total = facts.zone_lm(0, 180);
    // No "-0.0": a zone can be dark to rounding.
    const auto percent = [&](double lumens) {
        return total > 0.0 ? fmt::format("{:.1f}", std::abs(100.0 * lumens / total)) : std::string("–");
    };
    for (std::size_t low = 0; low < 180; low += 10) {
        const double zone = facts.zone_lm(low, low + 10);
        table += fmt::format("<tr><th scope=\"row\">{}–{}°</th><td>{}</td><td>{}</td><td>{}</td></tr>\n", low, low + 10,
                             amount_text(zone), percent(zone), percent(facts.zone_lm(0, low + 10)));
    }
    return table + "</tbody></table>\n";
}

std::string figure(std::string_view content, const std::string& caption, std::string_view style) {
    return fmt::format("<figure class=\"{}\">{}<figcaption>{}</figcaption></figure>\n", style, content, html(caption));
}

// The diagrams of an intensity in candela. One that a web does not have, a cone without a beam, is left out with the
// reason below it.
std::string diagrams(const std::string& label, std::size_t number, const Web& web, double height_m) {
    struct Shown {
        const char* kind;
        std::string caption;
        DiagramSize size = usual_size;
    };
    const std::string height = fmt::format("{} m", rounded(height_m, 4));
    const std::array shown{Shown{"polar", "Polar diagram"}, Shown{"cartesian", "Cartesian diagram"},
                           Shown{"heat-map", "Heat map"}, Shown{"isolux", "Isolux, " + height + " high"},
                           Shown{"cone", "Cone, down to " + height, size_of_cone}};
    std::string figures;
    for (const Shown& each : shown) {
        const PlottedWeb plotted{plain_text(label), &web};
        PlotOptions options;
        options.width_px = each.size.width_px;
        options.height_px = each.size.height_px;
        options.mounting_height_m = height_m;
        const Result<const DiagramKind*> kind = find_diagram(each.kind);
        const Result<Drawing> drawing = (*kind)->draw({&plotted, 1}, options);
        if (!drawing) {
            figures += figure(fmt::format("<p>{}</p>", html(drawing.error().diagnostics.back().message)), each.caption,
                              "diagram");
            continue;
        }
        const std::string prefix = fmt::format("{}-{}-", section_name(number), each.kind);
        figures += figure(to_svg(*drawing, {prefix, true}), each.caption, "diagram");
    }
    return figures;
}

ProfilePart part_of(const std::string& file, const std::string& label, std::size_t number,
                    const ProfilePartOptions& options, LoadedProfile loaded, const Console& console,
                    Diagnostics& diagnostics) {
    const ResolveOptions& resolve = options.input.resolve;
    const ProfileFacts facts = profile_facts(loaded.profile, loaded.web, resolve);
    const ProfileHeader header = header_of(loaded.profile, resolve);
    const std::string luminaire(luminaire_name(header));

    ProfilePart part;
    std::string pictures;
    Diagnostics of_picture;
    const bool is_photometric = facts.intensity_unit == "cd";
    const auto web = std::make_shared<const Web>(std::move(loaded.web));
    if (options.picture != nullptr && is_photometric) {
        ProfileShape shape{
            file, web, ProfileSize::declared, {}, std::make_shared<const Opening>(opening_of(loaded.profile))};
        const Result<std::string> image =
            profile_picture(file, std::move(shape), *options.picture, *options.stages, console, of_picture);
        part.has_picture = image.has_value();
        pictures = image ? figure(*image, "On the stage", "picture")
                         : fmt::format("<p>No picture: {}</p>\n", html(image.error().diagnostics.back().message));
    }

    part.row = row_of(label, number, luminaire, facts, diagnostics);
    part.section = begin_section(file, luminaire.empty() ? label : luminaire, number);
    part.section += "<div class=\"beside\">\n<div>" + facts_table(facts) + "</div>\n<div>" + pictures +
                    keywords_table(header) + "</div>\n</div>\n<div class=\"diagrams\">\n";
    part.section += is_photometric
                        ? diagrams(label, number, *web, options.mounting_height_m)
                        : fmt::format("<p>Diagrams are of candela, and the file states {}; with --as-candela "
                                      "its numbers count as candela.</p>\n",
                                      html(facts.intensity_unit));
    part.section += zones_table(facts) + "</div>\n<h3>Diagnostics</h3>\n" +
                    diagnostics_list(diagnostics, file, loaded.bytes) + "</section>\n";
    part.report = {{"file", file},
                   {"id", section_name(number)},
                   {"read", true},
                   {"flux_lm", facts.flux_lm},
                   {"peak_cd", facts.peak.intensity.value},
                   {"diagnostics", diagnostics_json(diagnostics)}};
    if (options.keeps_bytes) part.bytes = std::move(loaded.bytes);
    diagnostics.insert(diagnostics.end(), of_picture.begin(), of_picture.end());
    return part;
}

} // namespace

ProfilePart failed_part(const std::string& file, const std::string& label, std::size_t number, const Error& error,
                        std::string_view bytes) {
    const std::string reason = error.diagnostics.empty() ? "cannot be read" : error.diagnostics.back().message;
    ProfilePart part;
    part.row =
        fmt::format("<tr class=\"failed\">{}<td colspan=\"8\">not read: {}</td>{}</tr>\n", first_cell(label, number),
                    html_start(reason, longest_text), cell(diagnostics_count(error.diagnostics), "counts"));
    part.section = begin_section(file, label, number) + "<p>This file could not be read.</p>\n";
    if (!error.diagnostics.empty())
        part.section += "<h3>Diagnostics</h3>\n" + diagnostics_list(error.diagnostics, file, bytes);
    part.section += "</section>\n";
    part.report = {{"file", file},
                   {"id", section_name(number)},
                   {"read", false},
                   {"diagnostics", diagnostics_json(error.diagnostics)}};
    return part;
}

ProfilePart profile_part(const std::string& file, const std::string& label, std::size_t number,
                         const ProfilePartOptions& options, const Console& console, Diagnostics& diagnostics,
                         std::optional<Error>& error) {
    Result<std::string> bytes =
        file == "-" ? read_standard_input(limit("archive-bytes")) : read_file(file, limit_of_profile(file));
    if (!bytes) {
        error = std::move(bytes.error());
        return failed_part(file, label, number, *error, {});
    }
    Result<LoadedProfile> loaded = load_bytes(*bytes, file, options.input);
    if (!loaded) {
        error = std::move(loaded.error());
        ProfilePart part = failed_part(file, label, number, *error, *bytes);
        if (options.keeps_bytes) part.bytes = std::move(*bytes);
        return part;
    }
    // What check says, of the profile as it is.
    const Result<ResolvedWeb> resolved = resolve_web(loaded->profile, options.input.resolve);
    diagnostics = resolved ? report_of(loaded->profile.diagnostics, loaded->profile, *resolved, options.input.resolve)
                           : loaded->diagnostics;
    for (const Diagnostic& diagnostic : loaded->diagnostics)
        if (diagnostic.code == "RES0208") diagnostics.push_back(diagnostic); // of --smooth
    return part_of(file, label, number, options, std::move(*loaded), console, diagnostics);
}

} // namespace gonio::cli
