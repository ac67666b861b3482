#include <gonio/scene/capsule_overlap.hpp>
#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/material_description.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/shadow_body.hpp>
#include <gonio/transport/ray_bundle.hpp>
#include <gonio/transport/soft_shadow.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace gonio::detail {

using transport::NearBodies;
using transport::ShadowShares;

SoftShadow::SoftShadow(const LitScene& scene)
    : scene_(scene),
      reflectance_(shading::reflectance_kernels(scene.options.instruction_set)),
      kernels_(transport::shadow_kernels(scene.options.instruction_set)),
      plain_kernels_(transport::shadow_kernels(simd::InstructionSet::scalar)) {}

void SoftShadow::begin(const LitLight& light) {
    light_ = &light;
    lined_ = lined_light(light.light, {light.reach.center, light.reach.body_radius});
    bodies_.resize(scene_.stage.surfaces.size());
    for (std::vector<std::uint32_t>& bodies : bodies_)
        bodies.clear();
}

std::span<const VisibleShare> SoftShadow::visible(std::size_t own, const ShadowPoints& points, bool with_luminance) {
    shares_.assign(points.size(), VisibleShare());
    if (shares_.empty() || bodies_[own].empty()) return shares_;
    numbers_.clear();
    for (const std::uint32_t i : bodies_[own])
        numbers_.push_back(shadow_body(scene_.stage.surfaces[i].geometry, lined_));
    may_have_balls_ = lined_.kind == LinedLight::Kind::ball && !light_->luminance &&
                      std::any_of(numbers_.begin(), numbers_.end(),
                                  [](const ShadowBody& body) { return body.kind == ShadowBody::Kind::ball; });
    scratch_.resize(std::max(scratch_.size(), numbers_.size() * transport::shadow_scratch_bytes));
    for (std::size_t first = 0; first < points.size(); first += block)
        find(own, points, first, std::min(block, points.size() - first), with_luminance);
    return shares_;
}

void SoftShadow::find(std::size_t own, const ShadowPoints& points, std::size_t first, std::size_t count,
                      bool with_luminance) {
    const bool is_glossy =
        with_luminance && !std::holds_alternative<shading::Lambert<double>>(scene_.core_materials[own]);
    const bool has_cells = is_glossy || light_->luminance.has_value();
    std::fill_n(past_ball_.begin(), count, -1.0);
    find_left(points, first, count, is_glossy);
    if (left_.count == 0) return;
    ShadowShares shares;
    shares.visible = visible_.data();
    shares.hiding = hiding_.data();
    if (has_cells) {
        constexpr std::size_t all = ShadowShares::cells * cell_stride;
        cells_.resize(5 * all);
        shares.stride = cell_stride;
        shares.seen = cells_.data();
        shares.solid_angle = cells_.data() + all;
        for (std::size_t axis = 0; axis < 3; ++axis)
            shares.towards[axis] = cells_.data() + (2 + axis) * all;
    }
    kernels_for(left_.count)
        .visible_shares(lined_, numbers_.data(), numbers_.size(), left_.receivers(), scratch_.data(), shares);
    if (may_have_balls_) {
        behind_.clear();
        for (std::size_t k = 0; k < left_.count; ++k)
            if (hiding_[k] != ShadowShares::several && past_ball_[left_.index[k]] < 0.0)
                add_behind(points, first, left_.index[k], hiding_[k]);
        find_past_balls();
    }
    for (std::size_t k = 0; k < left_.count; ++k) {
        const std::size_t i = left_.index[k];
        VisibleShare& share = shares_[first + i];
        double by_lines = visible_[k];
        share.lx = by_lines;
        share.rgb = glm::vec3(static_cast<float>(by_lines));
        const bool is_alone = hiding_[k] != ShadowShares::several;
        if (by_lines == 1.0 || (by_lines == 0.0 && !is_alone)) continue;
        const glm::dvec3 point = points.position(first + i);
        const glm::dvec3 normal = points.normal(first + i);
        if (has_cells) find_cells_of(k, point);
        if (light_->luminance.has_value()) by_lines = integrated(normal);
        share.lx = by_lines;
        if (is_alone) {
            const std::uint32_t body = bodies_[own][static_cast<std::size_t>(hiding_[k])];
            share.lx = past_ball_[i] >= 0.0
                           ? past_ball_[i]
                           : closed_form(scene_.stage.surfaces[body].geometry, point, normal).value_or(by_lines);
        }
        share.rgb = is_glossy && share.lx != 0.0 && share.lx != 1.0
                        ? visible_luminance(own, point, normal, points.view(first + i), share.lx, by_lines)
                        : glm::vec3(static_cast<float>(share.lx));
    }
}

