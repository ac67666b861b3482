// Stress: every numeric function on adversarial and random input, searching for a number that breaks its promise.
//
// A subject takes seeded blocks of evaluations; each is checked against a tolerance (documented where the function is)
// or a range. The findings do not depend on the number of threads.
#pragma once

#include <gonio/measure/random.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::measure {

class StressTally {
public:
    // Counts `count` evaluations as done.
    void looked_at(std::uint64_t count) { evaluations_ += count; }

    // The error of one value as a share of its tolerance; a share above 1, or NaN, is a failure. `input` writes the
    // input, in hexadecimal floats.
    template<class Input>
    void hold(double share, const Input& input) {
        ++evaluations_;
        if (!(share <= 1.0)) broken(share, input());
        if (share > worst_) {
            worst_ = share;
            worst_input_ = input();
        }
    }

    // A property that must hold, for evaluations that are counted elsewhere.
    template<class Input>
    void require(bool fine, const Input& input) {
        if (!fine) broken(0.0, input());
    }

    // Adds the tally of the next block of the same subject.
    void add(const StressTally& next);

    [[nodiscard]] std::uint64_t evaluations() const { return evaluations_; }
    [[nodiscard]] std::uint64_t broken() const { return broken_; }
    [[nodiscard]] double worst() const { return worst_; } // share of the tolerance; 0 if there is only a range
    [[nodiscard]] const std::string& worst_input() const { return worst_input_; }
    [[nodiscard]] const std::vector<std::string>& findings() const { return findings_; } // the first three

private:
    void broken(double share, std::string input);

    std::uint64_t evaluations_ = 0;
    std::uint64_t broken_ = 0;
    double worst_ = 0.0;
    std::string worst_input_;
    std::vector<std::string> findings_;
};

struct StressSubject {
    std::string_view name; // "irradiance of a tube"
    std::string_view bar;  // "1e-5 E/L + 1e-6 δ"; the requirement, in words
    // Share of all evaluations of a run; slow subjects have a small weight.
    double weight = 1.0;
    // Runs about `evaluations` evaluations, with all random numbers from `random`.
    void (*block)(Random& random, std::uint64_t evaluations, StressTally& tally);
};

std::span<const StressSubject> stress_subjects();

struct StressOptions {
    std::uint64_t count = 10'000'000; // of all subjects together, approximately
    std::uint64_t seed = 1;
    unsigned threads = 0;         // 0 = as many as the machine has
    std::function<bool()> stop{}; // called between blocks
};

// The tally does not include blocks that a stopped subject did not finish.
StressTally stress(const StressSubject& subject, double share_of_count, const StressOptions& options);

} // namespace gonio::measure
