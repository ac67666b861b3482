#include <gonio/transport/bundle_caster.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <variant>

namespace gonio::detail {

namespace {

void store(const glm::dvec3& from, float (&to)[3]) {
    for (int axis = 0; axis < 3; ++axis)
        to[axis] = static_cast<float>(from[axis]);
}

// Rectangles overlap by this much of their size, so that no ray passes between those that meet at an edge.
constexpr double overlap = 4e-6;

transport::RayRectangle rectangle_from(const glm::dvec3& origin, const Frame& frame, double half_width,
                                       double half_height) {
    const glm::dvec3 to = frame.origin - origin;
    transport::RayRectangle rectangle;
    store(frame.z, rectangle.normal);
    store(frame.x, rectangle.x);
    store(frame.y, rectangle.y);
    rectangle.height = static_cast<float>(glm::dot(to, frame.z));
    rectangle.middle[0] = static_cast<float>(glm::dot(to, frame.x));
    rectangle.middle[1] = static_cast<float>(glm::dot(to, frame.y));
    rectangle.half_size[0] = static_cast<float>(half_width * (1.0 + overlap));
    rectangle.half_size[1] = static_cast<float>(half_height * (1.0 + overlap));
    return rectangle;
}

transport::RaySphere sphere_from(const glm::dvec3& origin, const Ball& ball) {
    transport::RaySphere sphere;
    store(ball.center - origin, sphere.center);
    sphere.radius = static_cast<float>(ball.radius);
    return sphere;
}

// Around a solid that is tested in double.
transport::RayBounds bounds_from(const glm::dvec3& origin, const Capsule& capsule, const Ball& around) {
    transport::RayBounds bounds;
    bounds.sphere = sphere_from(origin, {around.center, around.radius * (1.0 + overlap)});
    store(capsule.axis, bounds.axis);
    bounds.radius = static_cast<float>(capsule.radius * (1.0 + overlap));
    return bounds;
}

constexpr double endless = 1e37; // half the side of a plane

} // namespace

DirectionArrays::DirectionArrays(std::span<const glm::dvec3> directions) {
    for (const glm::dvec3& direction : directions)
        add(direction);
}

void DirectionArrays::clear() {
    for (std::vector<float>& axis : axes)
        axis.clear();
}

glm::dvec3 DirectionArrays::of(std::size_t index) const {
    return glm::normalize(glm::dvec3(axes[0][index], axes[1][index], axes[2][index]));
}

BundleCaster::BundleCaster(const Stage& stage, const RayCaster& caster, const Patches& patches,
                           simd::InstructionSet set)
    : stage_(stage), caster_(caster), patches_(patches), kernels_(transport::ray_kernels(set)) {}

void BundleCaster::add_rectangle(const Frame& frame, double half_width, double half_height, std::size_t chart) {
    rectangles_.push_back(rectangle_from(from_.origin, frame, half_width, half_height));
    const double height = glm::dot(frame.origin - from_.origin, frame.z);
    of_rectangles_.push_back({static_cast<std::uint32_t>(chart), height > 0.0, &patches_.grid(chart)});
}

void BundleCaster::add(const Panel& panel, std::size_t chart, bool is_solid) {
    if (is_solid && glm::dot(panel.frame.origin - from_.origin, panel.frame.z) > 0.0) return; // faces away
    const std::array<glm::dvec3, 4> at = corners(panel);
    const bool is_below = std::all_of(at.begin(), at.end(), [&](const glm::dvec3& corner) {
        return glm::dot(corner - from_.origin, from_.z) <= 0.0;
    });
    if (!is_below) add_rectangle(panel.frame, 0.5 * panel.width, 0.5 * panel.height, chart);
}

void BundleCaster::begin(const Frame& from, std::size_t own) {
    from_ = from;
    own_ = own;
    rectangles_.clear();
    of_rectangles_.clear();
    spheres_.clear();
    of_spheres_.clear();
    bounds_.clear();
    const auto is_below = [&](const Ball& ball) { return glm::dot(ball.center - from.origin, from.z) <= -ball.radius; };
    for (std::size_t i = 0; i < stage_.surfaces.size(); ++i) {
        if (i == own) continue;
        const Primitive& geometry = stage_.surfaces[i].geometry;
        const std::size_t chart = patches_.charts().index_of(i, 0);
        if (std::holds_alternative<Plane>(geometry)) {
            add_rectangle(patches_.charts().all()[chart].frame, endless, endless, chart);
        } else if (const auto* panel = std::get_if<Panel>(&geometry)) {
            add(*panel, chart, false);
        } else if (const auto* box = std::get_if<Box>(&geometry)) {
            if (hides(geometry, from.origin)) continue; // rays pass out of it
            for (int side = 0; side < 6; ++side)
                add(face(*box, side), chart + static_cast<std::size_t>(side), true);
        } else if (const auto* ball = std::get_if<Ball>(&geometry)) {
            if (hides(geometry, from.origin) || is_below(*ball)) continue;
            spheres_.push_back(sphere_from(from.origin, *ball));
            of_spheres_.push_back(static_cast<std::uint32_t>(chart));
        } else if (const auto* capsule = std::get_if<Capsule>(&geometry)) {
            const Ball around = *bounds(geometry);
            if (!is_below(around)) bounds_.push_back(bounds_from(from.origin, *capsule, around));
        }
    }
}

void BundleCaster::run(const DirectionArrays& directions) {
    for (std::vector<float>* const array : {&target_, &distance_, &u_, &v_})
        array->resize(directions.size());
    transport::RayFrame frame;
    store(from_.x, frame.x);
    store(from_.y, frame.y);
    store(from_.z, frame.z);
    const float* const arrays[3] = {directions.axes[0].data(), directions.axes[1].data(), directions.axes[2].data()};
    kernels_.first_hits(
        {rectangles_.data(), rectangles_.size(), spheres_.data(), spheres_.size(), bounds_.data(), bounds_.size()},
        frame, arrays, directions.size(), {target_.data(), distance_.data(), u_.data(), v_.data()});
}

void BundleCaster::cast(const DirectionArrays& directions, std::span<PatchPoint> ends,
                        std::span<std::uint32_t> charts) {
    run(directions);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const auto target = static_cast<std::int32_t>(target_[i]); // negative: none, or not known
        if (target >= 0 && static_cast<std::size_t>(target) < rectangles_.size()) {
            const Target& rectangle = of_rectangles_[static_cast<std::size_t>(target)];
            ends[i] = rectangle.blocks ? PatchPoint(back_side) : rectangle.grid->point(u_[i], v_[i]);
            charts[i] = rectangle.blocks ? no_patch : rectangle.chart;
            continue;
        }
        ends[i] = PatchPoint(no_patch);
        charts[i] = no_patch;
        if (target_[i] == transport::RayHits::nothing) continue;
        glm::dvec2 at;
        if (target_[i] == transport::RayHits::unknown) {
            const RayEnd end = caster_.cast({from_.origin, from_.to_world(directions.of(i))}, own_);
            if (end.surface == RayEnd::nothing) {
                if (!end.leaves()) ends[i] = PatchPoint(back_side);
                continue;
            }
            charts[i] = static_cast<std::uint32_t>(patches_.charts().index_of(end.surface, end.face));
            at = patches_.charts().all()[charts[i]].coordinates(end.position);
        } else {
            charts[i] = of_spheres_[static_cast<std::size_t>(target) - rectangles_.size()];
            at = patches_.charts().all()[charts[i]].on_sphere(static_cast<double>(u_[i]), static_cast<double>(v_[i]));
        }
        ends[i] = patches_.grid(charts[i]).point(static_cast<float>(at.x), static_cast<float>(at.y));
    }
}

