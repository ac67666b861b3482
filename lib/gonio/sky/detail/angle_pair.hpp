// Two angles as text: "180/40", in degrees, with or without the unit.
#pragma once

#include <gonio/base/result.hpp>

#include <string_view>

namespace gonio::detail {

struct AnglePair {
    double first_deg = 0.0;
    double second_deg = 0.0;
};

// Each is a number of degrees or an angle with its unit. `what` names the pair in the message ("a place"), `form` its
// parts ("latitude/longitude"). Fails (usage) on anything else.
Result<AnglePair> parse_angle_pair(std::string_view text, std::string_view what, std::string_view form,
                                   std::string_view example);

} // namespace gonio::detail
