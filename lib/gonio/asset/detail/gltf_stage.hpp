// The stage of a scene as parts of a glTF document.
#pragma once

#include <gonio/asset/detail/scene_stage.hpp>
#include <gonio/base/json.hpp>

#include <string>

namespace gonio::asset_detail {

struct GltfStage {
    detail::Json nodes = detail::Json::array(); // of surfaces and the camera, all of them roots
    detail::Json meshes, materials, cameras, accessors;
    detail::Json views = detail::Json::array(); // of `bytes`, which is buffer 0
    detail::Json extensions_used = detail::Json::array();
    std::string bytes; // a multiple of four bytes long
};

GltfStage gltf_stage(const SceneStage& stage);

// The frame's rotation for a node, in a world with Y up; of unit length to the last digit.
detail::Json gltf_rotation(const Frame& frame);

} // namespace gonio::asset_detail
