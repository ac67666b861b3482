// The elementary functions of every instruction set, to the ulp that simd/math.hpp states, over the bit patterns of
// their domains; and what they give outside of them.
#include <gonio/measure/stress/subjects.hpp>
#include <gonio/simd/array_math.hpp>

#include <fmt/format.h>

#include <array>
#include <bit>
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
};

// Even over the bit patterns of [low, high], so over the exponents.
float by_bits(const Function& f, Random& random) {
    const auto low = std::bit_cast<std::uint32_t>(f.low);
    const auto high = std::bit_cast<std::uint32_t>(f.high);
    const auto x = std::bit_cast<float>(low + static_cast<std::uint32_t>(random.bits() % (high - low + 1)));
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

// A NaN that goes in comes out; infinities and all other floats end somewhere.
void outside(Random& random, std::uint64_t evaluations, StressTally& tally) {
    constexpr std::size_t count = 64;
    std::vector<float> x(count);
    std::vector<float> result(count);
    for (std::uint64_t done = 0; done < evaluations; done += count * functions.size() * simd::available_sets().size()) {
        for (float& each : x)
            each = std::bit_cast<float>(static_cast<std::uint32_t>(random.bits() >> 32U)); // any float, NaN too
        for (const Function& f : functions)
            for (const simd::InstructionSet set : simd::available_sets()) {
                (simd::array_math(set).*f.function)(x.data(), result.data(), count);
                tally.looked_at(count);
                for (std::size_t i = 0; i < count; ++i) {
                    // acos and asin take what is above 1 for 1, and a NaN may be that.
                    const bool arc = f.function == &ArrayMath::asin || f.function == &ArrayMath::acos;
                    if (std::isnan(x[i]) && !arc)
                        tally.require(std::isnan(result[i]), [&] {
                            return fmt::format("{} {}: {} of NaN {:08x}", f.name, simd::to_text(set), result[i],
                                               std::bit_cast<std::uint32_t>(x[i]));
                        });
                }
            }
    }
}

void arc_tangent_of_two(Random& random, std::uint64_t evaluations, StressTally& tally) {
    constexpr std::size_t count = 256;
    std::vector<float> x(count);
    std::vector<float> y(count);
    std::vector<float> result(count);
    std::vector<double> truth(count);
    constexpr Function domain{"", nullptr, 1e-30F, 1e30F, true, 4.0, nullptr};
    for (std::uint64_t done = 0; done < evaluations; done += count * simd::available_sets().size()) {
        for (std::size_t i = 0; i < count; ++i) {
            x[i] = by_bits(domain, random);
            // As often as not about as large.
            y[i] =
                random.bits() % 2 == 0 ? by_bits(domain, random) : x[i] * static_cast<float>(random.uniform(-3.0, 3.0));
            truth[i] = static_cast<double>(std::atan2(static_cast<long double>(y[i]), static_cast<long double>(x[i])));
        }
        for (const simd::InstructionSet set : simd::available_sets()) {
            simd::array_math(set).atan2(y.data(), x.data(), result.data(), count);
            for (std::size_t i = 0; i < count; ++i) {
                // A quotient that is no normal number has an error of its own.
                const double off = std::fabs(static_cast<double>(result[i]) - truth[i]) /
                                   std::max(ulp(truth[i]), static_cast<double>(0x1p-146F));
                tally.hold(off / domain.bound_ulp, [&] {
                    return fmt::format("atan2 {}: {:.2f} ulp at y {:a} x {:a}", simd::to_text(set), off, y[i], x[i]);
                });
            }
        }
    }
}

} // namespace

std::span<const StressSubject> math_stress() {
    static constexpr std::array subjects{
        StressSubject{"elementary functions", "1 (sqrt) to 3 ulp, as simd/math.hpp says of each", 1.0, unary},
        StressSubject{"atan2", "4 ulp", 1.0, arc_tangent_of_two},
        StressSubject{"elementary functions of any floats", "a NaN stays one", 0.5, outside},
    };
    return subjects;
}

} // namespace gonio::measure::detail
