// The stages that are available by name.
#include <gonio/base/named.hpp>
#include <gonio/scene/stage.hpp>

#include <algorithm>
#include <array>

namespace gonio {

namespace {

using Vec = glm::dvec3;

constexpr Vec up{0.0, 0.0, 1.0};
constexpr bool subject = true;

LambertMaterial matte(double albedo) {
    return {Vec(albedo)};
}

// A dielectric.
FrostbiteMaterial polished(const Vec& base, double smoothness) {
    return {base, smoothness, 0.0, 0.5};
}

Box upright_box(const Vec& from, const Vec& to) {
    return {{0.5 * (from + to), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 0.5 * (to - from)};
}

// A room's corner: the light is 2.6 m high and 0.9 m in front of the wall, where a downlight produces its scallop.
Stage floor_stage() {
    Stage stage;
    stage.surfaces = {
        {"floor", Plane{Vec(0.0), up}, polished(Vec(0.35), 0.45)},
        {"wall", Plane{{0.0, 0.9, 0.0}, {0.0, -1.0, 0.0}}, matte(0.55)},
        {"sphere", Ball{{0.42, -0.28, 0.32}, 0.32}, polished({0.55, 0.16, 0.08}, 0.72), subject},
    };
    stage.camera = {{0.0, -4.7, 1.5}, {0.0, 0.4, 1.08}, up, 36.0, 36.0};
    stage.light.position = {0.0, 0.0, 2.6};
    stage.figure_position = {-0.75, 0.1, 0.0};
    return stage;
}

// A wall 3 m high, with the light 0.5 m in front of it just under the ceiling, the usual position of wall washers: C0
// towards the wall, or along it if the light would reach the wall.
Stage wall_stage() {
    Stage stage;
    stage.surfaces = {
        {"floor", Plane{Vec(0.0), up}, polished({0.24, 0.19, 0.15}, 0.5)},
        {"wall", Plane{{0.0, 0.5, 0.0}, {0.0, -1.0, 0.0}}, matte(0.6), subject},
        {"ceiling", Plane{{0.0, 0.0, 3.0}, -up}, matte(0.75)},
    };
    stage.camera = {{0.0, -4.6, 1.5}, {0.0, 0.5, 1.5}, up, 42.0, 42.0};
    stage.light = {{0.0, 0.0, 2.85}, -up, {-1.0, 0.0, 0.0}, 0.5};
    stage.figure_position = {-1.0, -0.1, 0.0};
    return stage;
}

// 2.2 m wide, 2.7 m high and 18 m long; the light is on the ceiling, 4.5 m from the camera, C0 across.
Stage corridor_stage() {
    Stage stage;
    const LambertMaterial plaster = matte(0.62);
    stage.surfaces = {
        {"floor", panel_facing({0.0, 7.0, 0.0}, up, {0, 1, 0}, 2.2, 18.0), polished(Vec(0.22), 0.6)},
        {"ceiling", panel_facing({0.0, 7.0, 2.7}, -up, {0, 1, 0}, 2.2, 18.0), matte(0.75)},
        {"wall", panel_facing({-1.1, 7.0, 1.35}, {1, 0, 0}, up, 18.0, 2.7), plaster, subject},
        {"wall", panel_facing({1.1, 7.0, 1.35}, {-1, 0, 0}, up, 18.0, 2.7), plaster, subject},
        {"wall", panel_facing({0.0, 16.0, 1.35}, {0, -1, 0}, up, 2.2, 2.7), plaster, subject},
    };
    stage.camera = {{0.0, -0.5, 1.6}, {0.0, 8.0, 1.25}, up, 52.0, 52.0};
    stage.light.position = {0.0, 4.0, 2.55};
    stage.figure_position = {0.5, 6.0, 0.0};
    return stage;
}

// A street along X: the pole is on the pavement, its head reaches over the road at +Y, 8 m high. C0 of the light is
// along the street, C90 across it, as in EULUMDAT.
Stage street_stage() {
    constexpr double width = 7.0; // of the road [m]
    constexpr double far = 300.0; // half the length of objects without an end
    constexpr double kerb = 0.12; // its height
    const LambertMaterial concrete = matte(0.3);
    const FrostbiteMaterial paint{Vec(0.3), 0.4, 0.0, 0.5};
    const Vec head{0.0, 0.6, 8.0};
    Stage stage;
    stage.surfaces = {{"road", Plane{Vec(0.0), up}, polished(Vec(0.09), 0.25), subject}};
    // Outwards from the road: kerbstone, pavement, verge.
    for (const double side : {-1.0, 1.0}) {
        const double edge = side < 0.0 ? 0.0 : width;
        const auto strip = [&](double from, double to, double top) {
            const double a = edge + side * from;
            const double b = edge + side * to;
            return upright_box({-far, std::min(a, b), -1.0}, {far, std::max(a, b), top});
        };
        stage.surfaces.push_back({"kerb", strip(0.0, 0.15, kerb), matte(0.4)});
        stage.surfaces.push_back({"pavement", strip(0.15, 2.5, kerb), concrete});
        stage.surfaces.push_back({"verge", strip(2.5, far, kerb - 0.02), LambertMaterial{{0.07, 0.1, 0.04}}});
    }
    stage.surfaces.push_back({"pole", capsule_between({0.0, -0.6, 0.0}, {0.0, -0.6, 8.2}, 0.07), paint});
    stage.surfaces.push_back({"pole", capsule_between({0.0, -0.6, 8.2}, {0.0, 0.3, 8.27}, 0.04), paint});
    stage.surfaces.push_back({"pole", upright_box({-0.14, 0.3, 8.15}, {0.14, 0.95, 8.25}), paint});
    stage.camera = {{-17.0, 5.0, 1.7}, {0.0, 2.6, 2.9}, up, 46.0, 46.0};
    stage.light.position = head;
    stage.figure_position = {-4.0, -1.2, kerb};
    return stage;
}

// Rough to smooth from left to right, dielectric to metal from front to back.
Stage spheres_stage() {
    constexpr int count = 5;
    constexpr double spacing = 0.6;
    constexpr double radius = 0.24;
    Stage stage;
    stage.surfaces = {{"floor", Plane{Vec(0.0), up}, polished(Vec(0.2), 0.3)}};
    for (int row = 0; row < count; ++row)
        for (int column = 0; column < count; ++column) {
            const Vec center{spacing * (column - 0.5 * (count - 1)), spacing * (row - 0.5 * (count - 1)), radius};
            const double smoothness = 0.15 + 0.8 * column / (count - 1);
            const double metal = static_cast<double>(row) / (count - 1);
            stage.surfaces.push_back({"sphere", Ball{center, radius},
                                      FrostbiteMaterial{{0.78, 0.5, 0.25}, smoothness, metal, 0.5}, subject});
        }
    stage.camera = {{0.0, -4.6, 3.3}, {0.0, -0.05, 0.15}, up, 36.0, 40.0};
    stage.light.position = {0.0, -0.8, 2.4};
    stage.figure_position = {-1.8, 1.2, 0.0};
    return stage;
}

// Cards of 18 % grey 0.5, 1, 2, 4 and 8 m in front of a light that emits towards them along +Y, 1.2 m high, C0 to the
// right. Each card has a separate sector around the axis and touches the axis with its corner, so no card shades
// another.
Stage card_stage() {
    struct Card {
        double distance; // along the axis
        double size;
        double right; // of its middle from the axis
        double above;
    };
    constexpr std::array cards{
        Card{0.5, 0.12, -0.06, -0.06}, Card{1.0, 0.2, 0.1, -0.1}, Card{2.0, 0.3, -0.15, 0.15},
        Card{4.0, 0.36, 0.49, 0.18},   Card{8.0, 0.6, 0.3, 0.3},
    };
    constexpr Vec light{0.0, 0.0, 1.2};
    const FrostbiteMaterial metal{Vec(0.6), 0.5, 1.0, 0.5};
    Stage stage;
    stage.surfaces = {{"floor", Plane{Vec(0.0), up}, matte(0.12)}};
    for (const Card& card : cards) {
        const Vec middle = light + Vec(card.right, card.distance, card.above);
        stage.surfaces.push_back(
            {"card", panel_facing(middle, {0, -1, 0}, up, card.size, card.size), matte(0.18), subject});
        const Vec foot(middle.x, middle.y + 0.015, 0.0);
        stage.surfaces.push_back({"stand", capsule_between(foot, foot + Vec(0.0, 0.0, middle.z), 0.01), metal});
    }
    stage.camera = {{0.8, -2.0, 2.3}, {0.0, 2.0, 1.22}, up, 28.0, 28.0};
    stage.light = {light, {0.0, 1.0, 0.0}, up};
    stage.figure_position = {-0.9, 4.0, 0.0};
    return stage;
}

// 4 m wide, 5 m deep, 2.6 m high and closed. Its walls are visible from inside only: a camera outside looks into it.
Stage room_stage() {
    const LambertMaterial plaster = matte(0.6);
    Stage stage;
    stage.surfaces = {
        {"floor", panel_facing({0.0, 0.0, 0.0}, up, {0, 1, 0}, 4.0, 5.0), polished({0.3, 0.21, 0.13}, 0.5)},
        {"ceiling", panel_facing({0.0, 0.0, 2.6}, -up, {0, 1, 0}, 4.0, 5.0), matte(0.8)},
        {"wall", panel_facing({-2.0, 0.0, 1.3}, {1, 0, 0}, up, 5.0, 2.6), plaster},
        {"wall", panel_facing({2.0, 0.0, 1.3}, {-1, 0, 0}, up, 5.0, 2.6), plaster},
        {"wall", panel_facing({0.0, 2.5, 1.3}, {0, -1, 0}, up, 4.0, 2.6), plaster},
        {"wall", panel_facing({0.0, -2.5, 1.3}, {0, 1, 0}, up, 4.0, 2.6), plaster},
        {"box", upright_box({0.2, 0.2, 0.0}, {1.4, 1.1, 0.74}), polished({0.42, 0.3, 0.2}, 0.55), subject},
        {"sphere", Ball{{-0.7, 0.9, 0.35}, 0.35}, polished(Vec(0.5), 0.75), subject},
    };
    stage.camera = {{-0.3, -2.4, 1.55}, {0.05, 1.2, 1.15}, up, 58.0, 58.0};
    stage.light.position = {0.0, 0.3, 2.3};
    stage.figure_position = {-1.4, 1.6, 0.0};
    return stage;
}

struct NamedStage : StageKind {
    Stage (*make)();
};

constexpr std::array stages{
    NamedStage{{"floor", "a floor with a sphere on it and a wall behind"}, floor_stage},
    NamedStage{{"wall", "a wall close to the light, for scallops and wall-washers"}, wall_stage},
    NamedStage{{"corridor", "a long corridor, the light on its ceiling"}, corridor_stage},
    NamedStage{{"street", "a road with kerbs, the light on an 8 m pole, C0 along the road"}, street_stage},
    NamedStage{{"spheres", "25 spheres, rough to smooth by dielectric to metal"}, spheres_stage},
    NamedStage{{"card", "18 % grey cards 0.5, 1, 2, 4 and 8 m along the light's axis"}, card_stage},
    NamedStage{{"room", "a closed room with a box and a sphere"}, room_stage},
};

constexpr auto kinds = [] {
    std::array<StageKind, stages.size()> all;
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = stages[i];
    return all;
}();

} // namespace

std::span<const StageKind> stage_kinds() {
    return kinds;
}

Result<Stage> make_stage(std::string_view name) {
    return find_named("stage", name, stages).map([](const NamedStage* named) {
        Stage stage = named->make();
        stage.name = named->name;
        return stage;
    });
}

} // namespace gonio
