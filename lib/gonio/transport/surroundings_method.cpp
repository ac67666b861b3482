#include <gonio/transport/surroundings_method.hpp>

#include <algorithm>
#include <array>

namespace gonio {

namespace {

constexpr std::array methods{
    SurroundingsMethodInfo{"spherical-harmonics", SurroundingsMethod::spherical_harmonics,
                           "sky: illuminance by nine coefficients, nothing in the way; else exact"},
    SurroundingsMethodInfo{"split-sum", SurroundingsMethod::split_sum,
                           "sky: Unreal Engine 4's prefiltered levels and table, nothing in the way; else exact"},
    SurroundingsMethodInfo{"dominant-direction", SurroundingsMethod::dominant_direction,
                           "sky: as Frostbite looks up prefiltered levels, nothing in the way"},
    SurroundingsMethodInfo{"prefiltered", SurroundingsMethod::prefiltered,
                           "sky: prefiltered levels and the exact albedo, nothing in the way; else exact"},
    SurroundingsMethodInfo{"parallax-box", SurroundingsMethod::parallax_box,
                           "reflections: a picture taken at --probe-at, projected onto a box; else exact"},
    SurroundingsMethodInfo{"parallax-sphere", SurroundingsMethod::parallax_sphere,
                           "reflections: a picture taken at --probe-at, projected onto a sphere; else exact"},
};

} // namespace

std::span<const SurroundingsMethodInfo> surroundings_methods() {
    return methods;
}

std::string_view to_text(SurroundingsMethod method) {
    const auto found = std::find_if(methods.begin(), methods.end(),
                                    [&](const SurroundingsMethodInfo& info) { return info.method == method; });
    return found == methods.end() ? std::string_view("exact") : found->name;
}

bool is_of_open_sky(SurroundingsMethod method) {
    return method == SurroundingsMethod::spherical_harmonics || method == SurroundingsMethod::split_sum ||
           method == SurroundingsMethod::dominant_direction || method == SurroundingsMethod::prefiltered;
}

bool has_local_probe(SurroundingsMethod method) {
    return method == SurroundingsMethod::parallax_box || method == SurroundingsMethod::parallax_sphere;
}

} // namespace gonio
