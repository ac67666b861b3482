#include <gonio/light/luminaire.hpp>
#include <gonio/light/shape_traits.hpp>
#include <gonio/transport/point_form.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

namespace gonio::detail {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
// Kernels compute in float: cosines and lengths get this room.
constexpr double room = 1e-5;

// Where the light is as seen from all points of a group, and from all places of the light.
struct Pose {
    double part = unbounded;   // ρ: the radius of the light over the distance of its centre
    double least_cosine = 0.0; // c = n·l of the centre
    double most_cosine = 1.0;
    double tilt = 1.0;       // sine of the angle between the normal and the axis of the light
    double least_half = 0.0; // l·h, h halfway between the light and the eye
    double most_half = 1.0;
    bool is_in_front = false; // all points are in front of the light's plane
};

// Bounds of the first and the second derivative of the logarithm of a factor, with respect to τ (see below).
struct Slopes {
    double first = 0.0;
    double second = 0.0;
    double turned = 0.0; // more of the first derivative, in proportion to |l'|

    Slopes operator+(const Slopes& more) const {
        return {first + more.first, second + more.second, turned + more.turned};
    }
};

// An angle from 0 to π by its cosine and sine. Sums and differences end there.
struct Angle {
    double cosine = 1.0;
    double sine = 0.0;

    static Angle of_cosine(double cosine) {
        const double c = std::clamp(cosine, -1.0, 1.0);
        return {c, std::sqrt((1.0 - c) * (1.0 + c))};
    }
    // At most a right one.
    static Angle of_sine(double sine) {
        const double s = std::min(sine, 1.0);
        return {std::sqrt((1.0 - s) * (1.0 + s)), s};
    }
    Angle operator+(const Angle& more) const {
        const Angle sum{cosine * more.cosine - sine * more.sine, sine * more.cosine + cosine * more.sine};
        return sum.sine < 0.0 ? Angle{-1.0, 0.0} : sum;
    }
    Angle operator-(const Angle& less) const {
        const Angle left{cosine * less.cosine + sine * less.sine, sine * less.cosine - cosine * less.sine};
        return left.sine < 0.0 ? Angle{1.0, 0.0} : left;
    }
    double cosine_of_half() const { return std::sqrt(std::max(0.5 * (1.0 + cosine), 0.0)); }
};

// The light at w + δ, in units of the distance of its centre, which is at w: an element of a flat light has
// f(l) (n·q)/|q|⁴ with q = w + δ, l = q/|q| (the height b over the plane of the light is common to all). Let δ = τe
// with a unit vector e in the plane of the light, 0 ≤ τ ≤ ρ, and λ = 1/(1 − ρ) ≥ 1/|q|. Then
//
//   |l'| ≤ λ,   l'' = −2(e·l)/|q| l' − |l'|² l,
//   c = n·l:  |c'| ≤ λ c₁,  c₁ = min(1, |n·e| + c),   |c''| ≤ λ² (2c₁ + c),
//
// and for a function g of l that along great circles has slopes G and H, |g'| ≤ λG and |g''| ≤ λ²(H + G), since
// |(e·l) l'| ≤ 1/(2|q|). With h halfway between l and v, U = |l + v| = 2 l·h, κ = 1/U and s = |n×h|, great circles have
//
//   |h'| ≤ κ,  |(l·h)'| ≤ σ/2,  |(l·h)''| ≤ (l·h + κ)/2,  σ = |l×h|,
//   |n·h'| ≤ sκ,  |n·h''| ≤ sσκ(1 + 2κ) + κ² n·h.
class LobeSlopes {
public:
    LobeSlopes(const LobeVariation& material, const Pose& pose)
        : material_(material),
          pose_(pose),
          stretch_(1.0 / (1.0 - pose.part)),
          turn_(std::min(1.0, pose.tilt + pose.most_cosine)),
          per_half_(0.5 / pose.least_half),
          across_(std::sqrt((1.0 - pose.least_half) * (1.0 + pose.least_half))) {
        cosine_ = {turn_ * stretch_, (2.0 * turn_ + pose.most_cosine) * stretch_ * stretch_, 0.0};
        half_ = {0.5 * across_ * stretch_, 0.5 * (pose.most_half + per_half_ + across_) * stretch_ * stretch_, 0.0};
    }

