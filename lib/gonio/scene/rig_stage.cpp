#include <gonio/base/kind_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/scene/detail/rig_stage.hpp>
#include <gonio/scene/detail/rig_values.hpp>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio::detail {

namespace {

using Keys = std::span<const std::string_view>;

constexpr std::array<std::string_view, 3> stage_keys{"name", "surfaces", "figure"};
constexpr std::array<std::string_view, 8> surface_keys{"name",  "material", "emits",  "plane",
                                                       "panel", "box",      "sphere", "capsule"};
constexpr std::array<std::string_view, 2> plane_keys{"point", "normal"};
constexpr std::array<std::string_view, 5> panel_keys{"center", "normal", "up", "width", "height"};
constexpr std::array<std::string_view, 4> box_keys{"center", "size", "up", "rotate"};
constexpr std::array<std::string_view, 2> sphere_keys{"center", "radius"};
constexpr std::array<std::string_view, 3> capsule_keys{"from", "to", "radius"};

// The values of an object under one path. Keeps the first failure and ignores everything read after it.
class Members {
public:
    Members(const Json& json, Keys keys, const std::string& source, std::string path)
        : json_(json), source_(source), path_(std::move(path)) {
        if (!json.is_object()) {
            fail_at(path_, rig_value_error("RIG0105", fmt::format("must be an object, not {}", type_of(json))));
            return;
        }
        for (const auto& [key, value] : json.items())
            if (std::find(keys.begin(), keys.end(), key) == keys.end()) fail_at(path_, unknown_name("key", key, keys));
    }

    // Leaves `target` unchanged if the key is missing.
    template<class T, class Read>
    void optional(const char* key, T& target, const Read& read) {
        const Json* const value = json_.find(key);
        if (failure_ || value == nullptr) return;
        if (Result<void> kept = keep(read(*value), target); !kept)
            fail_at(fmt::format("{}.{}", path_, key), Unexpected(kept.error()));
    }
    template<class T, class Read>
    void required(const char* key, T& target, const Read& read) {
        if (!failure_ && !json_.contains(key))
            fail_at(path_, rig_value_error("RIG0104", fmt::format("the key '{}' is missing", key)));
        optional(key, target, read);
    }