void BundleCaster::cast(const DirectionArrays& directions, std::span<std::uint32_t> charts) {
    run(directions);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        charts[i] = no_patch;
        if (target_[i] == transport::RayHits::nothing) continue;
        if (target_[i] == transport::RayHits::unknown) {
            const RayEnd end = caster_.cast({from_.origin, from_.to_world(directions.of(i))}, own_);
            if (end.surface != RayEnd::nothing)
                charts[i] = static_cast<std::uint32_t>(patches_.charts().index_of(end.surface, end.face));
        } else if (const auto target = static_cast<std::size_t>(target_[i]); target < rectangles_.size()) {
            if (!of_rectangles_[target].blocks) charts[i] = of_rectangles_[target].chart;
        } else {
            charts[i] = of_spheres_[target - rectangles_.size()];
        }
    }
}

ScatteredCaster::ScatteredCaster(const Stage& stage, const Patches& patches, simd::InstructionSet set)
    : stage_(stage), patches_(patches), kernels_(transport::ray_kernels(set)), caster_(stage) {}

void ScatteredCaster::begin(const glm::dvec3& anchor, std::size_t own) {
    rectangles_.clear();
    spheres_.clear();
    bounds_.clear();
    charts_.clear();
    std::vector<std::uint32_t> of_spheres;
    const auto add = [&](const Frame& frame, double width, double height, std::size_t chart, bool is_solid) {
        rectangles_.push_back(rectangle_from(anchor, frame, 0.5 * width, 0.5 * height));
        rectangles_.back().is_solid = is_solid;
        charts_.push_back(static_cast<std::uint32_t>(chart));
    };
    for (std::size_t i = 0; i < stage_.surfaces.size(); ++i) {
        if (i == own) continue;
        const Primitive& geometry = stage_.surfaces[i].geometry;
        const std::size_t chart = patches_.charts().index_of(i, 0);
        if (std::holds_alternative<Plane>(geometry)) {
            add(patches_.charts().all()[chart].frame, 2.0 * endless, 2.0 * endless, chart, false);
        } else if (const auto* panel = std::get_if<Panel>(&geometry)) {
            add(panel->frame, panel->width, panel->height, chart, false);
        } else if (const auto* box = std::get_if<Box>(&geometry)) {
            for (int side = 0; side < 6; ++side) {
                const Panel of_box = face(*box, side);
                add(of_box.frame, of_box.width, of_box.height, chart + static_cast<std::size_t>(side), true);
            }
        } else if (const auto* ball = std::get_if<Ball>(&geometry)) {
            spheres_.push_back(sphere_from(anchor, *ball));
            of_spheres.push_back(static_cast<std::uint32_t>(chart));
        } else if (const auto* capsule = std::get_if<Capsule>(&geometry)) {
            bounds_.push_back(bounds_from(anchor, *capsule, *bounds(geometry)));
        }
    }
    charts_.insert(charts_.end(), of_spheres.begin(), of_spheres.end());
}

