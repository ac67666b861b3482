// The output of preview --export: the exact geometry, camera and materials of a stage.
#include <gonio/asset/detail/scene_stage.hpp>
#include <gonio/asset/stage_scene.hpp>
#include <gonio/scene/core_material.hpp>
#include <gonio/scene/emissive_lights.hpp>
#include <gonio/scene/figure.hpp>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace gonio {
namespace {

using nlohmann::json;
using std::numbers::pi;

std::vector<Light> bulb() {
    LightDescription light;
    light.name = "bulb";
    light.shape = *parse_shape("point");
    light.intensity = *parse_photometric_value("100cd");
    light.position = {0.1, 0.2, 2.3};
    Diagnostics ignored;
    return {*resolve_light(std::move(light), ignored)};
}

LightScene exported(const Stage& stage, const char* file, int width = 64, int height = 48) {
    const StageFormat& format = **stage_format_of(file);
    StageSceneOptions options;
    options.name = "scene";
    options.width = width;
    options.height = height;
    return *stage_scene(format, stage, stage.camera, bulb(), options);
}

// The nodes of a glTF document as triangles in world coordinates, Z up.
struct Triangle {
    std::array<glm::dvec3, 3> corners;
    std::array<glm::dvec3, 3> normals; // of the corners
};

struct Body {
    std::string name;
    std::vector<Triangle> triangles;
};

class GltfScene {
public:
    explicit GltfScene(const LightScene& scene)
        : document_(json::parse(scene.files[0].bytes)), bytes_(scene.files[1].bytes) {
        EXPECT_EQ(document_["buffers"][0]["uri"], scene.files[1].name);
        EXPECT_EQ(document_["buffers"][0]["byteLength"], bytes_.size());
        for (const json& index : document_["scenes"][0]["nodes"])
            read_node(document_["nodes"].at(index.get<std::size_t>()));
    }

    // Through (x, y) from the picture's top left corner, both in [0, 1].
    Ray ray(double x, double y) const {
        const json& lens = document_["cameras"][0]["perspective"];
        const double half = std::tan(0.5 * lens["yfov"].get<double>());
        const double across = half * lens["aspectRatio"].get<double>();
        const glm::dvec3 local((2.0 * x - 1.0) * across, (1.0 - 2.0 * y) * half, -1.0);
        return {eye_, glm::normalize(turn_ * local)};
    }

    const std::vector<Body>& bodies() const { return bodies_; }
    const json& document() const { return document_; }

private:
    static glm::dvec3 z_up(const glm::dvec3& v) { return {v.x, -v.z, v.y}; }

    static glm::dvec3 vector(const json& node, const char* key, const glm::dvec3& none) {
        if (!node.contains(key)) return none;
        return {node[key][0].get<double>(), node[key][1].get<double>(), node[key][2].get<double>()};
    }

    template<class Number>
    std::vector<Number> numbers(const json& index) const {
        const json& accessor = document_["accessors"].at(index.get<std::size_t>());
        const json& view = document_["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
        const std::size_t at = view["byteOffset"].get<std::size_t>();
        const std::size_t length = view["byteLength"].get<std::size_t>();
        std::vector<Number> values(accessor["count"].get<std::size_t>() * (accessor["type"] == "VEC3" ? 3 : 1));
        EXPECT_EQ(values.size() * sizeof(Number), length);
        EXPECT_LE(at + length, bytes_.size());
        std::memcpy(values.data(), bytes_.data() + at, length);
        return values;
    }

    void read_node(const json& node) {
        const glm::dvec3 origin = vector(node, "translation", glm::dvec3(0.0));
        const glm::dvec3 scale = vector(node, "scale", glm::dvec3(1.0));
        const auto q = node["rotation"].get<std::vector<double>>();
        const glm::dmat3 turn = glm::mat3_cast(glm::dquat(q[3], q[0], q[1], q[2]));
        const glm::dmat3 world(z_up(turn[0]), z_up(turn[1]), z_up(turn[2]));
        if (node.contains("camera")) {
            eye_ = z_up(origin);
            turn_ = world;
        }
        if (!node.contains("mesh")) return;
        const json& part = document_["meshes"].at(node["mesh"].get<std::size_t>())["primitives"][0];
        EXPECT_LT(part["material"].get<std::size_t>(), document_["materials"].size());
        const auto points = numbers<float>(part["attributes"]["POSITION"]);
        const auto normals = numbers<float>(part["attributes"]["NORMAL"]);
        const auto indices = numbers<std::uint32_t>(part["indices"]);
        const auto vertex = [](const std::vector<float>& of, std::size_t index) {
            return glm::dvec3(of.at(3 * index), of.at(3 * index + 1), of.at(3 * index + 2));
        };
        Body body{node["name"], {}};
        for (std::size_t i = 0; i < indices.size(); i += 3) {
            Triangle triangle;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t index = indices[i + k];
                triangle.corners[k] = z_up(origin) + world * (scale * vertex(points, index));
                triangle.normals[k] = glm::normalize(world * (vertex(normals, index) / scale));
            }
            body.triangles.push_back(triangle);
        }
        bodies_.push_back(std::move(body));
    }

