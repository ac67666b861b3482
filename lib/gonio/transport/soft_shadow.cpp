#include <gonio/scene/capsule_overlap.hpp>
#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/material_description.hpp>
#include <gonio/scene/occlusion.hpp>
#include <gonio/scene/shadow_line.hpp>
#include <gonio/transport/ray_bundle.hpp>
#include <gonio/transport/soft_shadow.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <variant>

namespace gonio::detail {

namespace {

// The visible parts of a line, by the sine of the elevation: disjoint pieces in order.
class SeenPieces {
public:
    SeenPieces(double low, double high) { pieces_[count_++] = {low, high}; }

    bool empty() const { return count_ == 0; }

    void hide(double low, double high) {
        const auto keep = [&](double from, double to) {
            if (from < to && count_ < most) pieces_[count_++] = {from, to};
        };
        const auto cut = [&](const Piece& piece) {
            keep(piece.low, std::min(piece.high, low));
            keep(std::max(piece.low, high), piece.high);
        };
        if (count_ == 1) { // nearly always
            count_ = 0;
            return cut(Piece(pieces_[0]));
        }
        const std::array<Piece, most> before = pieces_;
        for (std::size_t i = 0, count = std::exchange(count_, 0); i < count; ++i)
            cut(before[i]);
    }

    double within(double low, double high) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < count_; ++i)
            sum += std::max(std::min(pieces_[i].high, high) - std::max(pieces_[i].low, low), 0.0);
        return sum;
    }

private:
    struct Piece {
        double low = 0.0;
        double high = 0.0;
    };
    static constexpr std::size_t most = 16; // for a line behind a fence, any further pieces are dropped

    std::array<Piece, most> pieces_{};
    std::size_t count_ = 0;
};

double cell_middle(const LightLine& line, std::size_t cell, std::size_t cells) {
    return line.low + (line.high - line.low) * (static_cast<double>(cell) + 0.5) / static_cast<double>(cells);
}

// A direction across an edge, rotated a little: other edges are often perpendicular to this one, and lines parallel to
// an edge are either wholly hidden or not at all.
glm::dvec3 across(const ShadowEdge& edge, const glm::dvec3& towards) {
    constexpr double turn = 0.6; // tangent of the angle
    const glm::dvec3 straight = edge.across - glm::dot(edge.across, towards) * towards;
    return straight + turn * glm::cross(towards, straight);
}

} // namespace

SoftShadow::SoftShadow(const LitScene& scene)
    : scene_(scene), reflectance_(shading::reflectance_kernels(scene.options.instruction_set)) {}

void SoftShadow::begin(const LitLight& light) {
    light_ = &light;
    bodies_.resize(scene_.stage.surfaces.size());
    for (std::vector<std::uint32_t>& bodies : bodies_)
        bodies.clear();
}

double SoftShadow::visible(std::size_t own, const glm::dvec3& point, const glm::dvec3& normal) {
    own_ = own;
    point_ = point;
    normal_ = normal;
    share_ = 1.0;
    by_lines_ = 1.0;
    near_.clear();
    const Ball light{light_->reach.center, light_->reach.body_radius};
    const glm::dvec3 to_light = light.center - point;
    const double distance = glm::length(to_light);
    if (!(distance > 0.0)) return share_;
    const glm::dvec3 towards = to_light / distance;
    // Near a wide light, its bounding sphere is all around.
    const double half_angle = distance > light.radius ? std::asin(light.radius / distance) : std::numbers::pi;
    ShadowEdge nearest;
    for (const std::uint32_t i : bodies_[own]) {
        const Primitive& body = scene_.stage.surfaces[i].geometry;
        if (!may_stand_between(body, scene_.body_bounds[i], {point, 0.0}, light)) continue;
        const ShadowEdge edge = nearest_edge(body, point, towards);
        // Skips a solid beside the light that does not overlap it. One without an edge in front of the light may also
        // cover all of it, so the ray to the middle is tested.
        if (edge.distance > half_angle * (1.0 + 1e-9) && is_apart(body, light) &&
            !stops(body, {point, towards}, distance))
            continue;
        near_.push_back(&body);
        if (std::abs(edge.distance) < std::abs(nearest.distance)) nearest = edge;
    }
    if (near_.empty()) return share_;
    lines_ = light_lines(light_->light, point, across(nearest, towards));
    if (lines_.count == 0) return share_;
    find_hidden();
    const auto is = [&](double share) {
        return std::all_of(seen_.begin(), seen_.end(), [&](double seen) { return seen == share; });
    };
    if (is(1.0)) return share_;
    find_light_of_cells();
    by_lines_ = is(0.0) ? 0.0 : integrated();
    const std::optional<double> exact = near_.size() == 1 ? closed_form(*near_.front()) : std::nullopt;
    share_ = exact.value_or(by_lines_);
    return share_;
}

