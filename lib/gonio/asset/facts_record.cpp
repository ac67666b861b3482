#include <gonio/asset/facts_record.hpp>
#include <gonio/base/report_json.hpp>

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace gonio {

using detail::Json;
using detail::number_or_null;

namespace {

Json zones_json(const ProfileFacts& facts) {
    Json zones = Json::object();
    constexpr std::array<std::array<std::size_t, 2>, 7> bands{
        {{0, 30}, {0, 40}, {0, 60}, {60, 90}, {0, 90}, {90, 180}, {0, 180}}};
    for (const auto& [low, high] : bands)
        zones[fmt::format("{}-{}", low, high)] = facts.zone_lm(low, high);
    return zones;
}

Json ten_degree_json(const ProfileFacts& facts) {
    Json zones = Json::array();
    for (const Lumens lumens : facts.ten_degree_zones_lm)
        zones.push_back(lumens.value);
    return zones;
}

// In per cent, as CIE 52 writes them.
Json cie_code_json(const CieFluxCode& code) {
    Json numbers = Json::array();
    const auto add = [&](const std::optional<double>& part) {
        numbers.push_back(number_or_null(part ? std::optional(100.0 * *part) : std::nullopt));
    };
    for (const std::optional<double>& part : code.within)
        add(part);
    add(code.downward);
    add(code.light_output_ratio);
    return numbers;
}

Json classes_json(const LuminaireClassification& classes) {
    constexpr std::array names{"L", "M", "H", "VH"};
    Json json = Json::object();
    for (std::size_t i = 0; i < names.size(); ++i)
        json[std::string("F") + names[i]] = classes.front[i].value;
    for (std::size_t i = 0; i < names.size(); ++i)
        json[std::string("B") + names[i]] = classes.back[i].value;
    json["UL"] = classes.up_low.value;
    json["UH"] = classes.up_high.value;
    return json;
}

} // namespace

Json detail::facts_json(const std::string& file, const ProfileFacts& facts, const Diagnostics& diagnostics) {
    Json lamps = Json::array();
    for (const DeclaredLamps& lamp : facts.lamps)
        lamps.push_back({{"count", lamp.count},
                         {"type", lamp.type},
                         {"flux_lm", number_or_null(lamp.flux_lm)},
                         {"cct_K", number_or_null(lamp.cct_k)},
                         {"cri", lamp.cri.empty() ? Json(nullptr) : Json(lamp.cri)},
                         {"input_W", number_or_null(lamp.input_w)}});
    return {{"schema", "gonio.info/1"},
            {"file", file},
            {"format", facts.format},
            {"version", facts.version},
            {"photometry", std::string(1, facts.photometry)},
            {"planes", facts.planes},
            {"gammas", facts.gammas},
            {"symmetry", to_text(facts.symmetry)},
            {"declared_symmetry", to_text(facts.declared_symmetry)},
            {"lamps", std::move(lamps)},
            {"intensity_unit", facts.intensity_unit},
            {"flux_unit", facts.flux_unit},
            {"flux_lm", facts.flux_lm},
            {"zonal_flux_lm", facts.zonal_flux_lm},
            {"declared_flux_lm", number_or_null(facts.declared_flux_lm)},
            {"absolute", !facts.declared_flux_lm},
            {"peak_cd", facts.peak.intensity.value},
            {"peak_c_deg", facts.peak.c_deg},
            {"peak_gamma_deg", facts.peak.gamma_deg},
            {"beam_angle_deg", number_or_null(facts.beam_deg)},
            {"field_angle_deg", number_or_null(facts.field_deg)},
            {"beam_angle_c90_deg", number_or_null(facts.beam_c90_deg)},
            {"field_angle_c90_deg", number_or_null(facts.field_c90_deg)},
            {"input_W", number_or_null(facts.input_w)},
            {"efficacy_lm_per_W", number_or_null(facts.efficacy_lm_per_w())},
            {"luminous_opening",
             {{"shape", to_text(facts.opening.shape)},
              {"width_m", facts.opening.width_m},
              {"length_m", facts.opening.length_m},
              {"height_m", facts.opening.height_m}}},
            {"point_distance_m", number_or_null(facts.point_distance_m)},
            {"center_beam_cd", facts.center_beam.value},
            {"beam_angle_cie_deg", number_or_null(facts.cie_beam_deg)},
            {"beam_angle_cie_c90_deg", number_or_null(facts.cie_beam_c90_deg)},
            {"nema_horizontal", facts.nema_horizontal ? Json(*facts.nema_horizontal) : Json(nullptr)},
            {"nema_vertical", facts.nema_vertical ? Json(*facts.nema_vertical) : Json(nullptr)},
            {"zones_lm", zones_json(facts)},
            {"ten_degree_zones_lm", ten_degree_json(facts)},
            {"cie_flux_code_percent", cie_code_json(facts.cie_code)},
            {"spacing_criterion",
             {{"c0_180", number_or_null(facts.spacing.along_c0)},
              {"c90_270", number_or_null(facts.spacing.along_c90)},
              {"diagonal", number_or_null(facts.spacing.diagonal)}}},
            {"lcs_front_c_deg", facts.street_side_c_deg},
            {"lcs_lm", classes_json(facts.classes)},
            {"diagnostics", diagnostics_json(diagnostics)}};
}

std::string facts_record(const std::string& file, const ProfileFacts& facts, const Diagnostics& diagnostics) {
    return detail::facts_json(file, facts, diagnostics).dump(2) + "\n";
}

} // namespace gonio