void ScatteredCaster::cast(const glm::dvec3& anchor, std::size_t own, const std::array<std::vector<float>, 3>& origins,
                           const std::array<std::vector<float>, 3>& directions, std::size_t count,
                           std::vector<PatchPlace>& ends) {
    begin(anchor, own);
    for (std::vector<float>* const array : {&target_, &distance_, &u_, &v_})
        array->resize(count);
    ends.assign(count, {});
    const float* const from[3] = {origins[0].data(), origins[1].data(), origins[2].data()};
    const float* const along[3] = {directions[0].data(), directions[1].data(), directions[2].data()};
    kernels_.first_hits_of_scattered(
        {rectangles_.data(), rectangles_.size(), spheres_.data(), spheres_.size(), bounds_.data(), bounds_.size()},
        from, along, count, {target_.data(), distance_.data(), u_.data(), v_.data()});
    for (std::size_t i = 0; i < count; ++i) {
        if (target_[i] == transport::RayHits::nothing) continue;
        if (target_[i] == transport::RayHits::back) {
            ends[i].chart = back_side;
            continue;
        }
        const auto on = [&](std::uint32_t chart, const glm::dvec2& at) {
            return PatchPlace{chart, static_cast<float>(at.x), static_cast<float>(at.y), distance_[i]};
        };
        if (target_[i] == transport::RayHits::unknown) {
            const glm::dvec3 origin = anchor + glm::dvec3(origins[0][i], origins[1][i], origins[2][i]);
            const glm::dvec3 direction(directions[0][i], directions[1][i], directions[2][i]);
            const RayEnd end = caster_.cast({origin, glm::normalize(direction)}, own);
            if (end.surface == RayEnd::nothing) {
                if (!end.leaves()) ends[i].chart = back_side;
                continue;
            }
            distance_[i] = static_cast<float>(glm::distance(origin, end.position));
            const std::size_t chart = patches_.charts().index_of(end.surface, end.face);
            ends[i] = on(static_cast<std::uint32_t>(chart), patches_.charts().all()[chart].coordinates(end.position));
            continue;
        }
        const auto target = static_cast<std::size_t>(target_[i]);
        if (target < rectangles_.size())
            ends[i] = {charts_[target], u_[i], v_[i], distance_[i]};
        else
            ends[i] = on(charts_[target], patches_.charts().all()[charts_[target]].on_sphere(
                                              static_cast<double>(u_[i]), static_cast<double>(v_[i])));
    }
}

} // namespace gonio::detail
