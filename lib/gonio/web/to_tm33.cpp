// Web + header → TM-33.
#include <gonio/base/charconv.hpp>
#include <gonio/profile/opening_code.hpp>
#include <gonio/profile/text_encoding.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/make_profile.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace gonio::web_detail {

namespace {

struct HeaderElement {
    const char* name;
    std::array<std::string_view, 2> keywords; // the first one that exists is used
    bool required;
};

// In the order of the schema.
constexpr std::array header_elements{
    HeaderElement{"Manufacturer", {"MANUFAC"}, false},       HeaderElement{"CatalogNumber", {"LUMCAT"}, false},
    HeaderElement{"Description", {"LUMINAIRE"}, true},       HeaderElement{"Laboratory", {"TESTLAB"}, true},
    HeaderElement{"ReportNumber", {"TEST"}, true},           HeaderElement{"TestDate", {"TESTDATE"}, false},
    HeaderElement{"ReportDate", {"ISSUEDATE", "DATE"}, true}};

// Every keyword goes to its element; keywords without an element go into a Comment that names them.
class Keywords {
public:
    explicit Keywords(const ProfileHeader& header) : header_(header), used_(header.keywords.size(), false) {}

    // The text of the first unused keyword of that name; empty if there is none.
    std::optional<std::string> take(std::string_view name) {
        for (std::size_t i = 0; i < used_.size(); ++i) {
            const IesKeyword& keyword = header_.keywords[i];
            if (used_[i] || name.empty() || !same_keyword(keyword.name, name)) continue;
            used_[i] = true;
            return to_utf8(keyword.text);
        }
        return std::nullopt;
    }

    void rest(std::vector<Tm33Text>& to) const {
        for (std::size_t i = 0; i < used_.size(); ++i) {
            const IesKeyword& keyword = header_.keywords[i];
            if (used_[i]) continue;
            const bool bare = keyword.name.empty() || (same_keyword(keyword.name, "OTHER") && !keyword.text.empty());
            to.push_back({"Comment", to_utf8(bare ? keyword.text : "[" + keyword.name + "] " + keyword.text)});
        }
    }

private:
    const ProfileHeader& header_;
    std::vector<bool> used_;
};

Tm33Symmetry symmetry_of(const Web& web, const Grid& grid) {
    const double first = grid.horizontal_deg.front();
    const double last = grid.horizontal_deg.back();
    if (web.photometry() != Photometry::c) {
        switch (web.stored_symmetry()) {
        case Symmetry::quadrant:
            return Tm33Symmetry::quadrant;
        case Symmetry::bilateral_0_180:
        case Symmetry::bilateral_90_270:
        case Symmetry::axial:
        case Symmetry::none:
            break;
        }
        return Tm33Symmetry::arbitrary;
    }
    if (grid.horizontal_deg.size() == 1) return Tm33Symmetry::full;
    if (last == 90.0) return Tm33Symmetry::quadrant;
    if (last == 180.0) return Tm33Symmetry::bilateral_0;
    return first == 90.0 ? Tm33Symmetry::bilateral_90 : Tm33Symmetry::none;
}

// Removes what XML 1.0 cannot hold, not even as a reference: control characters except tab and line ends, U+FFFE and
// U+FFFF. Whether there was any.
bool keep_xml_characters(std::string& text) {
    const std::size_t size = text.size();
    std::erase_if(text,
                  [](char c) { return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r'; });
    for (const std::string_view none : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})
        for (std::size_t at = text.find(none); at != std::string::npos; at = text.find(none, at))
            text.erase(at, none.size());
    return text.size() != size;
}

void take_keywords(Tm33File& file, Tm33Emitter& emitter, const ProfileHeader& header, Losses& losses) {
    Keywords keywords(header);
    std::string added;
    for (const HeaderElement& element : header_elements) {
        std::optional<std::string> text;
        for (const std::string_view keyword : element.keywords)
            if (!text) text = keywords.take(keyword);
        if (text && text->empty()) text.reset();
        if (!text && element.required) {
            text = "unknown";
            added += fmt::format("{}{}", added.empty() ? "" : ", ", element.name);
        }
        if (text) file.header.push_back({element.name, std::move(*text)});
    }
    emitter.description = keywords.take("LAMP").value_or("");
    emitter.catalog_number = keywords.take("LAMPCAT").value_or("");
    if (emitter.description.empty()) {
        emitter.description = "unknown";
        added += fmt::format("{}Emitter/Description", added.empty() ? "" : ", ");
    }
    for (const auto& [name, member] :
         {std::pair{"_CCT", &Tm33Emitter::cct_k}, std::pair{"_CRI", &Tm33Emitter::cri_ra}}) {
        const std::optional<double> number = leading_number(keyword_text(header, name));
        if (!number) continue; // text such as "nw" stays a comment
        emitter.*member = number;
        (void)keywords.take(name);
    }
    keywords.rest(file.header);
    bool removed = keep_xml_characters(emitter.description);
    removed |= keep_xml_characters(emitter.catalog_number);
    for (Tm33Text& text : file.header)
        removed |= keep_xml_characters(text.text);
    if (removed) losses.add("WEB0221", "control characters left out of the texts");
    if (!added.empty())
        losses.add("WEB0215", fmt::format("required by {} but missing in the source: {}", edition(file), added));
}

} // namespace

Tm33File make_tm33(const Web& web, const ProfileHeader& header, Losses& losses) {
    Tm33File file;
    Tm33Emitter emitter;
    take_keywords(file, emitter, header, losses);
    report_other_losses(header, false, losses);
    const LuminousOpening written =
        set_opening(file, emitter, header.opening, {header.length_m, header.width_m, header.height_m});
    if (written.shape != header.opening.shape)
        losses.add("WEB0209", fmt::format("the luminous opening, a {}, has no element in {}: written as a {}",
                                          to_text(header.opening.shape), edition(file), to_text(written.shape)));
    file.goniometer = web.photometry() == Photometry::a   ? "IES_A"
                      : web.photometry() == Photometry::b ? "IES_B"
                                                          : "IES_C";
    file.emitter_count = 1.0;
    emitter.quantity = header.lamp_count;
    emitter.input_watts = header.input_watts;
    if (header.lamp_flux_lm) emitter.rated_lumens = *header.lamp_flux_lm / header.lamp_count;
    Grid grid = lm63_grid(web, Lm63Planes::any_half, losses);
    Tm33Intensity intensity;
    intensity.absolute = !header.lamp_flux_lm.has_value();
    intensity.symmetry = symmetry_of(web, grid);
    intensity.horizontal_deg = std::move(grid.horizontal_deg);
    intensity.vertical_deg = std::move(grid.vertical_deg);
    intensity.candela = std::move(grid.candela);
    emitter.intensity = std::move(intensity);
    emitter.luminous_flux_lm = flux(web).value;
    file.emitters.push_back(std::move(emitter));
    return file;
}

} // namespace gonio::web_detail
