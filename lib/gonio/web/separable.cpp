#include <gonio/web/integrate.hpp>
#include <gonio/web/separable.hpp>

#include <algorithm>
#include <numbers>

namespace gonio {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;

void add(Terms& terms, std::size_t index, double weight) {
    if (weight == 0.0) return;
    for (Term& term : terms) {
        if (term.index != index) continue;
        term.weight += weight;
        return;
    }
    terms.push_back({index, weight});
}

// `low`, what of `knots` lies strictly between, and `high`.
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
    Terms terms;
    // Between two bends the web is linear in C, so its mean there is its value in the middle.
    const std::vector<double> pieces = cuts(bends_deg, low_deg, high_deg);
    for (std::size_t k = 1; k < pieces.size(); ++k) {
        const double width = (pieces[k] - pieces[k - 1]) * radians_per_degree;
        const double c = web.folded_c_deg(0.5 * (pieces[k] + pieces[k - 1]));
        if (c < planes.front() || c > planes.back()) continue;
        const auto above = std::upper_bound(planes.begin(), planes.end(), c);
        const auto right = std::min(static_cast<std::size_t>(above - planes.begin()), planes.size() - 1);
        if (right == 0) continue; // one plane of a web that is not axial: no width, no light
        const double weight = (c - planes[right - 1]) / (planes[right] - planes[right - 1]);
        add(terms, right - 1, width * (1.0 - weight));
        add(terms, right, width * weight);
    }
    return terms;
}

Terms gamma_terms(const Web& web, double low_deg, double high_deg) {
    const std::span<const double> gammas = web.gammas_deg();
    Terms terms;
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
        add(terms, upper - 1, integrate_linear_sin(a, b, 1.0 - at_from, 1.0 - at_to));
        add(terms, upper, integrate_linear_sin(a, b, at_from, at_to));
    }
    return terms;
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
