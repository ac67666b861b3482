// glTF 2.0: a node for each light, in metres and Y up. Points, spots and suns are KHR_lights_punctual; a profile is
// EXT_lights_ies with the portable profile (beside the .gltf, inside the .glb), and for readers without it a punctual
// light of the same flux on the same node. Rectangles and disks are EXT_lights_area (a draft): nits, one side; `size`
// is the height or the diameter, `aspect` the width over the height. They have a light of the same flux beside them
// too.
//
// EXT_lights_ies: candela of the file × multiplier × colour, which is clamped to [0, 1]; the node's −Z is γ = 0. So the
// colour is scaled to a greatest channel of 1, and the multiplier restores the luminance.
#include <gonio/asset/detail/gltf_stage.hpp>
#include <gonio/asset/detail/same_flux.hpp>
#include <gonio/asset/detail/scene_text.hpp>
#include <gonio/base/version.hpp>

#include <cstdint>

namespace gonio::asset_detail {

namespace {

using detail::Json;

constexpr const char* mime_type = "application/x-ies-lm-63";

Json numbers(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

Json spot_cone(double inner, double outer) {
    return {{"innerConeAngle", inner}, {"outerConeAngle", outer}};
}

// A light of the same flux: a point if the profile emits upwards too, else a spot about as narrow.
Json fallback(const SameFlux& same, const std::string& name, const ScaledColor& color) {
    Json json{{"name", name}, {"color", numbers(color.rgb)}};
    json["type"] = same.is_point ? "point" : "spot";
    json["intensity"] = color.factor * same.intensity;
    if (!same.is_point) json["spot"] = spot_cone(same.inner, same.outer);
    return json;
}

bool is_area(const SceneLight& light) {
    return light.kind == LightKind::rect || light.kind == LightKind::disk;
}

// The light as EXT_lights_area describes it.
Json area(const SceneLight& light) {
    const ScaledColor color = scaled(light.color);
    const bool is_rect = light.kind == LightKind::rect;
    Json json{{"name", light.name},
              {"type", is_rect ? "rect" : "disk"},
              {"color", numbers(color.rgb)},
              {"intensity", color.factor * light.nits},
              {"size", is_rect ? light.height : 2.0 * light.radius}};
    if (is_rect) json["rect"] = {{"aspect", light.width / light.height}};
    return json;
}

// The light as KHR_lights_punctual describes it.
Json punctual(const SceneLight& light, const SceneContent& scene) {
    const ScaledColor color = scaled(light.color);
    if (light.kind == LightKind::profile) return fallback(same_flux(scene.profiles[light.profile]), light.name, color);
    if (is_area(light)) return fallback(same_flux_as_area(light.intensity), light.name, color);
    Json json{{"name", light.name}, {"color", numbers(color.rgb)}};
    json["type"] = light.kind == LightKind::sun ? "directional" : light.kind == LightKind::spot ? "spot" : "point";
    json["intensity"] = color.factor * (light.kind == LightKind::sun ? light.lux : light.intensity);
    if (light.kind == LightKind::spot) json["spot"] = spot_cone(light.inner, light.outer);
    return json;
}

// The document without its buffers and buffer views; `profiles` states where each profile is.
Json document(const SceneContent& scene, Json profiles, const GltfStage& stage) {
    Json lights = Json::array();
    Json areas = Json::array();
    Json nodes = stage.nodes;
    for (const SceneLight& light : scene.lights) {
        Json node{{"name", light.name}, {"rotation", gltf_rotation(light.frame)}};
        if (light.frame.origin != glm::dvec3(0.0)) node["translation"] = numbers(y_up(light.frame.origin));
        node["extensions"] = Json::object();
        if (light.kind == LightKind::profile) {
            const ScaledColor color = scaled(light.color);
            node["extensions"]["EXT_lights_ies"] = {
                {"light", light.profile}, {"multiplier", color.factor}, {"color", numbers(color.rgb)}};
            node["extras"] = {{"flux_lm", scene.profiles[light.profile].flux.value},
                              {"peak_cd", scene.profiles[light.profile].peak.value}};
        }
        if (is_area(light)) {
            node["extensions"]["EXT_lights_area"] = {{"light", areas.size()}};
            areas.push_back(area(light));
        }
        node["extensions"]["KHR_lights_punctual"] = {{"light", lights.size()}};
        nodes.push_back(std::move(node));
        lights.push_back(punctual(light, scene));
    }
    Json used = Json::array();
    Json extensions = Json::object();
    if (!areas.empty()) {
        used.push_back("EXT_lights_area");
        extensions["EXT_lights_area"] = {{"lights", std::move(areas)}};
    }
    if (!scene.profiles.empty()) {
        used.push_back("EXT_lights_ies");
        for (std::size_t i = 0; i < scene.profiles.size(); ++i)
            profiles[i]["name"] = scene.profiles[i].name;
        extensions["EXT_lights_ies"] = {{"lights", std::move(profiles)}};
    }
    used.push_back("KHR_lights_punctual");
    for (const Json& extension : stage.extensions_used)
        used.push_back(extension);
    extensions["KHR_lights_punctual"] = {{"lights", std::move(lights)}};
    Json roots = Json::array();
    for (std::size_t i = 0; i < nodes.size(); ++i)
        roots.push_back(i);
    Json json{
        {"asset", {{"version", "2.0"}, {"generator", std::string("gonio ") + version}}},
        {"extensionsUsed", std::move(used)},
        {"extensions", std::move(extensions)},
        {"scene", 0},
        {"scenes", Json::array({{{"nodes", std::move(roots)}}})},
        {"nodes", std::move(nodes)},
    };
    if (!scene.stage) return json;
    json["scenes"][0]["extras"] = {{"description", scene.description}};
    if (scene.stage->white) json["scenes"][0]["extras"]["white_cd_per_m2"] = scene.stage->white->value;
    json["meshes"] = stage.meshes;
    json["materials"] = stage.materials;
    json["cameras"] = stage.cameras;
    json["accessors"] = stage.accessors;
    return json;
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

GltfStage stage_of(const SceneContent& scene) {
    return scene.stage ? gltf_stage(*scene.stage) : GltfStage{};
}

std::string binary(const SceneContent& scene) {
    const GltfStage stage = stage_of(scene);
    Json profiles = Json::array();
    Json views = stage.views;
    std::string data = stage.bytes;
    for (const MeasuredLight& profile : scene.profiles) {
        profiles.push_back({{"bufferView", views.size()}, {"mimeType", mime_type}});
        views.push_back({{"buffer", 0}, {"byteOffset", data.size()}, {"byteLength", profile.portable_ies.size()}});
        data += profile.portable_ies;
        data.resize((data.size() + 3) / 4 * 4, '\0');
    }
    Json json = document(scene, std::move(profiles), stage);
    if (!data.empty()) {
        json["buffers"] = Json::array({{{"byteLength", data.size()}}});
        json["bufferViews"] = std::move(views);
    }
    std::string chunks;
    append_chunk(chunks, "JSON", json.dump(), ' ');
    if (!data.empty()) append_chunk(chunks, std::string_view("BIN\0", 4), data, '\0');
    std::string bytes = "glTF";
    append_u32(bytes, 2);
    append_u32(bytes, 12 + chunks.size());
    return bytes + chunks;
}

} // namespace

std::vector<AssetFile> gltf_text_files(const SceneContent& scene) {
    Json profiles = Json::array();
    for (const MeasuredLight& profile : scene.profiles)
        profiles.push_back({{"uri", profile.name + ".ies"}});
    const GltfStage stage = stage_of(scene);
    Json json = document(scene, std::move(profiles), stage);
    if (scene.stage) {
        json["buffers"] = Json::array({{{"uri", scene.name + ".bin"}, {"byteLength", stage.bytes.size()}}});
        json["bufferViews"] = stage.views;
    }
    std::vector<AssetFile> files{{scene.name + ".gltf", json.dump(2) + "\n", {}}};
    if (scene.stage) files.push_back({scene.name + ".bin", stage.bytes, {}});
    for (const MeasuredLight& profile : scene.profiles)
        files.push_back({profile.name + ".ies", profile.portable_ies, {}});
    return files;
}

std::vector<AssetFile> gltf_binary_files(const SceneContent& scene) {
    return {{scene.name + ".glb", binary(scene), {}}};
}

std::vector<AssetFile> gltf_files(const SceneContent& scene) {
    std::vector<AssetFile> files = gltf_text_files(scene);
    files.push_back(gltf_binary_files(scene).front());
    return files;
}

} // namespace gonio::asset_detail
