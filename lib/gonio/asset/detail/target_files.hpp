// The files of each target, for target.cpp.
#pragma once

#include <gonio/asset/target.hpp>

namespace gonio::asset_detail {

std::vector<AssetFile> babylon_files(const MeasuredLight& light);
std::vector<AssetFile> blender_files(const MeasuredLight& light);
std::vector<AssetFile> gltf_files(const MeasuredLight& light);
std::vector<AssetFile> pbrt_files(const MeasuredLight& light);
std::vector<AssetFile> raw_files(const MeasuredLight& light);
std::vector<AssetFile> threejs_files(const MeasuredLight& light);
std::vector<AssetFile> usd_files(const MeasuredLight& light);

// "4.56 lm, peak 1.23 cd, of lamp.ies": what a comment in a written file says of the light. Without line ends.
std::string describe(const MeasuredLight& light);

// A string literal of JSON, which is one of Python and of JavaScript too; pure ASCII.
std::string quoted(std::string_view text);

} // namespace gonio::asset_detail
