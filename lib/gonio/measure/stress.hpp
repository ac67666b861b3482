// Stress: every numeric function on adversarial and random input, until a number breaks its promise.
//
// A subject takes seeded blocks of evaluations; each is held to a bar (documented where the function is) or to a range.
// What is found does not depend on the number of threads.
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
    // Of `count` evaluations that were looked at.
    void looked_at(std::uint64_t count) { evaluations_ += count; }

    // One value's share of its bar; above 1, or NaN, it is broken. `input` writes the input down, in hexadecimal
    // floats.
    template<class Input>
    void hold(double share, const Input& input) {
        ++evaluations_;
        if (!(share <= 1.0)) broken(share, input());
        if (share > worst_) {
            worst_ = share;
            worst_input_ = input();
        }
    }

    // A value that must be what it is promised to be, of evaluations that are counted elsewhere.
    template<class Input>
    void require(bool fine, const Input& input) {
        if (!fine) broken(0.0, input());
    }

    // Those of the next block of the same subject.
    void add(const StressTally& next);

    [[nodiscard]] std::uint64_t evaluations() const { return evaluations_; }
    [[nodiscard]] std::uint64_t broken() const { return broken_; }
    [[nodiscard]] double worst() const { return worst_; } // share of the bar; 0 where there is only a range
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
    std::string_view bar;  // "1e-5 E/L + 1e-6 δ"; what is required, in words
    // Of all evaluations of a run; slow subjects take few.
    double weight = 1.0;
    // About `evaluations` of them, with everything random from `random`.
    void (*block)(Random& random, std::uint64_t evaluations, StressTally& tally);
};

std::span<const StressSubject> stress_subjects();

struct StressOptions {
    std::uint64_t count = 10'000'000; // evaluations of all subjects together, about
    std::uint64_t seed = 1;
    unsigned threads = 0;         // 0 = as many as there are
    std::function<bool()> stop{}; // asked between blocks
};

// Nothing of what a stopped subject had left is in its tally.
StressTally stress(const StressSubject& subject, double share_of_count, const StressOptions& options);

} // namespace gonio::measure
