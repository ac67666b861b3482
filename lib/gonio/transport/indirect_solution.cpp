#include <gonio/base/parallel.hpp>
#include <gonio/transport/indirect_solution.hpp>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace gonio::detail {

namespace {

constexpr int most_steps = 400;
constexpr double least_change = 1e-6; // of the greatest illuminance

class Solver {
public:
    Solver(const ExchangeGeometry& geometry, std::span<const glm::dvec3> albedo,
           std::span<const glm::dvec3> reflected_lx, unsigned threads)
        : geometry_(geometry), patches_(geometry.patches()), threads_(threads) {
        const std::size_t cells = patches_.cells().size();
        reflected_.resize(cells);
        for (std::size_t i = 0; i < cells; ++i) {
            const std::size_t chart = patches_.cells()[i].chart;
            reflected_[i] = geometry.cell_factor(chart) * albedo[patches_.charts().all()[chart].surface];
        }
        once_ = gathered(
            [&](std::uint32_t patch) { return geometry.cell_factor(patches_.chart_of(patch)) * reflected_lx[patch]; });
    }

    // The first bounces one by one.
    std::vector<glm::dvec3> first(int bounces) const {
        std::vector<glm::dvec3> lx = once_;
        for (int step = 1; step < bounces; ++step) {
            std::vector<glm::dvec3> next = bounced(lx);
            const double change = greatest_change(lx, next);
            lx = std::move(next);
            if (change < least_change) break;
        }
        return lx;
    }

    std::vector<glm::dvec3> all() const {
        const std::vector<glm::dvec3> of_one =
            gathered([&](std::uint32_t patch) { return reflected_[patches_.cell_of(patch)]; });
        glm::dvec3 lost(0.0); // of an illuminance of 1 on all cells
        for (std::uint32_t i = 0; i < of_one.size(); ++i)
            lost += patches_.cell_area_m2(i) * (1.0 - of_one[i]);
        std::vector<glm::dvec3> lx = once_;
        for (int step = 0; step < most_steps; ++step) {
            std::vector<glm::dvec3> next = bounced(lx);
            glm::dvec3 missing(0.0);
            for (std::uint32_t i = 0; i < next.size(); ++i)
                missing += patches_.cell_area_m2(i) * (next[i] - lx[i]);
            // Of a stage without an end most of the area is far from where the light goes back and forth.
            const glm::dvec3 level = patches_.charts().endless() ? glm::dvec3(0.0) : missing / lost;
            for (std::size_t i = 0; i < next.size(); ++i)
                if (!patches_.cells()[i].covered) next[i] = glm::max(next[i] + level * of_one[i], glm::dvec3(0.0));
            const double change = greatest_change(lx, next);
            lx = std::move(next);
            if (change < least_change) break;
        }
        return lx;
    }

private:
    // `sent` of each patch.
    template<class SentBy>
    std::vector<glm::dvec3> gathered(const SentBy& sent) const {
        std::vector<glm::dvec3> of_patches(patches_.count());
        for (std::uint32_t patch = 0; patch < of_patches.size(); ++patch)
            of_patches[patch] = sent(patch);
        const std::vector<Sent> all = by_sender(patches_, of_patches);
        std::vector<glm::dvec3> lx(patches_.cells().size(), glm::dvec3(0.0));
        constexpr std::size_t together = 64;
        parallel_for((lx.size() + together - 1) / together, threads_, [&](std::size_t block) {
            for (std::size_t i = block * together; i < std::min((block + 1) * together, lx.size()); ++i)
                if (!patches_.cells()[i].covered) lx[i] = geometry_.from_cells().gathered(i, all);
        });
        return lx;
    }

    std::vector<glm::dvec3> bounced(std::span<const glm::dvec3> lx) const {
        std::vector<glm::dvec3> next = gathered([&](std::uint32_t patch) {
            const std::uint32_t cell = patches_.cell_of(patch);
            return reflected_[cell] * lx[cell];
        });
        for (std::size_t i = 0; i < next.size(); ++i)
            next[i] += once_[i];
        return next;
    }

    static double greatest_change(std::span<const glm::dvec3> before, std::span<const glm::dvec3> after) {
        double change = 0.0;
        double greatest = 0.0;
        for (std::size_t i = 0; i < before.size(); ++i)
            for (int channel = 0; channel < 3; ++channel) {
                change = std::max(change, std::abs(after[i][channel] - before[i][channel]));
                greatest = std::max(greatest, after[i][channel]);
            }
        return greatest > 0.0 ? change / greatest : 0.0;
    }

    const ExchangeGeometry& geometry_;
    const Patches& patches_;
    unsigned threads_;
    std::vector<glm::dvec3> reflected_; // the albedo of each cell, times the factor of its chart
    std::vector<glm::dvec3> once_;      // the first bounce, by cell [lx]
};

} // namespace

std::vector<glm::dvec3> solve_indirect(const ExchangeGeometry& geometry, std::span<const glm::dvec3> albedo,
                                       std::span<const glm::dvec3> reflected_lx, int bounces, unsigned threads) {
    if (bounces <= 0) return {geometry.patches().cells().size(), glm::dvec3(0.0)};
    const Solver solver(geometry, albedo, reflected_lx, threads);
    return bounces == all_bounces ? solver.all() : solver.first(bounces);
}

} // namespace gonio::detail
