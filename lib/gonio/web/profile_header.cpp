#include <gonio/base/text.hpp>
#include <gonio/profile/tm33_light.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/radiometric.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace gonio {

namespace {

ProfileHeader of(const IesFile& file, const ResolveOptions&) {
    ProfileHeader header;
    header.keywords = file.keywords;
    header.lamp_count = std::max(1, file.lamp_count);
    if (file.lumens_per_lamp > 0.0) header.lamp_flux_lm = file.lumens_per_lamp * file.lamp_count;
    header.input_watts = file.input_watts;
    header.tilt_applied = !file.tilt.angles_deg.empty();
    if (file.version == IesVersion::lm63_2019) header.file_generation_type = file.field_12;
    return header;
}

ProfileHeader of(const LdtFile& file, const ResolveOptions& options) {
    ProfileHeader header;
    const auto add = [&](const char* name, std::string_view text) {
        if (const std::string_view bare = trimmed(text); !bare.empty())
            header.keywords.push_back({name, std::string(bare)});
    };
    add("TEST", file.report_number);
    add("ISSUEDATE", file.date_user);
    add("MANUFAC", file.company);
    add("LUMCAT", file.luminaire_number);
    add("LUMINAIRE", file.luminaire_name);
    const auto wanted = static_cast<std::size_t>(std::max(1, options.lamp_set)) - 1;
    if (!file.lamp_sets.empty()) {
        const LdtLampSet& set = file.lamp_sets[wanted < file.lamp_sets.size() ? wanted : 0];
        add("LAMP", set.lamp_type);
        add("_CCT", set.color_temperature);
        add("_CRI", set.color_rendering);
        header.lamp_count = std::max(1, std::abs(set.lamp_count));
        if (set.lamp_count >= 0) header.lamp_flux_lm = set.flux_lm;
        header.input_watts = set.input_watts;
        header.other_lamp_sets = file.lamp_sets.size() - 1;
    }
    header.type_indicator = file.type_indicator;
    header.length_m = file.length_mm * 1e-3;
    header.width_m = file.width_mm * 1e-3;
    header.height_m = file.height_mm * 1e-3;
    header.tilt_deg = file.tilt_deg;
    header.file_name = file.file_name;
    header.has_ratios =
        std::any_of(file.direct_ratios.begin(), file.direct_ratios.end(), [](double ratio) { return ratio != 0.0; });
    return header;
}

// "[BALLAST] driver": the form in which TM-33 comments keep keywords that have no element.
IesKeyword keyword_of_comment(const std::string& text) {
    const std::size_t close = text.find(']');
    if (!text.starts_with("[") || close == std::string::npos || close == 1) return {"OTHER", text};
    return {text.substr(1, close - 1), std::string(trimmed(std::string_view(text).substr(close + 1)))};
}

ProfileHeader of(const Tm33File& file, const ResolveOptions&) {
    ProfileHeader header;
    constexpr std::array<std::pair<const char*, const char*>, 7> names{{{"Manufacturer", "MANUFAC"},
                                                                        {"CatalogNumber", "LUMCAT"},
                                                                        {"Description", "LUMINAIRE"},
                                                                        {"Laboratory", "TESTLAB"},
                                                                        {"ReportNumber", "TEST"},
                                                                        {"TestDate", "TESTDATE"},
                                                                        {"ReportDate", "ISSUEDATE"}}};
    for (const Tm33Text& element : file.header) {
        if (element.text.empty()) continue;
        const auto* const known =
            std::find_if(names.begin(), names.end(), [&](const auto& entry) { return element.name == entry.first; });
        if (known != names.end())
            header.keywords.push_back({known->second, element.text});
        else if (element.name == "Comment" || element.name == "Comments")
            header.keywords.push_back(keyword_of_comment(element.text));
        else
            header.keywords.push_back({"OTHER", element.name + ": " + element.text});
    }
    header.length_m = file.length_m.value_or(0.0);
    header.width_m = file.width_m.value_or(0.0);
    header.height_m = file.height_m.value_or(0.0);
    header.emitters = file.emitters.size();
    for (const Tm33Emitter& emitter : file.emitters) {
        header.spectra += emitter.spectra.size();
        header.tilt_applied = header.tilt_applied || !emitter.tilt.angles_deg.empty();
    }
    if (!file.emitters.empty()) {
        const Tm33Emitter& emitter = file.emitters.front();
        const auto add = [&](const char* name, std::string text) {
            if (!text.empty()) header.keywords.push_back({name, std::move(text)});
        };
        add("LAMP", emitter.description);
        add("LAMPCAT", emitter.catalog_number);
        if (emitter.cct_k) add("_CCT", fmt::format("{}", *emitter.cct_k));
        if (emitter.cri_ra) add("_CRI", fmt::format("{}", *emitter.cri_ra));
    }
    // Lamps, lumens and watts of all emitters, if the emitters can be combined.
    if (const Result<IesFile> light = lm63_of(file)) {
        header.lamp_count = std::max(1, light->lamp_count);
        if (light->lumens_per_lamp > 0.0) header.lamp_flux_lm = light->lumens_per_lamp * light->lamp_count;
        header.input_watts = light->input_watts;
    }
    return header;
}

} // namespace

bool same_keyword(std::string_view a, std::string_view b) {
    return equals_any_case(a, b);
}

ProfileHeader header_of(const Profile& profile, const ResolveOptions& options) {
    ProfileHeader header = std::visit([&](const auto& file) { return of(file, options); }, profile.file);
    if (options.as_candela) std::erase_if(header.keywords, states_radiometric_unit);
    header.source = profile.source;
    header.opening = luminous_opening(profile);
    if (options.azimuth == AzimuthConvention::as_written)
        header.azimuth =
            std::holds_alternative<LdtFile>(profile.file) ? AzimuthConvention::eulumdat : AzimuthConvention::lm63;
    return header;
}

std::string_view keyword_text(const ProfileHeader& header, std::string_view name) {
    for (const IesKeyword& keyword : header.keywords)
        if (same_keyword(keyword.name, name)) return keyword.text;
    return {};
}

void set_keyword(ProfileHeader& header, std::string_view name, std::string_view text) {
    for (IesKeyword& keyword : header.keywords) {
        if (!same_keyword(keyword.name, name)) continue;
        keyword.text = text;
        return;
    }
    header.keywords.push_back({std::string(name), std::string(text)});
}

} // namespace gonio
