// The value of --sweep: a parameter and the values that it takes, one after the other.
#pragma once

#include <gonio/base/limits.hpp>
#include <gonio/base/result.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

inline constexpr std::size_t most_sweep_values = limit("sweep-values").value;

struct SweepAxis {
    std::string text;                // as given
    std::string target;              // the light or surface; empty: all that have the parameter
    std::string key;                 // as `gonio list sweeps` names it
    std::vector<std::string> values; // as the parameter's own option takes them

    // "key.radius 5cm": computed values are rounded to four digits.
    std::string label(std::size_t value) const;
    // The parameter as given: "key.radius".
    std::string name() const;
};

// "KEY=FROM:TO:COUNT", uniform, or "…:log", in equal ratios; "KEY=A,B,C". FROM and TO may have different units of one
// quantity: TO is converted. The ends are exact; the values between them have 12 digits. KEY may be NAME.KEY, and a
// short name of the shape's grammar (r, w, l). Fails (usage), with the column of the text, on anything else; for an
// unknown KEY the error names the nearest one.
Result<SweepAxis> parse_sweep_axis(std::string_view text);

// The error for a value of the axis; it names the value.
Unexpected refused_value(const SweepAxis& axis, std::size_t value, const Error& error);

// Parameters that belong to no light and to no material.
struct ViewParameter {
    std::string_view name;
    std::string_view example;
    std::string_view summary;
};
inline constexpr ViewParameter view_parameters[] = {
    {"exposure", "8ev", "as for --exposure; each picture then has its own"},
    {"fov", "40deg", "full vertical field of view of the camera"},
    {"method", "ltc", "method for the light"},
};

} // namespace gonio::cli
