#include <gonio/web/refine_grid.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace gonio::web_detail {

namespace {

// The angles and the midpoints between them.
std::vector<double> with_middles(const std::vector<double>& angles) {
    std::vector<double> all;
    all.reserve(2 * angles.size() - 1);
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
        all.push_back(angles[i]);
        all.push_back(0.5 * (angles[i] + angles[i + 1]));
    }
    all.push_back(angles.back());
    return all;
}

// A step of one axis, and the difference of the light at its midpoint from the mean of its ends.
struct Step {
    bool of_planes = false;
    std::size_t index = 0;
    double error = 0.0;
};

// Intensities at the angles of a grid and the midpoints between them.
class Samples {
public:
    explicit Samples(const Light& light) : light_(light) {}

    // Those of a finer grid: a direction that the grid before had is not evaluated again.
    void take(const AngleGrid& grid) {
        std::vector<double> planes = with_middles(grid.planes_deg);
        std::vector<double> gammas = with_middles(grid.gammas_deg);
        const std::vector<std::size_t> of_plane = places(planes, planes_deg);
        const std::vector<std::size_t> of_gamma = places(gammas, gammas_deg);
        std::vector<double> new_gammas;
        for (std::size_t j = 0; j < gammas.size(); ++j)
            if (of_gamma[j] == gammas_deg.size()) new_gammas.push_back(gammas[j]);
        LightRows of_all(light_, gammas);
        LightRows of_new(light_, new_gammas);
        std::vector<double> all;
        all.reserve(planes.size() * gammas.size());
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const bool is_known = of_plane[i] < planes_deg.size();
            std::span<const double> found = is_known ? of_new.quick(planes[i]) : of_all.quick(planes[i]);
            for (const std::size_t j : of_gamma) {
                if (is_known && j < gammas_deg.size()) {
                    all.push_back(candela[of_plane[i] * gammas_deg.size() + j]);
                    continue;
                }
                all.push_back(found.front());
                found = found.subspan(1);
            }
        }
        planes_deg = std::move(planes);
        gammas_deg = std::move(gammas);
        candela = std::move(all);
    }

    std::vector<double> planes_deg;
    std::vector<double> gammas_deg;
    std::vector<double> candela; // [plane][γ]

private:
    // Of each angle its place among others, or their number if it is not among them. Both ascend.
    static std::vector<std::size_t> places(const std::vector<double>& angles, const std::vector<double>& among) {
        std::vector<std::size_t> all;
        std::size_t place = 0;
        for (const double angle : angles) {
            while (place < among.size() && among[place] < angle)
                ++place;
            all.push_back(place < among.size() && among[place] == angle ? place : among.size());
        }
        return all;
    }

    const Light& light_;
};

std::vector<Step> errors_of(const Samples& samples) {
    const std::vector<double>& planes = samples.planes_deg;
    const std::vector<double>& candela = samples.candela;
    const std::size_t rows = samples.gammas_deg.size();
    std::vector<Step> steps;
    for (std::size_t i = 1; i < planes.size(); i += 2) {
        Step step{true, i / 2, 0.0};
        for (std::size_t j = 0; j < rows; ++j)
            step.error = std::max(step.error, std::abs(candela[i * rows + j] - 0.5 * (candela[(i - 1) * rows + j] +
                                                                                      candela[(i + 1) * rows + j])));
        steps.push_back(step);
    }
    for (std::size_t j = 1; j < rows; j += 2) {
        Step step{false, j / 2, 0.0};
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const double* const at = candela.data() + i * rows + j;
            step.error = std::max(step.error, std::abs(at[0] - 0.5 * (at[-1] + at[1])));
        }
        steps.push_back(step);
    }
    return steps;
}

} // namespace

AngleGrid refined_grid(const Light& light, AngleGrid grid, Candelas limit) {
    Samples samples(light);
    for (;;) {
        samples.take(grid);
        std::vector<Step> steps = errors_of(samples);
        const auto angles_of_axis = [&](const Step& step) -> std::vector<double>& {
            return step.of_planes ? grid.planes_deg : grid.gammas_deg;
        };
        std::erase_if(steps, [&](const Step& step) {
            const std::vector<double>& angles = angles_of_axis(step);
            return step.error <= 0.5 * limit.value || angles[step.index + 1] - angles[step.index] <= finest_step_deg;
        });
        std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.error > b.error; });
        std::vector<double> planes;
        std::vector<double> gammas;
        for (const Step& step : steps) {
            const std::size_t more_planes = grid.planes_deg.size() + planes.size() + (step.of_planes ? 1 : 0);
            const std::size_t more_gammas = grid.gammas_deg.size() + gammas.size() + (step.of_planes ? 0 : 1);
            if (more_planes * more_gammas > most_refined_points) break;
            const std::vector<double>& angles = angles_of_axis(step);
            (step.of_planes ? planes : gammas).push_back(0.5 * (angles[step.index] + angles[step.index + 1]));
        }
        if (planes.empty() && gammas.empty()) return grid;
        for (auto& [into, from] : {std::pair{&grid.planes_deg, &planes}, std::pair{&grid.gammas_deg, &gammas}}) {
            into->insert(into->end(), from->begin(), from->end());
            std::sort(into->begin(), into->end());
        }
    }
}

} // namespace gonio::web_detail