    // Frostbite's: (1 + q z⁵)(1 + q y), z = 1 − c, q = r/2 + 2r (l·h)² − 1, and y ≤ 1 of the view.
    Slopes diffuse() const {
        const double r = material_.linear_roughness;
        if (r < 0.0) return {};
        const auto q_at = [r](double half) { return 0.5 * r + 2.0 * r * half * half - 1.0; };
        const double least = q_at(pose_.least_half);
        const double most = std::max(std::abs(least), std::abs(q_at(pose_.most_half)));
        const double first = 4.0 * r * pose_.most_half * half_.first;
        const double second = 4.0 * r * (half_.first * half_.first + pose_.most_half * half_.second);
        const double z = 1.0 - pose_.least_cosine;
        const double z4 = z * z * z * z;
        const auto logarithmic = [](double value, double slope, double bend) {
            if (!(value > 0.0)) return Slopes{unbounded, unbounded, 0.0};
            return Slopes{slope / value, bend / value + (slope / value) * (slope / value), 0.0};
        };
        const Slopes of_light =
            logarithmic(1.0 + std::min(least, 0.0) * z4 * z, first * z4 * z + 5.0 * most * z4 * cosine_.first,
                        second * z4 * z + 10.0 * first * z4 * cosine_.first +
                            most * (20.0 * z * z * z * cosine_.first * cosine_.first + 5.0 * z4 * cosine_.second));
        return of_light + logarithmic(1.0 + std::min(least, 0.0), first, second);
    }

    // D V F of GGX.
    Slopes specular() const { return distribution() + visibility() + reflectance(); }

private:
    // D ~ t⁻², t = 1 − k (n·h)² = α² + k s² with k = 1 − α². With T = s/(n·h): (n·h)²/t ≤ 1/α², s²/t ≤ 1 and
    // s (n·h)/t = T/(α² + T²) ≤ 1/(2α).
    Slopes distribution() const {
        const double a = material_.alpha;
        const double k = 1.0 - a * a;
        const double kappa = per_half_;
        const double first = 2.0 * k * kappa / a;
        const double bend = 2.0 * kappa * kappa * (1.0 + k / (a * a)) + k / a * kappa * across_ * (1.0 + 2.0 * kappa);
        const double second = 2.0 * (bend + 0.25 * first * first);
        return {0.0, (second + first) * stretch_ * stretch_, first * stretch_};
    }
    // V = 1/(2g), g = c λ(n·v) + n·v λ(c): |(log V)_c| ≤ 1/c, |(log V)_cc| ≤ 1/c².
    Slopes visibility() const {
        const double c = pose_.least_cosine;
        return {cosine_.first / c, cosine_.first * cosine_.first / (c * c) + cosine_.second / c, 0.0};
    }
    // F = f0 + (f90 − f0) z⁵, z = 1 − l·h.
    Slopes reflectance() const {
        const double more = material_.f90 - material_.f0;
        if (!(more > 0.0)) return {};
        const double low = 1.0 - pose_.most_half;
        const double z = 1.0 - pose_.least_half;
        const double least = material_.f0 + more * low * low * low * low * low;
        if (!(least > 0.0)) return {unbounded, unbounded, 0.0};
        const double first = more * 5.0 * z * z * z * z * half_.first / least;
        const double bend = more * z * z * z * (20.0 * half_.first * half_.first + 5.0 * z * half_.second) / least;
        return {0.0, bend + first * first, first};
    }

