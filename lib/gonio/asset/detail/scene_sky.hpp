// The sky of a scene as its target stores it.
#pragma once

#include <gonio/asset/scene_content.hpp>
#include <gonio/asset/sky_picture.hpp>
#include <gonio/asset/target.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace gonio::asset_detail {

// What the writer of a target gets; `name` is unique in the scene, that of the picture is SCENE.NAME.….
SceneSky scene_sky(const SkyPicture& sky, const TargetSky& held, std::string name, std::string_view scene);

// Adds the picture that the scene names, if it names one.
void add_sky_file(const SceneContent& scene, const SkyPicture* sky, const TargetSky& held,
                  std::vector<AssetFile>& files);

} // namespace gonio::asset_detail
