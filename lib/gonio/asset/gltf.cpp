// glTF 2.0: EXT_lights_ies with the portable profile (beside the .gltf, inside the .glb), and for readers without it
// KHR_lights_punctual on the same node.
//
// EXT_lights_ies: candela of the file × multiplier × colour, which is clamped to [0, 1]; the node's −Z is γ = 0. So the
// colour is scaled to a greatest channel of 1 and the multiplier gives back what that takes.
#include <gonio/asset/detail/target_files.hpp>
#include <gonio/base/version.hpp>
#include <gonio/light/closed_forms.hpp>
#include <gonio/web/zones.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace gonio::asset_detail {

namespace {

using Json = nlohmann::ordered_json;
using std::numbers::pi;

constexpr const char* mime_type = "application/x-ies-lm-63";

// The greatest channel, and the colour with that as 1.
struct ScaledColor {
    double factor;
    Json rgb;
};

ScaledColor scaled(const glm::dvec3& color) {
    const double most = std::max({color.x, color.y, color.z});
    return {most, {color.x / most, color.y / most, color.z / most}};
}

// Whether a thousandth of the peak is reached above the horizon.
bool shines_up(const Web& web, Candelas peak) {
    for (std::size_t plane = 0; plane < web.planes_deg().size(); ++plane)
        for (std::size_t k = 0; k < web.gammas_deg().size(); ++k)
            if (web.gammas_deg()[k] > 90.001 && web.column(plane)[k] > 1e-3 * peak.value) return true;
    return false;
}

// Flux-weighted mean of cosγ below the horizon, from the exact flux of rings of 5°.
double mean_cosine(const Web& web) {
    constexpr double step_deg = 5.0;
    double lumens = 0.0;
    double weighted = 0.0;
    for (int i = 0; i < 18; ++i) {
        const double low = step_deg * i;
        const double high = low + step_deg;
        const double ring = zone_flux(web, low, high).value;
        lumens += ring;
        weighted += ring * 0.5 * (std::cos(low * pi / 180.0) + std::cos(high * pi / 180.0));
    }
    return lumens > 0.0 ? weighted / lumens : 0.0;
}

struct Cone {
    double inner, outer; // half angles [rad]
};

// The cone whose lobe ((cosθ − cos outer)/(cos inner − cos outer))², which glTF has, is as narrow: of the same mean
// cosine. Without an inner cone that is (3 + cos outer)/4; wider ones end at the horizon and have one.
Cone cone_of(double mean_cosine) {
    if (mean_cosine >= 0.75) return {0.0, std::acos(std::clamp(4.0 * mean_cosine - 3.0, 0.0, 1.0))};
    // (½ − ¼c²)/(1 − ⅔c) for an inner cosine c rises from ½ to ¾.
    double low = 0.0;
    double high = 1.0;
    for (int step = 0; step < 60; ++step) {
        const double c = 0.5 * (low + high);
        (((0.5 - 0.25 * c * c) / (1.0 - 2.0 / 3.0 * c) < mean_cosine) ? low : high) = c;
    }
    return {std::acos(low), 0.5 * pi};
}

// A light of the same flux: what shines up too is a point, the rest a spot about as narrow.
Json punctual(const MeasuredLight& light, const ScaledColor& color) {
    Json json{{"name", light.name}, {"color", color.rgb}};
    if (shines_up(light.web, light.peak)) {
        json["type"] = "point";
        json["intensity"] = color.factor * light.flux.value / (4.0 * pi);
        return json;
    }
    const auto [inner, outer] = cone_of(mean_cosine(light.web));
    const double widest_inner = std::min(inner, 0.999 * outer); // below the outer one, as the format wants it
    json["type"] = "spot";
    json["intensity"] =
        color.factor * light.flux.value / closed_form::spot_solid_angle(Falloff::frostbite, widest_inner, outer);
    json["spot"] = {{"innerConeAngle", widest_inner}, {"outerConeAngle", outer}};
    return json;
}

// The document but for where the profile is.
Json document(const MeasuredLight& light, Json profile) {
    const ScaledColor color = scaled(light.color);
    profile["name"] = light.name;
    // A world of +Y up: the node's −Z goes down, its +X stays.
    const double half_turn = std::sqrt(0.5);
    Json node{{"name", light.name}, {"rotation", {-half_turn, 0.0, 0.0, half_turn}}};
    node["extensions"] = {
        {"EXT_lights_ies", {{"light", 0}, {"multiplier", color.factor}, {"color", color.rgb}}},
        {"KHR_lights_punctual", {{"light", 0}}},
    };
    node["extras"] = {{"flux_lm", light.flux.value}, {"peak_cd", light.peak.value}};
    return {
        {"asset", {{"version", "2.0"}, {"generator", std::string("gonio ") + version}}},
        {"extensionsUsed", {"EXT_lights_ies", "KHR_lights_punctual"}},
        {"extensions",
         {{"EXT_lights_ies", {{"lights", Json::array({std::move(profile)})}}},
          {"KHR_lights_punctual", {{"lights", Json::array({punctual(light, color)})}}}}},
        {"scene", 0},
        {"scenes", Json::array({{{"nodes", {0}}}})},
        {"nodes", Json::array({std::move(node)})},
    };
}

void append_u32(std::string& bytes, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>((value >> shift) & 0xffU);
}

// A chunk of a .glb, padded to whole words.
void append_chunk(std::string& bytes, std::string_view type, std::string data, char padding) {
    data.resize((data.size() + 3) / 4 * 4, padding);
    append_u32(bytes, data.size());
    bytes += type;
    bytes += data;
}

std::string binary(const MeasuredLight& light) {
    Json json = document(light, {{"bufferView", 0}, {"mimeType", mime_type}});
    json["buffers"] = Json::array({{{"byteLength", light.portable_ies.size()}}});
    json["bufferViews"] = Json::array({{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", light.portable_ies.size()}}});
    std::string chunks;
    append_chunk(chunks, "JSON", json.dump(), ' ');
    append_chunk(chunks, std::string_view("BIN\0", 4), light.portable_ies, '\0');
    std::string bytes = "glTF";
    append_u32(bytes, 2);
    append_u32(bytes, 12 + chunks.size());
    return bytes + chunks;
}

} // namespace

std::vector<AssetFile> gltf_files(const MeasuredLight& light) {
    const std::string ies = light.name + ".ies";
    return {{light.name + ".gltf", document(light, {{"uri", ies}}).dump(2) + "\n", {}},
            {ies, light.portable_ies, {}},
            {light.name + ".glb", binary(light), {}}};
}

} // namespace gonio::asset_detail