// Points near which nothing is, and those that a single ball hides the light from, need no lines, unless a glossy
// surface shows which part of the light is hidden.
void SoftShadow::find_left(const ShadowPoints& points, std::size_t first, std::size_t count, bool is_glossy) {
    left_.clear();
    if (!may_have_balls_) {
        for (std::size_t i = 0; i < count; ++i)
            left_.add(points, first, i);
        return;
    }
    transport::ShadowReceivers receivers;
    for (std::size_t axis = 0; axis < 3; ++axis)
        receivers.position[axis] = points.numbers(axis) + first;
    receivers.count = count;
    kernels_for(count).near_bodies(lined_, numbers_.data(), numbers_.size(), receivers, near_.data());
    behind_.clear();
    for (std::size_t i = 0; i < count; ++i)
        if (near_[i] >= 0.0) add_behind(points, first, i, near_[i]);
    find_past_balls();
    for (std::size_t i = 0; i < count; ++i) {
        const double share = past_ball_[i];
        if (near_[i] == NearBodies::none) continue;
        if (share >= 0.0 && (!is_glossy || share == 0.0 || share == 1.0))
            shares_[first + i] = {share, glm::vec3(static_cast<float>(share))};
        else
            left_.add(points, first, i);
    }
}

void SoftShadow::add_behind(const ShadowPoints& points, std::size_t first, std::size_t i, double body) {
    const ShadowBody& ball = numbers_[static_cast<std::size_t>(body)];
    if (ball.kind != ShadowBody::Kind::ball) return;
    for (std::size_t axis = 0; axis < 3; ++axis)
        middle_[axis][behind_.count] = ball.middle[axis];
    radius_[behind_.count] = ball.radius;
    behind_.add(points, first, i);
}

void SoftShadow::find_past_balls() {
    if (behind_.count == 0) return;
    transport::ReceiversBehindBalls receivers;
    receivers.receivers = behind_.receivers();
    for (std::size_t axis = 0; axis < 3; ++axis)
        receivers.middle[axis] = middle_[axis].data();
    receivers.radius = radius_.data();
    std::array<double, block> share;
    kernels_for(behind_.count).share_past_balls(lined_, receivers, share.data());
    for (std::size_t k = 0; k < behind_.count; ++k)
        past_ball_[behind_.index[k]] = share[k];
}

void SoftShadow::find_cells_of(std::size_t k, const glm::dvec3& point) {
    constexpr std::size_t all = ShadowShares::cells * cell_stride;
    for (std::size_t cell = 0; cell < ShadowShares::cells; ++cell) {
        const float* const at = cells_.data() + cell * cell_stride + k;
        seen_[cell] = at[0];
        light_of_[cell] = at[all];
        for (std::size_t axis = 0; axis < 3; ++axis)
            towards_[axis][cell] = at[(2 + axis) * all];
    }
    if (!light_->luminance) return;
    OfCells luminance;
    light_->luminance->towards(point, {{towards_[0].data(), towards_[1].data(), towards_[2].data()}, luminance.size()},
                               scene_.intensity, luminance.data());
    for (std::size_t cell = 0; cell < ShadowShares::cells; ++cell)
        light_of_[cell] *= luminance[cell];
}

// The share of the illuminance of a light whose luminance is not the same everywhere.
double SoftShadow::integrated(const glm::dvec3& normal) const {
    const glm::vec3 n(normal);
    float all = 0.0F;
    float seen = 0.0F;
    float all_above = 0.0F;
    float seen_above = 0.0F;
    for (std::size_t cell = 0; cell < ShadowShares::cells; ++cell) {
        const float cosine = n.x * towards_[0][cell] + n.y * towards_[1][cell] + n.z * towards_[2][cell];
        const float weight = light_of_[cell] * std::max(cosine, 0.0F);
        all += light_of_[cell];
        seen += light_of_[cell] * seen_[cell];
        all_above += weight;
        seen_above += weight * seen_[cell];
    }
    if (all_above > 0.0F) return std::min(static_cast<double>(seen_above) / static_cast<double>(all_above), 1.0);
    // A sliver above the horizon that contains no cell's middle.
    return all > 0.0F ? std::min(static_cast<double>(seen) / static_cast<double>(all), 1.0) : 1.0;
}

