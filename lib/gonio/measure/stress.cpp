#include <gonio/base/parallel.hpp>
#include <gonio/measure/stress.hpp>
#include <gonio/measure/stress/subjects.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gonio::measure {

namespace {

constexpr std::uint64_t block_evaluations = 20'000;
constexpr std::size_t most_findings = 3;
constexpr std::size_t blocks_at_once = 256; // their tallies are added after each batch

// Hash of a name: FNV-1a (G. Fowler, L. Noll, P. Vo, 1991), so that subjects do not share random numbers.
std::uint64_t hash(std::string_view text) {
    std::uint64_t h = 0xCBF29CE484222325U;
    for (const char c : text)
        h = (h ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
    return h;
}

} // namespace

void StressTally::broken(double share, std::string input) {
    ++broken_;
    if (findings_.size() >= most_findings) return;
    findings_.push_back(share > 0.0 || std::isnan(share) ? fmt::format("{:.3g} of the error bound: {}", share, input)
                                                         : std::move(input));
}

void StressTally::add(const StressTally& next) {
    evaluations_ += next.evaluations_;
    broken_ += next.broken_;
    if (next.worst_ > worst_) {
        worst_ = next.worst_;
        worst_input_ = next.worst_input_;
    }
    for (const std::string& finding : next.findings_)
        if (findings_.size() < most_findings) findings_.push_back(finding);
}

std::span<const StressSubject> stress_subjects() {
    static const std::vector<StressSubject> all = [] {
        std::vector<StressSubject> made;
        for (const auto subjects : {detail::irradiance_stress(), detail::specular_stress(), detail::brdf_stress(),
                                    detail::falloff_stress(), detail::geometry_stress(), detail::math_stress(),
                                    detail::color_stress(), detail::light_stress(), detail::web_stress()})
            made.insert(made.end(), subjects.begin(), subjects.end());
        return made;
    }();
    return all;
}

StressTally stress(const StressSubject& subject, double share_of_count, const StressOptions& options) {
    const auto wanted = static_cast<std::uint64_t>(std::ceil(share_of_count * static_cast<double>(options.count)));
    // A slow subject gets smaller blocks, so that they take no longer than those of other subjects.
    const auto of_block =
        std::clamp(static_cast<std::uint64_t>(static_cast<double>(block_evaluations) * subject.weight),
                   std::uint64_t{16}, block_evaluations);
    const std::uint64_t blocks = std::max<std::uint64_t>(1, (wanted + of_block - 1) / of_block);
    const std::uint64_t own_seed = hash(subject.name) ^ (options.seed * 0x9E3779B97F4A7C15U);
    StressTally all;
    for (std::uint64_t first = 0; first < blocks; first += blocks_at_once) {
        std::vector<StressTally> tallies(
            static_cast<std::size_t>(std::min<std::uint64_t>(blocks_at_once, blocks - first)));
        parallel_for(tallies.size(), options.threads, [&](std::size_t i) {
            if (options.stop && options.stop()) return;
            Random random(own_seed + (first + i) * 0xD1342543DE82EF95U);
            subject.block(random, of_block, tallies[i]);
        });
        for (const StressTally& tally : tallies)
            all.add(tally);
        if (options.stop && options.stop()) break;
    }
    return all;
}

} // namespace gonio::measure
