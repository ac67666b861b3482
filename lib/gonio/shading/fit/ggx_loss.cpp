// Prints lib/gonio/shading/ggx_loss_coefficients.hpp: the share of light that GGX facets with a reflectance of 1 lose
// by single scattering, L(μ, α) = 1 − E, as a polynomial in two variables.
//
//     gonio-ggx-loss-fit > lib/gonio/shading/ggx_loss_coefficients.hpp     the header
//     gonio-ggx-loss-fit --errors                                          the errors of other degrees
//
// E = ∫∫ G₂/G₁ over the visible normals: a cap of the unit sphere about the stretched view (J. Dupuy and A. Benyoub,
// 2023). Each ring of it is an arc, since the mirrored direction is above the surface where a linear function of cosφ
// is positive. The cap is divided at the rings where that arc begins or becomes a full circle; within the pieces the
// integrand is smooth.
#include <gonio/base/gauss_legendre.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t of_cosine = 16; // coefficients in s = √(μ(1 + α)/(μ + α)): L behaves as μ ln μ at 0
constexpr std::size_t of_alpha = 10;  // and in α

// On [0, 1].
constexpr auto rule = [] {
    auto nodes = gonio::gauss_legendre<40>();
    for (gonio::QuadratureNode& node : nodes)
        node = {0.5 + 0.5 * node.at, 0.5 * node.weight};
    return nodes;
}();

// The cap of visible normals for one view.
class VisibleNormals {
public:
    VisibleNormals(double mu, double alpha) : alpha_(alpha), mu_(mu), across_(std::sqrt((1.0 - mu) * (1.0 + mu))) {
        const double length = std::hypot(alpha * across_, mu);
        stretched_across_ = alpha * across_ / length;
        stretched_up_ = mu / length;
    }

    // ∫∫ G₂/G₁ du dφ/π over φ in [0, π], where u is the share of the cap's height.
    [[nodiscard]] double albedo() const {
        double sum = 0.0;
        const std::vector<double> cuts = divisions();
        for (std::size_t piece = 0; piece + 1 < cuts.size(); ++piece) {
            const double width = cuts[piece + 1] - cuts[piece];
            for (const gonio::QuadratureNode& node : rule) {
                // Denser towards both ends, where the integrand has square roots of the distance.
                const double x = node.at;
                const double u = cuts[piece] + width * x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
                sum += node.weight * width * 30.0 * x * x * (1.0 - x) * (1.0 - x) * ring(u);
            }
        }
        return sum;
    }

private:
    struct Ring {
        double r, up;               // of the point of the cap about the stretched view's axis; of the normal, not unit
        double constant, of_cosine; // the sign of the mirrored direction's height is that of constant + of_cosine·cosφ
    };

    [[nodiscard]] Ring ring_at(double u) const {
        const double fallen = u * (1.0 + stretched_up_);
        const double r = std::sqrt(std::fmax(fallen * (2.0 - fallen), 0.0));
        const double up = (1.0 - u) * (1.0 + stretched_up_);
        const double a2 = alpha_ * alpha_;
        const double constant = 2.0 * up * (across_ * alpha_ * stretched_across_ + mu_ * up) -
                                mu_ * (a2 * (r * r + stretched_across_ * stretched_across_) + up * up);
        return {r, up, constant, 2.0 * r * (up * across_ * alpha_ - mu_ * a2 * stretched_across_)};
    }

    [[nodiscard]] double ring(double u) const {
        const Ring at = ring_at(u);
        double from = 0.0;
        double to = pi;
        const double size = std::fabs(at.of_cosine);
        if (at.constant <= -size) return 0.0;
        if (at.constant < size) (at.of_cosine > 0.0 ? to : from) = std::acos(-at.constant / at.of_cosine);
        double sum = 0.0;
        for (const gonio::QuadratureNode& node : rule)
            sum += node.weight * shadowing(at, from + (to - from) * node.at);
        return sum * (to - from) / pi;
    }

