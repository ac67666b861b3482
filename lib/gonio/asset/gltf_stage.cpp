// Meshes of unit size, placed by nodes; materials; the camera.
//
// A material with a Lambertian part is a dielectric; KHR_materials_specular gives its reflectance f0 as a factor on
// 0.04 (0: no reflection at all, not even at grazing). A material without one is a metal. Roughness is the root of α.
// Readers subtract the reflected share from the diffuse part; gonio does not. A glTF material is written as it is. A
// coat is KHR_materials_clearcoat, whose readers dim what is below by 1 − F(n·v).
#include <gonio/asset/detail/gltf_stage.hpp>
#include <gonio/asset/detail/scene_text.hpp>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

namespace gonio::asset_detail {

namespace {

using detail::Json;
using std::numbers::pi;

constexpr int float_type = 5126;
constexpr int index_type = 5125; // 32 bits
constexpr int vertex_target = 34962;
constexpr int index_target = 34963;

struct Vertex {
    glm::dvec3 point;
    glm::dvec3 normal;
};

struct Geometry {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices; // three per triangle, counter-clockwise from outside
};

// A rectangle of 2 by 2 in the plane spanned by x and y, at distance `out` from the origin along its normal.
void add_square(Geometry& made, const glm::dvec3& x, const glm::dvec3& y, double out) {
    const glm::dvec3 normal = glm::cross(x, y);
    const auto first = static_cast<std::uint32_t>(made.vertices.size());
    for (const auto& [u, v] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}})
        made.vertices.push_back({u * x + v * y + out * normal, normal});
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U})
        made.indices.push_back(first + corner);
}

// The square [−1, 1]² at z = 0, seen from +Z.
Geometry sheet() {
    Geometry made;
    add_square(made, {1, 0, 0}, {0, 1, 0}, 0.0);
    return made;
}

Geometry cube() {
    Geometry made;
    const std::array<glm::dvec3, 3> axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3& x = axes[(i + 1) % 3];
        const glm::dvec3& y = axes[(i + 2) % 3];
        add_square(made, x, y, 1.0);
        add_square(made, y, x, 1.0);
    }
    return made;
}

// A capsule of radius 1 along Z; of length 0 it is a sphere. Each pole is one vertex.
Geometry round_body(double half_length) {
    constexpr std::uint32_t around = 256;
    constexpr int quarter = around / 4;
    Geometry made;
    const auto add = [&](double polar, double turn, double shift) {
        const glm::dvec3 normal(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar));
        made.vertices.push_back({normal + glm::dvec3(0.0, 0.0, shift), normal});
    };
    std::uint32_t rings = 0;
    const auto add_ring = [&](int step, double shift) {
        for (std::uint32_t i = 0; i < around; ++i)
            add(0.5 * pi * step / quarter, 2.0 * pi * i / around, shift);
        ++rings;
    };
    add(0.0, 0.0, half_length);
    for (int step = 1; step <= quarter; ++step)
        add_ring(step, half_length);
    for (int step = half_length > 0.0 ? quarter : quarter + 1; step < 2 * quarter; ++step)
        add_ring(step, -half_length);
    add(pi, 0.0, -half_length);
    const std::uint32_t last = 1 + rings * around;
    for (std::uint32_t i = 0; i < around; ++i) {
        const std::uint32_t next = (i + 1) % around;
        made.indices.insert(made.indices.end(), {0, 1 + i, 1 + next});
        for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
            const std::uint32_t row = 1 + ring * around;
            made.indices.insert(made.indices.end(), {row + i, row + around + i, row + around + next, row + i,
                                                     row + around + next, row + next});
        }
        const std::uint32_t row = last - around;
        made.indices.insert(made.indices.end(), {last, row + next, row + i});
    }
    return made;
}

void append_word(std::string& bytes, std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8)
        bytes += static_cast<char>((word >> shift) & 0xffU);
}

void append_float(std::string& bytes, double value) {
    append_word(bytes, __builtin_bit_cast(std::uint32_t, static_cast<float>(value)));
}

