// The elementary functions of every instruction set, to the ulp that simd/math.hpp states, over the bit patterns of
// their domains; and their results outside the domains.
#include <gonio/measure/stress/subjects.hpp>
#include <gonio/simd/array_math.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace gonio::measure::detail {

namespace {

using simd::ArrayMath;

// One unit in the last place of the float nearest to x.
double ulp(double x) {
    const auto magnitude = static_cast<float>(std::fabs(x));
    if (magnitude < std::numeric_limits<float>::min()) return static_cast<double>(0x1p-149F);
    return static_cast<double>(std::nextafterf(magnitude, std::numeric_limits<float>::infinity())) -
           static_cast<double>(magnitude);
}

struct Function {
    const char* name;
    ArrayMath::Unary ArrayMath::*function;
    float low; // domain of |x|
    float high;
    bool both_signs;
    double bound_ulp;
    long double (*truth)(long double);
};

// atan(x)/x − 1 for 0 < x ≤ 1, by its series where the difference cancels.
long double arc_excess(long double x) {
    if (x > 0.1L) return std::atan(x) / x - 1.0L;
    long double sum = 0.0L;
    for (int k = 12; k >= 1; --k)
        sum = x * x * (sum + (k % 2 == 0 ? 1.0L : -1.0L) / static_cast<long double>(2 * k + 1));
    return sum;
}

constexpr auto quarter = std::numbers::pi_v<float> / 4.0F;

constexpr std::array functions{
    Function{"sqrt", &ArrayMath::sqrt, 0x1p-149F, 3.4e38F, false, 1.0, [](long double x) { return std::sqrt(x); }},
    Function{"asin", &ArrayMath::asin, 1e-20F, 1.0F, true, 3.0, [](long double x) { return std::asin(x); }},
    Function{"acos", &ArrayMath::acos, 1e-20F, 1.0F, true, 3.0, [](long double x) { return std::acos(x); }},
    Function{"atan", &ArrayMath::atan, 1e-30F, 1e30F, true, 3.0, [](long double x) { return std::atan(x); }},
    Function{"sin", &ArrayMath::sin, 1e-30F, quarter, true, 3.0, [](long double x) { return std::sin(x); }},
    Function{"cos", &ArrayMath::cos, 1e-30F, quarter, true, 2.0, [](long double x) { return std::cos(x); }},
    Function{"exp2", &ArrayMath::exp2, 1e-10F, 126.0F, true, 2.0, [](long double x) { return std::exp2(x); }},
    Function{"log2", &ArrayMath::log2, 0x1p-149F, 3.4e38F, false, 3.0, [](long double x) { return std::log2(x); }},
    Function{"atan_excess", &ArrayMath::atan_excess, 1e-10F, 1.0F, false, 6.0,
             [](long double x) { return arc_excess(x) * x; }},
    Function{"atan_ratio_excess", &ArrayMath::atan_ratio_excess, 1e-20F, 1.0F, false, 4.0,
             [](long double t) { return arc_excess(std::sqrt(t)); }},
    Function{"atanh_ratio", &ArrayMath::atanh_ratio, 1e-20F, 0.25F, false, 2.0,
             [](long double t) { return std::atanh(std::sqrt(t)) / std::sqrt(t); }},
};

// Uniform over the bit patterns of [low, high], so over the exponents.
float by_bits(const Function& f, Random& random) {
    const auto low = __builtin_bit_cast(std::uint32_t, f.low);
    const auto high = __builtin_bit_cast(std::uint32_t, f.high);
    const auto x = __builtin_bit_cast(float, low + static_cast<std::uint32_t>(random.bits() % (high - low + 1)));
    return f.both_signs && random.bits() % 2 == 0 ? -x : x;
}

void unary(Random& random, std::uint64_t evaluations, StressTally& tally) {
    constexpr std::size_t count = 256;
    std::vector<float> x(count);
    std::vector<float> result(count);
    std::vector<double> truth(count);
    const std::size_t sets = simd::available_sets().size();
    for (std::uint64_t done = 0; done < evaluations; done += 2 * count * sets) {
        const Function& f = functions[random.bits() % functions.size()];
        for (std::size_t i = 0; i < count; ++i) {
            x[i] = by_bits(f, random);
            truth[i] = static_cast<double>(f.truth(static_cast<long double>(x[i])));
        }
        for (const simd::InstructionSet set : simd::available_sets())
            for (const ArrayMath* math : {&simd::array_math(set), &simd::array_math_of_twins(set)}) {
                (math->*f.function)(x.data(), result.data(), count);
                for (std::size_t i = 0; i < count; ++i) {
                    const double off = std::fabs(static_cast<double>(result[i]) - truth[i]) / ulp(truth[i]);
                    tally.hold(off / f.bound_ulp, [&] {
                        return fmt::format("{} {}: {:.2f} ulp at {:a}", f.name, simd::to_text(set), off, x[i]);
                    });
                }
            }
    }
}

// A NaN gives a NaN; infinities and all other floats give some result.
void outside(Random& random, std::uint64_t evaluations, StressTally& tally) {
    constexpr std::size_t count = 64;
    std::vector<float> x(count);
    std::vector<float> result(count);
    for (std::uint64_t done = 0; done < evaluations; done += count * functions.size() * simd::available_sets().size()) {
        for (float& each : x)
            each = __builtin_bit_cast(float, static_cast<std::uint32_t>(random.bits() >> 32U)); // any float, NaN too
        for (const Function& f : functions)
            for (const simd::InstructionSet set : simd::available_sets()) {
                (simd::array_math(set).*f.function)(x.data(), result.data(), count);
                tally.looked_at(count);
                for (std::size_t i = 0; i < count; ++i) {
                    // acos and asin clamp values above 1 to 1, and may do so for a NaN.
                    const bool arc = f.function == &ArrayMath::asin || f.function == &ArrayMath::acos;
                    if (std::isnan(x[i]) && !arc)
                        tally.require(std::isnan(result[i]), [&] {
                            return fmt::format("{} {}: {} of NaN {:08x}", f.name, simd::to_text(set), result[i],
                                               __builtin_bit_cast(std::uint32_t, x[i]));
                        });
                }
            }
    }
}

// A quotient below the normal range has a rounding error of its own size.
double ulp_of_angle(double x) {
    return std::max(ulp(x), static_cast<double>(0x1p-146F));
}

// 4 ulp; atan2_above needs y ≥ 0 and treats values below 1e-37 as 0.
void arc_tangent_of_two(Random& random, std::uint64_t evaluations, StressTally& tally) {
    constexpr std::size_t count = 256;
    std::vector<float> x(count);
    std::vector<float> y(count);
    std::vector<float> result(count);
    std::vector<double> truth(count);
    constexpr Function domain{"", nullptr, 1e-30F, 1e30F, true, 4.0, nullptr};
    for (std::uint64_t done = 0; done < evaluations; done += count * simd::available_sets().size()) {
        const bool above = random.bits() % 2 == 0;
        for (std::size_t i = 0; i < count; ++i) {
            x[i] = by_bits(domain, random);
            // Half of the time y is about as large as x.
            y[i] =
                random.bits() % 2 == 0 ? by_bits(domain, random) : x[i] * static_cast<float>(random.uniform(-3.0, 3.0));
            if (above) y[i] = std::fabs(y[i]);
            truth[i] = static_cast<double>(std::atan2(static_cast<long double>(y[i]), static_cast<long double>(x[i])));
        }
        for (const simd::InstructionSet set : simd::available_sets()) {
            (above ? simd::array_math(set).atan2_above : simd::array_math(set).atan2)(y.data(), x.data(), result.data(),
                                                                                      count);
            for (std::size_t i = 0; i < count; ++i) {
                const double off = std::fabs(static_cast<double>(result[i]) - truth[i]) / ulp_of_angle(truth[i]);
                tally.hold(off / domain.bound_ulp, [&] {
                    return fmt::format("{} {}: {:.2f} ulp at y {:a} x {:a}", above ? "atan2_above" : "atan2",
                                       simd::to_text(set), off, y[i], x[i]);
                });
            }
        }
    }
}

// 4 + 3 |y log₂x| ulp where the result is a normal number, for x ≥ 0.
void powers(Random& random, std::uint64_t evaluations, StressTally& tally) {
    constexpr std::size_t count = 256;
    std::vector<float> x(count);
    std::vector<float> y(count);
    std::vector<float> result(count);
    constexpr Function domain{"", nullptr, 1e-30F, 1e30F, false, 0.0, nullptr};
    for (std::uint64_t done = 0; done < evaluations; done += count * simd::available_sets().size()) {
        for (std::size_t i = 0; i < count; ++i) {
            x[i] = random.bits() % 2 == 0 ? by_bits(domain, random) : static_cast<float>(random.uniform(0.0, 2.0));
            y[i] = static_cast<float>(random.uniform(-8.0, 8.0));
            if (random.bits() % 8 == 0) y[i] = 0.0F;
        }
        for (const simd::InstructionSet set : simd::available_sets()) {
            simd::array_math(set).pow(x.data(), y.data(), result.data(), count);
            for (std::size_t i = 0; i < count; ++i) {
                const auto truth =
                    static_cast<double>(std::pow(static_cast<long double>(x[i]), static_cast<long double>(y[i])));
                const auto input = [&] {
                    return fmt::format("pow {}: {} for {} at x {:a} y {:a}", simd::to_text(set), result[i], truth, x[i],
                                       y[i]);
                };
                if (!(truth >= static_cast<double>(std::numeric_limits<float>::min()) &&
                      truth <= static_cast<double>(std::numeric_limits<float>::max()))) {
                    tally.looked_at(1);
                    tally.require(result[i] >= 0.0F, input);
                    continue;
                }
                const double exponent = std::fabs(std::log2(truth));
                tally.hold(std::fabs(static_cast<double>(result[i]) - truth) / ulp(truth) / (4.0 + 3.0 * exponent),
                           input);
            }
        }
    }
}

} // namespace

std::span<const StressSubject> math_stress() {
    static constexpr std::array subjects{
        StressSubject{"elementary functions", "1 (sqrt) to 6 ulp, as simd/math.hpp says of each", 1.0, unary},
        StressSubject{"atan2", "4 ulp", 1.0, arc_tangent_of_two},
        StressSubject{"pow", "4 + 3 |y log2 x| ulp", 0.5, powers},
        StressSubject{"elementary functions of any floats", "a NaN stays one", 0.5, outside},
    };
    return subjects;
}

} // namespace gonio::measure::detail
