#include <gonio/scene/core_vector.hpp>
#include <gonio/transport/bundle_caster.hpp>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

namespace gonio::detail {

namespace {

// Rectangles overlap by this much of their size, so that no ray passes between those that meet at an edge.
constexpr double overlap = 4e-6;

transport::RayRectangle rectangle_from(const glm::dvec3& origin, const Frame& frame, double half_width,
                                       double half_height) {
    const glm::dvec3 to = frame.origin - origin;
    transport::RayRectangle rectangle;
    put(rectangle.normal, frame.z);
    put(rectangle.x, frame.x);
    put(rectangle.y, frame.y);
    rectangle.height = static_cast<float>(glm::dot(to, frame.z));
    rectangle.middle[0] = static_cast<float>(glm::dot(to, frame.x));
    rectangle.middle[1] = static_cast<float>(glm::dot(to, frame.y));
    rectangle.half_size[0] = static_cast<float>(half_width * (1.0 + overlap));
    rectangle.half_size[1] = static_cast<float>(half_height * (1.0 + overlap));
    return rectangle;
}

transport::RaySphere sphere_from(const glm::dvec3& origin, const Ball& ball) {
    transport::RaySphere sphere;
    put(sphere.center, ball.center - origin);
    sphere.radius = static_cast<float>(ball.radius);
    return sphere;
}

transport::RayCapsule capsule_from(const glm::dvec3& origin, const Capsule& capsule) {
    transport::RayCapsule made;
    put(made.center, capsule.center - origin);
    put(made.axis, capsule.axis);
    made.half_length = static_cast<float>(capsule.half_length);
    made.radius = static_cast<float>(capsule.radius);
    return made;
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

BundleCaster::BundleCaster(const Stage& stage, const Patches& patches, simd::InstructionSet set)
    : stage_(stage), patches_(patches), kernels_(transport::ray_kernels(set)) {}

BundleCaster::Outline BundleCaster::outline_of(const glm::vec3& center, float radius) {
    const float distance = glm::length(center);
    Outline outline;
    if (!(distance > radius)) return outline;
    outline.axis = center / distance;
    outline.sine = radius / distance;
    outline.cosine = std::sqrt((1.0F - outline.sine) * (1.0F + outline.sine));
    outline.nearest_m = distance - radius;
    return outline;
}

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
    rectangles_.clear();
    of_rectangles_.clear();
    spheres_.clear();
    of_spheres_.clear();
    capsules_.clear();
    of_capsules_.clear();
    outlines_.clear();
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
            if (hides(geometry, from.origin) || is_below(*bounds(geometry))) continue;
            capsules_.push_back(capsule_from(from.origin, *capsule));
            of_capsules_.push_back(static_cast<std::uint32_t>(chart));
        }
    }
}

void BundleCaster::find_outlines() {
    outlines_.reserve(rectangles_.size() + spheres_.size() + capsules_.size());
    for (const transport::RayRectangle& rectangle : rectangles_)
        outlines_.push_back(outline_of(rectangle.height * glm::make_vec3(rectangle.normal) +
                                           rectangle.middle[0] * glm::make_vec3(rectangle.x) +
                                           rectangle.middle[1] * glm::make_vec3(rectangle.y),
                                       std::hypot(rectangle.half_size[0], rectangle.half_size[1])));
    for (const transport::RaySphere& sphere : spheres_)
        outlines_.push_back(outline_of(glm::make_vec3(sphere.center), sphere.radius));
    for (const transport::RayCapsule& capsule : capsules_)
        outlines_.push_back(outline_of(glm::make_vec3(capsule.center), capsule.half_length + capsule.radius));
}

bool BundleCaster::find_nearer(std::uint32_t chart) {
    nearer_.rectangles.clear();
    nearer_.spheres.clear();
    nearer_.capsules.clear();
    nearer_.charts.clear();
    bool is_empty = true;
    if (outlines_.empty()) find_outlines();
    const std::size_t surface = patches_.charts().all()[chart].surface;
    const Primitive& geometry = stage_.surfaces[surface].geometry;
    const std::optional<Ball> around = bounds(geometry);
    const glm::vec3 center = around ? glm::vec3(around->center - from_.origin) : glm::vec3(0.0F);
    // Rays go to points a little above the surface.
    constexpr float wider = 1.001F;
    const float radius = around ? wider * static_cast<float>(around->radius) : 0.0F;
    const Outline whole = around ? outline_of(center, radius) : Outline();
    const bool is_all_around = whole.cosine < 0.0F;
    // Of a ball, the points that are seen are no farther than where lines touch it.
    const float distance = glm::length(center);
    const float farthest = is_all_around                            ? std::numeric_limits<float>::infinity()
                           : std::holds_alternative<Ball>(geometry) ? distance * whole.cosine + (wider - 1.0F) * radius
                                                                    : distance + radius;
    const auto may_be_nearer = [&](const Outline& target) {
        if (is_all_around || target.cosine < 0.0F) return true;
        constexpr float rounding = 1e-5F;
        const float cosine_of_both = whole.cosine * target.cosine - whole.sine * target.sine;
        return target.nearest_m <= farthest && glm::dot(whole.axis, target.axis) >= cosine_of_both - rounding;
    };
    // Beyond the plane of a rectangle, as seen from the rays' origin, or across it. What a solid stands on hides
    // nothing.
    const auto crosses = [&](const transport::RayRectangle& rectangle) {
        if (is_all_around) return true;
        constexpr float standing = 0.999F;
        const float along = glm::dot(glm::make_vec3(rectangle.normal), center) - rectangle.height;
        return (rectangle.height > 0.0F ? along : -along) > -standing * radius;
    };
    // Other faces of the same box do not hide points that are turned to the origin.
    const auto is_own = [&](std::uint32_t of) { return patches_.charts().all()[of].surface == surface; };
    const Outline* outline = outlines_.data();
    for (std::size_t i = 0; i < rectangles_.size(); ++i, ++outline) {
        const std::uint32_t of = of_rectangles_[i].chart;
        if (of != chart && (is_own(of) || !crosses(rectangles_[i]) || !may_be_nearer(*outline))) continue;
        nearer_.rectangles.push_back(rectangles_[i]);
        nearer_.charts.push_back(of_rectangles_[i].blocks ? no_patch : of);
        is_empty = is_empty && of == chart;
    }
    for (std::size_t i = 0; i < spheres_.size(); ++i, ++outline) {
        if (of_spheres_[i] != chart && !may_be_nearer(*outline)) continue;
        nearer_.spheres.push_back(spheres_[i]);
        nearer_.charts.push_back(of_spheres_[i]);
        is_empty = is_empty && of_spheres_[i] == chart;
    }
    for (std::size_t i = 0; i < capsules_.size(); ++i, ++outline) {
        if (of_capsules_[i] != chart && !may_be_nearer(*outline)) continue;
        nearer_.capsules.push_back(capsules_[i]);
        nearer_.charts.push_back(of_capsules_[i]);
        is_empty = is_empty && of_capsules_[i] == chart;
    }
    return !is_empty;
}