    // G₂/G₁ of the direction mirrored at the normal of azimuth φ.
    [[nodiscard]] double shadowing(const Ring& at, double phi) const {
        const double x = alpha_ * (at.r * std::cos(phi) + stretched_across_);
        const double y = alpha_ * at.r * std::sin(phi);
        const double length2 = x * x + y * y + at.up * at.up;
        const double out = 2.0 * (across_ * x + mu_ * at.up) * at.up / length2 - mu_;
        if (!(out > 0.0)) return 0.0;
        const double a2 = alpha_ * alpha_;
        const double wide_in = std::sqrt(a2 + (1.0 - a2) * mu_ * mu_);
        const double wide_out = std::sqrt(a2 + (1.0 - a2) * out * out);
        return out * (mu_ + wide_in) / (out * wide_in + mu_ * wide_out);
    }

    // 0, 1 and the heights at which a ring's arc begins or becomes a full circle.
    [[nodiscard]] std::vector<double> divisions() const {
        constexpr int steps = 400;
        std::vector<double> cuts{0.0};
        for (const double side : {-1.0, 1.0}) {
            const auto sign = [&](double u) {
                const Ring at = ring_at(u);
                return at.constant + side * at.of_cosine > 0.0;
            };
            for (int k = 0; k < steps; ++k) {
                double low = place(k, steps);
                double high = place(k + 1, steps);
                if (sign(low) == sign(high)) continue;
                const bool below = sign(low);
                for (int halving = 0; halving < 60; ++halving) {
                    const double middle = 0.5 * (low + high);
                    (sign(middle) == below ? low : high) = middle;
                }
                cuts.push_back(low);
            }
        }
        cuts.push_back(1.0);
        for (std::size_t i = 1; i < cuts.size(); ++i)
            for (std::size_t k = i; k > 0 && cuts[k] < cuts[k - 1]; --k)
                std::swap(cuts[k], cuts[k - 1]);
        return cuts;
    }
    // Uniform in between, denser towards 1, where small α puts its divisions.
    static double place(int k, int steps) {
        const double left = 1.0 - static_cast<double>(k) / steps;
        return 1.0 - left * left * left * left;
    }

    double alpha_, mu_, across_;
    double stretched_across_ = 0.0, stretched_up_ = 0.0;
};

double loss(double mu, double alpha) {
    return 1.0 - VisibleNormals(mu, alpha).albedo();
}