    void fail_at(const std::string& path, const Unexpected& reason) {
        if (!failure_) failure_ = placed(reason.value(), source_, path).value();
    }
    const std::string& path() const { return path_; }
    const std::optional<Error>& failure() const { return failure_; }

private:
    const Json& json_;
    const std::string& source_;
    std::string path_;
    std::optional<Error> failure_;
};

Result<glm::dvec3> unit_vector_of(const Json& json) {
    Result<glm::dvec3> vector = nonzero_vector_of(json);
    // Divided by its largest component first: the square of a large one would overflow.
    if (!vector) return vector;
    const glm::dvec3 size = glm::abs(*vector);
    return glm::normalize(*vector / std::max({size.x, size.y, size.z}));
}

// Positions in float pictures stay finite, and so do the squares of distances.
constexpr double farthest = 1e9; // [m]

Result<glm::dvec3> place_of(const Json& json) {
    Result<glm::dvec3> place = position_of(json);
    if (place && std::max({std::abs(place->x), std::abs(place->y), std::abs(place->z)}) > farthest)
        return rig_value_error("RIG0106", fmt::format("must lie within {:g} m", farthest));
    return place;
}

Result<double> length_of(const Json& json) {
    Result<double> length = positive_length(json);
    if (length && !(*length >= 1.0 / farthest && *length <= farthest))
        return rig_value_error("RIG0106", fmt::format("must lie within {:g} m and {:g} m", 1.0 / farthest, farthest));
    return length;
}

Result<glm::dvec3> size_of(const Json& json) {
    Result<glm::dvec3> size = place_of(json);
    if (size && !(std::min({size->x, size->y, size->z}) > 0.0))
        return rig_value_error("RIG0106", "must be greater than 0 along every axis",
                               "for a flat surface without thickness use a panel");
    return size;
}

// Reads each primitive from its members, which record the failure.
Plane read_plane(Members& members) {
    Plane plane;
    members.optional("point", plane.point, place_of);
    members.optional("normal", plane.normal, unit_vector_of);
    return plane;
}

Panel read_panel(Members& members) {
    glm::dvec3 center(0.0);
    glm::dvec3 normal(0.0, 0.0, 1.0);
    glm::dvec3 up(0.0, 0.0, 1.0);
    Panel panel;
    members.required("center", center, place_of);
    members.required("normal", normal, unit_vector_of);
    members.optional("up", up, unit_vector_of);
    members.required("width", panel.width, length_of);
    members.required("height", panel.height, length_of);
    return panel_facing(center, normal, up, panel.width, panel.height);
}

Box read_box(Members& members) {
    glm::dvec3 center(0.0);
    glm::dvec3 size(1.0);
    glm::dvec3 up(0.0, 0.0, 1.0);
    double turn = 0.0;
    members.required("center", center, place_of);
    members.required("size", size, size_of);
    members.optional("up", up, unit_vector_of);
    members.optional("rotate", turn, angle_of);
    const Frame upright = aimed_frame(center, -up, {0.0, 1.0, 0.0});
    const double c = std::cos(turn);
    const double s = std::sin(turn);
    return {{center, c * upright.x + s * upright.y, c * upright.y - s * upright.x, upright.z}, 0.5 * size};
}

Ball read_sphere(Members& members) {
    Ball ball;
    members.required("center", ball.center, place_of);
    members.required("radius", ball.radius, length_of);
    return ball;
}

Capsule read_capsule(Members& members) {
    glm::dvec3 from(0.0);
    glm::dvec3 to(0.0, 0.0, 1.0);
    double radius = 0.1;
    members.required("from", from, place_of);
    members.required("to", to, place_of);
    members.required("radius", radius, length_of);
    if (!(glm::distance(from, to) > 0.0)) {
        members.fail_at(members.path(),
                        rig_value_error("RIG0106", "'from' and 'to' must differ", "for a ball use a sphere"));
        return {};
    }
    return capsule_between(from, to, radius);
}

template<class Shape>
Primitive read_as(Shape (*read)(Members&), Members& members) {
    return read(members);
}

struct PrimitiveKind {
    std::string_view key;
    Keys keys;
    Primitive (*read)(Members&);
};

constexpr std::array primitives{
    PrimitiveKind{"plane", plane_keys, [](Members& m) { return read_as(read_plane, m); }},
    PrimitiveKind{"panel", panel_keys, [](Members& m) { return read_as(read_panel, m); }},
    PrimitiveKind{"box", box_keys, [](Members& m) { return read_as(read_box, m); }},
    PrimitiveKind{"sphere", sphere_keys, [](Members& m) { return read_as(read_sphere, m); }},
    PrimitiveKind{"capsule", capsule_keys, [](Members& m) { return read_as(read_capsule, m); }},
};

Result<Material> material_of(const Json& json) {
    Result<std::string> text = text_of(json, "for example \"lambert:albedo=0.5\"");
    if (!text) return pass_on(text);
    return parse_material(*text);
}

Result<std::string> filled_name_of(const Json& json) {
    Result<std::string> text = name_of(json);
    if (text && text->empty()) return rig_value_error("RIG0106", "must not be empty");
    return text;
}

Result<Surface> read_surface(const Json& json, const RigContext& rig, const std::string& path) {
    const std::string& source = rig.source;
    Surface surface;
    Members members(json, surface_keys, source, path);
    members.required("name", surface.name, filled_name_of);
    members.optional("material", surface.material, material_of);
    if (members.failure()) return Unexpected(*members.failure());
    const PrimitiveKind* found = nullptr;
    for (const PrimitiveKind& kind : primitives) {
        if (!json.contains(kind.key)) continue;
        if (found != nullptr)
            return rig_error("RIG0107", source, path, fmt::format("has both a {} and a {}", found->key, kind.key),
                             "a surface has only one shape");
        found = &kind;
    }
    if (found == nullptr)
        return rig_error("RIG0104", source, path, "has no shape", "give it a plane, panel, box, sphere or capsule");
    const std::string key(found->key);
    Members shape(*json.find(key), found->keys, source, fmt::format("{}.{}", path, key));
    const Primitive geometry = shape.failure() ? Primitive() : found->read(shape);
    if (shape.failure()) return Unexpected(*shape.failure());
    surface.geometry = geometry;
    if (const Json* const emits = json.find("emits")) {
        const std::string at = fmt::format("{}.emits", path);
        Result<SurfaceEmission> emission = read_emission(*emits, rig, at);
        if (!emission) return pass_on(emission);
        if (const Result<Nits> luminance = emitted_luminance(geometry, emission->amount); !luminance)
            return placed(luminance.error(), source, at);
        surface.emits = *emission;
    }
    return surface;
}

// The bounds of the stage's subjects, if they have any.
std::optional<Ball> subject_bounds(const Stage& stage) {
    constexpr double far = std::numeric_limits<double>::infinity();
    glm::dvec3 low(far);
    glm::dvec3 high(-far);
    for (const Surface& surface : stage.surfaces) {
        const std::optional<Ball> around = bounds(surface.geometry);
        if (!surface.subject || !around) continue;
        low = glm::min(low, around->center - around->radius);
        high = glm::max(high, around->center + around->radius);
    }
    if (!(low.x <= high.x)) return std::nullopt;
    return Ball{0.5 * (low + high), 0.5 * glm::distance(low, high)};
}

Camera camera_for(const Stage& stage) {
    const std::optional<Ball> subjects = subject_bounds(stage);
    if (!subjects) return {};
    Camera camera;
    camera.target = subjects->center;
    camera.least_horizontal_fov_deg = camera.vertical_fov_deg;
    // From the front and above if the view from there is free, else from the sides, from behind, or from closer.
    for (const double distance : {2.6, 1.8, 1.2})
        for (const glm::dvec3& from : {glm::dvec3(-0.3, -1.0, 0.45), glm::dvec3(1.0, -0.3, 0.45),
                                       glm::dvec3(-1.0, 0.3, 0.45), glm::dvec3(0.3, 1.0, 0.45)}) {
            camera.position = subjects->center + distance * subjects->radius * glm::normalize(from);
            if (check_camera(stage, camera)) return camera;
        }
    return camera;
}

} // namespace

