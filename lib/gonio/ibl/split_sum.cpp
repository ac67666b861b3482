#include <gonio/base/gauss_legendre.hpp>
#include <gonio/base/named.hpp>
#include <gonio/ibl/split_sum.hpp>

#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr std::array models{
    SplitSumModelInfo{"ggx", SplitSumModel::ggx, "GGX with height-correlated shadowing, as Filament"},
    SplitSumModelInfo{"ue4", SplitSumModel::ue4, "GGX with the shadowing of Unreal Engine 4, k = alpha/2"},
    SplitSumModelInfo{"frostbite", SplitSumModel::frostbite,
                      "as ggx, with the albedo of Frostbite's diffuse part as a third channel"},
};
static_assert(in_enum_order(models, &SplitSumModelInfo::model, SplitSumModel::frostbite));

constexpr std::array schemes{
    MultipleScatteringInfo{"none", MultipleScattering::none, "light that is scattered once"},
    MultipleScatteringInfo{"filament", MultipleScattering::filament, "times 1 + F0 (1/E - 1)"},
    MultipleScatteringInfo{"kulla-conty", MultipleScattering::kulla_conty,
                           "plus (1 - E) F^2 Em / (1 - F (1 - Em)), Em the mean of E, F the mean reflectance"},
    MultipleScatteringInfo{"fdez-aguera", MultipleScattering::fdez_aguera,
                           "plus (1 - E) (A F0 + B) F / (1 - F (1 - E)), F the mean reflectance"},
};
static_assert(in_enum_order(schemes, &MultipleScatteringInfo::scheme, MultipleScattering::fdez_aguera));

double fifth_power(double x) {
    const double square = x * x;
    return square * square * x;
}

// G/(4 n·l n·v)
double visibility(double n_dot_l, double n_dot_v, double alpha, SplitSumModel model) {
    if (model == SplitSumModel::ue4) {
        const double k = 0.5 * alpha;
        return 0.25 / ((n_dot_l * (1.0 - k) + k) * (n_dot_v * (1.0 - k) + k));
    }
    const auto widened = [&](double c) { return std::sqrt(alpha * alpha + (1.0 - alpha * alpha) * c * c); };
    return 0.5 / (n_dot_l * widened(n_dot_v) + n_dot_v * widened(n_dot_l));
}

// ∫ f over [from, to], nodes gathered at both ends, where f may have a root's slope.
template<std::size_t count, class F>
auto gathered(double from, double to, const F& f) {
    static constexpr auto nodes = gauss_legendre<count>();
    decltype(f(from)) sum{};
    for (const QuadratureNode& node : nodes) {
        // x = (1 + s(3 − s²)/2)/2 for s in [−1, 1]
        const double s = node.at;
        const double x = 0.5 + 0.25 * s * (3.0 - s * s);
        sum += node.weight * 0.75 * (1.0 - s * s) * f(from + (to - from) * x);
    }
    return (to - from) * sum;
}

// ∫ D G/(4 n·v) dω over the half vectors, in two parts: all of it, and times (1 − v·h)⁵.
class HalfVectors {
public:
    HalfVectors(double n_dot_v, double alpha, SplitSumModel model)
        : n_dot_v_(n_dot_v), sine_v_(std::sqrt((1.0 - n_dot_v) * (1.0 + n_dot_v))), alpha_(alpha), model_(model) {}

    [[nodiscard]] glm::dvec2 sum() const {
        // Up to the first break all azimuths have n·l > 0, from the second on none.
        const double view = std::atan2(sine_v_, n_dot_v_);
        const double first = std::tan(0.25 * pi - 0.5 * view);
        const double second = std::tan(0.25 * pi + 0.5 * view);
        // In t up to where little of D lies; in the logarithm of the tangent from there on: D, the eye's height and the
        // breaks each have their own scale.
        constexpr double little = 0.02;
        const double near = std::min(first, alpha_ * std::sqrt(little / (1.0 - little)));
        glm::dvec2 total = gathered<nodes_of_panel>(0.0, place(near),
                                                    [this](double t) { return at(alpha_ * std::sqrt(t / (1.0 - t))); });
        total += in_panels(near, first);
        total += in_panels(first, second);
        return total;
    }

private:
    // D cos θh dω = dt dφ/2π for tan² θh = α² t/(1 − t).
    [[nodiscard]] double place(double tangent) const {
        return tangent * tangent / (alpha_ * alpha_ + tangent * tangent);
    }

    [[nodiscard]] glm::dvec2 in_panels(double from, double to) const {
        constexpr double length = 2.0;
        constexpr double far = 1e-9; // of D
        to = std::min(to, alpha_ / std::sqrt(far));
        if (!(to > from)) return glm::dvec2(0.0);
        const double start = std::log(from);
        const double whole = std::log(to / from);
        const int panels = std::max(1, static_cast<int>(std::ceil(whole / length)));
        glm::dvec2 total(0.0);
        for (int i = 0; i < panels; ++i)
            total += gathered<nodes_of_panel>(start + whole * i / panels, start + whole * (i + 1) / panels,
                                              [this](double y) {
                                                  const double tangent = std::exp(y);
                                                  const double t = place(tangent);
                                                  return 2.0 * t * (1.0 - t) * at(tangent);
                                              });
        return total;
    }