    const LobeVariation& material_;
    const Pose& pose_;
    double stretch_;  // λ
    double turn_;     // c₁
    double per_half_; // κ
    double across_;   // σ
    Slopes cosine_;   // of c itself, not of its logarithm
    Slopes half_;     // of l·h
};

// The light is that of the centre times (1 + τ n·e/c) e^φ, with the slopes of φ those of f plus those of −4 log|q|:
// 4λ |e·l| and 4λ². Of these 4λ |e·l| and what is proportional to |l'| ≤ λ √(1 − (e·l)²) are not large together: the
// sum is at most the root of the sum of squares. Opposite places have the mean
//
//   e^φ₂ cosh φ₁ + (|n·e|/c) τ e^φ₂ sinh φ₁,   φ₁ ≤ Φ'τ,  φ₂ ≤ Φ''τ²/2,
//
// as both places have the same weight; a sum of powers ≥ 1 of τ², so over the light it is at most its value at ρ times
// the mean of τ²/ρ². With t = φ₁²/2 + φ₂ ≤ 1, e^φ₂ cosh φ₁ − 1 ≤ t + t² and e^φ₂ sinh φ₁ ≤ φ₁ (1 + 2t).
double shape_share(const Pose& pose, const Slopes& lobe, double mean_square) {
    const double stretch = 1.0 / (1.0 - pose.part);
    const double first = (std::sqrt(16.0 * stretch * stretch + lobe.turned * lobe.turned) + lobe.first) * pose.part;
    const double second = 0.5 * (4.0 * stretch * stretch + lobe.second) * pose.part * pose.part;
    const double t = 0.5 * first * first + second;
    if (!(t < 1.0)) return unbounded;
    return mean_square * (t + t * t + pose.tilt / pose.least_cosine * pose.part * first * (1.0 + 2.0 * t));
}

// The mean of |δ|² over a flat light, over the square of its radius.
struct MeanSquare {
    double operator()(const RectShape& /*rect*/) const { return 1.0 / 3.0; }
    double operator()(const DiskShape& /*disk*/) const { return 0.5; }
    // (a² + b²)/4 over the larger squared.
    double operator()(const EllipseShape& /*ellipse*/) const { return 0.5; }
    template<class Kind>
    double operator()(const Kind& /*not flat*/) const {
        return 1.0;
    }
};

// Within the reach of a web's bounds, and small enough for asin ρ ≤ 1.0013 ρ, 1/(1 − ρ²) ≤ 1.003 and
// (1 − ρ)⁻⁴ ≤ 1 + 4.6 ρ.
constexpr double farthest_part = 0.0499;
static_assert(farthest_part * 1.0013 < WebVariation::reach_rad);

// The directions from the centre of a light to points.
struct Directions {
    glm::dvec3 to_points{0.0}; // to the middle of their bounds [m]
    double middle_m = 0.0;     // its length
    double near_m = 0.0;       // the least distance
    Angle spread;              // of the points about the middle
    double part = unbounded;   // ρ
};

// Nothing for points that are too near.
std::optional<Directions> directions_to(const LitLight& light, const SampleBounds& points) {
    Directions found;
    const glm::dvec3 center = light.reach.center;
    found.to_points = points.center - center;
    found.middle_m = glm::length(found.to_points);
    if (!(points.radius < found.middle_m)) return std::nullopt;
    found.near_m = glm::length(center - glm::clamp(center, points.low, points.high)) * (1.0 - room);
    found.part = light.reach.body_radius / found.near_m * (1.0 + room);
    if (!(found.part < farthest_part)) return std::nullopt;
    found.spread = Angle::of_sine(points.radius / found.middle_m);
    return found;
}

// The web of a face of a flat opening.
const WebVariation* flat_web(const LitLight& light) {
    const FaceEmission* const emission = light.light.emission.get();
    if (!light.luminance || emission == nullptr || !(emission->body->flat_area_m2() > 0.0)) return nullptr;
    const WebVariation* const variation = light.luminance->variation();
    return variation != nullptr && variation->is_bounded() ? variation : nullptr;
}

WebVariation::Bounds web_towards(const LitLight& light, const WebVariation& variation, const Directions& to) {
    const glm::dvec3 axis = light.light.emission->luminaire.to_world(variation.axis());
    const Angle angle = Angle::of_cosine(glm::dot(axis, to.to_points) / to.middle_m);
    const Angle more = to.spread + Angle::of_sine(room);
    return variation.over((angle + more).cosine, (angle - more).cosine);
}

std::optional<Pose> pose_of(const LitLight& light, const SampleBounds& points, const Directions& to) {
    const double far_m = (to.middle_m + points.radius) * (1.0 + room);
    const glm::dvec3 half = 0.5 * (points.high - points.low);
    Pose pose;
    pose.part = to.part;
    const glm::dvec3 out = -light.light.frame.z;
    pose.is_in_front = glm::dot(out, to.to_points) - glm::dot(glm::abs(out), half) > room * far_m;
    if (points.flat) {
        const double height_m = glm::dot(points.normal, light.reach.center);
        const double most_m = glm::dot(points.normal, points.center) + glm::dot(glm::abs(points.normal), half);
        pose.least_cosine = (height_m - most_m) / far_m - room;
        pose.most_cosine = std::min(1.0, (height_m - points.least_height) / to.near_m + room);
        pose.tilt = std::min(1.0, glm::length(glm::cross(points.normal, light.light.frame.z)) + room);
    } else {
        const Angle angle = Angle::of_cosine(-glm::dot(points.normal, to.to_points) / to.middle_m);
        const Angle more = to.spread + Angle::of_sine(points.spread_sin) + Angle::of_sine(room);
        pose.least_cosine = (angle + more).cosine - room;
        pose.most_cosine = (angle - more).cosine;
    }
    if (!(pose.least_cosine > pose.part)) return std::nullopt;
    return pose;
}

} // namespace