    json document_;
    std::string bytes_;
    std::vector<Body> bodies_;
    glm::dvec3 eye_{0.0};
    glm::dmat3 turn_{1.0};
};

glm::dvec3 face_normal(const Triangle& t) {
    return glm::cross(t.corners[1] - t.corners[0], t.corners[2] - t.corners[0]);
}

double area_of(const Body& body) {
    double area = 0.0;
    for (const Triangle& triangle : body.triangles)
        area += 0.5 * glm::length(face_normal(triangle));
    return area;
}

double exact_area(const Primitive& primitive) {
    if (const auto* panel = std::get_if<Panel>(&primitive)) return panel->width * panel->height;
    if (const auto* ball = std::get_if<Ball>(&primitive)) return 4.0 * pi * ball->radius * ball->radius;
    if (const auto* box = std::get_if<Box>(&primitive)) {
        const glm::dvec3& h = box->half_size;
        return 8.0 * (h.x * h.y + h.y * h.z + h.z * h.x);
    }
    if (const auto* capsule = std::get_if<Capsule>(&primitive))
        return 4.0 * pi * capsule->radius * (capsule->half_length + capsule->radius);
    return plane_size.value * plane_size.value;
}

// In a closed body each edge of a face belongs to one other face too, in the opposite direction.
bool is_closed(const Body& body) {
    using Point = std::tuple<long, long, long>;
    const auto place = [](const glm::dvec3& p) {
        return Point(std::lround(1e6 * p.x), std::lround(1e6 * p.y), std::lround(1e6 * p.z));
    };
    std::map<std::pair<Point, Point>, int> edges;
    for (const Triangle& triangle : body.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Point a = place(triangle.corners[k]);
            const Point b = place(triangle.corners[(k + 1) % 3]);
            ++edges[{a, b}];
            --edges[{b, a}];
        }
    return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

std::optional<double> distance_to_triangles(const GltfScene& scene, const Ray& ray) {
    std::optional<double> nearest;
    for (const Body& body : scene.bodies())
        for (const Triangle& t : body.triangles) {
            const glm::dvec3 normal = face_normal(t);
            const double facing = glm::dot(normal, ray.direction);
            if (!(facing < 0.0)) continue; // visible from its front only, as single-sided materials are
            const double distance = glm::dot(normal, t.corners[0] - ray.origin) / facing;
            if (distance <= 0.0 || (nearest && *nearest <= distance)) continue;
            const glm::dvec3 at = ray.origin + distance * ray.direction;
            bool inside = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::dvec3 edge = t.corners[(k + 1) % 3] - t.corners[k];
                inside &= glm::dot(normal, glm::cross(edge, at - t.corners[k])) >= 0.0;
            }
            if (inside) nearest = distance;
        }
    return nearest;
}

// One body of each kind, tilted.
Stage bodies() {
    Stage stage = *make_stage("floor");
    stage.surfaces = {
        {"floor", Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}, LambertMaterial{}},
        {"panel", panel_facing({0.7, 0.8, 0.6}, glm::normalize(glm::dvec3(-1, -2, 0.5)), {0.2, 0, 1}, 0.8, 0.5),
         LambertMaterial{}},
        {"ball", Ball{{-0.6, 0.1, 0.4}, 0.4}, LambertMaterial{}},
        {"box", Box{aimed_frame({0.4, 0.1, 0.3}, {0.3, 0.2, -1}, {0.5, 1, 0}), {0.2, 0.3, 0.1}}, LambertMaterial{}},
        {"capsule", capsule_between({-0.2, 0.6, 0.1}, {0.3, 0.7, 0.9}, 0.12), LambertMaterial{}},
    };
    return stage;
}

