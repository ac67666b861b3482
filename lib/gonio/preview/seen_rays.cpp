#include <gonio/preview/detail/seen_rays.hpp>
#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/emitter.hpp>

#include <glm/geometric.hpp>

#include <limits>
#include <optional>
#include <variant>

namespace gonio::detail {

namespace {

struct TargetNumbers {
    const glm::dvec3& eye;
    preview::CameraTarget& to;

    using Kind = preview::CameraTarget::Kind;

    void operator()(const Plane& plane) const {
        to.kind = Kind::plane;
        put_plane(plane.point, plane.normal);
    }
    void operator()(const Panel& panel) const {
        to.kind = Kind::panel;
        put_plane(panel.frame.origin, panel.frame.z);
        put(to.middle, panel.frame.origin);
        put(to.x, panel.frame.x);
        put(to.y, panel.frame.y);
        put(to.half_size, {0.5 * panel.width, 0.5 * panel.height, 0.0});
    }
    void operator()(const Ball& ball) const {
        to.kind = Kind::ball;
        put(to.middle, ball.center - eye);
        to.radius = ball.radius;
    }
    void operator()(const Box& box) const {
        to.kind = Kind::box;
        put(to.middle, box.frame.to_local(eye - box.frame.origin));
        put(to.x, box.frame.x);
        put(to.y, box.frame.y);
        put(to.normal, box.frame.z);
        put(to.half_size, box.half_size);
    }
    void operator()(const Capsule& capsule) const {
        to.kind = Kind::capsule;
        const glm::dvec3 to_center = capsule.center - eye;
        put(to.middle, to_center);
        put(to.x, capsule.axis);
        to.height = glm::dot(to_center, capsule.axis);
        to.half_size[0] = capsule.half_length;
        to.radius = capsule.radius;
        put(to.ends[0], capsule.center - capsule.half_length * capsule.axis - eye);
        put(to.ends[1], capsule.center + capsule.half_length * capsule.axis - eye);
    }

private:
    void put_plane(const glm::dvec3& point, const glm::dvec3& normal) const {
        put(to.normal, normal);
        to.height = glm::dot(point - eye, normal);
    }
};

preview::CameraTarget target_of(const Primitive& primitive, const glm::dvec3& eye) {
    preview::CameraTarget target;
    std::visit(TargetNumbers{eye, target}, primitive);
    return target;
}

} // namespace

RaysFrom& SeenRays::begin(std::size_t count) {
    rays_.resize(count);
    rays_.origin = scene_.rays.eye();
    return rays_;
}

void SeenRays::begin_grid(double left, double top, std::size_t columns, std::size_t rows) {
    begin(columns * rows);
    const CameraRays::Plane& plane = scene_.rays.plane();
    preview::CameraRow row;
    put(row.start, plane.corner);
    put(row.step, plane.right);
    row.first = left;
    for (std::size_t i = 0; i < rows; ++i) {
        put(row.down, (top + static_cast<double>(i)) * plane.down);
        double* const to[3] = {rays_.x.data() + i * columns, rays_.y.data() + i * columns,
                               rays_.z.data() + i * columns};
        scene_.kernels.directions(row, columns, to);
    }
}

preview::CameraRayArrays SeenRays::arrays(std::size_t first, std::size_t count) const {
    preview::CameraRayArrays arrays;
    put(arrays.origin, rays_.origin);
    arrays.direction[0] = rays_.x.data() + first;
    arrays.direction[1] = rays_.y.data() + first;
    arrays.direction[2] = rays_.z.data() + first;
    arrays.count = count;
    return arrays;
}

void SeenRays::cast(std::span<const std::uint32_t> surfaces, std::span<const std::uint32_t> lights) {
    first_.begin(rays_.size());
    const preview::CameraRayArrays all = arrays(0, rays_.size());
    bool has_faces = false;
    for (const std::uint32_t i : surfaces) {
        const Primitive& geometry = scene_.stage.surfaces[i].geometry;
        scene_.kernels.meet(target_of(geometry, rays_.origin), all, i, first_.distance.data(), first_.number.data());
        has_faces = has_faces || std::holds_alternative<Box>(geometry);
    }
    kind_.resize(rays_.size());
    for (std::size_t i = 0; i < rays_.size(); ++i)
        kind_[i] = first_.distance[i] < std::numeric_limits<double>::infinity() ? surface : nothing;
    if (has_faces) find_faces();
    find_lights(lights);
}

void SeenRays::find_faces() {
    for (std::size_t i = 0; i < size(); ++i)
        if (is_surface(i))
            kind_[i] = static_cast<std::uint8_t>(
                surface + face_at(scene_.stage.surfaces[surface_of(i)].geometry, position_of(i)));
}

void SeenRays::find_lights(std::span<const std::uint32_t> lights) {
    for (const std::uint32_t light : lights)
        for (std::size_t i = 0; i < size(); ++i) {
            const std::optional<double> distance = distance_to(scene_.lights[light], rays_.at(i));
            if (!distance || *distance >= first_.distance[i]) continue;
            kind_[i] = emitter;
            first_.number[i] = light;
            first_.distance[i] = *distance;
        }
}

glm::dvec3 SeenRays::normal_of(std::size_t i) const {
    const Primitive& met = scene_.stage.surfaces[surface_of(i)].geometry;
    const auto* const box = std::get_if<Box>(&met);
    return box != nullptr ? face(*box, face_of(i)).frame.z : normal_at(met, position_of(i));
}

void SeenRays::put_positions(std::size_t first, std::size_t count, const glm::dvec3& anchor,
                             float* const (&to)[3]) const {
    double less[3];
    put(less, anchor);
    scene_.kernels.positions(arrays(first, count), first_.distance.data() + first, less, to);
}

void SeenRays::put_views(std::size_t first, std::size_t count, float* const (&to)[3]) const {
    scene_.kernels.views(arrays(first, count), to);
}

void SeenRays::put_changes(std::size_t columns, std::span<std::uint8_t> to) const {
    std::vector<std::uint32_t> shown(size());
    for (std::size_t i = 0; i < size(); ++i)
        shown[i] = (static_cast<std::uint32_t>(static_cast<std::int32_t>(first_.number[i])) << 3U) | kind_[i];
    for (std::size_t row = columns; row + columns < size(); row += columns)
        for (std::size_t i = row + 1; i < row + columns - 1; ++i) {
            const std::uint32_t here = shown[i];
            const std::uint32_t changes = (here ^ shown[i - 1]) | (here ^ shown[i + 1]) | (here ^ shown[i - columns]) |
                                          (here ^ shown[i + columns]);
            to[i] = changes != 0 ? 1 : 0;
        }
}

Seen SeenRays::at(std::size_t i) const {
    Seen seen;
    seen.view = view_of(i);
    if (is_emitter(i)) {
        seen.what = Seen::What::emitter;
        seen.light = light_of(i);
    } else if (is_surface(i)) {
        seen.what = Seen::What::surface;
        seen.hit = {first_.distance[i], surface_of(i), face_of(i), position_of(i), normal_of(i)};
    }
    return seen;
}

} // namespace gonio::detail
