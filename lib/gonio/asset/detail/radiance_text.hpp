// What the writers of lights and stages for Radiance share.
#pragma once

#include <gonio/asset/detail/scene_text.hpp>

#include <glm/vec3.hpp>

#include <string>
#include <string_view>

namespace gonio::asset_detail {

// Linear Rec.709 in Radiance's channels; white is (1, 1, 1) in both.
glm::dvec3 radiance_rgb(const glm::dvec3& rec709);

// The arguments of a polygon: a rectangle by its middle and half of its sides; its front is u × v.
std::string radiance_rectangle(const glm::dvec3& middle, const glm::dvec3& u, const glm::dvec3& v);

// The surfaces of a stage, after the lines that render it; the mixed materials are functions in `name`.cal.
// Light of a sky is ambient light in Radiance: it needs one bounce more.
std::string radiance_stage(const SceneStage& stage, std::string_view name, bool has_sky);
// Whether a colour of the material lies outside what Radiance's channels can hold.
bool radiance_clips(const SceneMaterial& of);
std::string radiance_view(const SceneCamera& camera);

} // namespace gonio::asset_detail