void BundleCaster::run(const DirectionArrays& directions, const transport::RayTargets& targets) {
    const std::size_t count = directions.size();
    for (std::vector<float>* const array : {&target_, &distance_, &u_, &v_})
        array->resize(count);
    transport::RayFrame frame;
    put(frame.x, from_.x);
    put(frame.y, from_.y);
    put(frame.z, from_.z);
    const float* const arrays[3] = {directions.axes[0].data(), directions.axes[1].data(), directions.axes[2].data()};
    kernels_.first_hits(targets, frame, arrays, count, {target_.data(), distance_.data(), u_.data(), v_.data()});
}

void BundleCaster::cast(const DirectionArrays& directions, std::span<PatchPoint> ends,
                        std::span<std::uint32_t> charts) {
    run(directions,
        {rectangles_.data(), rectangles_.size(), spheres_.data(), spheres_.size(), capsules_.data(), capsules_.size()});
    const std::size_t solids = rectangles_.size() + spheres_.size();
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
        if (static_cast<std::size_t>(target) >= solids) {
            charts[i] = of_capsules_[static_cast<std::size_t>(target) - solids];
            const glm::dvec3 along = from_.to_world(directions.of(i));
            at = patches_.charts().all()[charts[i]].coordinates(from_.origin +
                                                                static_cast<double>(distance_[i]) * along);
        } else {
            charts[i] = of_spheres_[static_cast<std::size_t>(target) - rectangles_.size()];
            at = patches_.charts().all()[charts[i]].on_sphere(static_cast<double>(u_[i]), static_cast<double>(v_[i]));
        }
        ends[i] = patches_.grid(charts[i]).point(static_cast<float>(at.x), static_cast<float>(at.y));
    }
}

void BundleCaster::cast_toward(const DirectionArrays& directions, std::span<std::uint32_t> charts) {
    run(directions, {nearer_.rectangles.data(), nearer_.rectangles.size(), nearer_.spheres.data(),
                     nearer_.spheres.size(), nearer_.capsules.data(), nearer_.capsules.size()});
    for (std::size_t i = 0; i < charts.size(); ++i)
        charts[i] =
            target_[i] == transport::RayHits::nothing ? no_patch : nearer_.charts[static_cast<std::size_t>(target_[i])];
}

ScatteredCaster::ScatteredCaster(const Stage& stage, const Patches& patches, simd::InstructionSet set)
    : stage_(stage), patches_(patches), kernels_(transport::ray_kernels(set)) {}

void ScatteredCaster::begin(const glm::dvec3& anchor, std::size_t own) {
    rectangles_.clear();
    spheres_.clear();
    capsules_.clear();
    charts_.clear();
    std::vector<std::uint32_t> of_spheres, of_capsules;
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
            capsules_.push_back(capsule_from(anchor, *capsule));
            of_capsules.push_back(static_cast<std::uint32_t>(chart));
        }
    }
    charts_.insert(charts_.end(), of_spheres.begin(), of_spheres.end());
    charts_.insert(charts_.end(), of_capsules.begin(), of_capsules.end());
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
        {rectangles_.data(), rectangles_.size(), spheres_.data(), spheres_.size(), capsules_.data(), capsules_.size()},
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
        const auto target = static_cast<std::size_t>(target_[i]);
        const Chart& chart = patches_.charts().all()[charts_[target]];
        if (target < rectangles_.size()) {
            ends[i] = {charts_[target], u_[i], v_[i], distance_[i]};
        } else if (target < rectangles_.size() + spheres_.size()) {
            ends[i] = on(charts_[target], chart.on_sphere(static_cast<double>(u_[i]), static_cast<double>(v_[i])));
        } else {
            const glm::dvec3 origin = anchor + glm::dvec3(origins[0][i], origins[1][i], origins[2][i]);
            const glm::dvec3 direction(directions[0][i], directions[1][i], directions[2][i]);
            ends[i] = on(charts_[target],
                         chart.coordinates(origin + static_cast<double>(distance_[i]) * glm::normalize(direction)));
        }
    }
}

} // namespace gonio::detail
