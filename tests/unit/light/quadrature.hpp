// Gauss–Legendre rules for the tests, with nodes found by Newton's method: shares nothing with the library.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace gonio::test {

template<class Real>
struct GaussRule {
    std::vector<Real> at;
    std::vector<Real> weight;

    explicit GaussRule(int n) {
        for (int i = 0; i < n; ++i) {
            Real x = std::cos(std::numbers::pi_v<Real> * (Real(i) + Real(0.75)) / (Real(n) + Real(0.5)));
            Real slope = 1;
            for (int step = 0; step < 50; ++step) {
                Real before = 1;
                Real here = x;
                for (int k = 2; k <= n; ++k) {
                    const Real next = (Real(2 * k - 1) * x * here - Real(k - 1) * before) / Real(k);
                    before = here;
                    here = next;
                }
                slope = Real(n) * (x * here - before) / (x * x - 1);
                x -= here / slope;
            }
            at.push_back(x);
            weight.push_back(2 / ((1 - x * x) * slope * slope));
        }
    }
};

// ∫ f over [low, high], split into `panels` equal pieces of 24 nodes each.
template<class Real, class F>
Real integral(Real low, Real high, int panels, F&& f) {
    static const GaussRule<Real> rule(24);
    Real sum = 0;
    for (int p = 0; p < panels; ++p) {
        const Real from = low + (high - low) * Real(p) / Real(panels);
        const Real to = low + (high - low) * Real(p + 1) / Real(panels);
        const Real half = (to - from) / 2;
        for (std::size_t i = 0; i < rule.at.size(); ++i)
            sum += half * rule.weight[i] * f((from + to) / 2 + half * rule.at[i]);
    }
    return sum;
}

} // namespace gonio::test
