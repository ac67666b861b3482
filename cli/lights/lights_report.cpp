#include "lights_report.hpp"

#include <gonio/base/unit_text.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/interchange/scene_rig.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/web.hpp>

#include "../json_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace gonio::cli {

namespace {

constexpr double no_sign = 0.0; // −0 + 0 is 0

std::string vector_text(const glm::dvec3& v) {
    return fmt::format("{},{},{}", rounded(v.x + no_sign, 4), rounded(v.y + no_sign, 4), rounded(v.z + no_sign, 4));
}

Json vector_json(const glm::dvec3& v) {
    return Json::array({v.x + no_sign, v.y + no_sign, v.z + no_sign});
}

// "r=0.03m", or the profile's file.
std::string size_text(const FoundLight& light, const FoundScene& scene) {
    if (!light.shape) return "-";
    if (const auto* const profile = std::get_if<ProfileShape>(&*light.shape))
        return light.profile ? scene.profiles[*light.profile].name : profile->file;
    std::string text;
    for (const ShapeValue& value : values_of(*light.shape)) {
        std::string one;
        if (const auto* const length = std::get_if<Meters>(&value.value))
            one = fmt::format("{}={}m", value.key, rounded(length->value, 4));
        else if (const auto* const angle = std::get_if<Radians>(&value.value))
            one = fmt::format("{}={}°", value.key, rounded(to_degrees(*angle), 4));
        else if (const auto* const flag = std::get_if<bool>(&value.value); flag != nullptr && *flag)
            one = value.key;
        if (!one.empty()) text += (text.empty() ? "" : " ") + one;
    }
    return text.empty() ? "-" : text;
}

std::optional<double> cct_of(const FoundLight& light) {
    if (light.temperature) return light.temperature->value;
    const Result<Uv> uv = uv_of_rgb(light.color, *find_rgb_space("rec709"));
    if (!uv) return std::nullopt;
    const Cct cct = fast_cct(*uv);
    constexpr double farthest = 0.05; // as the CIE has it
    if (!std::isfinite(cct.temperature.value) || !(std::abs(cct.duv) <= farthest)) return std::nullopt;
    return cct.temperature.value;
}

// Letters in a text of UTF-8.
std::size_t width_of(std::string_view text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

std::string padded(std::string text, std::size_t width) {
    const std::size_t has = width_of(text);
    if (has < width) text.append(width - has, ' ');
    return text;
}

std::string right(const std::optional<double>& value, std::size_t width) {
    const std::string text = value ? rounded(*value, 4) : "-";
    return std::string(text.size() < width ? width - text.size() : 0, ' ') + text;
}

} // namespace

std::vector<LightMeasures> measures_of(const FoundScene& scene) {
    std::vector<LightMeasures> all;
    all.reserve(scene.lights.size());
    std::map<const Web*, std::pair<double, double>> webs; // flux, peak
    const auto lumen = parse_photometric_unit("lm");
    for (const FoundLight& light : scene.lights) {
        LightMeasures measures;
        if (light.shape) {
            measures.cct_k = cct_of(light);
            if (const auto* const profile = std::get_if<ProfileShape>(&*light.shape)) {
                if (profile->web) {
                    auto [at, is_new] = webs.try_emplace(profile->web.get());
                    if (is_new) at->second = {flux(*profile->web).value, peak(*profile->web).intensity.value};
                    const auto& [flux_lm, peak_cd] = at->second;
                    double scale = 1.0;
                    if (light.intensity)
                        scale = light.intensity->number /
                                (light.intensity->unit.unit->dimension == Dimension::luminous_flux ? flux_lm : peak_cd);
                    measures.flux_lm = at->second.first * scale;
                    measures.intensity_cd = at->second.second * scale;
                }
            } else if (light.intensity) {
                Result<ShapePhotometry> photometry = ShapePhotometry::of(*light.shape);
                Result<Emission> emission = photometry ? photometry->emission_of(*light.intensity)
                                                       : Result<Emission>(Unexpected(photometry.error()));
                if (emission) {
                    if (emission->illuminance.value > 0.0) measures.illuminance_lx = emission->illuminance.value;
                    if (class_of(*light.shape) != ShapeClass::sun) {
                        measures.intensity_cd = emission->intensity.value;
                        if (const Result<double> flux = photometry->express(*emission, *lumen))
                            measures.flux_lm = *flux;
                    }
                    if (class_of(*light.shape) != ShapeClass::punctual)
                        measures.luminance_nt = emission->luminance.value;
                }
            }
        }
        all.push_back(measures);
    }
    return all;
}

void print_lights(const FoundScene& scene, const std::vector<LightMeasures>& measures, Console& console) {
    std::string head = fmt::format("{}: {}", scene.source, scene.format);
    if (!scene.generator.empty()) head += fmt::format(" of {}", scene.generator);
    console.print(fmt::format("{}, {} light{}\n", head, scene.lights.size(), scene.lights.size() == 1 ? "" : "s"));
    if (scene.lights.empty()) return;
    constexpr std::size_t widest = 32;
    std::size_t name = 4;
    std::size_t shape = 5;
    std::size_t size = 4;
    for (const FoundLight& light : scene.lights) {
        name = std::clamp(width_of(light.name), name, widest);
        shape = std::max(shape, width_of(light.shape ? kind_of(*light.shape) : light.kind));
        size = std::clamp(width_of(size_text(light, scene)), size, widest);
    }
    console.print(fmt::format("{}  {}  {}  {:>8}  {:>8}  {:>8}  {:>8}  {:>6}  {}\n", padded("name", name),
                              padded("shape", shape), padded("size", size), "lm", "cd", "cd/m²", "lx", "K",
                              "place and direction [m]"));
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const FoundLight& light = scene.lights[i];
        const LightMeasures& of = measures[i];
        const std::optional<double> kelvin = of.cct_k ? std::optional(std::round(*of.cct_k)) : std::nullopt;
        const bool is_sun = light.shape && std::holds_alternative<SunShape>(*light.shape);
        std::string where = light.is_converted() ? is_sun ? "towards " + vector_text(light.direction)
                                                          : fmt::format("at {} towards {}", vector_text(light.position),
                                                                        vector_text(light.direction))
                                                 : fmt::format("only listed: {}", light.stated);
        console.print(fmt::format("{}  {}  {}  {}  {}  {}  {}  {}  {}\n", padded(light.name, name),
                                  padded(light.shape ? kind_of(*light.shape) : light.kind, shape),
                                  padded(size_text(light, scene), size), right(of.flux_lm, 8),
                                  right(of.intensity_cd, 8), right(of.luminance_nt, 8), right(of.illuminance_lx, 8),
                                  right(kelvin, 6), where));
    }
}