// The surface would block the light that is in its place.
TEST(StageScene, ASurfaceThatEmitsIsItsLight) {
    Stage stage = bodies();
    stage.surfaces[2].emits = parse_surface_emission("500nt").value();
    const std::vector<LightDescription> emitted = emissive_lights(stage).value();
    Diagnostics diagnostics;
    const Light light = resolve_light(emitted.front(), diagnostics).value();
    StageSceneOptions options;
    options.name = "scene";
    options.width = 64;
    options.height = 48;
    for (const StageFormat& format : stage_formats()) {
        const LightScene scene = stage_scene(format, stage, stage.camera, {&light, 1}, options).value();
        const std::string& text = scene.files[0].bytes;
        EXPECT_NE(std::find(scene.instead.begin(), scene.instead.end(),
                            "surface 'ball' emits: it is written as its light alone, without a material"),
                  scene.instead.end())
            << format.extension;
        EXPECT_EQ(text.find("ball_material"), std::string::npos) << format.extension;
        EXPECT_NE(text.find("capsule_material"), std::string::npos) << format.extension;
    }
}

TEST(StageScene, MeshesAreClosedOutwardAndOfTheRightArea) {
    const Stage stage = bodies();
    const GltfScene scene(exported(stage, "scene.gltf"));
    ASSERT_EQ(scene.bodies().size(), stage.surfaces.size());
    for (std::size_t i = 0; i < stage.surfaces.size(); ++i) {
        const Body& body = scene.bodies()[i];
        const Primitive& truth = stage.surfaces[i].geometry;
        EXPECT_EQ(body.name, stage.surfaces[i].name);
        EXPECT_EQ(is_closed(body), !is_sheet(truth)) << body.name;
        // With 256 corners around, faces have 1 − (2π/256)²/6 of the circumference and the same factor along.
        const double exact = exact_area(truth);
        EXPECT_NEAR(area_of(body), exact, 2.1e-4 * exact) << body.name;
        for (const Triangle& t : body.triangles) {
            const glm::dvec3 flat = glm::normalize(face_normal(t));
            for (std::size_t k = 0; k < 3; ++k) {
                ASSERT_GT(glm::dot(flat, t.normals[k]), 0.999) << body.name;
                if (std::holds_alternative<Box>(truth)) continue; // its corners have three normals
                ASSERT_GT(glm::dot(normal_at(truth, t.corners[k]), t.normals[k]), 1.0 - 1e-8) << body.name;
            }
        }
    }
}

TEST(StageScene, CameraSeesTheSameThroughTriangles) {
    int hits = 0;
    for (const auto& [width, height] : {std::pair{64, 48}, {30, 80}}) {
        Stage stage = bodies();
        stage.camera = {{0.3, -2.6, 1.4}, {0.05, 0.3, 0.4}, {0.1, 0.0, 1.0}, 30.0, 36.0};
        const GltfScene scene(exported(stage, "scene.gltf", width, height));
        const CameraRays rays(stage.camera, width, height);
        for (const double x : {0.0, 0.31, 0.5, 0.77, 1.0})
            for (const double y : {0.0, 0.24, 0.5, 0.69, 1.0}) {
                const Ray truth = rays.ray(x * width, y * height);
                const Ray ray = scene.ray(x, y);
                EXPECT_LT(glm::distance(ray.origin, truth.origin), 1e-12);
                EXPECT_LT(glm::distance(ray.direction, truth.direction), 1e-12) << x << ' ' << y;
                const std::optional<Hit> hit = first_hit(stage, truth);
                const std::optional<double> distance = distance_to_triangles(scene, ray);
                ASSERT_EQ(hit.has_value(), distance.has_value()) << x << ' ' << y;
                if (!hit) continue;
                ++hits;
                // A face lies inside the surface by the sag at most; a slanting ray meets it later.
                const double slant = -glm::dot(hit->normal, ray.direction);
                EXPECT_NEAR(*distance, hit->distance, (ball_sag * 0.4 + 1e-6) / slant) << x << ' ' << y;
            }
    }
    EXPECT_GE(hits, 40);
}

// Names are unique, and a second export gives the same bytes.
TEST(StageScene, HoldsEveryStageInEveryFormat) {
    for (const StageKind& kind : stage_kinds()) {
        Stage stage = *make_stage(kind.name);
        if (kind.name == "room") add_figure(stage);
        for (const StageFormat& format : stage_formats()) {
            const std::string file = "scene" + std::string(format.extension);
            const LightScene scene = exported(stage, file.c_str());
            EXPECT_EQ(scene.files.at(0).name, file);
            EXPECT_EQ(scene.files[0].bytes, exported(stage, file.c_str()).files[0].bytes);
            // All stages except the matte one have a material that other formats cannot store fully.
            EXPECT_EQ(scene.instead.empty(), kind.name == "card") << kind.name;
            if (format.extension != ".gltf") continue;
            const json document = json::parse(scene.files[0].bytes);
            std::map<std::string, int> names;
            for (const json& node : document["nodes"])
                EXPECT_EQ(++names[node["name"].get<std::string>()], 1) << node["name"];
            EXPECT_EQ(names.size(), stage.surfaces.size() + 2); // the camera and the light
        }
    }
}

