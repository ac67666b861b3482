// Falloff of spots with angle and of windows with distance: in [0, 1] for any float, and compared with double where
// floats can resolve the width of the cone.
#include <gonio/measure/hostile_poses.hpp>
#include <gonio/measure/stress/subjects.hpp>
#include <gonio/shading/falloff.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace gonio::measure::detail {

namespace {

// An angle from very narrow to the whole half circle, including round numbers.
double angle(Random& random) {
    if (random.bits() % 8 == 0) return static_cast<double>(random.bits() % 37) * (std::numbers::pi / 36.0);
    return std::exp(random.uniform(std::log(1e-6), std::log(std::numbers::pi)));
}

template<class S>
std::array<S, 6> lobes(S theta, S inner, S outer) {
    return {shading::lobe_hard(theta, inner, outer),         shading::lobe_frostbite(theta, inner, outer),
            shading::lobe_linear_cos(theta, inner, outer),   shading::lobe_smoothstep_cos(theta, inner, outer),
            shading::lobe_linear_angle(theta, inner, outer), shading::lobe_smoothstep_angle(theta, inner, outer)};
}

// Float against double on the same floats. A ramp as steep as 1/(b − a) magnifies the rounding of θ, which is about
// ulp(b): 8 of those are allowed, and 1e-6 of the value's range for the sines.
void spots(Random& random, std::uint64_t evaluations, StressTally& tally) {
    for (std::uint64_t done = 0; done < evaluations; done += 6) {
        auto outer = static_cast<float>(std::min(angle(random), std::numbers::pi / 2.0));
        auto inner = static_cast<float>(angle(random));
        if (random.bits() % 8 == 0) inner = outer;
        if (random.bits() % 8 == 0) inner = std::nextafter(outer, 0.0F);
        if (inner > outer) std::swap(inner, outer);
        outer = std::min(outer, 1.5707964F);
        inner = std::min(inner, outer);
        auto theta = static_cast<float>(angle(random));
        if (random.bits() % 2 == 0) theta = static_cast<float>(random.uniform(inner, std::nextafter(outer, 4.0F)));
        if (random.bits() % 16 == 0) theta = random.bits() % 2 == 0 ? inner : outer;
        const std::array<float, 6> found = lobes(theta, inner, outer);
        const std::array<double, 6> truth =
            lobes(static_cast<double>(theta), static_cast<double>(inner), static_cast<double>(outer));
        const double width = static_cast<double>(outer) - static_cast<double>(inner);
        // Smoothstep and square are at most twice as steep as a linear ramp.
        const double bar = 1e-6 + (width > 0.0 ? 2.0 * 8.0 * static_cast<double>(outer) * 0x1p-24 / width : 0.0);
        for (std::size_t i = 0; i < found.size(); ++i) {
            const bool in_range = found[i] >= 0.0F && found[i] <= 1.0F;
            const double off = std::fabs(static_cast<double>(found[i]) - truth[i]);
            tally.hold(in_range ? off / bar : HUGE_VAL, [&] {
                return fmt::format("lobe {}: {:.9g} for {:.9g}, theta {:a} inner {:a} outer {:a}", i, found[i],
                                   truth[i], theta, inner, outer);
            });
        }
    }
}

// Any float: lobes, windows and Frostbite's factor stay in [0, 1].
void any_floats(Random& random, std::uint64_t evaluations, StressTally& tally) {
    for (std::uint64_t done = 0; done < evaluations; done += 10) {
        const auto distance = static_cast<float>(std::fabs(hostile::number(random)));
        const auto inverse_range = static_cast<float>(std::fabs(hostile::number(random)));
        const auto outer = static_cast<float>(angle(random));
        const float inner = outer * static_cast<float>(random.uniform());
        const auto theta = static_cast<float>(angle(random));
        const auto cosine = static_cast<float>(random.uniform(-1.0, 1.0));
        const std::array<float, 6> found = lobes(theta, inner, outer);
        const std::array<float, 4> others{
            shading::window_squared(distance, inverse_range), shading::window_gltf(distance, inverse_range),
            shading::spot_squared_linear(cosine, inverse_range, static_cast<float>(hostile::number(random))),
            shading::inside_frustum(
                {static_cast<float>(hostile::number(random)), static_cast<float>(hostile::number(random)), distance},
                inner * 0.5F, outer * 0.5F)};
        tally.looked_at(10);
        const auto check = [&](float value, std::size_t which) {
            tally.require(value >= 0.0F && value <= 1.0F, [&] {
                return fmt::format("function {}: {}, distance {:a} inverse range {:a} theta {:a} inner {:a} outer {:a}",
                                   which, value, distance, inverse_range, theta, inner, outer);
            });
        };
        for (std::size_t i = 0; i < found.size(); ++i)
            check(found[i], i);
        for (std::size_t i = 0; i < others.size(); ++i)
            check(others[i], found.size() + i);
    }
}

} // namespace

std::span<const StressSubject> falloff_stress() {
    static constexpr std::array subjects{
        StressSubject{"falloff of spots", "1e-6 + 16 roundings of the outer angle over the ramp's width, [0, 1]", 0.3,
                      spots},
        StressSubject{"falloff of any floats", "in [0, 1]", 0.3, any_floats},
    };
    return subjects;
}

} // namespace gonio::measure::detail
