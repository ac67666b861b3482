#include <gonio/base/parallel.hpp>
#include <gonio/transport/indirect_solution.hpp>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace gonio::detail {

namespace {

constexpr int most_steps = 400;
constexpr double least_change = 1e-6;

class Solver {
public:
    Solver(const ExchangeGeometry& geometry, std::span<const glm::dvec3> albedo, std::span<const glm::dvec3> direct_lx,
           unsigned threads)
        : geometry_(geometry), patches_(geometry.patches()), albedo_(albedo), threads_(threads) {
        sent_.resize(patches_.count());
        for (std::uint32_t i = 0; i < sent_.size(); ++i)
            sent_[i] = albedo[patches_.surface_of(i)] * direct_lx[i];
        const std::size_t cells = patches_.cells().size();
        cell_albedo_.resize(cells);
        for (std::size_t i = 0; i < cells; ++i)
            cell_albedo_[i] = albedo[patches_.charts().all()[patches_.cells()[i].chart].surface];
        once_ = gathered([&](std::uint32_t patch) { return sent_[patch]; });
        for (std::uint32_t i = 0; i < sent_.size(); ++i)
            returned_lm_ += patches_.area_m2(i) * (1.0 - geometry.escaping(patches_.cell_of(i))) * sent_[i];
        glm::dvec3 sent_lm(0.0);
        for (std::uint32_t i = 0; i < sent_.size(); ++i)
            sent_lm += patches_.area_m2(i) * sent_[i];
        // In an open stage few rays return, and their number is too uncertain to balance by. A plane has light on parts
        // of it that no patch counts.
        balances_ = !patches_.charts().endless();
        for (int channel = 0; channel < 3; ++channel)
            balances_ = balances_ && returned_lm_[channel] >= 0.5 * sent_lm[channel];
    }

    std::vector<glm::dvec3> solve(int bounces) {
        std::vector<glm::dvec3> lx = once_;
        const bool all = bounces == all_bounces;
        if (all) balance(lx);
        for (int step = 1; step < (all ? most_steps : std::min(bounces, most_steps)); ++step) {
            std::vector<glm::dvec3> next = gathered([&](std::uint32_t patch) {
                const std::uint32_t cell = patches_.cell_of(patch);
                return cell_albedo_[cell] * lx[cell];
            });
            for (std::size_t i = 0; i < next.size(); ++i)
                next[i] += once_[i];
            if (all) balance(next);
            const double change = greatest_change(lx, next);
            lx = std::move(next);
            if (change < least_change) break;
        }
        return lx;
    }

private:
    template<class Sent>
    std::vector<glm::dvec3> gathered(const Sent& sent) const {
        std::vector<glm::dvec3> lx(patches_.cells().size(), glm::dvec3(0.0));
        constexpr std::size_t together = 64;
        parallel_for((lx.size() + together - 1) / together, threads_, [&](std::size_t block) {
            for (std::size_t i = block * together; i < std::min((block + 1) * together, lx.size()); ++i) {
                if (patches_.cells()[i].covered) continue;
                const std::span<const std::uint32_t> ends = geometry_.cell_ends(i);
                glm::dvec3 sum(0.0);
                for (const std::uint32_t patch : ends)
                    if (patch != no_patch) sum += sent(patch);
                lx[i] = sum / static_cast<double>(ends.size());
            }
        });
        return lx;
    }

    // What arrives is what is sent and does not escape: Σ E A = Σ ρ (E₀ + E) A (1 − x).
    void balance(std::vector<glm::dvec3>& lx) const {
        if (!balances_) return;
        glm::dvec3 lost_lm(0.0);
        for (std::uint32_t i = 0; i < lx.size(); ++i)
            lost_lm += patches_.cell_area_m2(i) * lx[i] * (1.0 - cell_albedo_[i] * (1.0 - geometry_.escaping(i)));
        for (int channel = 0; channel < 3; ++channel)
            if (lost_lm[channel] > 0.0)
                for (glm::dvec3& of_cell : lx)
                    of_cell[channel] *= returned_lm_[channel] / lost_lm[channel];
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
    std::span<const glm::dvec3> albedo_;
    unsigned threads_;
    std::vector<glm::dvec3> sent_; // of direct light, by patch [lm/m²]
    std::vector<glm::dvec3> cell_albedo_;
    std::vector<glm::dvec3> once_; // the first bounce, by cell [lx]
    glm::dvec3 returned_lm_{0.0};
    bool balances_ = true;
};

} // namespace

std::vector<glm::dvec3> solve_indirect(const ExchangeGeometry& geometry, std::span<const glm::dvec3> albedo,
                                       std::span<const glm::dvec3> direct_lx, int bounces, unsigned threads) {
    if (bounces <= 0) return std::vector<glm::dvec3>(geometry.patches().cells().size(), glm::dvec3(0.0));
    return Solver(geometry, albedo, direct_lx, threads).solve(bounces);
}

} // namespace gonio::detail