Result<SurfaceEmission> read_emission(const Json& json, const RigContext& rig, const std::string& path) {
    Result<std::string> text = text_of(json, unit_hint(json, "nt"));
    Diagnostics said;
    Result<SurfaceEmission> emission =
        text ? parse_surface_emission(*text, &said, &rig.files) : Result<SurfaceEmission>(pass_on(text));
    if (!emission) return placed(emission.error(), rig.source, path);
    for (Diagnostic& diagnostic : said) {
        diagnostic.location.file = rig.source;
        diagnostic.message = fmt::format("{}: {}", path, diagnostic.message);
        rig.diagnostics.push_back(std::move(diagnostic));
    }
    return emission;
}

Result<Stage> read_rig_stage(const Json& json, const RigContext& rig) {
    const std::string& source = rig.source;
    if (json.is_string()) {
        Result<std::string> name = text_of(json);
        Result<Stage> stage = name ? make_stage(*name) : Result<Stage>(pass_on(name));
        if (!stage) return placed(stage.error(), source, "stage");
        return stage;
    }
    if (!json.is_object())
        return rig_error("RIG0105", source, "stage",
                         fmt::format("must be a string or an object, not {}", type_of(json)),
                         R"(for example "floor" or { "surfaces": [ … ] })");
    Stage stage;
    stage.name = "custom";
    Members members(json, stage_keys, source, "stage");
    members.optional("name", stage.name, filled_name_of);
    members.optional("figure", stage.figure_position, place_of);
    if (members.failure()) return Unexpected(*members.failure());
    const auto surfaces = json.find("surfaces");
    if (surfaces == json.end() || !surfaces->is_array() || surfaces->empty())
        return rig_error("RIG0104", source, "stage.surfaces", "must be an array of at least one surface",
                         R"(for example [ { "name": "floor", "plane": {} } ])");
    if (surfaces->size() > limit("stage-surfaces").value)
        return rig_error("RIG0108", source, "stage.surfaces",
                         fmt::format("holds more than {}", to_text(limit("stage-surfaces"))), std::string(limits_hint));
    for (std::size_t i = 0; i < surfaces->size(); ++i) {
        Result<Surface> surface = read_surface((*surfaces)[i], rig, fmt::format("stage.surfaces[{}]", i));
        if (!surface) return pass_on(surface);
        stage.surfaces.push_back(std::move(*surface));
    }
    const bool has_solids = std::any_of(stage.surfaces.begin(), stage.surfaces.end(),
                                        [](const Surface& surface) { return !is_sheet(surface.geometry); });
    for (Surface& surface : stage.surfaces)
        surface.subject = !has_solids || !is_sheet(surface.geometry);
    stage.camera = camera_for(stage);
    return stage;
}

std::span<const std::string_view> rig_stage_keys() {
    return stage_keys;
}

std::span<const std::string_view> rig_surface_keys() {
    return surface_keys;
}

std::span<const std::string_view> rig_primitive_keys(std::string_view primitive) {
    for (const PrimitiveKind& kind : primitives)
        if (kind.key == primitive) return kind.keys;
    return {};
}

} // namespace gonio::detail
