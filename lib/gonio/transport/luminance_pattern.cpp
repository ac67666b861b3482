#include <gonio/light/light_image.hpp>
#include <gonio/light/luminaire.hpp>
#include <gonio/light/luminances.hpp>
#include <gonio/light/shape_traits.hpp>
#include <gonio/transport/luminance_pattern.hpp>
#include <gonio/web/web.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <variant>

namespace gonio::detail {

namespace {

constexpr double pi = std::numbers::pi;

void copy(const glm::dvec3& from, float (&to)[3]) {
    for (int i = 0; i < 3; ++i)
        to[i] = static_cast<float>(from[i]);
}

// `side`: −1 turns all directions round.
transport::LightFrame axes_of(const Frame& frame, const glm::dvec3& origin, double side = 1.0) {
    transport::LightFrame axes;
    copy(origin, axes.origin);
    copy(side * frame.x, axes.x);
    copy(side * frame.y, axes.y);
    copy(side * frame.z, axes.z);
    return axes;
}

// The typical step of the web's angles [deg].
double web_step_deg(const Web& web) {
    const std::span<const double> angles = web.vertical_deg();
    if (angles.size() < 2) return 5.0;
    return (angles.back() - angles.front()) / static_cast<double>(angles.size() - 1);
}

// Half of the extent along X and Y.
struct Outline {
    double half_x = 0.0;
    double half_y = 0.0;
    bool is_round = false;
    bool two_sided = false;
};

struct OutlineOf {
    Outline operator()(const RectShape& rect) const {
        return {0.5 * rect.width.value, 0.5 * rect.height.value, false, rect.two_sided};
    }
    Outline operator()(const DiskShape& disk) const {
        return {disk.radius.value, disk.radius.value, true, disk.two_sided};
    }
    Outline operator()(const EllipseShape& ellipse) const {
        return {0.5 * ellipse.width.value, 0.5 * ellipse.height.value, true, ellipse.two_sided};
    }
    template<class Kind>
    Outline operator()(const Kind& /*not flat*/) const {
        return {};
    }
};

// Where the ray meets the plane of a light, along its X and Y; one that runs along the plane or away from it meets it
// far outside. `from` and `along`: in the light's frame.
glm::dvec2 meeting(const glm::dvec3& from, const glm::dvec3& along) {
    constexpr double least_slope = 1e-3;
    const double slope = std::max(-std::copysign(1.0, from.z) * along.z, least_slope);
    return glm::dvec2(from) + std::abs(from.z) / slope * glm::dvec2(along);
}

// Directions in which receivers see a round light, weighted by its irradiance.
struct Directions {
    std::array<std::vector<float>, 3> towards; // from the light to the receiver
    std::vector<double> weight;
    std::vector<std::size_t> receiver;

    void begin(std::size_t of_receiver, const glm::dvec3& its_normal) {
        current = of_receiver;
        normal = its_normal;
    }
    // `to_light` of any length; nothing below the horizon.
    void add(const glm::dvec3& to_light, double solid_angle) {
        const double cosine = glm::dot(normal, to_light);
        if (!(cosine > 0.0)) return;
        for (int axis = 0; axis < 3; ++axis)
            towards.at(static_cast<std::size_t>(axis)).push_back(static_cast<float>(-to_light[axis]));
        weight.push_back(solid_angle * cosine / glm::length(to_light));
        receiver.push_back(current);
    }