    // The factor of dt.
    [[nodiscard]] glm::dvec2 at(double tangent) const {
        const double cosine = 1.0 / std::sqrt(1.0 + tangent * tangent);
        const double sine = tangent * cosine;
        // n·l = n·v cos 2θh + sin θv sin 2θh cos φ
        const double even = n_dot_v_ * (cosine - sine) * (cosine + sine);
        const double swing = sine_v_ * 2.0 * sine * cosine;
        double most = pi;
        if (even < swing) {
            if (even <= -swing) return glm::dvec2(0.0);
            most = std::acos(-even / swing);
        }
        return gathered<nodes_of_ring>(0.0, most, [&](double phi) {
            const double turned = std::cos(phi);
            const double n_dot_l = std::max(0.0, even + swing * turned);
            const double v_dot_h = n_dot_v_ * cosine + sine_v_ * sine * turned;
            const double once = 4.0 * visibility(n_dot_l, n_dot_v_, alpha_, model_) * n_dot_l * v_dot_h / (cosine * pi);
            return glm::dvec2(once, once * fifth_power(1.0 - v_dot_h));
        });
    }

    static constexpr std::size_t nodes_of_panel = 12;
    static constexpr std::size_t nodes_of_ring = 24;

    double n_dot_v_;
    double sine_v_;
    double alpha_;
    SplitSumModel model_;
};

// (1/π) ∫ f n·l dω of Frostbite's diffuse part, base colour 1: a polynomial of n·l and the cosine of the azimuth.
double diffuse_albedo(double n_dot_v, double roughness) {
    static constexpr auto nodes = gauss_legendre<16>();
    const double sine_v = std::sqrt((1.0 - n_dot_v) * (1.0 + n_dot_v));
    const double factor = 1.0 - roughness * (1.0 - 1.0 / 1.51);
    double sum = 0.0;
    for (const QuadratureNode& height : nodes) {
        const double n_dot_l = 0.5 * (1.0 + height.at);
        const double sine_l = std::sqrt((1.0 - n_dot_l) * (1.0 + n_dot_l));
        // Even steps are Gauss nodes in azimuth.
        constexpr int steps = 8;
        double ring = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double l_dot_v = n_dot_l * n_dot_v + sine_l * sine_v * std::cos(pi * (i + 0.5) / steps);
            const double grazing = roughness * (0.5 + (1.0 + l_dot_v)) - 1.0; // 2 (l·h)² = 1 + l·v
            ring += (1.0 + grazing * fifth_power(1.0 - n_dot_l)) * (1.0 + grazing * fifth_power(1.0 - n_dot_v));
        }
        sum += 0.5 * height.weight * 2.0 * n_dot_l * factor * ring / steps;
    }
    return sum;
}

// Below this roughness the surface is a mirror: α < 1e-4.
constexpr double mirror = 0.01;

} // namespace

std::span<const SplitSumModelInfo> split_sum_models() {
    return models;
}

const SplitSumModelInfo& info_of(SplitSumModel model) {
    return models.at(static_cast<std::size_t>(model));
}

Result<SplitSumModel> parse_split_sum_model(std::string_view text) {
    return find_named("split-sum model", text, models).map([](const auto* row) { return row->model; });
}

std::span<const MultipleScatteringInfo> multiple_scattering_schemes() {
    return schemes;
}

const MultipleScatteringInfo& info_of(MultipleScattering scheme) {
    return schemes.at(static_cast<std::size_t>(scheme));
}

Result<MultipleScattering> parse_multiple_scattering(std::string_view text) {
    return find_named("multiple scattering", text, schemes).map([](const auto* row) { return row->scheme; });
}

SplitSum split_sum(double n_dot_v, double roughness, SplitSumModel model) {
    if (!(n_dot_v > 0.0 && n_dot_v <= 1.0 && roughness >= 0.0 && roughness <= 1.0)) {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, nan, nan};
    }
    SplitSum result;
    if (roughness < mirror) {
        result.bias = fifth_power(1.0 - n_dot_v);
        result.scale = 1.0 - result.bias;
    } else {
        const glm::dvec2 sum = HalfVectors(n_dot_v, roughness * roughness, model).sum();
        result.scale = sum.x - sum.y;
        result.bias = sum.y;
    }
    if (model == SplitSumModel::frostbite) result.diffuse = diffuse_albedo(n_dot_v, roughness);
    return result;
}

double mean_albedo(double roughness, SplitSumModel model) {
    // μ = x²: E changes fast at grazing.
    static constexpr auto nodes = gauss_legendre<24>();
    double sum = 0.0;
    for (const QuadratureNode& node : nodes) {
        const double x = 0.5 * (1.0 + node.at);
        sum += node.weight * 2.0 * x * x * x * split_sum(x * x, roughness, model).albedo();
    }
    return sum;
}

double specular_albedo(double f0, const SplitSum& sum, double mean, MultipleScattering scheme) {
    const double once = f0 * sum.scale + sum.bias;
    const double lost = 1.0 - sum.albedo();
    const double mean_reflectance = f0 + (1.0 - f0) / 21.0; // of Schlick's F over uniform light
    switch (scheme) {
    case MultipleScattering::none:
        return once;
    case MultipleScattering::filament:
        return once * (1.0 + f0 * (1.0 / sum.albedo() - 1.0));
    case MultipleScattering::kulla_conty:
        return once + lost * mean_reflectance * mean_reflectance * mean / (1.0 - mean_reflectance * (1.0 - mean));
    case MultipleScattering::fdez_aguera:
        return once + lost * once * mean_reflectance / (1.0 - mean_reflectance * lost);
    }
    return once;
}

} // namespace gonio
