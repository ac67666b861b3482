// Prints the coefficients of simd/math.hpp: weighted minimax polynomials, by the Remez exchange algorithm. The test
// generated.minimax compares them.
//
// Each function is written as a known head plus a power times P(t); the weight makes the error of P an error relative
// to the function. The last column is that error before rounding of the coefficients to float.
#include <gonio/base/solve_linear.hpp>

#include <cmath>
#include <cstdio>
#include <functional>
#include <utility>
#include <vector>

namespace {

using Real = long double;
using Function = std::function<Real(Real)>;

// Minimises max |weight·(target − P)| over [low, high] over the polynomials P with `terms` coefficients.
void fit(const char* name, const Function& target, const Function& weight, Real low, Real high, std::size_t terms) {
    const Real pi = std::acos(Real(-1));
    std::vector<Real> nodes(terms + 1);
    for (std::size_t i = 0; i <= terms; ++i)
        nodes[i] = (low + high) / 2 - (high - low) / 2 * std::cos(pi * Real(i) / Real(terms));
    std::vector<Real> c;
    Real worst = 0;
    for (int round = 0; round < 12; ++round) {
        std::vector<std::vector<Real>> rows;
        std::vector<Real> right;
        for (std::size_t i = 0; i <= terms; ++i) {
            std::vector<Real> row;
            for (std::size_t k = 0; k < terms; ++k)
                row.push_back(std::pow(nodes[i], Real(k)));
            row.push_back((i % 2 == 0 ? 1 : -1) / weight(nodes[i]));
            rows.push_back(row);
            right.push_back(target(nodes[i]));
        }
        c = gonio::solve_linear(rows, right);
        const auto error = [&](Real t) {
            Real p = 0;
            for (std::size_t k = terms; k-- > 0;)
                p = p * t + c[k];
            return weight(t) * (target(t) - p);
        };
        // The next nodes: the extremum of each run of errors with the same sign.
        constexpr int samples = 40000;
        std::vector<std::pair<Real, Real>> extrema;
        worst = 0;
        for (int i = 0; i <= samples; ++i) {
            const Real t = low + (high - low) * Real(i) / samples;
            const Real e = error(t);
            worst = std::max(worst, std::abs(e));
            if (extrema.empty() || (e > 0) != (extrema.back().second > 0)) {
                extrema.emplace_back(t, e);
            } else if (std::abs(e) > std::abs(extrema.back().second)) {
                extrema.back() = {t, e};
            }
        }
        if (extrema.size() < terms + 1) break;
        while (extrema.size() > terms + 1) {
            if (std::abs(extrema.front().second) < std::abs(extrema.back().second)) {
                extrema.erase(extrema.begin());
            } else {
                extrema.pop_back();
            }
        }
        for (std::size_t i = 0; i <= terms; ++i)
            nodes[i] = extrema[i].first;
    }
    std::printf("%s:", name);
    c.resize(terms); // the last unknown was the levelled error
    for (const Real k : c)
        std::printf(" %.9gF", static_cast<double>(static_cast<float>(k)));
    std::printf("   %.2Lg\n", worst);
}

} // namespace

int main() {
    const Real tiny = 1e-5L;
    const auto root = [](Real t) { return std::sqrt(t); };
    const auto atan_excess = [&](Real t) {
        return t < 1e-6L ? -1.0L / 3 + t / 5 - t * t / 7 : (std::atan(root(t)) / root(t) - 1) / t;
    };
    fit(
        "atan, x=sqrt t in [0,1]: x + x t P(t), relative to x t P(t)", atan_excess,
        [&](Real t) { return -1 / atan_excess(t); }, 0, 1, 9);
    fit(
        "atanh, x=sqrt t in [0,1/2]: x + x t P(t)",
        [&](Real t) { return t < tiny ? 1.0L / 3 + t / 5 : (std::atanh(root(t)) / root(t) - 1) / t; },
        [&](Real t) { return t < tiny ? tiny : t * root(t) / std::atanh(root(t)); }, 0, 0.25L, 5);
    fit(
        "asin, x=sqrt t in [0,1/2]: x + x t P(t)",
        [&](Real t) { return t < tiny ? 1.0L / 6 + 3 * t / 40 : (std::asin(root(t)) / root(t) - 1) / t; },
        [&](Real t) { return t < tiny ? tiny : t * root(t) / std::asin(root(t)); }, 0, 0.25L, 5);
    fit(
        "sin, x=sqrt t in [0,pi/4]: x + x t P(t)",
        [&](Real t) { return t < tiny ? -1.0L / 6 + t / 120 : (std::sin(root(t)) / root(t) - 1) / t; },
        [&](Real t) { return t < tiny ? tiny : t * root(t) / std::sin(root(t)); }, 0, 0.617L, 3);
    fit(
        "cos, x=sqrt t in [0,pi/4]: 1 - t/2 + t t P(t)",
        [&](Real t) { return t < 1e-4L ? 1.0L / 24 - t / 720 : (std::cos(root(t)) - 1 + t / 2) / (t * t); },
        [&](Real t) { return t < 1e-4L ? 1e-8L : t * t / std::cos(root(t)); }, 0, 0.617L, 3);
    fit(
        "exp2, t in [-1/2,1/2]: 1 + t P(t)",
        [&](Real t) { return std::abs(t) < 1e-12L ? std::log(2.0L) : std::expm1(t * std::log(2.0L)) / t; },
        [&](Real t) { return std::max(std::abs(t), tiny) / std::exp2(t); }, -0.5L, 0.5L, 6);
    fit(
        "log(1+t), t in [sqrt(1/2)-1, sqrt 2-1]: t - t t/2 + t t t P(t)",
        [&](Real t) {
            return std::abs(t) < 1e-4L ? 1.0L / 3 - t / 4 + t * t / 5 : (std::log1p(t) - t + t * t / 2) / (t * t * t);
        },
        [&](Real t) { return std::abs(t) < 1e-4L ? 1e-8L : std::abs(t * t * t / std::log1p(t)); }, std::sqrt(0.5L) - 1,
        std::sqrt(2.0L) - 1, 9);
}
