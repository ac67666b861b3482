#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/scene/detail/rig_values.hpp>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace gonio::detail {

std::string_view type_of(const Json& json) {
    if (json.is_null()) return "null";
    if (json.is_boolean()) return "a boolean";
    if (json.is_number()) return "a number";
    if (json.is_string()) return "a string";
    return json.is_array() ? "an array" : "an object";
}

// The hint for a plain number where a number with a unit is expected: "800" → "800lm".
std::string unit_hint(const Json& json, std::string_view unit) {
    return json.is_number() ? fmt::format("write it with its unit, for example \"{}{}\"", json.dump(), unit)
                            : std::string();
}

Result<std::string> text_of(const Json& json, std::string hint) {
    if (!json.is_string())
        return rig_value_error("RIG0105", fmt::format("must be a string, not {}", type_of(json)), std::move(hint));
    std::string text = json.as_string();
    if (text.find('\0') != std::string::npos) return rig_value_error("RIG0106", "must not hold a null character");
    return text;
}

Result<std::string> name_of(const Json& json) {
    Result<std::string> text = text_of(json);
    if (text && has_control_characters(*text))
        return rig_value_error("RIG0106", "must not have control characters", "write letters, digits and signs");
    return text;
}

Result<glm::dvec3> vector_of(const Json& json) {
    const auto wrong = [](std::string what) {
        return rig_value_error("RIG0105", fmt::format("must be an array of three numbers, not {}", what),
                               "for example [0, 0, 2.5]");
    };
    if (!json.is_array()) return wrong(std::string(type_of(json)));
    if (json.size() != 3) return wrong(fmt::format("of {}", json.size()));
    glm::dvec3 vector(0.0);
    for (std::size_t i = 0; i < 3; ++i) {
        if (!json[i].is_number()) return wrong(fmt::format("one with {}", type_of(json[i])));
        vector[static_cast<int>(i)] = json[i].as_double();
    }
    return vector;
}

Result<glm::dvec3> position_of(const Json& json) {
    Result<glm::dvec3> vector = vector_of(json);
    if (vector && !glm::all(glm::lessThanEqual(glm::abs(*vector), glm::dvec3(farthest_m))))
        return rig_value_error("RIG0106", fmt::format("must lie within {} m", farthest_m));
    return vector;
}

Result<glm::dvec3> nonzero_vector_of(const Json& json) {
    Result<glm::dvec3> vector = vector_of(json);
    if (vector && *vector == glm::dvec3(0.0)) return rig_value_error("RIG0106", "must not be zero");
    return vector;
}

Result<double> positive_length(const Json& json) {
    Result<std::string> text = text_of(json, unit_hint(json, "m"));
    if (!text) return pass_on(text);
    Result<double> meters = parse_amount(*text, Dimension::length, "it");
    if (meters && !(*meters > 0.0)) return rig_value_error("RIG0106", "must be greater than 0");
    return meters;
}

Result<double> angle_of(const Json& json) {
    Result<std::string> text = text_of(json, unit_hint(json, "deg"));
    if (!text) return pass_on(text);
    return parse_amount(*text, Dimension::angle, "it");
}

} // namespace gonio::detail
