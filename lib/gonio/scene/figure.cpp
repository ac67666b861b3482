#include <gonio/scene/figure.hpp>

#include <array>
#include <string>
#include <string_view>

namespace gonio {

namespace {

constexpr std::string_view surface_name = "figure";

// Dimensions of the 50th percentile to a centimetre, from the point midway between the feet [m].
struct Limb {
    glm::dvec3 from;
    glm::dvec3 to;
    double radius;
};

constexpr double head_radius = 0.115;
constexpr std::array middle{
    Limb{{0.0, 0.0, 1.42}, {0.0, 0.0, 1.56}, 0.055},    // neck
    Limb{{-0.12, 0.0, 1.31}, {0.12, 0.0, 1.31}, 0.115}, // shoulders
    Limb{{0.0, 0.0, 1.0}, {0.0, 0.0, 1.27}, 0.14},      // trunk
    Limb{{-0.06, 0.0, 0.94}, {0.06, 0.0, 0.94}, 0.125}, // hips
};
// The limbs on the side of +X.
constexpr std::array side{
    Limb{{0.21, 0.0, 1.37}, {0.26, 0.02, 1.09}, 0.05},     // upper arm
    Limb{{0.26, 0.02, 1.09}, {0.27, -0.05, 0.82}, 0.042},  // lower arm and hand
    Limb{{0.09, 0.0, 0.9}, {0.1, 0.0, 0.49}, 0.078},       // thigh
    Limb{{0.1, 0.0, 0.49}, {0.1, 0.02, 0.07}, 0.055},      // lower leg
    Limb{{0.1, 0.02, 0.045}, {0.12, -0.14, 0.045}, 0.045}, // foot
};

} // namespace

void add_figure(Stage& stage) {
    const auto add = [&](const Primitive& part) {
        stage.surfaces.push_back({std::string(surface_name), part, LambertMaterial{glm::dvec3(0.4)}});
    };
    const auto limb = [&](const Limb& l, double mirror) {
        const glm::dvec3 at(mirror, 1.0, 1.0);
        add(capsule_between(stage.figure_position + at * l.from, stage.figure_position + at * l.to, l.radius));
    };
    add(Ball{stage.figure_position + glm::dvec3(0.0, 0.0, figure_height - head_radius), head_radius});
    for (const Limb& l : middle)
        limb(l, 1.0);
    for (const double mirror : {-1.0, 1.0})
        for (const Limb& l : side)
            limb(l, mirror);
}

bool is_of_figure(const Surface& surface) {
    return surface.name == surface_name && !surface.subject; // every solid of a rig's stage is a subject
}

} // namespace gonio