std::optional<LobeVariation> LobeVariation::of(const CoreMaterial& material) {
    LobeVariation found;
    if (std::holds_alternative<shading::Lambert<double>>(material)) return found;
    const auto with_lobe = [&](const auto& core) {
        found.alpha = shading::lobe_alpha(core);
        found.f0 = std::min({core.f0.x, core.f0.y, core.f0.z});
    };
    if (const auto* const ggx = std::get_if<shading::Ggx<double>>(&material)) {
        with_lobe(*ggx);
        found.f90 = 1.0;
        found.has_lobe = true;
        return found;
    }
    const auto* const frostbite = std::get_if<shading::Frostbite<double>>(&material);
    if (frostbite == nullptr) return std::nullopt;
    with_lobe(*frostbite);
    found.f90 = frostbite->f90;
    found.linear_roughness = frostbite->linear_roughness;
    found.has_lobe = frostbite->f90 > 0.0 || frostbite->f0.x > 0.0 || frostbite->f0.y > 0.0 || frostbite->f0.z > 0.0;
    return found;
}

ViewBounds::ViewBounds(const SurfaceSamples& samples, std::size_t first, std::size_t count) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = first; i < first + count; ++i)
        sum += samples.view_of(i);
    const double length = glm::length(sum);
    if (!(length > 0.0)) return;
    axis = sum / length;
    double least = 1.0;
    for (std::size_t i = first; i < first + count; ++i)
        least = std::min(least, glm::dot(axis, samples.view_of(i)));
    cosine = std::max(least - room, -1.0);
}

bool is_web_dark(const LitLight& light, const SampleBounds& points) {
    const WebVariation* const variation = flat_web(light);
    if (variation == nullptr) return false;
    const std::optional<Directions> to = directions_to(light, points);
    return to && !(web_towards(light, *variation, *to).most > 0.0);
}

