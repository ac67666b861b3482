#include <gonio/web/integrate.hpp>
#include <gonio/web/separable.hpp>

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <utility>

namespace gonio {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;

// Terms in the order of their first occurrence, each index once. A few terms are searched linearly; for many, such as
// all planes of a fine web, a table maps each index to its position.
class Sum {
public:
    explicit Sum(std::size_t indices) : indices_(indices) {}

    void add(std::size_t index, double weight) {
        if (weight == 0.0) return;
        const std::size_t at = place_of(index);
        if (at < terms_.size()) {
            terms_[at].weight += weight;
            return;
        }
        if (!places_.empty()) places_[index] = terms_.size();
        terms_.push_back({index, weight});
        if (places_.empty() && terms_.size() > few) make_table();
    }

    Terms take() { return std::move(terms_); }

private:
    static constexpr std::size_t few = 32;
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    std::size_t place_of(std::size_t index) const {
        if (!places_.empty()) return places_[index];
        const auto found =
            std::find_if(terms_.begin(), terms_.end(), [&](const Term& term) { return term.index == index; });
        return found == terms_.end() ? none : static_cast<std::size_t>(found - terms_.begin());
    }

    void make_table() {
        places_.assign(indices_, none);
        for (std::size_t i = 0; i < terms_.size(); ++i)
            places_[terms_[i].index] = i;
    }

    std::size_t indices_;
    Terms terms_;
    std::vector<std::size_t> places_;
};

// `low`, the `knots` strictly in between, and `high`.
std::vector<double> cuts(std::span<const double> knots, double low, double high) {
    std::vector<double> all{low};
    const auto first = std::upper_bound(knots.begin(), knots.end(), low);
    for (auto knot = first; knot != knots.end() && *knot < high; ++knot)
        all.push_back(*knot);
    all.push_back(high);
    return all;
}

} // namespace

Terms plane_terms(const Web& web, std::span<const double> bends_deg, double low_deg, double high_deg) {
    const std::span<const double> planes = web.planes_deg();
    if (web.stored_symmetry() == Symmetry::axial) return {{0, (high_deg - low_deg) * radians_per_degree}};
    Sum terms(planes.size());
    // Between two bends the web is linear in C, so its mean there is the value at the midpoint.
    const std::vector<double> pieces = cuts(bends_deg, low_deg, high_deg);
    for (std::size_t k = 1; k < pieces.size(); ++k) {
        const double width = (pieces[k] - pieces[k - 1]) * radians_per_degree;
        const double c = web.folded_c_deg(0.5 * (pieces[k] + pieces[k - 1]));
        if (c < planes.front() || c > planes.back()) continue;
        const auto above = std::upper_bound(planes.begin(), planes.end(), c);
        const auto right = std::min(static_cast<std::size_t>(above - planes.begin()), planes.size() - 1);
        if (right == 0) continue; // one plane of a web that is not axial: no width, so no light
        const double weight = (c - planes[right - 1]) / (planes[right] - planes[right - 1]);
        terms.add(right - 1, width * (1.0 - weight));
        terms.add(right, width * weight);
    }
    return terms.take();
}

Terms gamma_terms(const Web& web, double low_deg, double high_deg) {
    const std::span<const double> gammas = web.gammas_deg();
    Sum terms(gammas.size());
    const std::vector<double> pieces = cuts(gammas, low_deg, high_deg);
    for (std::size_t k = 1; k < pieces.size(); ++k) {
        const double from = pieces[k - 1];
        const double to = pieces[k];
        const double middle = 0.5 * (from + to);
        if (middle < gammas.front() || middle > gammas.back() || gammas.size() < 2) continue;
        const auto above = std::upper_bound(gammas.begin(), gammas.end(), middle);
        const auto upper = std::min(static_cast<std::size_t>(above - gammas.begin()), gammas.size() - 1);
        const double cell = gammas[upper] - gammas[upper - 1];
        const double at_from = (from - gammas[upper - 1]) / cell;
        const double at_to = (to - gammas[upper - 1]) / cell;
        const double a = from * radians_per_degree;
        const double b = to * radians_per_degree;
        terms.add(upper - 1, integrate_linear_sin(a, b, 1.0 - at_from, 1.0 - at_to));
        terms.add(upper, integrate_linear_sin(a, b, at_from, at_to));
    }
    return terms.take();
}

Lumens sum_of(const Web& web, const Terms& planes, const Terms& gammas) {
    double sum = 0.0;
    for (const Term& plane : planes) {
        double along = 0.0;
        for (const Term& gamma : gammas)
            along += gamma.weight * web.column(plane.index)[gamma.index];
        sum += plane.weight * along;
    }
    return Lumens(sum);
}

} // namespace gonio
