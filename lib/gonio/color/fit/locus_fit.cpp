// Prints lib/gonio/color/locus_coefficients.hpp: the Planckian locus u'(t), v'(t), t = 1000 K/T, as minimax rational
// functions over 800 K to infinity, by Remez' exchange against the 1 nm sum.
//
//     gonio-locus-fit > lib/gonio/color/locus_coefficients.hpp        the header
//     gonio-locus-fit --errors                                        what each degree achieves, in double and float
//
// The reference is summed in long double; the equations are solved in 113 bits, because those of degree 11 lose 20
// digits.
#include <gonio/base/solve_linear.hpp>
#include <gonio/color/detail/cie_tables.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

namespace {

__extension__ using Real = __float128;
using Rows = std::vector<std::vector<Real>>;

constexpr long double greatest_t = 1.25L; // 800 K
// The fit extends a little beyond both ends, where a minimax error has its steepest slope: the normal of the locus,
// along which Duv is measured, comes from the derivative. The sum is as smooth below t = 0 as above.
constexpr long double fitted_from = -0.02L;
constexpr long double fitted_to = greatest_t + 0.03L;
constexpr long double pi = 3.14159265358979323846L;

std::array<long double, 2> locus(long double t) {
    long double x = 0.0L;
    long double y = 0.0L;
    long double z = 0.0L;
    for (std::size_t i = 0; i < gonio::detail::observer.size(); ++i) {
        const long double w = 1e3L / (gonio::detail::observer_first_nm + static_cast<long double>(i));
        const long double a = 1.438776877e-2L * 1e3L * w;
        // times t, which does not change the chromaticity and is regular at t = 0
        const long double power = w * w * w * w * w * (t != 0.0L ? t / std::expm1(a * t) : 1.0L / a);
        x += power * static_cast<long double>(gonio::detail::observer[i][0]);
        y += power * static_cast<long double>(gonio::detail::observer[i][1]);
        z += power * static_cast<long double>(gonio::detail::observer[i][2]);
    }
    const long double d = x + 15.0L * y + 3.0L * z;
    return {4.0L * x / d, 9.0L * y / d};
}

// The locus on a fine grid, denser at the ends, where the extrema are close together.
struct Samples {
    std::vector<long double> t;
    std::array<std::vector<long double>, 2> value;

    Samples(int count, long double from, long double to) {
        for (int i = 0; i <= count; ++i) {
            t.push_back(from + (to - from) / 2 * (1.0L - std::cos(pi * i / count)));
            const auto at = locus(t.back());
            for (std::size_t c = 0; c < 2; ++c)
                value[c].push_back(at[c]);
        }
    }
};

// p[0] + p[1] t + …  over  1 + q[1] t + …
struct Rational {
    std::vector<double> p, q;
    long double levelled = 0.0L; // the equalised error of the exchange, before rounding
};

Real horner(const std::vector<Real>& c, Real t) {
    Real sum = 0;
    for (std::size_t k = c.size(); k-- > 0;)
        sum = sum * t + c[k];
    return sum;
}

// The sample of largest error in each run of one sign, cut to `wanted` of them; fewer if there are no more.
std::vector<std::size_t> extrema(const std::vector<long double>& error, std::size_t wanted) {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < error.size(); ++i) {
        if (found.empty() || (error[i] > 0) != (error[found.back()] > 0))
            found.push_back(i);
        else if (std::abs(error[i]) > std::abs(error[found.back()]))
            found.back() = i;
    }
    while (found.size() > wanted) {
        if (std::abs(error[found.front()]) < std::abs(error[found.back()]))
            found.erase(found.begin());
        else
            found.pop_back();
    }
    return found;
}

// One run of the exchange. The first nodes are the extrema of a Chebyshev polynomial, concentrated towards t = 0 for a
// warp above 1.
Rational exchange_from(const Samples& samples, std::size_t component, std::size_t degree, double warp) {
    const std::vector<long double>& f = samples.value[component];
    const std::size_t unknowns = 2 * degree + 2;
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < unknowns; ++i) {
        const double share = std::pow(static_cast<double>(i) / static_cast<double>(unknowns - 1), warp);
        nodes.push_back(static_cast<std::size_t>(share * static_cast<double>(samples.t.size() - 1)));
    }
    std::vector<Real> p;
    std::vector<Real> q(degree + 1, 0);
    q[0] = 1;
    Real level = 0;
    Rational best;
    best.levelled = 1.0L;
    for (int exchange = 0; exchange < 40; ++exchange) {
        for (int round = 0; round < 6; ++round) { // the level times the denominator is not a linear term
            Rows rows;
            std::vector<Real> right;
            for (std::size_t i = 0; i < unknowns; ++i) {
                const Real t = samples.t[nodes[i]];
                const Real value = f[nodes[i]];
                std::vector<Real> row;
                Real power = 1;
                for (std::size_t k = 0; k <= degree; ++k, power *= t)
                    row.push_back(power);
                power = t;
                for (std::size_t k = 1; k <= degree; ++k, power *= t)
                    row.push_back(-value * power);
                row.push_back((i % 2 == 0 ? 1 : -1) * horner(q, t));
                rows.push_back(std::move(row));
                right.push_back(value);
            }
            const std::vector<Real> solution = gonio::solve_linear(std::move(rows), std::move(right));
            p.assign(solution.begin(), solution.begin() + static_cast<std::ptrdiff_t>(degree) + 1);
            for (std::size_t k = 1; k <= degree; ++k)
                q[k] = solution[degree + k];
            level = solution.back();
        }
        std::vector<long double> error;
        long double worst = 0.0L;
        for (std::size_t i = 0; i < samples.t.size(); ++i) {
            const Real t = samples.t[i];
            error.push_back(static_cast<long double>(horner(p, t) / horner(q, t)) - f[i]);
            worst = std::fmax(worst, std::abs(error.back()));
        }
        if (worst < best.levelled) {
            best.p.assign(p.begin(), p.end());
            best.q.assign(q.begin(), q.end());
            best.levelled = worst;
        }
        const long double size = std::abs(static_cast<long double>(level));
        if (worst <= size * 1.001L) break;
        std::vector<std::size_t> next = extrema(error, unknowns);
        if (next.size() < unknowns) break;
        nodes = std::move(next);
    }
    return best;
}