    std::size_t current = 0;
    glm::dvec3 normal{0.0};
};

constexpr double most_nodes = 64.0;

// Nodes of equal solid angle on a spiral of the golden angle over the cap that the sphere covers.
void add_sphere(const glm::dvec3& to_center, double radius_m, double node_rad, Directions& to) {
    const double distance = glm::length(to_center);
    if (!(distance > radius_m)) return to.add(to_center, 1.0);
    const double half_angle = std::asin(radius_m / distance);
    const double across = half_angle / node_rad;
    const auto count = static_cast<int>(std::clamp(std::ceil(4.0 * across * across), 1.0, most_nodes));
    const glm::dvec3 axis = to_center / distance;
    const glm::dvec3 seed = std::abs(axis.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(glm::cross(axis, seed));
    const glm::dvec3 y = glm::cross(axis, x);
    constexpr double golden_angle = 2.399963229728653;
    for (int i = 0; i < count; ++i) {
        const double cosine = 1.0 - (1.0 - std::cos(half_angle)) * (i + 0.5) / count;
        const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
        to.add(cosine * axis + sine * std::cos(golden_angle * i) * x + sine * std::sin(golden_angle * i) * y, 1.0);
    }
}

// Nodes on the axis of the tube, uniform in the angle at which the receiver sees them.
void add_tube(const glm::dvec3& to_center, const glm::dvec3& axis, double length_m, double node_rad, Directions& to) {
    const double along = glm::dot(to_center, axis);
    const glm::dvec3 across = to_center - along * axis;
    const double distance = std::max(glm::length(across), 1e-6 * length_m);
    const double first = std::atan2(along - 0.5 * length_m, distance);
    const double last = std::atan2(along + 0.5 * length_m, distance);
    const auto count = static_cast<int>(std::clamp(std::ceil((last - first) / node_rad), 1.0, most_nodes));
    for (int i = 0; i < count; ++i) {
        const double psi = first + (last - first) * (i + 0.5) / count;
        to.add(across + distance * std::tan(psi) * axis, std::cos(psi));
    }
}

// a²/(a² + b²).
double square_share(double a, double b) {
    return a * a / (a * a + b * b);
}

// The frame with the columns along Y; for the far side, that of a light which emits there.
Frame column_frame(const Frame& light, bool columns_along_y, bool behind) {
    Frame frame = light;
    if (behind) {
        frame.y = -light.y;
        frame.z = -light.z;
    }
    if (columns_along_y) return frame;
    return {frame.origin, -frame.y, frame.x, frame.z};
}

} // namespace

ColumnPattern::ColumnPattern(const Light& light, bool columns_along_y, bool behind, double step_deg)
    : count_(static_cast<std::size_t>(std::ceil(180.0 / step_deg)) + 1),
      step_rad_(pi / static_cast<double>(count_ - 1)),
      nodes_(count_ * count_ * 4) {
    LuminanceShares luminances(light);
    const Frame frame = column_frame(light.frame, columns_along_y, behind);
    const glm::dvec3 x = luminances.frame().to_local(frame.x);
    const glm::dvec3 y = luminances.frame().to_local(frame.y);
    const glm::dvec3 z = luminances.frame().to_local(frame.z);
    // At 90° itself an opening has no luminance, only the limit of it.
    constexpr double most = 0.5 * pi - 1e-4;
    const auto angle = [&](std::size_t i) {
        return std::clamp(static_cast<double>(i) * step_rad_ - 0.5 * pi, -most, most);
    };
    std::vector<double> sine_psi(count_);
    std::vector<double> cosine_psi(count_);
    for (std::size_t node = 0; node < count_; ++node) {
        sine_psi[node] = std::sin(angle(node));
        cosine_psi[node] = std::cos(angle(node));
    }
    std::array<std::vector<double>, 3> towards;
    for (std::vector<double>& axis : towards)
        axis.resize(count_);
    std::vector<double> luminance(count_);
    for (std::size_t row = 0; row < count_; ++row) {
        const double cosine_phi = std::cos(angle(row));
        const glm::dvec3 across = -std::sin(angle(row)) * x - cosine_phi * z;
        for (std::size_t node = 0; node < count_; ++node) {
            const glm::dvec3 direction = cosine_psi[node] * across - sine_psi[node] * y;
            for (int axis = 0; axis < 3; ++axis)
                towards.at(static_cast<std::size_t>(axis))[node] = direction[axis];
        }
        luminances.along(towards[0], towards[1], towards[2], luminance);
        double cosine_sum = 0.0;
        double sine_sum = 0.0;
        double before_cosine = 0.0;
        double before_sine = 0.0;
        for (std::size_t node = 0; node < count_; ++node) {
            const double t = luminance[node] * cosine_phi * cosine_psi[node];
            const double cosine = t * cosine_psi[node];
            const double sine = t * sine_psi[node];
            if (node > 0) {
                cosine_sum += 0.5 * step_rad_ * (before_cosine + cosine);
                sine_sum += 0.5 * step_rad_ * (before_sine + sine);
            }
            float* const to = nodes_.data() + 4 * (row * count_ + node);
            to[0] = static_cast<float>(cosine_sum);
            to[1] = static_cast<float>(cosine);
            to[2] = static_cast<float>(sine_sum);
            to[3] = static_cast<float>(sine);
            before_cosine = cosine;
            before_sine = sine;
        }
    }
}

transport::ColumnTable ColumnPattern::constants() const {
    return {nodes_.data(), count_, static_cast<float>(step_rad_)};
}

LuminancePattern::LuminancePattern(const Light& light, LuminanceTables& tables, WebTables& webs) : light_(light) {
    if (light.image != nullptr) {
        const auto& rect = std::get<RectShape>(light.shape);
        std::shared_ptr<const ImagePattern>& made =
            tables.images[{light.image.get(), rect.width.value, rect.height.value}];
        if (made == nullptr) made = std::make_shared<const ImagePattern>(rect, *light.image);
        image_ = made;
        return;
    }
    const Web& web = *luminance_web(light);
    const double web_deg = web_step_deg(web);
    std::shared_ptr<const WebTable>& table = webs[&web];
    if (table == nullptr) table = std::make_shared<const WebTable>(web);
    web_ = table;
    std::shared_ptr<const WebVariation>& variation = tables.variations[&web];
    if (variation == nullptr) variation = std::make_shared<const WebVariation>(web);
    variation_ = variation;
    if (light.emission != nullptr) add_faces(*light.emission);
    if (!is_flat(light.shape)) {
        node_rad_ = degrees(std::clamp(web_deg, 2.0, 10.0)).value;
        return;
    }
    const Outline outline = std::visit(OutlineOf(), light.shape);
    columns_along_y_ = outline.half_y >= outline.half_x;
    column_rad_ = degrees(std::clamp(1.25 * web_deg, 2.5, 6.0)).value;
    const double step_deg = std::clamp(0.25 * web_deg, 0.5, 1.0);
    const void* const source = light.emission != nullptr ? static_cast<const void*>(light.emission->body.get()) : &web;
    const std::size_t face = light.emission != nullptr ? light.emission->face : 0;
    const auto pattern = [&](bool behind) {
        std::shared_ptr<const ColumnPattern>& made = tables.columns[{source, face, columns_along_y_, behind}];
        if (made == nullptr) made = std::make_shared<const ColumnPattern>(light, columns_along_y_, behind, step_deg);
        return made;
    };
    front_ = pattern(false);
    if (outline.two_sided) back_ = pattern(true);
}

void LuminancePattern::by_columns(const transport::Receivers& receivers, const glm::dvec3& anchor,
                                  const transport::LuminanceKernels& kernels, float* share) const {
    const Outline outline = std::visit(OutlineOf(), light_.shape);
    for (const bool behind : {false, true}) {
        const std::shared_ptr<const ColumnPattern>& pattern = behind ? back_ : front_;
        if (pattern == nullptr) continue;
        const Frame frame = column_frame(light_.frame, columns_along_y_, behind);
        transport::ColumnLight light;
        copy(light_.frame.origin - anchor, light.origin);
        copy(frame.x, light.x);
        copy(frame.y, light.y);
        copy(frame.z, light.z);
        light.half_x = static_cast<float>(columns_along_y_ ? outline.half_x : outline.half_y);
        light.half_y = static_cast<float>(columns_along_y_ ? outline.half_y : outline.half_x);
        light.is_round = outline.is_round;
        light.column_rad = static_cast<float>(column_rad_);
        light.table = pattern->constants();
        kernels.columns(receivers, light, share);
    }
}

// From farther away the outline has no digits left in floats, and one direction is enough.
void LuminancePattern::replace_far(const transport::Receivers& receivers, const glm::dvec3& anchor,
                                   float* share) const {
    const Outline outline = std::visit(OutlineOf(), light_.shape);
    constexpr double farthest = 1e4; // in radii
    const double far_m = farthest * std::hypot(outline.half_x, outline.half_y);
    for (std::size_t i = 0; i < receivers.count; ++i) {
        const glm::dvec3 at(receivers.position[0][i], receivers.position[1][i], receivers.position[2][i]);
        const glm::dvec3 towards = anchor + at - light_.frame.origin;
        if (glm::dot(towards, towards) > far_m * far_m) share[i] = static_cast<float>(light_.luminance_share(towards));
    }
}

void LuminancePattern::evaluate(const transport::Receivers& receivers, const glm::dvec3& anchor,
                                const transport::LuminanceKernels& columns,
                                const transport::IntensityKernels& intensity, std::vector<float>& share) const {
    share.assign(receivers.count, 0.0F);
    if (image_ == nullptr && front_ == nullptr) return by_directions(receivers, anchor, intensity, share);
    if (image_ != nullptr)
        image_->evaluate(light_, receivers, anchor, columns, share.data());
    else
        by_columns(receivers, anchor, columns, share.data());
    replace_far(receivers, anchor, share.data());
}

void LuminancePattern::towards(const glm::dvec3& receiver, const transport::Points& directions,
                               const transport::IntensityKernels& intensity, float* share) const {
    if (image_ == nullptr) return towards_points(directions, -1.0, intensity, share);
    constexpr double blur = 1.0 / 12.0; // of a side: shadows look along 8 lines of 4 cells each
    for (std::size_t i = 0; i < directions.count; ++i) {
        const auto axis = [&](std::size_t of) { return static_cast<double>(directions.position[of][i]); };
        share[i] = static_cast<float>(blurred(receiver, {axis(0), axis(1), axis(2)}, glm::dvec2(blur)));
    }
}

// The mean of the image over a rectangle around the place that the ray meets, which is moved onto the light.
double LuminancePattern::blurred(const glm::dvec3& viewer, const glm::dvec3& toward, const glm::dvec2& half) const {
    const Frame& frame = light_.frame;
    const glm::dvec2 met = meeting(frame.to_local(viewer - frame.origin), frame.to_local(toward));
    const glm::dvec2 at = glm::clamp(place_on(std::get<RectShape>(light_.shape), met.x, met.y), 0.0, 1.0);
    return light_.image->mean(at - half, at + half);
}

void LuminancePattern::by_directions(const transport::Receivers& receivers, const glm::dvec3& anchor,
                                     const transport::IntensityKernels& kernels, std::vector<float>& share) const {
    Directions found;
    for (std::size_t i = 0; i < receivers.count; ++i) {
        const auto vector = [&](const float* const(&of)[3]) { return glm::dvec3(of[0][i], of[1][i], of[2][i]); };
        const glm::dvec3 to_center = light_.frame.origin - anchor - vector(receivers.position);
        found.begin(i, vector(receivers.normal));
        if (const auto* const sphere = std::get_if<SphereShape>(&light_.shape))
            add_sphere(to_center, sphere->radius.value, node_rad_, found);
        else if (const auto* const tube = std::get_if<TubeShape>(&light_.shape))
            add_tube(to_center, light_.frame.x, tube->length.value, node_rad_, found);
        else if (const auto* const cylinder = std::get_if<CylinderShape>(&light_.shape))
            add_tube(to_center, light_.frame.x, cylinder->length.value, node_rad_, found);
        else
            found.add(to_center, 1.0);
    }
    // A sphere has the same projected area in all directions.
    const double scale = light_.emission != nullptr
                             ? light_.web_scale / light_.emission->body->projected_area_m2({0.0, 0.0, -1.0})
                             : light_.web_scale;
    std::vector<float> values(found.weight.size(), 1.0F);
    kernels.web({{found.towards[0].data(), found.towards[1].data(), found.towards[2].data()}, values.size()},
                axes_of(luminance_frame(light_), glm::dvec3(0.0)), web_->constants(scale), values.data());
    std::vector<double> sums(receivers.count, 0.0);
    std::vector<double> weights(receivers.count, 0.0);
    for (std::size_t k = 0; k < values.size(); ++k) {
        sums[found.receiver[k]] += found.weight[k] * static_cast<double>(values[k]);
        weights[found.receiver[k]] += found.weight[k];
    }
    for (std::size_t i = 0; i < receivers.count; ++i)
        share[i] = weights[i] > 0.0 ? static_cast<float>(sums[i] / weights[i]) : 0.0F;
}

void LuminancePattern::add_faces(const FaceEmission& emission) {
    for (const LuminousFace& face : emission.body->faces()) {
        if (!face.is_flat) {
            round_m2_ += static_cast<float>(0.25 * face.area_m2);
            continue;
        }
        const glm::dvec3 normal = face.area_m2 * emission.luminaire.to_world(face.normal);
        for (int axis = 0; axis < 3; ++axis)
            face_normals_.at(static_cast<std::size_t>(axis)).push_back(static_cast<float>(normal[axis]));
    }
}

void LuminancePattern::towards_points(const transport::Points& points, double side,
                                      const transport::IntensityKernels& kernels, float* share) const {
    std::fill(share, share + points.count, 1.0F);
    kernels.web(points, axes_of(luminance_frame(light_), glm::dvec3(0.0), side), web_->constants(light_.web_scale),
                share);
    if (light_.emission == nullptr) return;
    const transport::BodyFaces faces{{face_normals_[0].data(), face_normals_[1].data(), face_normals_[2].data()},
                                     face_normals_[0].size(),
                                     round_m2_};
    kernels.per_projected_area(points, static_cast<float>(side), faces, share);
}

void LuminancePattern::candela(const transport::Points& points, const glm::dvec3& anchor,
                               const transport::IntensityKernels& intensity, float* cd) const {
    std::fill(cd, cd + points.count, 1.0F);
    intensity.web(points, axes_of(luminance_frame(light_), light_.frame.origin - anchor),
                  web_->constants(light_.web_scale), cd);
}

// L(x) is the luminance by place, x a place of the light within its radius r of the centre; ω the direction from the
// centre to the receiver, at the distance d, and ω_x that from x, at d_x. With ρ = r/d, the angle η between ω and ω_x
// is at most asin ρ, and |d_x − d| ≤ r. S, J and Q are those of the web (web_variation.hpp).
//
// Of a place. A flat opening of area A has L(x) = I(ω_x)/(A cosγ_x), and b = d_x cosγ_x, the height of the receiver
// over its plane, is the same from every place: L(x) = I(ω_x) d_x/(A b), hence
//
//   |L(x) − L(0)| ≤ ((I + Sη)(1 + ρ) − I) d/(A b).
//
// The projected area P of a body with more than one plane changes by at most ηΣ, with Σ the area of its faces:
//
//   |L(x) − L(0)| ≤ (I + Sη)/(P − ηΣ) − I/P.
//
// Behind a mask L(x) is proportional to the web: |L(x) − L(0)| ≤ Sη. Every mean of L over the light is as near to L(0).
//
// Of the mean over a flat light, in which the first order cancels between x and −x. The angles of the two differ by at
// most ρ²/(1 − ρ²), and 2d ≤ d_x + d_−x ≤ (2 + ρ²)d, so that
//
//   |I(ω_x) + I(ω_−x) − 2I| ≤ ηJ + η²Q + Sρ²/(1 − ρ²) = c,
//   |L(x) + L(−x) − 2L(0)| ≤ C = (c + Iρ² + 2Sηρ) d/(A b), or c behind a mask.
//
// The weight of a place is n·(x − p) b/d_x⁴, as long as the light is above the horizon: ρ < cosθ. It differs from that
// of the centre by at most the part w = (1 + ρ/cosθ)(1 − ρ)⁻⁴ − 1. With e the bound of a place, a pair adds at most
// C + 2we, and the weights of a pair are at least 2(1 − w) times that of the centre:
//
//   |mean − L(0)| ≤ (C/2 + we)/(1 − w).
//
// A lobe takes the mean plus `narrow` times the difference of a place from it (along_lobes()).
void LuminancePattern::from_center(const transport::Receivers& receivers, const glm::dvec3& anchor,
                                   std::optional<double> alpha, const transport::IntensityKernels& intensity,
                                   std::vector<float>& share, std::vector<float>& error) const {
    const std::size_t count = receivers.count;
    error.assign(count, std::numeric_limits<float>::infinity());
    share.assign(count, 1.0F);
    if (image_ != nullptr) return;
    const Frame& frame = luminance_frame(light_);
    candela({{receivers.position[0], receivers.position[1], receivers.position[2]}, count}, anchor, intensity,
            share.data());
    const double radius_m =
        with_traits(light_.shape, [](const auto& kind, auto traits) { return traits.radius(kind); });
    const LuminousBody* const body = light_.emission != nullptr ? light_.emission->body.get() : nullptr;
    const double flat_m2 = body != nullptr ? body->flat_area_m2() : 0.0;
    const bool is_even = front_ != nullptr && (body == nullptr || flat_m2 > 0.0); // about its centre
    const glm::dvec3 axis = frame.to_world(variation_->axis());
    // Within reach_rad, and small enough for asin ρ ≤ 1.0013 ρ, 1/(1 − ρ²) ≤ 1.003 and (1 − ρ)⁻⁴ ≤ 1 + 4.6 ρ.
    constexpr double farthest_part = 0.0499;
    static_assert(farthest_part * 1.0013 < WebVariation::reach_rad);
    for (std::size_t i = 0; i < count; ++i) {
        const auto vector = [&](const float* const(&of)[3]) { return glm::dvec3(of[0][i], of[1][i], of[2][i]); };
        const glm::dvec3 way = anchor + vector(receivers.position) - light_.frame.origin;
        const double inverse_m = 1.0 / glm::length(way);
        const double part = radius_m * inverse_m;
        if (!(part < farthest_part)) continue;
        const double turn_rad = 1.0013 * part; // no less than η
        const double cd = share[i];
        const WebVariation::Bounds& web = variation_->at(glm::dot(way, axis) * inverse_m);
        const double slope = light_.web_scale * web.slope;
        const double change = slope * turn_rad;
        double area_m2 = 1.0; // projected; of masks, whose web is a luminance
        double of_place = change;
        if (flat_m2 > 0.0) {
            area_m2 = flat_m2 * std::abs(glm::dot(way, light_.frame.z)) * inverse_m;
            of_place = ((cd + change) * (1.0 + part) - cd) / area_m2;
        } else if (body != nullptr) {
            area_m2 = body->projected_area_m2(frame.to_local(way));
            const double least_m2 = area_m2 - turn_rad * body->area_m2();
            if (!(least_m2 > 0.0)) continue;
            of_place = (cd + change) / least_m2 - cd / area_m2;
        }
        if (!(area_m2 > 0.0)) continue;
        share[i] = static_cast<float>(cd / area_m2);
        double of_mean = of_place;
        const double cosine = -glm::dot(vector(receivers.normal), way) * inverse_m;
        if (is_even && turn_rad < web.bend_rad && part < cosine) {
            const double square = part * part;
            double pair = light_.web_scale * turn_rad * (web.kink + turn_rad * web.curve) + 1.003 * slope * square;
            if (body != nullptr) pair += cd * square + 2.0 * change * part;
            const double weight = (1.0 + part / cosine) * (1.0 + 4.6 * part) - 1.0;
            if (weight < 1.0) of_mean = std::min(of_mean, (0.5 * pair / area_m2 + weight * of_place) / (1.0 - weight));
        }
        if (alpha) of_mean += 2.0 * of_place * square_share(part, 2.0 * *alpha);
        error[i] = static_cast<float>(of_mean);
    }
}

void LuminancePattern::along_lobes(const shading::Surfaces& surfaces, const glm::dvec3& anchor, double alpha,
                                   const transport::LuminanceKernels& kernels,
                                   const transport::IntensityKernels& intensity, const std::vector<float>& mean,
                                   std::vector<float>& share) const {
    share = mean;
    const Frame& frame = light_.frame;
    const Outline outline = std::visit(OutlineOf(), light_.shape);
    const double lobe_rad = 2.0 * alpha; // facets turn what they reflect by twice their angle
    transport::LobeLight light;
    copy(frame.origin - anchor, light.origin);
    copy(frame.x, light.x);
    copy(frame.y, light.y);
    copy(frame.z, light.z);
    light.is_flat = front_ != nullptr;
    light.is_round = outline.is_round;
    light.half_x = static_cast<float>(outline.half_x);
    light.half_y = static_cast<float>(outline.half_y);
    light.radius = static_cast<float>(
        with_traits(light_.shape, [](const auto& kind, auto traits) { return traits.radius(kind); }));
    light.lobe_rad = static_cast<float>(lobe_rad);
    constexpr std::size_t most = 64; // points of a chunk
    std::array<std::array<float, most>, 3> towards{};
    std::array<float, most> narrow{};
    std::array<float, most> seen{};
    for (std::size_t first = 0; first < surfaces.count; first += most) {
        const std::size_t count = std::min(surfaces.count - first, most);
        transport::LobePoints points;
        for (int axis = 0; axis < 3; ++axis) {
            points.position[axis] = surfaces.position[axis] + first;
            points.normal[axis] = surfaces.normal[axis] + first;
            points.view[axis] = surfaces.view[axis] + first;
        }
        points.count = count;
        kernels.lobes(points, light, {narrow.data(), {towards[0].data(), towards[1].data(), towards[2].data()}});
        if (image_ == nullptr)
            towards_points({{towards[0].data(), towards[1].data(), towards[2].data()}, count}, 1.0, intensity,
                           seen.data());
        else
            blurred_by_lobes(points, anchor, lobe_rad, seen.data());
        for (std::size_t k = 0; k < count; ++k)
            if (mean[first + k] > 0.0F) share[first + k] += narrow[k] * (seen[k] - share[first + k]);
    }
}

void LuminancePattern::blurred_by_lobes(const transport::LobePoints& points, const glm::dvec3& anchor, double lobe_rad,
                                        float* seen) const {
    const Outline outline = std::visit(OutlineOf(), light_.shape);
    const glm::dvec2 half_m(outline.half_x, outline.half_y);
    for (std::size_t i = 0; i < points.count; ++i) {
        const auto vector = [&](const float* const(&of)[3]) { return glm::dvec3(of[0][i], of[1][i], of[2][i]); };
        const glm::dvec3 normal = vector(points.normal);
        const glm::dvec3 view = vector(points.view);
        const glm::dvec3 mirrored = 2.0 * glm::dot(normal, view) * normal - view;
        const glm::dvec3 position = anchor + vector(points.position);
        const glm::dvec2 half = 0.5 * lobe_rad * glm::distance(position, light_.frame.origin) / half_m;
        seen[i] = static_cast<float>(blurred(position, mirrored, half));
    }
}

} // namespace gonio::detail
