#include <gonio/base/charconv.hpp>
#include <gonio/light/far_field.hpp>
#include <gonio/light/luminous_body.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/light/profile_facts.hpp>
#include <gonio/profile/text_encoding.hpp>
#include <gonio/profile/tm33_light.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/radiometric.hpp>
#include <gonio/web/symmetry.hpp>

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>
#include <variant>

namespace gonio {

namespace {

std::optional<double> if_positive(double value) {
    return value > 0.0 ? std::optional(value) : std::nullopt;
}

void add_file_facts(ProfileFacts& facts, const IesFile& file) {
    facts.format = "IES";
    facts.version = to_text(file.version);
    facts.photometry = file.photometry == Photometry::a ? 'A' : file.photometry == Photometry::b ? 'B' : 'C';
    facts.planes = file.horizontal_deg.size();
    facts.gammas = file.vertical_deg.size();
    facts.input_w = if_positive(file.input_watts);
    DeclaredLamps lamp;
    lamp.count = file.lamp_count;
    for (const IesKeyword& keyword : file.keywords)
        if (keyword.name == "LAMP") lamp.type = to_utf8(keyword.text);
    if (file.lumens_per_lamp > 0.0) lamp.flux_lm = file.lumens_per_lamp * file.lamp_count;
    lamp.input_w = facts.input_w;
    facts.lamps.push_back(std::move(lamp));
}

void add_file_facts(ProfileFacts& facts, const LdtFile& file, int lamp_set) {
    facts.format = "LDT";
    facts.version = "EULUMDAT";
    facts.gammas = file.gammas_deg.size();
    facts.planes = facts.gammas == 0 ? 0 : file.candela_per_klm.size() / facts.gammas;
    for (const LdtLampSet& set : file.lamp_sets)
        facts.lamps.push_back({std::abs(set.lamp_count), to_utf8(set.lamp_type), if_positive(set.flux_lm),
                               leading_number(set.color_temperature), to_utf8(set.color_rendering),
                               if_positive(set.input_watts)});
    facts.input_w = facts.lamps[static_cast<std::size_t>(lamp_set) - 1].input_w;
}

void add_file_facts(ProfileFacts& facts, const Tm33File& file) {
    facts.format = "TM-33";
    facts.version = edition(file);
    const Photometry photometry = photometry_of(file).value_or(Photometry::c);
    facts.photometry = photometry == Photometry::a ? 'A' : photometry == Photometry::b ? 'B' : 'C';
    double watts = 0.0;
    for (const Tm33Emitter& emitter : file.emitters) {
        if (emitter.intensity && facts.planes == 0) {
            facts.planes = emitter.intensity->horizontal_deg.size();
            facts.gammas = emitter.intensity->vertical_deg.size();
        }
        watts += emitter.input_watts.value_or(0.0);
        const double count = emitter.quantity.value_or(1.0);
        facts.lamps.push_back({count >= 1.0 && count <= 1e6 ? static_cast<int>(count) : 1, emitter.description,
                               if_positive(emitter.rated_lumens.value_or(0.0) * count), emitter.cct_k,
                               emitter.cri_ra ? fmt::format("{}", *emitter.cri_ra) : std::string(),
                               if_positive(emitter.input_watts.value_or(0.0))});
    }
    facts.input_w = if_positive(watts);
}

std::optional<double> in_degrees(const std::optional<Radians>& angle) {
    return angle ? std::optional(to_degrees(*angle)) : std::nullopt;
}

std::optional<int> nema_of(const std::optional<double>& field_deg) {
    return field_deg ? std::optional(nema_type(degrees(*field_deg))) : std::nullopt;
}

// "mW/sr" is mW over the sphere. What a unit without "/sr" is over the sphere is not known.
std::string flux_unit_of(std::string_view intensity_unit) {
    constexpr std::string_view per_steradian = "/sr";
    if (!intensity_unit.ends_with(per_steradian)) return fmt::format("{}·sr", intensity_unit);
    intensity_unit.remove_suffix(per_steradian.size());
    return std::string(intensity_unit);
}

} // namespace

double ProfileFacts::zone_lm(std::size_t low_deg, std::size_t high_deg) const {
    double sum = 0.0;
    for (std::size_t i = low_deg / 10; i < high_deg / 10; ++i)
        sum += ten_degree_zones_lm[i].value;
    return sum;
}

std::optional<double> ProfileFacts::efficacy_lm_per_w() const {
    return input_w && flux_unit == "lm" ? std::optional(flux_lm / *input_w) : std::nullopt;
}

ProfileFacts profile_facts(const Profile& profile, const Web& web, const ResolveOptions& options, FactsExtent extent) {
    ProfileFacts facts;
    if (const std::string unit = radiometric_unit(profile); !unit.empty() && !options.as_candela) {
        facts.intensity_unit = unit;
        facts.flux_unit = flux_unit_of(unit);
    }
    if (const auto* ies = std::get_if<IesFile>(&profile.file))
        add_file_facts(facts, *ies);
    else if (const auto* tm33 = std::get_if<Tm33File>(&profile.file))
        add_file_facts(facts, *tm33);
    else
        add_file_facts(facts, std::get<LdtFile>(profile.file), options.lamp_set);
    facts.symmetry = detected_symmetry(web);
    facts.declared_symmetry = web.stored_symmetry();
    facts.flux_lm = flux(web).value;
    facts.zonal_flux_lm = zonal_flux(web).value;
    facts.declared_flux_lm = declared_flux_lm(profile, options);
    facts.peak = peak(web);
    facts.beam_deg = in_degrees(spread_angle(web, 0.0, 0.5));
    facts.field_deg = in_degrees(spread_angle(web, 0.0, 0.1));
    facts.beam_c90_deg = in_degrees(spread_angle(web, 90.0, 0.5));
    facts.field_c90_deg = in_degrees(spread_angle(web, 90.0, 0.1));
    facts.opening = luminous_opening(profile);
    if (extent != FactsExtent::brief)
        if (const auto body = LuminousBody::of(opening_of(profile), web))
            facts.point_distance_m = point_distance(*body, web, 0.01).value;
    facts.nema_horizontal = nema_of(facts.field_deg);
    facts.nema_vertical = nema_of(facts.field_c90_deg);
    facts.ten_degree_zones_lm = ten_degree_zones(web);
    if (extent != FactsExtent::all) return facts;
    facts.center_beam = center_beam(web);
    facts.cie_beam_deg = in_degrees(cie_beam_angle(web, 0.0));
    facts.cie_beam_c90_deg = in_degrees(cie_beam_angle(web, 90.0));
    facts.cie_code =
        cie_flux_code(web, facts.declared_flux_lm ? std::optional(Lumens(*facts.declared_flux_lm)) : std::nullopt);
    facts.spacing = spacing_criterion(web);
    facts.street_side_c_deg = street_side_c_deg(profile, web, options.azimuth);
    facts.classes = luminaire_classification(web, facts.street_side_c_deg);
    return facts;
}

} // namespace gonio
