#include "luminaire_input.hpp"

#include <gonio/base/file_scope.hpp>
#include <gonio/base/named.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/web/profile_header.hpp>
#include <gonio/web/zones.hpp>

#include "profile_input.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>
#include <utility>
#include <variant>

namespace gonio::cli {

namespace {

// Of the first lamps: a number, or a group of EULUMDAT, which stands for its lowest.
std::optional<double> declared_ra(const Profile& profile) {
    std::string text;
    if (const auto* ldt = std::get_if<LdtFile>(&profile.file)) {
        if (!ldt->lamp_sets.empty()) text = ldt->lamp_sets.front().color_rendering;
    } else if (const auto* tm33 = std::get_if<Tm33File>(&profile.file)) {
        if (!tm33->emitters.empty()) return tm33->emitters.front().cri_ra;
    }
    constexpr std::array groups{Named{"1A", 90.0}, Named{"1B", 80.0}, Named{"2A", 70.0},
                                Named{"2B", 60.0}, Named{"3", 40.0},  Named{"4", 20.0}};
    std::string_view trimmed = text;
    while (!trimmed.empty() && (trimmed.front() == ' ' || trimmed.front() == '>' || trimmed.front() == '='))
        trimmed.remove_prefix(1);
    while (!trimmed.empty() && trimmed.back() == ' ')
        trimmed.remove_suffix(1);
    for (const auto& group : groups)
        if (trimmed == group.name) return group.value;
    const std::optional<double> number = parse_number(trimmed);
    return number && *number >= 20.0 && *number <= 100.0 ? number : std::nullopt;
}

} // namespace

Result<LuminaireInput> luminaire_input(const Arguments& arguments, ProfileSize size, Diagnostics& diagnostics) {
    LuminaireInput input;
    const auto file = arguments.value("--luminaire");
    if (!file) return fail("USE0104", "no luminaire is given", "add --luminaire FILE");
    input.file = *file;
    ProfileShape profile;
    profile.file = input.file;
    profile.size = size;
    input.light.shape = profile;
    input.light.name = "luminaire";
    if (const auto text = arguments.value("--flux")) {
        Result<double> lumens = parse_amount(*text, Dimension::luminous_flux, "--flux");
        if (!lumens) return pass_on(lumens);
        input.flux = *text;
        Result<PhotometricValue> value = parse_photometric_value(*text);
        if (!value) return pass_on(value);
        input.light.intensity = *value;
    }
    ProfileInputOptions options;
    options.photometric = true;
    Result<LoadedProfile> loaded = load(input.file, options);
    if (!loaded) return pass_on(loaded);
    diagnostics = loaded->diagnostics;
    input.ra = declared_ra(loaded->profile);
    const ProfileHeader header = header_of(loaded->profile);
    if (header.input_watts > 0.0) input.input_w = header.input_watts;
    input.name = luminaire_name(header);
    input.street_side_c_deg = street_side_c_deg(loaded->profile, loaded->web);
    return input;
}

Result<std::string> name_beside(const std::string& file, const std::string& rig) {
    const std::string folder = folder_of_file(rig);
    if ((folder.empty() || folder == ".") && !file.starts_with("/") && !file.starts_with("../")) return file;
    if (!folder.empty() && file.starts_with(folder + "/")) return file.substr(folder.size() + 1);
    return fail("USE0107", fmt::format("'{}' is not below the folder of '{}'", file, rig),
                "a rig names files below its own folder: write it beside the luminaire");
}

} // namespace gonio::cli
