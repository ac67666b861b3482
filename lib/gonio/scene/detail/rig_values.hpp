// Values of a rig's JSON. A failure reports what was expected; the caller adds the path in front (placed).
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/scene/detail/rig_stream.hpp>

#include <glm/vec3.hpp>

#include <string>
#include <string_view>
#include <utility>

namespace gonio::detail {

// "a number", "an array".
std::string_view type_of(const Json& json);

// The hint for a plain number where a number with a unit is expected: "800" → "800lm"; otherwise empty.
std::string unit_hint(const Json& json, std::string_view unit);

Result<std::string> text_of(const Json& json, std::string hint = {});

// A name that is shown: without control characters, which a terminal would follow.
Result<std::string> name_of(const Json& json);

// Three numbers.
Result<glm::dvec3> vector_of(const Json& json);

inline constexpr double farthest_m = 1e100; // in each direction: the range of a probe

// Within farthest_m.
Result<glm::dvec3> position_of(const Json& json);

// Fails on a zero vector.
Result<glm::dvec3> nonzero_vector_of(const Json& json);

// A length with its unit, greater than 0 [m].
Result<double> positive_length(const Json& json);

// An angle with its unit [rad].
Result<double> angle_of(const Json& json);

template<class T, class Value>
Result<void> keep(Result<Value> value, T& target) {
    if (!value) return pass_on(value);
    target = T(std::move(*value));
    return {};
}

} // namespace gonio::detail