TEST(StageScene, FormatsGoByTheName) {
    EXPECT_EQ((*stage_format_of("a/b.c/room.usda"))->target, "usd");
    for (const char* name : {"", ".py", "room", "room.obj", "room.PY", "py"})
        EXPECT_EQ(stage_format_of(name).error().failure, Failure::usage) << name;
}

// (1/π) ∬ f ⟨n·l⟩⟨n·v⟩ by midpoints in μ, a rule other than the exporter's.
double mean_albedo(const FrostbiteMaterial& material) {
    const auto core = core_material(material);
    constexpr int steps = 100;
    constexpr int turns = 20;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; j < steps; ++j)
            for (int k = 0; k < turns; ++k) {
                const double mu_v = (i + 0.5) / steps;
                const double mu_l = (j + 0.5) / steps;
                const double phi = 2.0 * pi * (k + 0.5) / turns;
                const double across = std::sqrt(1.0 - mu_l * mu_l);
                sum += mu_v * mu_l *
                       diffuse_part(core, {0.0, 0.0, 1.0}, {across * std::cos(phi), across * std::sin(phi), mu_l},
                                    {std::sqrt(1.0 - mu_v * mu_v), 0.0, mu_v})
                           .x;
            }
    return 4.0 * pi * sum / steps / steps / turns;
}

TEST(StageMaterial, KeepsAlbedoAndLobe) {
    using asset_detail::scene_material;
    std::vector<std::string> losses;
    const auto lambert = scene_material(LambertMaterial{{0.2, 0.4, 0.6}}, losses);
    EXPECT_EQ(lambert.diffuse, glm::dvec3(0.2, 0.4, 0.6));
    EXPECT_FALSE(lambert.has_lobe());
    const auto ue4 = scene_material(Ue4Material{{0.5, 0.25, 0.1}, 0.4, 0.5, 0.5, 1.0}, losses);
    EXPECT_LT(glm::distance(ue4.diffuse, {0.25, 0.125, 0.05}), 1e-15);
    EXPECT_LT(glm::distance(ue4.f0, {0.27, 0.145, 0.07}), 1e-15);
    EXPECT_NEAR(ue4.alpha, 0.16, 1e-15);
    const auto ggx = scene_material(GgxMaterial{{1.0, 0.7, 0.3}, 0.2}, losses);
    EXPECT_FALSE(ggx.has_diffuse());
    EXPECT_EQ(ggx.alpha, 0.2);
    EXPECT_TRUE(losses.empty());
    for (const double smoothness : {0.0, 0.3, 0.8}) {
        losses.clear();
        const FrostbiteMaterial material{glm::dvec3(0.6), smoothness, 0.0, 0.5};
        const auto made = scene_material(material, losses);
        EXPECT_NEAR(made.diffuse.x, mean_albedo(material), 1e-4) << smoothness; // midpoints
        EXPECT_NEAR(made.f0.x, 0.04, 1e-15);
        EXPECT_NEAR(made.alpha, (1.0 - smoothness) * (1.0 - smoothness), 1e-12);
        EXPECT_EQ(losses.size(), 1U);
    }
    losses.clear();
    // Uniform light on a rough surface of albedo 1: the albedo of EON, within the error of its own fit.
    EXPECT_NEAR(scene_material(EonMaterial{glm::dvec3(1.0), 1.0}, losses).diffuse.x, 1.0, 1e-3);
    EXPECT_EQ(losses.size(), 1U);
    scene_material(BlinnMaterial{}, losses);
    scene_material(KullaContyMaterial{}, losses);
    EXPECT_EQ(losses.size(), 3U);
    scene_material(Ue4Material{glm::dvec3(0.5), 0.4, 0.0, 0.5, 0.5}, losses);  // cavity dims the reflection
    scene_material(FrostbiteMaterial{glm::dvec3(0.5), 0.4, 0.0, 0.2}, losses); // f90 < 1
    EXPECT_EQ(losses.size(), 6U);
}