// Chebyshev points of [0, 1] without its ends, and with them; and the polynomials T_i(2x − 1).
double inner_point(std::size_t i, std::size_t count) {
    return 0.5 + 0.5 * std::cos(pi * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
}
double end_point(std::size_t i, std::size_t count) {
    return i + 1 == count ? 0.0 : 0.5 + 0.5 * std::cos(pi * static_cast<double>(i) / static_cast<double>(count - 1));
}
double chebyshev(std::size_t i, double x) {
    return std::cos(static_cast<double>(i) * std::acos(std::fmin(std::fmax(2.0 * x - 1.0, -1.0), 1.0)));
}

constexpr double least_alpha = 1e-6;

double cosine_at(double s, double alpha) {
    return std::fmin(alpha * s * s / (1.0 + alpha - s * s), 1.0);
}

struct Fit {
    std::size_t n, m;
    std::vector<double> c; // [n][m]

    Fit(std::size_t of_q, std::size_t of_a) : n(of_q), m(of_a), c(n * m) {
        // Includes both ends in s: nothing is lost at grazing, where L is steep.
        std::vector<double> values(n * m);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < m; ++j) {
                const double alpha = std::fmax(inner_point(j, m), least_alpha);
                const double mu = cosine_at(end_point(i, n), alpha);
                values[i * m + j] = mu > 0.0 ? loss(mu, alpha) : 0.0;
            }
        const auto at_end = [](std::size_t i, std::size_t count) { return i == 0 || i + 1 == count; };
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < m; ++j) {
                double sum = 0.0;
                for (std::size_t k = 0; k < n; ++k)
                    for (std::size_t l = 0; l < m; ++l)
                        sum += values[k * m + l] * (at_end(k, n) ? 0.5 : 1.0) * chebyshev(i, end_point(k, n)) *
                               chebyshev(j, inner_point(l, m));
                c[i * m + j] =
                    sum * (at_end(i, n) ? 1.0 : 2.0) * (j == 0 ? 1.0 : 2.0) / static_cast<double>((n - 1) * m);
            }
    }
    [[nodiscard]] double at(double mu, double alpha) const {
        const double s = std::sqrt(mu * (1.0 + alpha) / (mu + alpha));
        double sum = 0.0;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < m; ++j)
                sum += c[i * m + j] * chebyshev(i, s) * chebyshev(j, alpha);
        return sum;
    }
    [[nodiscard]] double largest_error() const {
        double largest = 0.0;
        for (int j = 0; j <= 30; ++j) {
            const double alpha = std::fmax(std::pow(j / 30.0, 2.0), 1e-4);
            for (int i = 1; i <= 60; ++i) {
                // Uniform first, then towards grazing.
                const double mu = cosine_at(i <= 40 ? i / 40.0 : 0.025 * std::pow(0.6, i - 40), alpha);
                largest = std::fmax(largest, std::fabs(at(mu, alpha) - loss(mu, alpha)));
            }
        }
        return largest;
    }
};

// Rounded relative to the largest value: further digits of the small ones differ by compiler.
void print_rows(const std::vector<double>& values, std::size_t in_row) {
    for (std::size_t i = 0; i < values.size(); ++i)
        std::printf("%s%.9fF,%s", i % in_row == 0 ? "    " : " ", values[i], (i + 1) % in_row == 0 ? "\n" : "");
}

} // namespace

int main(int count, char** arguments) {
    if (count > 1 && std::string_view(arguments[1]) == "--errors") {
        std::printf("E(1, 1) − (1 − ln 2): %.1e\n", 1.0 - loss(1.0, 1.0) - (1.0 - std::log(2.0)));
        for (const double alpha : {0.1, 0.25, 0.5, 1.0})
            std::printf("E(1, %g) = %.6f\n", alpha, 1.0 - loss(1.0, alpha));
        for (const auto& [n, m] :
             {std::array<std::size_t, 2>{10, 6}, {12, 8}, {14, 8}, {16, 8}, {16, 10}, {18, 10}, {20, 10}})
            std::printf("%zu x %zu: %.1e\n", n, m, Fit(n, m).largest_error());
        return 0;
    }
    const Fit fit(of_cosine, of_alpha);
    std::puts("// Printed by fit/ggx_loss.cpp: what GGX facets that reflect all light lose by a single scattering.");
    std::puts("#pragma once\n\n#include <cstddef>\n\n// clang-format off\nnamespace gonio::shading::detail {\n");
    std::printf("inline constexpr std::size_t ggx_loss_of_cosine = %zu;\n", of_cosine);
    std::printf("inline constexpr std::size_t ggx_loss_of_alpha = %zu;\n\n", of_alpha);
    std::puts("// L(μ, α) = Σᵢ Σⱼ c[i][j] Tᵢ(2s − 1) Tⱼ(2α − 1), s = √(μ(1 + α)/(μ + α)), T Chebyshev's polynomials.");
    std::printf("// Largest error for 1e-4 ≤ α ≤ 1: %.1e.\n", fit.largest_error());
    std::puts("inline constexpr float ggx_loss_terms[ggx_loss_of_cosine * ggx_loss_of_alpha] = {");
    print_rows(fit.c, of_alpha / 2);
    std::puts("};\n\n} // namespace gonio::shading::detail\n// clang-format on");
    return 0;
}