void SoftShadow::find_hidden() {
    std::array<LightLineSeen, light_line_count> seen_lines;
    std::array<HiddenPiece, light_line_count> pieces;
    for (std::size_t i = 0; i < lines_.count; ++i)
        seen_lines[i] = LightLineSeen(lines_.lines[i].from, lines_.lines[i].to);
    hidden_.clear();
    for (const Primitive* const body : near_) {
        hidden_pieces(*body, point_, std::span(seen_lines).first(lines_.count), pieces);
        hidden_.push_back(pieces);
    }
    for (std::size_t i = 0; i < lines_.count; ++i) {
        const LightLine& line = lines_.lines[i];
        SeenPieces seen(line.low, line.high);
        bool whole = true;
        for (const auto& of_body : hidden_) {
            const HiddenPiece& piece = of_body[i];
            if (piece.empty()) continue;
            whole = false;
            const auto sine_at = [&](double t) {
                return t <= 0.0   ? line.low
                       : t >= 1.0 ? line.high
                                  : lines_.sine_of(line.from + t * (line.to - line.from));
            };
            seen.hide(sine_at(piece.low), sine_at(piece.high));
        }
        const double width = (line.high - line.low) / static_cast<double>(cell_count);
        for (std::size_t cell = 0; cell < cell_count; ++cell) {
            const double low = line.low + width * static_cast<double>(cell);
            double share = whole ? 1.0 : 0.0;
            if (!whole && !seen.empty() && width > 0.0) share = std::min(seen.within(low, low + width) / width, 1.0);
            seen_[i * cell_count + cell] = share;
        }
    }
}

// Of the light towards the point from a unit direction, over its mean.
double SoftShadow::luminance_from(const glm::dvec3& direction) const {
    return light_->luminance ? light_->luminance->towards(point_, direction) : 1.0;
}

void SoftShadow::find_light_of_cells() {
    for (std::size_t i = 0; i < lines_.count; ++i) {
        const LightLine& line = lines_.lines[i];
        const double solid_angle = line.turn * (line.high - line.low);
        for (std::size_t cell = i * cell_count; cell < (i + 1) * cell_count; ++cell) {
            towards_[cell] = lines_.direction(line, cell_middle(line, cell % cell_count, cell_count));
            light_of_[cell] = solid_angle * luminance_from(towards_[cell]);
        }
    }
}

// The share of the illuminance that the lines let through.
double SoftShadow::integrated() const {
    double all = 0.0;
    double seen = 0.0;
    double all_above = 0.0;
    double seen_above = 0.0;
    for (std::size_t cell = 0; cell < lines_.count * cell_count; ++cell) {
        const LightLine& line = lines_.lines[cell / cell_count];
        const double solid_angle = line.turn * (line.high - line.low);
        const double weight = light_of_[cell] * std::max(glm::dot(normal_, towards_[cell]), 0.0);
        all += solid_angle;
        seen += solid_angle * seen_[cell];
        all_above += weight;
        seen_above += weight * seen_[cell];
    }
    if (all_above > 0.0) return std::min(seen_above / all_above, 1.0);
    return all > 0.0 ? std::min(seen / all, 1.0) : 1.0; // a sliver above the horizon that contains no cell's middle
}

