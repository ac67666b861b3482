#include <gonio/light/light_color.hpp>
#include <gonio/light/luminaire.hpp>
#include <gonio/light/luminances.hpp>
#include <gonio/light/shape_traits.hpp>
#include <gonio/scene/core_vector.hpp>
#include <gonio/scene/detail/polar_cubature.hpp>
#include <gonio/scene/detail/standard_methods.hpp>
#include <gonio/scene/detail/surface_parts.hpp>
#include <gonio/scene/image_illuminance.hpp>
#include <gonio/scene/probe_light.hpp>
#include <gonio/scene/reference.hpp>
#include <gonio/shading/falloff.hpp>
#include <gonio/shading/seen_from.hpp>
#include <gonio/shading/shade.hpp>
#include <gonio/web/web.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace gonio {

namespace {

using detail::CubatureResult;
using detail::LightRegion;
using detail::PolarEdges;
using detail::PolarPeak;
using detail::Vec;
using detail::vec;

// Lights of a smaller apparent size have no digits left of their own outline; they count as a direction.
constexpr double least_reach = 1e-8; // [rad]

// The region of a light as seen from a receiver at the origin; lengths of the light are multiplied by `scale`.
LightRegion region_of(const shading::SphereLight<double>& light, Vec center, Vec normal, double scale) {
    return LightRegion::sphere(center, scale * light.radius, normal);
}
LightRegion region_of(const shading::DiskLight<double>& light, Vec center, Vec normal, double scale) {
    return LightRegion::disk(center, light.axis, scale * light.radius, light.two_sided, normal);
}
LightRegion region_of(const shading::RectangleLight<double>& light, Vec center, Vec normal, double scale) {
    return LightRegion::rectangle(center, light.axis, light.width_direction, scale * light.width, scale * light.height,
                                  light.two_sided, normal);
}
LightRegion region_of(const shading::TubeLight<double>& light, Vec center, Vec normal, double scale) {
    return LightRegion::tube(center, light.axis, scale * light.radius, scale * light.length, normal);
}
LightRegion region_of(const shading::CylinderLight<double>& light, Vec center, Vec normal, double scale) {
    return LightRegion::cylinder(center, light.axis, scale * light.radius, scale * light.length, normal);
}
LightRegion region_of(const shading::SunLight<double>& light, Vec /*center*/, Vec normal, double /*scale*/) {
    return LightRegion::cap(light.toward, light.sine, light.cosine, normal);
}

// What of that region does not shine: the flat end of a cylinder that the receiver sees.
template<class CoreLight>
std::optional<LightRegion> dark_part_of(const CoreLight& light, Vec center, Vec normal, double scale) {
    if constexpr (std::is_same_v<CoreLight, shading::CylinderLight<double>>) {
        const double along = dot(light.axis, center);
        const double half = 0.5 * scale * light.length;
        if (std::abs(along) <= half) return std::nullopt;
        const Vec outward = light.axis * std::copysign(1.0, -along);
        return LightRegion::disk(center + outward * half, outward, scale * light.radius, false, normal);
    }
    return std::nullopt;
}

// The light's luminance towards the receiver from directions ω, over Light::luminance.
class EmissionByDirection {
public:
    EmissionByDirection(const Light& light, const glm::dvec3& receiver, const ReferenceGoal& goal)
        : light_(light), receiver_(receiver), has_pattern_(light.has_pattern()) {
        // Many at once are off by some 1e-12.
        constexpr double fine = 1e-10;
        if (light.image == nullptr && luminance_web(light) != nullptr && goal.relative_error >= fine)
            shares_.emplace(light);
    }