Json numbers(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

Json color_json(const glm::dvec3& v) {
    return {v.x, v.y, v.z, 1.0};
}

struct UsedExtensions {
    bool specular = false;
    bool clearcoat = false;
};

Json base_json(const SceneMaterial& material, UsedExtensions& uses) {
    if (const auto& own = material.gltf)
        return {{"name", material.name},
                {"pbrMetallicRoughness",
                 {{"baseColorFactor", color_json(own->base)},
                  {"metallicFactor", own->metallic},
                  {"roughnessFactor", own->roughness}}}};
    Json surface{{"baseColorFactor", color_json(material.has_diffuse() ? material.diffuse : material.f0)},
                 {"metallicFactor", material.has_diffuse() || !material.has_lobe() ? 0.0 : 1.0},
                 {"roughnessFactor", std::sqrt(material.alpha)}};
    Json json{{"name", material.name}, {"pbrMetallicRoughness", std::move(surface)}};
    if (material.has_diffuse() || !material.has_lobe()) {
        uses.specular = true;
        json["extensions"]["KHR_materials_specular"] = material.has_lobe()
                                                           ? Json{{"specularColorFactor", numbers(material.f0 / 0.04)}}
                                                           : Json{{"specularFactor", 0.0}};
    }
    return json;
}

Json material_json(const SceneMaterial& material, UsedExtensions& uses) {
    Json json = base_json(material, uses);
    if (material.coat) {
        uses.clearcoat = true;
        json["extensions"]["KHR_materials_clearcoat"] = {{"clearcoatFactor", material.coat->amount},
                                                         {"clearcoatRoughnessFactor", 1.0 - material.coat->smoothness}};
    }
    return json;
}

class GltfBuilder {
public:
    explicit GltfBuilder(GltfStage& made) : made_(made) {
        made.meshes = made.materials = made.cameras = made.accessors = Json::array();
    }

    void add(const SceneSurface& surface) {
        const std::size_t material = surface.material;
        if (const auto* panel = std::get_if<Panel>(&surface.shape))
            place(surface, panel->frame, 0.5 * glm::dvec3(panel->width, panel->height, 2.0),
                  mesh_of(is_sheet, material));
        else if (const auto* box = std::get_if<Box>(&surface.shape))
            place(surface, box->frame, box->half_size, mesh_of(is_cube, material));
        else if (const auto* ball = std::get_if<Ball>(&surface.shape))
            place(surface, frame_of(*ball), glm::dvec3(ball->radius), mesh_of(0.0, material));
        else if (const auto* capsule = std::get_if<Capsule>(&surface.shape))
            place(surface, frame_of(*capsule), glm::dvec3(capsule->radius),
                  mesh_of(capsule->half_length / capsule->radius, material));
    }

private:
    // A shape is the half length of a capsule over its radius (0 for a sphere), or one of these.
    static constexpr double is_sheet = -1.0;
    static constexpr double is_cube = -2.0;

    void place(const SceneSurface& surface, const Frame& frame, const glm::dvec3& size, std::size_t mesh) {
        made_.nodes.push_back({{"name", surface.name},
                               {"translation", numbers(y_up(frame.origin))},
                               {"rotation", gltf_rotation(frame)},
                               {"scale", numbers(size)},
                               {"mesh", mesh}});
    }

    std::size_t view(std::size_t offset, int target) {
        made_.views.push_back(
            {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", made_.bytes.size() - offset}, {"target", target}});
        return made_.views.size() - 1;
    }

    std::size_t vectors(const Geometry& geometry, glm::dvec3 Vertex::*member) {
        const std::size_t offset = made_.bytes.size();
        glm::dvec3 low(0.0);
        glm::dvec3 high(0.0);
        for (const Vertex& vertex : geometry.vertices) {
            const glm::dvec3& v = vertex.*member;
            low = glm::min(low, v);
            high = glm::max(high, v);
            for (int k = 0; k < 3; ++k)
                append_float(made_.bytes, v[k] + 0.0); // removes the sign of a negative zero
        }
        Json accessor{{"bufferView", view(offset, vertex_target)},
                      {"componentType", float_type},
                      {"count", geometry.vertices.size()},
                      {"type", "VEC3"}};
        const auto rounded = [](const glm::dvec3& v) {
            return numbers({static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
        };
        if (member == &Vertex::point) {
            accessor["min"] = rounded(low);
            accessor["max"] = rounded(high);
        }
        made_.accessors.push_back(std::move(accessor));
        return made_.accessors.size() - 1;
    }

    std::size_t triangles(const Geometry& geometry) {
        const std::size_t offset = made_.bytes.size();
        for (const std::uint32_t index : geometry.indices)
            append_word(made_.bytes, index);
        made_.accessors.push_back({{"bufferView", view(offset, index_target)},
                                   {"componentType", index_type},
                                   {"count", geometry.indices.size()},
                                   {"type", "SCALAR"}});
        return made_.accessors.size() - 1;
    }

    // A mesh for each shape and material; meshes of the same shape share its numbers.
    std::size_t mesh_of(double shape, std::size_t material) {
        const auto [mesh, is_new] = meshes_.emplace(std::pair(shape, material), made_.meshes.size());
        if (!is_new) return mesh->second;
        const auto known = primitives_.find(shape);
        Json primitive;
        if (known != primitives_.end()) {
            primitive = known->second;
        } else {
            const Geometry geometry = shape == is_sheet ? sheet() : shape == is_cube ? cube() : round_body(shape);
            const std::size_t points = vectors(geometry, &Vertex::point);
            const std::size_t normals = vectors(geometry, &Vertex::normal);
            primitive = {{"attributes", {{"POSITION", points}, {"NORMAL", normals}}}, {"indices", triangles(geometry)}};
            primitives_.emplace(shape, primitive);
        }
        primitive["material"] = material;
        made_.meshes.push_back({{"primitives", Json::array({std::move(primitive)})}});
        return mesh->second;
    }

    GltfStage& made_;
    std::map<double, Json> primitives_;
    std::map<std::pair<double, std::size_t>, std::size_t> meshes_;
};

} // namespace

GltfStage gltf_stage(const SceneStage& stage) {
    GltfStage made;
    GltfBuilder builder(made);
    UsedExtensions uses;
    for (const SceneMaterial& material : stage.materials)
        made.materials.push_back(material_json(material, uses));
    for (const SceneSurface& surface : stage.surfaces)
        builder.add(surface);
    const SceneCamera& camera = stage.camera;
    made.cameras.push_back(
        {{"type", "perspective"},
         {"perspective",
          {{"aspectRatio", camera.aspect()}, {"yfov", camera.vertical_fov}, {"zfar", 10000.0}, {"znear", 0.01}}}});
    made.nodes.push_back({{"name", "camera"},
                          {"translation", numbers(y_up(camera.frame.origin))},
                          {"rotation", gltf_rotation(camera.frame)},
                          {"camera", 0},
                          {"extras", {{"width", camera.width}, {"height", camera.height}}}});
    if (uses.clearcoat) made.extensions_used.push_back("KHR_materials_clearcoat");
    if (uses.specular) made.extensions_used.push_back("KHR_materials_specular");
    return made;
}

Json gltf_rotation(const Frame& frame) {
    const glm::dquat turn = glm::normalize(glm::quat_cast(glm::dmat3(y_up(frame.x), y_up(frame.y), y_up(frame.z))));
    return {turn.x, turn.y, turn.z, turn.w};
}

} // namespace gonio::asset_detail