// A uniform sphere light behind a sphere or a capsule: the light wholly above the horizon, the occluder in front of it.
std::optional<double> SoftShadow::closed_form(const Primitive& body) const {
    const auto* const light = light_->luminance ? nullptr : std::get_if<SphereShape>(&light_->light.shape);
    const auto* const ball = std::get_if<Ball>(&body);
    const auto* const capsule = std::get_if<Capsule>(&body);
    if (light == nullptr || (ball == nullptr && capsule == nullptr) || hides(body, point_)) return std::nullopt;
    const glm::dvec3 to_light = light_->reach.center - point_;
    const double light_distance = glm::length(to_light);
    const double sine = light->radius.value / light_distance;
    const double cosine = glm::dot(normal_, to_light) / light_distance;
    const double nearest = light_distance - light->radius.value;
    if (!(cosine >= sine)) return std::nullopt;
    double hidden = 0.0;
    if (ball != nullptr) {
        const glm::dvec3 to_ball = ball->center - point_;
        const double ball_distance = glm::length(to_ball);
        if (ball_distance + ball->radius > nearest) return std::nullopt;
        hidden = projected_cap_overlap(to_light / light_distance, std::asin(sine), to_ball / ball_distance,
                                       std::asin(ball->radius / ball_distance), normal_);
    } else {
        Capsule seen = *capsule;
        seen.center -= point_;
        const glm::dvec3 half = seen.half_length * seen.axis;
        if (std::max(glm::length(seen.center - half), glm::length(seen.center + half)) + seen.radius > nearest)
            return std::nullopt;
        hidden = projected_capsule_overlap(to_light / light_distance, std::asin(sine), seen, normal_);
    }
    return std::clamp(1.0 - hidden / (std::numbers::pi * sine * sine * cosine), 0.0, 1.0);
}

glm::vec3 SoftShadow::visible_luminance(const glm::dvec3& view) const {
    const auto grey = glm::vec3(static_cast<float>(share_));
    const CoreMaterial& material = scene_.core_materials[own_];
    if (share_ == 0.0 || share_ == 1.0 || std::holds_alternative<shading::Lambert<double>>(material)) return grey;
    // In the frame of the surface, whose normal is z.
    constexpr std::size_t most = light_line_count * cell_count;
    const std::size_t count = lines_.count * cell_count;
    Frame frame = frame_about(point_, normal_);
    if (is_anisotropic(material)) {
        // Tangents of scenes are level, and X where the normal is Z.
        frame.x = vec(grain_of(0.0).along(vec(normal_)));
        frame.y = glm::cross(frame.z, frame.x);
    }
    const glm::dvec3 to_eye = frame.to_local(view);
    std::array<std::array<float, most>, 3> lights{};
    std::array<std::array<float, most>, 3> eyes{};
    std::array<std::array<float, most>, 3> reflectance{};
    for (std::size_t cell = 0; cell < count; ++cell) {
        const glm::dvec3 to_light = frame.to_local(towards_[cell]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lights[axis][cell] = static_cast<float>(to_light[static_cast<int>(axis)]);
            eyes[axis][cell] = static_cast<float>(to_eye[static_cast<int>(axis)]);
        }
    }
    float* const rgb[3] = {reflectance[0].data(), reflectance[1].data(), reflectance[2].data()};
    reflectance_.brdf({{lights[0].data(), lights[1].data(), lights[2].data()},
                       {eyes[0].data(), eyes[1].data(), eyes[2].data()},
                       count},
                      scene_.materials[own_], rgb);
    glm::dvec3 all(0.0);
    glm::dvec3 seen(0.0);
    for (std::size_t cell = 0; cell < count; ++cell) {
        const double light = light_of_[cell] * std::max(static_cast<double>(lights[2][cell]), 0.0);
        const glm::dvec3 value = light * glm::dvec3(reflectance[0][cell], reflectance[1][cell], reflectance[2][cell]);
        all += value;
        seen += value * seen_[cell];
    }
    // If the illuminance has a closed form, its ratio to the lines corrects the luminance too.
    const double mended = by_lines_ > 0.0 ? share_ / by_lines_ : 1.0;
    glm::vec3 shares = grey;
    for (int channel = 0; channel < 3; ++channel)
        if (all[channel] > 0.0)
            shares[channel] = static_cast<float>(std::clamp(mended * seen[channel] / all[channel], 0.0, 1.0));
    return shares;
}

} // namespace gonio::detail
