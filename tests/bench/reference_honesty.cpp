// Whether the reference integrator's estimate of its own error holds: 1000 seeded cases, each computed with several
// requested errors, against the same integral at much higher convergence. Arguments: the number of cases (1000) and a
// seed (1).
#include <gonio/scene/reference.hpp>

#include "../unit/scene/reference_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

namespace {

using namespace gonio;

struct Tally {
    std::size_t asked = 0;
    std::size_t broken = 0; // |value − truth| > estimate
    std::size_t missed = 0; // |value − truth| > requested error
    std::size_t not_converged = 0;
    std::size_t evaluations = 0;
    std::size_t most_evaluations = 0;
    double worst_share = 0.0;  // error as a fraction of the estimate
    std::vector<double> error; // as a fraction of the requested error

    void add(const ReferenceValue& value, double truth, double goal) {
        ++asked;
        // The limit of double precision: the estimate of the truth itself is as small.
        const double slack = 1e-12 * std::abs(truth);
        const double off = std::max(std::abs(value.value - truth) - slack, 0.0);
        if (off > value.error_estimate) ++broken;
        if (off > goal * std::abs(truth)) ++missed;
        if (!value.converged) ++not_converged;
        evaluations += value.evaluations;
        most_evaluations = std::max(most_evaluations, value.evaluations);
        if (value.error_estimate > 0.0) worst_share = std::max(worst_share, off / value.error_estimate);
        if (truth > 0.0) error.push_back(off / (goal * truth));
    }
    double median() {
        if (error.empty()) return 0.0;
        std::nth_element(error.begin(), error.begin() + static_cast<std::ptrdiff_t>(error.size() / 2), error.end());
        return error[error.size() / 2];
    }
};

} // namespace

int main(int argc, char** argv) {
    const unsigned cases = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 1000U;
    const auto seed = static_cast<std::uint64_t>(argc > 2 ? std::atoll(argv[2]) : 1);
    const ReferenceGoal truth_goal{1e-12, 20'000'000};
    constexpr std::array goals{1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8};
    std::array<Tally, goals.size()> tallies;
    std::size_t rough_truths = 0;
    std::array<double, goals.size()> seconds{};
    for (unsigned i = 0; i < cases; ++i) {
        const test::ReferenceCase c = test::reference_case(i, seed);
        const glm::dvec3 origin(0.0);
        const ReferenceLuminance truth = reference_luminance(c.light, origin, c.normal, c.view, c.material, truth_goal);
        for (const ReferenceValue* t : {&truth.diffuse, &truth.specular})
            if (t->error_estimate > 1e-9 * t->value) {
                ++rough_truths;
                std::printf("case %u: the truth is known to %.1e only\n", i, t->error_estimate / t->value);
            }
        for (std::size_t g = 0; g < goals.size(); ++g) {
            const std::clock_t start = std::clock(); // CPU time: other programs may be running
            const ReferenceLuminance value =
                reference_luminance(c.light, origin, c.normal, c.view, c.material, {goals[g], 4'000'000});
            seconds[g] += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
            const std::size_t before = tallies[g].broken;
            tallies[g].add(value.diffuse, truth.diffuse.value, goals[g]);
            tallies[g].add(value.specular, truth.specular.value, goals[g]);
            if (tallies[g].broken != before)
                std::printf("case %u at %.0e: diffuse %.12g ± %.1e (%.12g), specular %.12g ± %.1e (%.12g)\n", i,
                            goals[g], value.diffuse.value, value.diffuse.error_estimate, truth.diffuse.value,
                            value.specular.value, value.specular.error_estimate, truth.specular.value);
        }
    }
    std::printf(
        "| asked for | values | within the estimate | within what was asked | not converged | median error over "
        "asked | evaluations, mean / most | ms a light |\n|---|---|---|---|---|---|---|---|\n");
    for (std::size_t g = 0; g < goals.size(); ++g) {
        Tally& t = tallies[g];
        std::printf("| %.0e | %zu | %.2f %% | %.2f %% | %zu | %.1e | %zu / %zu | %.2f |\n", goals[g], t.asked,
                    100.0 * static_cast<double>(t.asked - t.broken) / static_cast<double>(t.asked),
                    100.0 * static_cast<double>(t.asked - t.missed) / static_cast<double>(t.asked), t.not_converged,
                    t.median(), t.evaluations / t.asked, t.most_evaluations, 1e3 * seconds[g] / cases);
    }
    std::printf("%zu truths are known to worse than 1e-9\n", rough_truths);
    return 0;
}
