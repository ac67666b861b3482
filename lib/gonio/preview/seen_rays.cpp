#include <gonio/preview/detail/seen_rays.hpp>
#include <gonio/scene/emitter.hpp>

#include <cmath>
#include <optional>
#include <variant>

namespace gonio::detail {

RaysFrom& SeenRays::begin(std::size_t count) {
    rays_.resize(count);
    return rays_;
}

void SeenRays::cast(std::span<const std::uint32_t> surfaces, std::span<const std::uint32_t> lights) {
    first_.begin(rays_.size());
    bool has_faces = false;
    for (const std::uint32_t i : surfaces) {
        const Primitive& geometry = scene_.stage.surfaces[i].geometry;
        meet_first(geometry, rays_, i, first_);
        has_faces = has_faces || std::holds_alternative<Box>(geometry);
    }
    kind_.resize(rays_.size());
    for (std::size_t i = 0; i < rays_.size(); ++i)
        kind_[i] = std::isfinite(first_.distance[i]) ? surface : nothing;
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
                             const std::array<float*, 3>& to) const {
    const std::array axes{rays_.x.data() + first, rays_.y.data() + first, rays_.z.data() + first};
    const double* const distance = first_.distance.data() + first;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double from = rays_.origin[static_cast<int>(axis)];
        const double less = anchor[static_cast<int>(axis)];
        const double* const along = axes[axis];
        float* const numbers = to[axis];
        for (std::size_t i = 0; i < count; ++i)
            numbers[i] = static_cast<float>(from + distance[i] * along[i] - less);
    }
}

void SeenRays::put_views(std::size_t first, std::size_t count, const std::array<float*, 3>& to) const {
    const std::array axes{rays_.x.data() + first, rays_.y.data() + first, rays_.z.data() + first};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double* const along = axes[axis];
        float* const numbers = to[axis];
        for (std::size_t i = 0; i < count; ++i)
            numbers[i] = static_cast<float>(-along[i]);
    }
}

void SeenRays::put_changes(std::size_t first, std::size_t count, std::size_t stride, std::uint8_t* to) const {
    const auto differ = [&](const auto& values, std::size_t i) {
        const auto here = values[i];
        return (here != values[i - 1]) | (here != values[i + 1]) | (here != values[i - stride]) |
               (here != values[i + stride]);
    };
    const std::uint8_t* const kind = kind_.data() + first;
    const std::uint32_t* const number = first_.number.data() + first;
    for (std::size_t i = 0; i < count; ++i)
        to[i] = differ(kind, i) ? 1 : 0;
    for (std::size_t i = 0; i < count; ++i)
        to[i] = static_cast<std::uint8_t>(to[i] | (differ(number, i) ? 1 : 0));
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