// A uniform sphere light behind a sphere or a capsule: the light wholly above the horizon, the occluder in front of it.
std::optional<double> SoftShadow::closed_form(const Primitive& body, const glm::dvec3& point,
                                              const glm::dvec3& normal) const {
    const auto* const light = light_->luminance ? nullptr : std::get_if<SphereShape>(&light_->light.shape);
    const auto* const ball = std::get_if<Ball>(&body);
    const auto* const capsule = std::get_if<Capsule>(&body);
    if (light == nullptr || (ball == nullptr && capsule == nullptr) || hides(body, point)) return std::nullopt;
    const glm::dvec3 to_light = light_->reach.center - point;
    const double light_distance = glm::length(to_light);
    const double sine = light->radius.value / light_distance;
    const double cosine = glm::dot(normal, to_light) / light_distance;
    const double nearest = light_distance - light->radius.value;
    if (!(cosine >= sine)) return std::nullopt;
    double hidden = 0.0;
    if (ball != nullptr) {
        const glm::dvec3 to_ball = ball->center - point;
        const double ball_distance = glm::length(to_ball);
        if (ball_distance + ball->radius > nearest) return std::nullopt;
        hidden = projected_cap_overlap(to_light / light_distance, std::asin(sine), to_ball / ball_distance,
                                       std::asin(ball->radius / ball_distance), normal);
    } else {
        Capsule seen = *capsule;
        seen.center -= point;
        const glm::dvec3 half = seen.half_length * seen.axis;
        if (std::max(glm::length(seen.center - half), glm::length(seen.center + half)) + seen.radius > nearest)
            return std::nullopt;
        hidden = projected_capsule_overlap(to_light / light_distance, std::asin(sine), seen, normal);
    }
    return std::clamp(1.0 - hidden / (std::numbers::pi * sine * sine * cosine), 0.0, 1.0);
}

glm::vec3 SoftShadow::visible_luminance(std::size_t own, const glm::dvec3& point, const glm::dvec3& normal,
                                        const glm::dvec3& view, double share, double by_lines) const {
    const CoreMaterial& material = scene_.core_materials[own];
    // In the frame of the surface, whose normal is z.
    constexpr std::size_t count = ShadowShares::cells;
    Frame frame = frame_about(point, normal);
    if (is_anisotropic(material)) {
        // Tangents of scenes are level, and X where the normal is Z.
        frame.x = vec(grain_of(0.0).along(vec(normal)));
        frame.y = glm::cross(frame.z, frame.x);
    }
    const glm::vec3 to_eye(frame.to_local(view));
    std::array<OfCells, 3> lights;
    std::array<OfCells, 3> eyes;
    std::array<OfCells, 3> reflectance;
    const std::array<glm::vec3, 3> axes{glm::vec3(frame.x), glm::vec3(frame.y), glm::vec3(frame.z)};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t cell = 0; cell < count; ++cell)
            lights[axis][cell] =
                axes[axis].x * towards_[0][cell] + axes[axis].y * towards_[1][cell] + axes[axis].z * towards_[2][cell];
        eyes[axis].fill(to_eye[static_cast<int>(axis)]);
    }
    float* const rgb[3] = {reflectance[0].data(), reflectance[1].data(), reflectance[2].data()};
    reflectance_.brdf({{lights[0].data(), lights[1].data(), lights[2].data()},
                       {eyes[0].data(), eyes[1].data(), eyes[2].data()},
                       count},
                      scene_.materials[own], rgb);
    glm::vec3 all(0.0F);
    glm::vec3 seen(0.0F);
    for (std::size_t cell = 0; cell < count; ++cell) {
        const float light = light_of_[cell] * std::max(lights[2][cell], 0.0F);
        const glm::vec3 value = light * glm::vec3(reflectance[0][cell], reflectance[1][cell], reflectance[2][cell]);
        all += value;
        seen += value * seen_[cell];
    }
    // If the illuminance has a closed form, its ratio to the lines corrects the luminance too.
    const double mended = by_lines > 0.0 ? share / by_lines : 1.0;
    glm::vec3 shares(static_cast<float>(share));
    for (int channel = 0; channel < 3; ++channel)
        if (all[channel] > 0.0F)
            shares[channel] =
                static_cast<float>(std::clamp(mended * static_cast<double>(seen[channel] / all[channel]), 0.0, 1.0));
    return shares;
}

} // namespace gonio::detail