// glTF's own material is written unchanged; other materials are replaced, and the replacement is reported.
TEST(StageMaterial, OfGltfIsWrittenAsItIs) {
    Stage stage = bodies();
    for (Surface& surface : stage.surfaces)
        surface.material = GltfMaterial{{0.9, 0.5, 0.25}, 0.25, 0.625};
    const LightScene scene = exported(stage, "scene.gltf");
    EXPECT_TRUE(scene.instead.empty());
    const json document = json::parse(scene.files[0].bytes);
    ASSERT_EQ(document["materials"].size(), stage.surfaces.size());
    for (const json& material : document["materials"]) {
        const json expected = {
            {"baseColorFactor", {0.9, 0.5, 0.25, 1.0}}, {"metallicFactor", 0.25}, {"roughnessFactor", 0.625}};
        EXPECT_EQ(material["pbrMetallicRoughness"], expected);
        EXPECT_FALSE(material.contains("extensions"));
    }
    EXPECT_EQ(scene.files[0].bytes.find("KHR_materials_specular"), std::string::npos);
    EXPECT_EQ(exported(stage, "scene.usda").instead.size(), stage.surfaces.size());
    std::vector<std::string> losses;
    const auto made = asset_detail::scene_material(GltfMaterial{glm::dvec3(0.5), 0.0, 0.5}, losses);
    EXPECT_EQ(losses.size(), 1U);
    EXPECT_DOUBLE_EQ(made.f0.x, 0.04);
    EXPECT_DOUBLE_EQ(made.alpha, 0.25);
    // 0.96 of the base less the reflection at slanting angles: 0.9565, by midpoints.
    EXPECT_NEAR(made.diffuse.x, 0.4782, 2e-4);
    losses.clear();
    asset_detail::scene_material(GltfMaterial{glm::dvec3(0.5), 1.0, 0.5}, losses);
    EXPECT_TRUE(losses.empty()); // a metal has only the GGX lobe
}

// A coat goes to the programs that have one, over the same base; the others say that it is left out.
TEST(StageMaterial, CoatsAreWrittenWhereThereAreSome) {
    Stage stage = bodies();
    for (Surface& surface : stage.surfaces)
        surface.material = CoatedMaterial{GltfMaterial{{0.9, 0.5, 0.25}, 0.25, 0.625}, {0.5, 0.75, CoatOrder::ue4}};
    const LightScene gltf = exported(stage, "scene.gltf");
    const json document = json::parse(gltf.files[0].bytes);
    EXPECT_EQ(gltf.instead.size(), stage.surfaces.size());
    for (const json& material : document["materials"]) {
        EXPECT_EQ(material["pbrMetallicRoughness"]["metallicFactor"], 0.25);
        EXPECT_EQ(material["extensions"]["KHR_materials_clearcoat"],
                  (json{{"clearcoatFactor", 0.5}, {"clearcoatRoughnessFactor", 0.25}}));
    }
    const auto& used = document["extensionsUsed"];
    EXPECT_NE(std::find(used.begin(), used.end(), "KHR_materials_clearcoat"), used.end());
    const LightScene usd = exported(stage, "scene.usda");
    EXPECT_NE(usd.files[0].bytes.find("float inputs:clearcoat = 0.5\n"), std::string::npos);
    EXPECT_NE(usd.files[0].bytes.find("float inputs:clearcoatRoughness = 0.25\n"), std::string::npos);
    const LightScene pbrt = exported(stage, "scene.pbrt");
    EXPECT_TRUE(std::any_of(pbrt.instead.begin(), pbrt.instead.end(), [](const std::string& line) {
        return line.find("its clear coat is left out") != std::string::npos;
    }));
}

TEST(StageMaterial, MixesGiveBackTheWhole) {
    std::vector<std::string> losses;
    for (const double metal : {0.0, 0.25, 0.5, 0.75, 1.0})
        for (const glm::dvec3& base : {glm::dvec3(0.78, 0.5, 0.25), glm::dvec3(0.5), glm::dvec3(0.02, 0.9, 0.3)}) {
            const auto whole = asset_detail::scene_material(Ue4Material{base, 0.3, metal, 0.5, 1.0}, losses);
            const auto parts = asset_detail::mixed(whole);
            const double rest = 1.0 - parts.metal;
            EXPECT_LT(glm::distance(rest * parts.diffuse, whole.diffuse), 1e-12);
            EXPECT_LT(glm::distance(rest * glm::dvec3(parts.f0) + parts.metal * parts.metal_f0, whole.f0), 1e-12);
            for (int k = 0; k < 3; ++k) {
                EXPECT_LE(parts.diffuse[k], 1.0);
                EXPECT_GE(parts.metal_f0[k], 0.0);
                EXPECT_LE(parts.metal_f0[k], 1.0 + 1e-12);
            }
        }
    // f0 of glass.
    EXPECT_NEAR(asset_detail::refractive_index(0.04), 1.5, 1e-12);
}

} // namespace
} // namespace gonio
