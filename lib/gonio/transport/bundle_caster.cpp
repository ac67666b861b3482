#include <gonio/transport/bundle_caster.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <variant>

namespace gonio::detail {

namespace {

void store(const glm::dvec3& from, float (&to)[3]) {
    for (int axis = 0; axis < 3; ++axis)
        to[axis] = static_cast<float>(from[axis]);
}

// Rectangles overlap by this much of their size, so that no ray passes between those that meet at an edge.
constexpr double overlap = 4e-6;

} // namespace

DirectionArrays::DirectionArrays(std::span<const glm::dvec3> directions) : exact(directions.begin(), directions.end()) {
    for (const glm::dvec3& direction : directions)
        for (int axis = 0; axis < 3; ++axis)
            rounded[static_cast<std::size_t>(axis)].push_back(static_cast<float>(direction[axis]));
}

BundleCaster::BundleCaster(const Stage& stage, const RayCaster& caster, const Patches& patches,
                           simd::InstructionSet set)
    : stage_(stage), caster_(caster), patches_(patches), kernels_(transport::ray_kernels(set)) {}

void BundleCaster::add_rectangle(const Frame& frame, double half_width, double half_height, std::size_t chart,
                                 const Frame& from) {
    const glm::dvec3 to = frame.origin - from.origin;
    transport::RayRectangle rectangle;
    store(frame.z, rectangle.normal);
    store(frame.x, rectangle.x);
    store(frame.y, rectangle.y);
    const double height = glm::dot(to, frame.z);
    rectangle.height = static_cast<float>(height);
    rectangle.middle[0] = static_cast<float>(glm::dot(to, frame.x));
    rectangle.middle[1] = static_cast<float>(glm::dot(to, frame.y));
    rectangle.half_size[0] = static_cast<float>(half_width * (1.0 + overlap));
    rectangle.half_size[1] = static_cast<float>(half_height * (1.0 + overlap));
    rectangles_.push_back(rectangle);
    of_rectangles_.push_back({chart, height > 0.0});
}

void BundleCaster::add(const Panel& panel, std::size_t chart, bool is_solid, const Frame& from) {
    if (is_solid && glm::dot(panel.frame.origin - from.origin, panel.frame.z) > 0.0) return; // faces away
    const std::array<glm::dvec3, 4> at = corners(panel);
    const bool is_below = std::all_of(
        at.begin(), at.end(), [&](const glm::dvec3& corner) { return glm::dot(corner - from.origin, from.z) <= 0.0; });
    if (!is_below) add_rectangle(panel.frame, 0.5 * panel.width, 0.5 * panel.height, chart, from);
}

void BundleCaster::add(const Plane& plane, std::size_t chart, const Frame& from) {
    (void)plane;
    constexpr double endless = 1e37;
    add_rectangle(patches_.charts().all()[chart].frame, endless, endless, chart, from);
}

void BundleCaster::cast(const Frame& from, std::size_t own, const DirectionArrays& directions,
                        std::span<std::uint32_t> ends) {
    rectangles_.clear();
    of_rectangles_.clear();
    spheres_.clear();
    of_spheres_.clear();
    bounds_.clear();
    for (std::size_t i = 0; i < stage_.surfaces.size(); ++i) {
        if (i == own) continue;
        const Primitive& geometry = stage_.surfaces[i].geometry;
        const std::size_t chart = patches_.charts().index_of(i, 0);
        const auto sphere_around = [&](const Ball& ball) {
            transport::RaySphere sphere;
            store(ball.center - from.origin, sphere.center);
            sphere.radius = static_cast<float>(ball.radius);
            return sphere;
        };
        const auto is_below = [&](const Ball& ball) {
            return glm::dot(ball.center - from.origin, from.z) <= -ball.radius;
        };
        if (const auto* plane = std::get_if<Plane>(&geometry)) {
            add(*plane, chart, from);
        } else if (const auto* panel = std::get_if<Panel>(&geometry)) {
            add(*panel, chart, false, from);
        } else if (const auto* box = std::get_if<Box>(&geometry)) {
            if (hides(geometry, from.origin)) continue; // rays pass out of it
            for (int side = 0; side < 6; ++side)
                add(face(*box, side), chart + static_cast<std::size_t>(side), true, from);
        } else if (const auto* ball = std::get_if<Ball>(&geometry)) {
            if (hides(geometry, from.origin) || is_below(*ball)) continue;
            spheres_.push_back(sphere_around(*ball));
            of_spheres_.push_back(chart);
        } else if (const std::optional<Ball> around = bounds(geometry); around && !is_below(*around)) {
            Ball wider = *around;
            wider.radius *= 1.0 + overlap;
            bounds_.push_back(sphere_around(wider));
        }
    }
    const std::size_t count = directions.exact.size();
    for (std::vector<float>* const array : {&target_, &distance_, &u_, &v_})
        array->resize(count);
    transport::RayFrame frame;
    store(from.x, frame.x);
    store(from.y, frame.y);
    store(from.z, frame.z);
    const float* const arrays[3] = {directions.rounded[0].data(), directions.rounded[1].data(),
                                    directions.rounded[2].data()};
    kernels_.first_hits(
        {rectangles_.data(), rectangles_.size(), spheres_.data(), spheres_.size(), bounds_.data(), bounds_.size()},
        frame, arrays, count, {target_.data(), distance_.data(), u_.data(), v_.data()});
    for (std::size_t i = 0; i < count; ++i) {
        if (target_[i] == transport::RayHits::unknown) {
            const RayEnd end = caster_.cast({from.origin, from.to_world(directions.exact[i])}, own);
            ends[i] = end.surface == RayEnd::nothing
                          ? no_patch
                          : patches_.at(patches_.charts().index_of(end.surface, end.face), end.position);
        } else if (target_[i] == transport::RayHits::nothing) {
            ends[i] = no_patch;
        } else if (const auto target = static_cast<std::size_t>(target_[i]); target < rectangles_.size()) {
            ends[i] = of_rectangles_[target].blocks
                          ? no_patch
                          : patches_.at(of_rectangles_[target].chart,
                                        glm::dvec2(static_cast<double>(u_[i]), static_cast<double>(v_[i])));
        } else {
            const glm::dvec3 position =
                from.origin + static_cast<double>(distance_[i]) * from.to_world(directions.exact[i]);
            ends[i] = patches_.at(of_spheres_[target - rectangles_.size()], position);
        }
    }
}

} // namespace gonio::detail
