// The stage of a scene as a target's writer gets it: what it is made of, what that looks like, who looks at it.
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/base/quantity.hpp>
#include <gonio/scene/camera.hpp>
#include <gonio/scene/material_description.hpp>
#include <gonio/scene/stage.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gonio::asset_detail {

// What every target holds of a material: a Lambertian part, and a GGX lobe with Schlick's reflectance from f0 to 1 at
// grazing.
struct SceneMaterial {
    std::string name;        // unique in the scene: letters, digits and '_'
    glm::dvec3 diffuse{0.0}; // albedo: the part of even light from all sides that our diffuse part gives back
    glm::dvec3 f0{0.0};      // 0: no lobe
    double alpha = 1.0;      // what enters D and V; the targets' own roughness is its root
    std::optional<MetallicRoughness> metallic_roughness; // what a target with glTF's own material takes instead

    bool has_diffuse() const { return diffuse != glm::dvec3(0.0); }
    bool has_lobe() const { return f0 != glm::dvec3(0.0); }
};

using SceneShape = std::variant<Panel, Ball, Box, Capsule>; // a plane is a panel of plane_size

struct SceneSurface {
    std::string name; // unique in the scene: letters, digits and '_'
    SceneShape shape;
    std::size_t material = 0; // index
};

struct SceneCamera {
    Frame frame;               // looks along −Z, Y is up
    double vertical_fov = 0.0; // full angle of the picture [rad]
    int width = 0;             // of the picture [pixels]
    int height = 0;

    double aspect() const { return static_cast<double>(width) / height; }
};

struct SceneStage {
    std::vector<SceneMaterial> materials;
    std::vector<SceneSurface> surfaces;
    SceneCamera camera;
    std::optional<Nits> white; // the luminance that our picture shows as 1
    bool shows_backs = false;  // the camera stands behind a sheet, through which ours looks
};

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
