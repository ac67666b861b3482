// The places of a glTF document's elements, and the tree of its nodes: what is needed to find its lights without
// keeping the document. About 30 bytes for a node.
#pragma once

#include <gonio/base/json.hpp>
#include <gonio/base/result.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio::interchange_detail {

inline constexpr std::uint32_t nothing = 0xffffffff;

// An element of an array, as bytes of the text.
struct GltfElement {
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
};

// The extensions of nodes that are lights.
enum class GltfLights : std::uint8_t { punctual, ies, area };
inline constexpr std::array<std::string_view, 3> gltf_light_extensions{"KHR_lights_punctual", "EXT_lights_ies",
                                                                       "EXT_lights_area"};

struct GltfNode {
    GltfElement element;
    std::uint32_t mesh = nothing;
    std::uint32_t parent = nothing;
    std::uint8_t lights = 0; // bits by GltfLights
    bool is_root = false;    // of the scene that is shown
};

struct GltfIndex {
    std::string generator;
    std::vector<GltfNode> nodes;
    std::vector<GltfElement> meshes, materials, accessors, buffers, buffer_views;
    std::array<std::vector<GltfElement>, 3> lights; // by GltfLights
    bool any_emission = false;                      // a material has an emissiveFactor
    bool has_scenes = false;
};

// The index of a document. Fails (malformed) on text that is not JSON, not glTF 2.0, or has wrong types where the index
// looks; on a child that does not exist, two parents or a cycle; on too many nodes; (unsupported) if the document
// requires an extension that may change lights.
Result<GltfIndex> gltf_index(std::string_view text, const std::string& source);

// The range of a value in an element, by its keys and array indices ("spot", "outerConeAngle"); length 0: not there.
GltfElement gltf_value_place(std::string_view text, GltfElement element, const std::vector<std::string>& path);

} // namespace gonio::interchange_detail
