#include <gonio/base/json.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/interchange/scene_rig.hpp>

#include <fmt/format.h>

#include <numbers>

namespace gonio {

namespace {

using detail::Json;

Json vector_json(const glm::dvec3& v) {
    return Json::array({v.x + 0.0, v.y + 0.0, v.z + 0.0}); // without the sign of −0
}

// In degrees where they read back as the same angle.
std::string angle_text(Radians angle) {
    const double deg = to_degrees(angle);
    return degrees(deg).value == angle.value ? shortest(deg) + "deg" : shortest(angle.value) + "rad";
}

} // namespace

std::string shape_text(const Shape& shape) {
    std::string text = kind_of(shape);
    const char* before = ":";
    for (const ShapeValue& value : values_of(shape)) {
        std::string written = std::visit(
            [&](const auto& of) -> std::string {
                using Value = std::decay_t<decltype(of)>;
                if constexpr (std::is_same_v<Value, Meters>)
                    return fmt::format("{}={}m", value.key, shortest(of.value));
                else if constexpr (std::is_same_v<Value, Radians>)
                    return fmt::format("{}={}", value.key, angle_text(of));
                else if constexpr (std::is_same_v<Value, bool>)
                    return of ? std::string(value.key) : std::string();
                else
                    return fmt::format("{}={}", value.key, to_text(of));
            },
            value.value);
        if (written.empty()) continue;
        text += before + written;
        before = ",";
    }
    return text;
}

std::string scene_rig(const FoundScene& scene,
                      const std::function<std::string(const FoundLight& light)>& profile_file) {
    std::string text = "{\n  \"schema\": \"gonio.rig/1\",\n  \"lights\": [";
    const char* before = "\n    ";
    for (const FoundLight& light : scene.lights) {
        if (!light.shape || (light.intensity && light.intensity->number < 0.0)) continue;
        const bool is_profile = std::holds_alternative<ProfileShape>(*light.shape);
        Json json{{"name", light.name},
                  {"shape", is_profile ? "ies:" + profile_file(light) : shape_text(*light.shape)}};
        if (light.intensity)
            json["intensity"] =
                fmt::format("{}{}", shortest(light.intensity->number), light.intensity->unit.unit->symbol);
        if (light.color != glm::dvec3(1.0))
            json["color"] =
                fmt::format("rgb({},{},{})", shortest(light.color.x), shortest(light.color.y), shortest(light.color.z));
        json["position"] = vector_json(light.position);
        json["direction"] = vector_json(light.direction);
        json["up"] = vector_json(light.up);
        if (light.range) json["range"] = fmt::format("{}m", shortest(light.range->value));
        text += before + json.dump();
        before = ",\n    ";
    }
    return text + "\n  ]\n}\n";
}

} // namespace gonio
