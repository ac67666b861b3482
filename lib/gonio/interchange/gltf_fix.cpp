// Changes numbers of a glTF document where they stand; all other bytes are kept.
#include <gonio/base/json_text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/interchange/audit.hpp>
#include <gonio/interchange/detail/gltf_document.hpp>
#include <gonio/interchange/detail/gltf_index.hpp>
#include <gonio/interchange/detail/reading.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>

namespace gonio {

namespace {

using namespace interchange_detail;

struct Edit {
    std::uint32_t length = 0;
    std::string text;
    AppliedFix fix;
};

// The entry of a light that a fix is about: the use of a profile is in its node.
GltfElement entry_of(const GltfIndex& index, const FoundLight& light) {
    if (light.kind == "ies") {
        std::size_t node = 0;
        const std::string_view digits = std::string_view(light.place).substr(std::string_view("nodes[").size());
        std::from_chars(digits.data(), digits.data() + digits.size(), node);
        return node < index.nodes.size() ? index.nodes[node].element : GltfElement{};
    }
    const bool is_area = light.kind == "rect" || light.kind == "disk";
    const auto& lights = index.lights[static_cast<std::size_t>(is_area ? GltfLights::area : GltfLights::punctual)];
    return light.index < lights.size() ? lights[light.index] : GltfElement{};
}

std::string joined(const std::vector<std::string>& path) {
    std::string text;
    for (const std::string& step : path)
        text += (text.empty() ? "" : ".") + step;
    return text;
}

void append_u32(std::string& bytes, std::size_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>((value >> shift) & 0xffU);
}

// A GLB with another JSON chunk.
std::string repacked(std::string_view glb, std::string_view old_json, std::string json) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto behind = static_cast<std::size_t>(old_json.data() - glb.data()) + old_json.size();
    const std::string_view rest = glb.substr(std::min(behind, glb.size()));
    std::string bytes = "glTF";
    append_u32(bytes, 2);
    append_u32(bytes, 12 + 8 + json.size() + rest.size());
    append_u32(bytes, json.size());
    return bytes + "JSON" + json + std::string(rest);
}

} // namespace

Result<FixedScene> fix_scene(std::string_view bytes, const FoundScene& scene, std::span<const SceneFinding> findings) {
    if (scene.format != "gltf")
        return fail(Failure::unsupported, fmt::format("scenes of the format {} cannot be fixed", scene.format),
                    "glTF can; correct the others in their own program");
    Result<GltfDocument> document = gltf_document(bytes, scene.source);
    if (!document) return pass_on(document);
    Result<GltfIndex> index = gltf_index(document->json, scene.source);
    if (!index) return pass_on(index);
    std::map<std::uint32_t, Edit> edits; // by offset
    for (const SceneFinding& finding : findings)
        for (const SceneFix& fix : finding.fixes) {
            const FoundLight& light = scene.lights[fix.light];
            const GltfElement entry = entry_of(*index, light);
            std::vector<std::string> path = fix.path;
            if (light.kind == "ies") path.insert(path.begin(), {"extensions", "EXT_lights_ies"});
            const GltfElement place = gltf_value_place(document->json, entry, path);
            if (place.length == 0 || edits.contains(place.offset)) continue;
            const std::optional<double> now = parse_number(document->json.substr(place.offset, place.length));
            if (!now) continue;
            const double to = std::isnan(fix.from) ? *now * fix.to : fix.to; // a factor where the number was not known
            edits[place.offset] = {
                place.length, shortest(to), {std::string(finding.code->code), light.name, joined(fix.path), *now, to}};
        }
    FixedScene fixed;
    std::string json;
    std::size_t at = 0;
    for (auto& [offset, edit] : edits) {
        json += document->json.substr(at, offset - at);
        json += edit.text;
        at = offset + edit.length;
        fixed.applied.push_back(std::move(edit.fix));
    }
    json += document->json.substr(at);
    if (document->is_binary) {
        fixed.bytes = repacked(document->container, document->json, std::move(json));
    } else {
        const std::size_t before = bytes.size() - document->json.size(); // a byte order mark
        fixed.bytes = std::string(bytes.substr(0, before)) + json;
    }
    return fixed;
}

} // namespace gonio