    void operator()(std::span<const Vec> toward, std::span<double> to) {
        if (!has_pattern_) {
            std::fill(to.begin(), to.end(), 1.0);
            return;
        }
        if (!shares_) {
            for (std::size_t i = 0; i < to.size(); ++i)
                to[i] = light_.luminance_share_at(receiver_, {toward[i].x, toward[i].y, toward[i].z});
            return;
        }
        const Frame& frame = shares_->frame();
        for (std::vector<double>* const numbers : {&x_, &y_, &z_})
            numbers->resize(to.size());
        for (std::size_t i = 0; i < to.size(); ++i) {
            const glm::dvec3 local = frame.to_local({-toward[i].x, -toward[i].y, -toward[i].z});
            x_[i] = local.x;
            y_[i] = local.y;
            z_[i] = local.z;
        }
        shares_->along(x_, y_, z_, to);
    }

private:
    const Light& light_;
    const glm::dvec3& receiver_;
    bool has_pattern_;
    std::optional<LuminanceShares> shares_;
    std::vector<double> x_, y_, z_; // in its frame
};

// For a function without a peak: the pole is in the light's middle.
PolarPeak smooth(const LightRegion& region, Vec normal) {
    const Vec middle = region.middle();
    Vec along = normal - middle * dot(normal, middle);
    if (!(dot(along, along) > 1e-12)) along = cross(middle, std::abs(middle.x) < 0.6 ? Vec{1, 0, 0} : Vec{0, 1, 0});
    return {middle, along, 1.0, 1.0};
}

// How to integrate a function that has no peak.
struct SmoothWay {
    PolarPeak peak;
    PolarEdges edges;
};

// The angles [rad] of a full turn at which the stored planes and their mirror images lie.
std::vector<double> plane_azimuths(const Web& mask) {
    const Symmetry stored = mask.stored_symmetry();
    std::vector<double> degrees;
    if (stored == Symmetry::axial) return degrees;
    for (const double c : mask.planes_deg()) {
        degrees.push_back(c);
        if (mirrored_in_0_180(stored)) degrees.push_back(-c);
        if (mirrored_in_90_270(stored)) degrees.push_back(180.0 - c);
        if (stored == Symmetry::quadrant) degrees.push_back(180.0 + c);
    }
    for (double& c : degrees)
        c = std::remainder(c, 360.0) + 0.0; // −0 counts as 0
    std::sort(degrees.begin(), degrees.end());
    degrees.erase(std::unique(degrees.begin(), degrees.end()), degrees.end());
    for (double& c : degrees)
        c *= std::numbers::pi / 180.0;
    return degrees;
}

// With a web of type C the pole is that of its angles, so that its grid consists of lines of the polar coordinates.
// Not if the cells would take more than half of the evaluations, nor for a rough goal, which a few cells across the
// grid reach sooner.
SmoothWay way_of(const Light& light, const LightRegion& region, Vec normal, const ReferenceGoal& goal) {
    const Web* const mask = luminance_web(light);
    const Frame& frame = luminance_frame(light);
    SmoothWay way{smooth(region, normal), {}};
    constexpr double rough = 1e-5;
    if (mask == nullptr || mask->photometry() != Photometry::c || goal.relative_error > rough) return way;
    PolarEdges edges;
    edges.azimuths = plane_azimuths(*mask);
    for (const double gamma : mask->gammas_deg())
        if (gamma > 0.0 && gamma < 180.0) edges.angles.push_back(gamma * std::numbers::pi / 180.0);
    constexpr std::size_t evaluations_in_cell = 49;
    if (edges.empty() ||
        (edges.azimuths.size() + 1) * (edges.angles.size() + 1) > goal.most_evaluations / (2 * evaluations_in_cell))
        return way;
    // The light reaches the receiver in the opposite direction: γ = 0 is −Z, C0 is +X.
    return {{vec(frame.z), vec(frame.x) * -1.0, 1.0, 1.0}, std::move(edges)};
}

// For a lobe of normals of the width α: about the mirrored view the light's direction moves by 2 in the plane of
// incidence and by 2 n·v across it when the normal moves by 1. For views at the horizon the pole is lifted off it by α,
// which changes nothing in the lobe: from within the lobe's width the horizon would appear to turn sharply.
PolarPeak lobe(const LightRegion& region, Vec normal, Vec view, double alpha) {
    const double cosine = dot(normal, view);
    const double lifted = std::clamp(alpha, 1e-3, 0.5);
    const Vec mirrored = normal * (2.0 * cosine) - view + normal * std::max(lifted - cosine, 0.0);
    const Vec pole = mirrored * (1.0 / shading::length(mirrored));
    const double squeeze = std::min(std::max(cosine, lifted), 1.0);
    const double width = 2.0 * alpha;
    // Far from the pole, or with a wide lobe, the integrand hardly changes within a small light.
    const double away = shading::length(region.middle() - pole);
    if (region.reach() >= least_reach && region.reach() < 1e-4 * std::max(width * squeeze, away))
        return smooth(region, normal);
    Vec along = normal - pole * dot(normal, pole);
    if (!(dot(along, along) > 1e-12)) along = smooth(region, normal).along;
    return {pole, along, width, squeeze};
}

double bounded(double value) {
    return std::min(std::max(value, 0.0), shading::illuminance_ceiling);
}

struct Pose {
    LightRegion region;
    std::optional<LightRegion> dark_part; // of the region
    Vec normal;
    double scale; // luminance, and the window of the range
};

Pose pose(const Light& light, const glm::dvec3& position, const glm::dvec3& normal) {
    const Vec center = vec(light.frame.origin - position);
    const bool windowed = light.range && class_of(light.shape) != ShapeClass::sun;
    const double window = windowed ? shading::window_squared(shading::length(center), 1.0 / light.range->value) : 1.0;
    const LightRegion none = LightRegion::cap(vec(normal), 0.0, 1.0, vec(normal));
    using Regions = std::pair<LightRegion, std::optional<LightRegion>>;
    const auto region = [&](const auto& core) {
        const auto seen = shading::exactly_seen_from(core, center);
        // Squares of scaled lengths neither overflow nor underflow.
        const double scale = simd::reciprocal_power_of_two(
            std::max(shading::largest_component(seen.to_center), shading::detail::largest_size(seen.light)));
        return Regions(region_of(seen.light, seen.to_center * scale, vec(normal), scale),
                       dark_part_of(seen.light, seen.to_center * scale, vec(normal), scale));
    };
    auto [whole, dark_part] =
        with_core_light(light.shape, light.frame, light.color, Regions(none, std::nullopt), region);
    return {whole, dark_part, vec(normal), light.luminance.value * window};
}

// ∫ f(l) ⟨n·l⟩ over the light times its luminance; f(directions, values) is a function of unit directions. `closed_lx`
// is the integral for f = 1.
template<class F>
ReferenceValue integrate(const Pose& p, const PolarPeak& peak, const PolarEdges& edges, F& f, double closed_lx,
                         const ReferenceGoal& goal) {
    const double relative_error = std::max(goal.relative_error, 1e-13);
    const double reach = p.region.reach();
    if (reach < least_reach) {
        // f varies by the square of the light's extent relative to the lobe's.
        const Vec middle = p.region.middle();
        double at_middle = 0.0;
        f(std::span(&middle, 1), std::span(&at_middle, 1));
        const double value = at_middle * closed_lx;
        const double extent = reach / (peak.width * peak.squeeze);
        const double error = value * (1e-10 + extent * extent);
        return {bounded(value), bounded(error), 1, error <= relative_error * value};
    }
    const auto integrand = [&](std::span<const Vec> l, std::span<double> to) {
        f(l, to);
        for (std::size_t i = 0; i < l.size(); ++i)
            to[i] *= std::max(dot(p.normal, l[i]), 0.0);
    };
    const auto over = [&](const LightRegion& region, double within) {
        detail::PolarCubature<decltype(integrand)> cubature(region, peak, integrand, edges);
        return cubature.integrate({within, goal.most_evaluations});
    };
    CubatureResult result = over(p.region, relative_error);
    if (p.dark_part && !p.dark_part->dark()) {
        // The difference of two integrals: both need as many digits more as it loses.
        CubatureResult dark = over(*p.dark_part, relative_error);
        const double left = result.value - dark.value;
        if (result.error_estimate + dark.error_estimate > relative_error * left) {
            const double share = left / (result.value + dark.value);
            const double finer = std::max(relative_error * std::max(0.5 * share, 1e-3), 1e-13);
            result = over(p.region, finer);
            dark = over(*p.dark_part, finer);
        }
        result.value = std::max(result.value - dark.value, 0.0);
        result.error_estimate += dark.error_estimate;
        result.evaluations += dark.evaluations;
        result.converged = result.error_estimate <= relative_error * result.value;
    }
    return {bounded(result.value * p.scale), bounded(result.error_estimate * p.scale), result.evaluations,
            result.converged};
}

// The closed form, without the mask or the pattern of a face.
double closed_illuminance(const Light& light, const glm::dvec3& position, const glm::dvec3& normal) {
    Light bare = light;
    bare.emission.reset();
    bare.image.reset();
    bare.parts.reset();
    std::visit(
        [](auto& shape) {
            if constexpr (requires { shape.mask; }) shape.mask.reset();
            if constexpr (requires { shape.image; }) shape.image.reset();
        },
        bare.shape);
    return detail::illuminance_of(bare, position, normal, {IrradianceMethod::exact, {}}).illuminance_lx;
}

} // namespace