// Remez' exchange for rational functions does not converge from every start: takes the best of several.
Rational fit(const Samples& samples, std::size_t component, std::size_t degree) {
    Rational best;
    best.levelled = 1.0L;
    for (const double warp : {0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.4, 1.6}) {
        Rational found = exchange_from(samples, component, degree, warp);
        if (found.levelled < best.levelled) best = std::move(found);
    }
    return best;
}

template<class S>
S evaluate(const Rational& r, S t) {
    S p = 0;
    S q = 0;
    for (std::size_t k = r.p.size(); k-- > 0;) {
        p = p * t + static_cast<S>(r.p[k]);
        q = q * t + static_cast<S>(r.q[k]);
    }
    return p / q;
}

// The largest Δu'v' of both functions, with coefficients and Horner's rule in S.
template<class S>
double worst_error(const Samples& samples, const Rational& u, const Rational& v) {
    long double worst = 0.0L;
    for (const auto at : samples.t) {
        // The reference must be at the rounded t: half an ulp of t is 4e-8 in u'.
        const S t = static_cast<S>(at);
        const auto truth = locus(static_cast<long double>(t));
        const long double du = static_cast<long double>(evaluate(u, t)) - truth[0];
        const long double dv = static_cast<long double>(evaluate(v, t)) - truth[1];
        worst = std::fmax(worst, std::hypot(du, dv));
    }
    return static_cast<double>(worst);
}

void print_array(const char* type, const char* name, const std::vector<double>& c, bool single) {
    (void)std::printf("    static constexpr %s %s[%zu] = {", type, name, c.size());
    for (std::size_t k = 0; k < c.size(); ++k) {
        (void)std::printf("%s", k % 3 == 0 ? "\n        " : " ");
        if (single)
            (void)std::printf("%#.9gF,", static_cast<double>(static_cast<float>(c[k])));
        else
            (void)std::printf("%#.17g,", c[k]);
    }
    (void)std::printf("\n    };\n");
}

void print_struct(const Samples& fine, const char* type, const Rational& u, const Rational& v) {
    const bool single = type[0] == 'f';
    (void)std::printf("// Largest delta u'v' against the sum, 800 K to infinity: %.1e.\n",
                      single ? worst_error<float>(fine, u, v) : worst_error<double>(fine, u, v));
    (void)std::printf("template<>\nstruct LocusCoefficients<%s> {\n", type);
    print_array(type, "pu", u.p, single);
    print_array(type, "qu", u.q, single);
    print_array(type, "pv", v.p, single);
    print_array(type, "qv", v.q, single);
    (void)std::printf("};\n");
}

} // namespace

int main(int argc, char** argv) {
    const Samples samples(1200, fitted_from, fitted_to);
    const Samples fine(3001, 0.0L, greatest_t);
    if (argc > 1 && std::string_view(argv[1]) == "--errors") {
        (void)std::printf("| degrees | levelled u' | levelled v' | max delta u'v', double | max delta u'v', float |\n"
                          "|---|---|---|---|---|\n");
        for (std::size_t degree = 2; degree <= 12; ++degree) {
            const Rational u = fit(samples, 0, degree);
            const Rational v = fit(samples, 1, degree);
            (void)std::printf("| (%zu,%zu) twice | %.1Le | %.1Le | %.1e | %.1e |\n", degree, degree, u.levelled,
                              v.levelled, worst_error<double>(fine, u, v), worst_error<float>(fine, u, v));
        }
        return 0;
    }
    (void)std::printf(
        "// Printed by fit/locus_fit.cpp: rational functions of t = 1000 K/T, near the best of their degrees.\n"
        "// u' = (pu[0] + pu[1] t + …)/(qu[0] + qu[1] t + …), v' likewise. For 0 <= t <= 1.25 (800 K).\n"
        "#pragma once\n\n// clang-format off\nnamespace gonio::color {\n\ntemplate<class T>\nstruct "
        "LocusCoefficients;\n\n");
    print_struct(fine, "float", fit(samples, 0, 6), fit(samples, 1, 6));
    (void)std::printf("\n");
    print_struct(fine, "double", fit(samples, 0, 11), fit(samples, 1, 11));
    (void)std::printf("\n} // namespace gonio::color\n");
    return 0;
}
