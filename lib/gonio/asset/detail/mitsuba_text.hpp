// Text that Mitsuba's lights and stages share.
#pragma once

#include <gonio/asset/detail/scene_text.hpp>

#include <string>
#include <string_view>

namespace gonio::asset_detail {

// to_world, given by its columns.
std::string mitsuba_matrix(const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z, const glm::dvec3& origin);

std::string mitsuba_rgb(std::string_view name, const glm::dvec3& color);

// The stage of a scene, before its lights.
std::string mitsuba_stage(const SceneStage& stage);

} // namespace gonio::asset_detail