ReferenceValue operator+(const ReferenceValue& a, const ReferenceValue& b) {
    return {a.value + b.value, a.error_estimate + b.error_estimate, a.evaluations + b.evaluations,
            a.converged && b.converged};
}

bool has_extent(const Shape& shape) {
    return class_of(shape) != ShapeClass::punctual;
}

ReferenceValue reference_illuminance(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                                     const ReferenceGoal& goal) {
    if (!has_extent(light.shape)) return {};
    const Pose p = pose(light, position, normal);
    if (p.region.dark() || !(p.scale > 0.0)) return {};
    if (light.image != nullptr && p.region.reach() >= least_reach) {
        ReferenceValue sum = detail::image_illuminance(light, position, normal, goal);
        const double window = p.scale / light.luminance.value;
        sum.value = bounded(sum.value * window);
        sum.error_estimate = bounded(sum.error_estimate * window);
        return sum;
    }
    EmissionByDirection emission(light, position, goal);
    const double closed_lx = p.region.reach() < least_reach ? closed_illuminance(light, position, normal) : 0.0;
    const SmoothWay way = way_of(light, p.region, p.normal, goal);
    return integrate(p, way.peak, way.edges, emission, closed_lx, goal);
}

ReferenceLuminance reference_luminance(const Light& light, const glm::dvec3& position, const glm::dvec3& normal,
                                       const glm::dvec3& view, const Material& material, const ReferenceGoal& goal) {
    if constexpr (!detail::has_named_luminance) {
        constexpr ReferenceValue none{std::numeric_limits<double>::quiet_NaN(), 0.0, 0, false};
        return {none, none};
    }
    if (!has_extent(light.shape) || !(glm::dot(normal, view) > 0.0)) return {};
    const Pose p = pose(light, position, normal);
    if (p.region.dark() || !(p.scale > 0.0)) return {};
    EmissionByDirection emission(light, position, goal);
    const Vec v = vec(view);
    const Vec weight = vec(rec709_luminance * light.color); // to Y
    const detail::SurfaceParts parts = detail::surface_parts(material);
    const double closed_lx = p.region.reach() < least_reach ? closed_illuminance(light, position, normal) : 0.0;
    const auto part = [&](const detail::SurfaceParts::Reflectance& reflectance, const PolarPeak& peak,
                          const PolarEdges& edges) {
        const auto f = [&](std::span<const Vec> l, std::span<double> to) {
            emission(l, to);
            for (std::size_t i = 0; i < l.size(); ++i)
                to[i] *= dot(weight, reflectance(p.normal, l[i], v));
        };
        return integrate(p, peak, edges, f, closed_lx, goal);
    };
    const SmoothWay way = way_of(light, p.region, p.normal, goal);
    return {part(parts.diffuse, way.peak, way.edges),
            part(parts.specular, lobe(p.region, p.normal, v, parts.alpha), {})};
}

} // namespace gonio