std::string audit_text(const FoundScene& scene, const std::vector<SceneFinding>& findings) {
    std::string text;
    for (const SceneFinding& finding : findings) {
        const Diagnostic said = to_diagnostic(finding, scene);
        text += fmt::format("{} {}\n        {}{}\n", said.code, said.message, said.hint,
                            finding.fixes.empty() ? "" : " (--fix)");
    }
    const auto counted = [](std::size_t number, std::string_view what) {
        return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
    };
    return text + (findings.empty() ? fmt::format("nothing implausible in {}\n", counted(scene.lights.size(), "light"))
                                    : fmt::format("{} in {}\n", counted(findings.size(), "finding"),
                                                  counted(scene.lights.size(), "light")));
}

void print_lights_json(const FoundScene& scene, const std::vector<LightMeasures>& measures,
                       const std::optional<std::vector<SceneFinding>>& findings, const Diagnostics& diagnostics,
                       bool pretty, Console& console) {
    JsonWriter json(console, pretty);
    json.member("schema", "gonio.lights/1");
    json.member("file", scene.source);
    json.member("format", scene.format);
    json.member("generator", scene.generator);
    json.member("meters_per_unit", scene.meters_per_unit);
    json.begin_array("lights");
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const FoundLight& light = scene.lights[i];
        const LightMeasures& of = measures[i];
        Json one{{"name", light.name}, {"place", light.place},   {"line", light.location.line},
                 {"kind", light.kind}, {"stated", light.stated}, {"converted", light.is_converted()}};
        if (light.shape) {
            const bool is_profile = std::holds_alternative<ProfileShape>(*light.shape);
            one["shape"] = is_profile ? "ies:" + size_text(light, scene) : shape_text(*light.shape);
            if (of.flux_lm) one["flux_lm"] = *of.flux_lm;
            if (of.intensity_cd) one["intensity_cd"] = *of.intensity_cd;
            if (of.luminance_nt) one["luminance_nt"] = *of.luminance_nt;
            if (of.illuminance_lx) one["illuminance_lx"] = *of.illuminance_lx;
            if (of.cct_k) one["cct_K"] = *of.cct_k;
            one["color"] = vector_json(light.color);
            one["position"] = vector_json(light.position);
            one["direction"] = vector_json(light.direction);
            one["up"] = vector_json(light.up);
            if (light.zoom)
                one["zoom_deg"] = Json::array({to_degrees(light.zoom->least), to_degrees(light.zoom->most)});
            if (light.range) one["range_m"] = light.range->value;
        }
        one["remarks"] = Json::array();
        for (const LightRemark& said : light.remarks)
            one["remarks"].push_back(Json{{"code", said.code->code}, {"message", said.message}});
        json.element(one);
    }
    json.end_array();
    if (findings) {
        json.begin_array("findings");
        for (const SceneFinding& finding : *findings) {
            Json names = Json::array();
            for (const std::size_t light : finding.lights)
                names.push_back(scene.lights[light].name);
            json.element(Json{{"code", finding.code->code},
                              {"message", finding.message},
                              {"hint", finding.hint},
                              {"lights", names},
                              {"can_fix", !finding.fixes.empty()}});
        }
        json.end_array();
    }
    json.member("diagnostics", diagnostics_json(diagnostics));
    json.end();
}

} // namespace gonio::cli
