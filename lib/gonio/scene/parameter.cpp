#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/scene/parameter.hpp>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace gonio {

namespace {

// Names, examples and the shapes that have each one, except for parameters with texts that name the shapes themselves.
std::vector<ParameterName> parameters_of_lights() {
    const auto of_shapes = [](std::string_view name, std::string_view what) {
        return kinds_with_parameter(name) + std::string(what);
    };
    static const std::string radius = of_shapes("radius", " (r)");
    static const std::string width = of_shapes("width", " (w)");
    static const std::string length = of_shapes("length", " (l)");
    static const std::string size = of_shapes("size", ": a factor for all lengths");
    return {
        {"cct", "2700K", "colour temperature: 2700K or 2700K/0.003", true},
        {"color", "d65", "colour, as --color takes it", true},
        {"intensity", "800lm", "amount: lm, cd, nt, lx, W", true},
        {"radius", "10cm", radius},
        {"width", "60cm", width},
        {"length", "1.2m", length},
        {"size", "2", size},
        {"h", "30cm", "ellipse, rect: its height; frustum: its horizontal angle"},
        {"v", "40deg", "frustum: its vertical angle"},
        {"outer", "40deg", "spot: outer half angle"},
        {"cone", "80deg", "spot: outer full angle"},
        {"inner", "5deg", "spot: inner half angle, with full intensity"},
        {"beam", "30deg", "spot: full angle at half of the peak; the ratio of inner to outer stays"},
        {"falloff", "hard", "spot: from inner to outer"},
        {"angle", "0.53deg", "sun: its diameter"},
        {"x", "1m", "position of the centre"},
        {"y", "1m", "position of the centre"},
        {"height", "2.5m", "height of the centre above 0"},
        {"rotate", "90deg", "rotation about the direction, C0 towards C90"},
        {"yaw", "45deg", "rotation of the direction about the vertical, anticlockwise from above"},
        {"range", "12m", "distance at which it fades to zero"},
    };
}

Result<bool> set_color(LightDescription& light, std::string_view name, std::string_view value,
                       Diagnostics& diagnostics) {
    if (name == "cct") {
        Result<double> kelvin = parse_amount(value.substr(0, value.find('/')), Dimension::temperature, "cct");
        if (!kelvin) return pass_on(kelvin);
    }
    Result<glm::dvec3> color = parse_light_color(value, &diagnostics);
    if (!color) return pass_on(color);
    light.color = *color;
    return true;
}

glm::dvec3 turned(const glm::dvec3& v, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

Result<bool> set_angle(LightDescription& light, std::string_view name, std::string_view value) {
    Result<double> angle = parse_amount(value, Dimension::angle, name);
    if (!angle) return pass_on(angle);
    if (name == "rotate") {
        light.rotation = Radians(*angle);
    } else {
        light.direction = turned(light.direction, *angle);
        light.up = turned(light.up, *angle);
    }
    return true;
}

Result<bool> set_length(LightDescription& light, std::string_view name, std::string_view value) {
    if (class_of(light.shape) == ShapeClass::sun) return false;
    Result<double> meters = parse_amount(value, Dimension::length, name);
    if (!meters) return pass_on(meters);
    if (name == "range") {
        if (!(*meters > 0.0)) return fail("USE0106", fmt::format("range must be greater than 0, not {}", value));
        light.range = Meters(*meters);
    } else {
        light.position[name == "x" ? 0 : name == "y" ? 1 : 2] = *meters;
    }
    return true;
}

} // namespace

std::span<const ParameterName> light_parameters() {
    static const std::vector<ParameterName> of_lights = parameters_of_lights();
    return of_lights;
}

Result<bool> set_parameter(LightDescription& light, std::string_view name, std::string_view value,
                           Diagnostics& diagnostics) {
    if (name == "cct" || name == "color") return set_color(light, name, value, diagnostics);
    if (name == "rotate" || name == "yaw") return set_angle(light, name, value);
    if (name == "x" || name == "y" || name == "height" || name == "range") return set_length(light, name, value);
    if (name == "intensity") {
        Result<PhotometricValue> amount = parse_photometric_value(value);
        if (!amount) return pass_on(amount);
        light.intensity = *amount;
        return true;
    }
    return set_shape_parameter(light.shape, name, std::string(value));
}

std::vector<std::string_view> parameters_of(const LightDescription& light) {
    std::vector<std::string_view> names;
    for (const ParameterName& parameter : light_parameters()) {
        LightDescription scratch = light;
        Diagnostics unheard;
        // If the example is outside a bound of this light, the light still has the parameter.
        const Result<bool> set = set_parameter(scratch, parameter.name, parameter.example, unheard);
        if (!set || *set) names.push_back(parameter.name);
    }
    return names;
}

} // namespace gonio
