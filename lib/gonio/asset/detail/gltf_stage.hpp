// The stage of a scene as parts of a glTF document.
#pragma once

#include <gonio/asset/detail/scene_stage.hpp>

#include <nlohmann/json.hpp>

#include <string>

namespace gonio::asset_detail {

struct GltfStage {
    nlohmann::ordered_json nodes = nlohmann::ordered_json::array(); // of surfaces and the camera, all of them roots
    nlohmann::ordered_json meshes, materials, cameras, accessors;
    nlohmann::ordered_json views = nlohmann::ordered_json::array(); // of `bytes`, which is buffer 0
    nlohmann::ordered_json extensions_used = nlohmann::ordered_json::array();
    std::string bytes; // a multiple of four bytes long
};

GltfStage gltf_stage(const SceneStage& stage);

// The frame's rotation for a node, in a world with Y up; of unit length to the last digit.
nlohmann::ordered_json gltf_rotation(const Frame& frame);

} // namespace gonio::asset_detail
