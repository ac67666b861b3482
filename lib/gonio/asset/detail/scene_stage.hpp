// Converts a stage into what the writers of targets get.
#pragma once

#include <gonio/asset/scene_content.hpp>
#include <gonio/base/frame.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/primitives.hpp>

#include <glm/vec3.hpp>

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::asset_detail {

// Every property that is lost is added to `losses`, for example "its … is written as …".
SceneMaterial scene_material(const Material& material, std::vector<std::string>& losses);

// A metal on a share of the surface and a dielectric on the rest: together they have the material's albedo and, because
// Schlick's reflectance is linear in f0, its lobe. For programs with dielectrics that reflect without colour.
struct MixedMaterial {
    double metal = 0.0; // share, [0, 1]
    glm::dvec3 metal_f0{0.0};
    glm::dvec3 diffuse{0.0}; // albedo of the rest, at most 1
    double f0 = 0.0;         // reflectance of the rest
};
MixedMaterial mixed(const SceneMaterial& material);

// Refractive index of a dielectric that reflects f0 < 1 at normal incidence.
double refractive_index(double f0);

// Frames with Z along the axis; a sphere is a capsule of length 0.
Frame frame_of(const Ball& ball);
Frame frame_of(const Capsule& capsule);

// Names in use, and for each the last number that was appended to it: many lights of a rig may have the same name, and
// each takes the next number.
struct TakenNames {
    std::set<std::string> names;
    std::map<std::string, int> last_number;
};

// Letters, digits and '_', not a name in use; it is in use afterwards.
std::string unique_name(std::string_view name, TakenNames& taken);

} // namespace gonio::asset_detail
