// How a stage becomes what targets' writers get of it.
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

// The rest of a material is named, an "its … is written as …" each.
SceneMaterial scene_material(const Material& material, std::vector<std::string>& losses);

// A dielectric beneath a metal's share of the surface: together they have the material's albedo and, for Schlick's
// reflectance is linear in f0, its lobe. For programs whose dielectrics reflect without colour.
struct MixedMaterial {
    double metal = 0.0; // share, [0, 1]
    glm::dvec3 metal_f0{0.0};
    glm::dvec3 diffuse{0.0}; // albedo of the rest, at most 1
    double f0 = 0.0;         // reflectance of the rest
};
MixedMaterial mixed(const SceneMaterial& material);

// Refractive index of a dielectric that reflects f0 < 1 at normal incidence.
double refractive_index(double f0);

// A ball is a capsule without length; frames whose Z is its axis.
Frame frame_of(const Ball& ball);
Frame frame_of(const Capsule& capsule);

// Names that are taken, and for each the last number that was put behind it: a rig of equal names asks for them in
// turn.
struct TakenNames {
    std::set<std::string> names;
    std::map<std::string, int> last_number;
};

// Letters, digits and '_', and none that is taken; is taken then.
std::string unique_name(std::string_view name, TakenNames& taken);

} // namespace gonio::asset_detail