PointForm point_form(const LitLight& light, const SampleBounds& points, const ViewBounds& views,
                     const LobeVariation& lobe) {
    const WebVariation* const variation = flat_web(light);
    if (variation == nullptr) return {};
    const std::optional<Directions> to = directions_to(light, points);
    if (!to) return {};
    const std::optional<Pose> seen = pose_of(light, points, *to);
    if (!seen) return {};
    Pose pose = *seen;
    const double mean_square = std::visit(MeanSquare(), light.light.shape);
    double shape = 0.0;
    if (lobe.has_lobe || lobe.linear_roughness >= 0.0) {
        const Angle between = Angle::of_cosine(-glm::dot(to->to_points, views.axis) / to->middle_m);
        const Angle of_places = Angle::of_sine(1.0013 * pose.part + room);
        const Angle spread = Angle::of_cosine(views.cosine) + to->spread + of_places;
        pose.least_half = (between + spread).cosine_of_half();
        pose.most_half = (between - spread).cosine_of_half();
        constexpr double least_half = 0.01; // against the light, κ has no bound
        if (!(pose.least_half > least_half)) return {};
        // The cosines of all places of the light, too.
        pose.least_cosine -= pose.part;
        pose.most_cosine = std::min(1.0, pose.most_cosine + pose.part);
        if (!(pose.least_cosine > 0.0)) return {};
        const LobeSlopes slopes(lobe, pose);
        shape = shape_share(pose, slopes.diffuse(), mean_square);
        if (lobe.has_lobe) shape = std::max(shape, shape_share(pose, slopes.specular(), mean_square));
        // The diffuse part is the closed form times a mean over a rule of degree 5 (shade.hpp): the two differ by the
        // sixth order, whose coefficients are those of (1 + 2xτ + τ²)⁻², at most (n + 3 over 3).
        const double cubed = pose.part * pose.part * pose.part;
        shape += 400.0 * cubed * cubed;
    } else {
        shape = shape_share(pose, {}, mean_square);
    }
    if (!(shape < 1.0)) return {};

    const double scale = light.light.web_scale;
    const WebVariation::Bounds web = web_towards(light, *variation, *to);
    const auto form = [&](double share, double cd) {
        const double lx_per_cd = light.light.luminance.value * pose.most_cosine / (to->near_m * to->near_m);
        return PointForm{share, cd, lx_per_cd * (share * scale * web.most + cd)};
    };
    // Points in front of the light's plane and behind it: both the light and the point give 0 to the most of the web.
    if (!pose.is_in_front) return form(0.0, scale * web.most * (1.0 + shape) * (1.0 + pose.part));

    // As in LuminancePattern::from_center(), times the projected area: of a place |L(x) − L(0)| ≤ Iρ + Sη(1 + ρ), of a
    // pair C; each separately as a share of I and in candela. The mean of τ over the light is at most the root of the
    // mean of τ².
    const double part = pose.part;
    const double turn_rad = 1.0013 * part;
    const double change = scale * web.slope * turn_rad;
    const double place_share = part;
    const double place_cd = change * (1.0 + part);
    double mean_share = place_share;
    double mean_cd = place_cd;
    const double weight = (1.0 + pose.tilt * part / pose.least_cosine) * (1.0 + 4.6 * part) - 1.0;
    if (turn_rad < web.bend_rad && weight < 0.5) {
        const double kinked = std::sqrt(mean_square) * scale * turn_rad * web.kink;
        const double bent = mean_square * (scale * turn_rad * turn_rad * web.curve +
                                           1.003 * scale * web.slope * part * part + 2.0 * change * part);
        mean_share = mean_square * (0.5 * part * part + weight * part) / (1.0 - weight);
        mean_cd = (0.5 * (kinked + bent) + mean_square * weight * place_cd) / (1.0 - weight);
    }
    // A lobe shows a place of the light, but the mean where it is wider (along_lobes()).
    const double narrow = lobe.has_lobe ? 2.0 * part * part / (part * part + 4.0 * lobe.alpha * lobe.alpha) : 0.0;
    const double of_share = mean_share + narrow * place_share;
    const double of_cd = mean_cd + narrow * place_cd;
    return form(shape + of_share * (1.0 + shape), of_cd * (1.0 + shape));
}

} // namespace gonio::detail
