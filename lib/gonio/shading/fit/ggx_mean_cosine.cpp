// Prints lib/gonio/shading/ggx_mean_cosine_coefficients.hpp: where Schlick's weight has its mean over what GGX facets
// reflect, as a polynomial in two variables.
//
//     gonio-ggx-mean-cosine-fit > lib/gonio/shading/ggx_mean_cosine_coefficients.hpp     the header
//     gonio-ggx-mean-cosine-fit --errors                                                 the errors of other degrees
//
// With S = ∫ D V n·l dl and B = ∫ (1 − l·h)⁵ D V n·l dl, the cosine μ̂ is that of B = S (1 − μ̂)⁵. Smooth facets have
// μ̂ = μ. Around μ = α it changes on the scale of α, so μ̂ = μ + α z P(z, √α) with z = α/(μ + α), and P is a sum of
// products of Chebyshev's polynomials. P is fitted by least squares of B, with the derivative of B by P as the weight.
#include <gonio/shading/brdf_ggx.hpp>
#include <gonio/shading/furnace.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

namespace {

constexpr std::size_t of_z = 8;
constexpr std::size_t of_root = 10;

struct Point {
    double mu, alpha, sum, grazing;

    [[nodiscard]] double z() const { return alpha / (mu + alpha); }
    [[nodiscard]] double cosine() const { return 1.0 - std::pow(std::fmax(grazing / sum, 0.0), 0.2); }
};

Point point(double mu, double alpha) {
    const gonio::shading::Ggx<double> facets{{0.0, 1.0, 0.0}, alpha};
    const auto albedo = directional_albedo(facets, mu, alpha, 500, 150);
    return {mu, alpha, albedo.y, albedo.x};
}

// Uniform in z and in √μ by turns; `shift` moves them in between.
std::vector<Point> points(std::size_t roots, double shift) {
    constexpr int cosines = 36;
    std::vector<Point> all;
    for (std::size_t j = 0; j < roots; ++j) {
        const double place = (static_cast<double>(j) + shift) / static_cast<double>(roots - 1);
        const double root = 0.01 + 0.99 * (0.5 - 0.5 * std::cos(std::numbers::pi * std::fmin(place, 1.0)));
        const double alpha = root * root;
        for (int i = 0; i < cosines; ++i) {
            const double u = (i + 0.5) / cosines;
            const double least_z = alpha / (1.0 + alpha);
            const double z = least_z + (1.0 - least_z) * u;
            all.push_back(point(std::clamp(i % 2 == 0 ? alpha * (1.0 - z) / z : u * u, 1e-5, 1.0), alpha));
        }
        all.push_back(point(1.0, alpha));
        all.push_back(point(1e-5, alpha));
    }
    return all;
}

double chebyshev(std::size_t i, double x) {
    return std::cos(static_cast<double>(i) * std::acos(std::clamp(2.0 * x - 1.0, -1.0, 1.0)));
}

struct Fit {
    std::size_t n, m;
    std::vector<double> c; // [n][m]

    Fit(std::size_t by_z, std::size_t by_root, const std::vector<Point>& data)
        : n(by_z), m(by_root), c(by_z * by_root) {
        const std::size_t count = n * m;
        std::vector<std::vector<long double>> rows(count, std::vector<long double>(count + 1, 0.0L));
        for (const Point& p : data) {
            const double cosine = p.cosine();
            const double size = p.alpha * p.z();
            const double weight = p.sum * 5.0 * std::pow(1.0 - cosine, 4) * size + 1e-7;
            const std::vector<double> terms = terms_at(p);
            for (std::size_t i = 0; i < count; ++i) {
                for (std::size_t k = 0; k < count; ++k)
                    rows[i][k] += static_cast<long double>(terms[i] * weight) * (terms[k] * weight);
                rows[i][count] += static_cast<long double>(terms[i] * weight) * (weight * (cosine - p.mu) / size);
            }
        }
        for (std::size_t i = 0; i < count; ++i)
            rows[i][i] += 1e-13L;
        solve(rows);
    }
    // B.
    [[nodiscard]] double at(const Point& p) const {
        const std::vector<double> terms = terms_at(p);
        double sum = 0.0;
        for (std::size_t i = 0; i < c.size(); ++i)
            sum += c[i] * terms[i];
        const double cosine = std::clamp(p.mu + p.alpha * p.z() * sum, 0.0, 1.0);
        return p.sum * std::pow(1.0 - cosine, 5);
    }
    [[nodiscard]] double largest_error(const std::vector<Point>& data, double from_mu = 0.0) const {
        double largest = 0.0;
        for (const Point& p : data)
            if (p.mu >= from_mu) largest = std::fmax(largest, std::fabs(at(p) - p.grazing));
        return largest;
    }

private:
    [[nodiscard]] std::vector<double> terms_at(const Point& p) const {
        std::vector<double> terms;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < m; ++j)
                terms.push_back(chebyshev(i, p.z()) * chebyshev(j, std::sqrt(p.alpha)));
        return terms;
    }
    // Elimination; the greatest pivot of the column.
    void solve(std::vector<std::vector<long double>>& rows) {
        const std::size_t count = c.size();
        for (std::size_t i = 0; i < count; ++i) {
            const auto greatest =
                std::max_element(rows.begin() + static_cast<std::ptrdiff_t>(i), rows.end(),
                                 [&](const auto& a, const auto& b) { return std::fabs(a[i]) < std::fabs(b[i]); });
            std::swap(rows[i], *greatest);
            for (std::size_t k = i + 1; k < count; ++k) {
                const long double factor = rows[k][i] / rows[i][i];
                for (std::size_t l = i; l <= count; ++l)
                    rows[k][l] -= factor * rows[i][l];
            }
        }
        for (std::size_t i = count; i-- > 0;) {
            long double rest = rows[i][count];
            for (std::size_t k = i + 1; k < count; ++k)
                rest -= rows[i][k] * static_cast<long double>(c[k]);
            c[i] = static_cast<double>(rest / rows[i][i]);
        }
    }
};

} // namespace

int main(int count, char** arguments) {
    const std::vector<Point> data = points(20, 0.0);
    const std::vector<Point> between = points(17, 0.4);
    if (count > 1 && std::string_view(arguments[1]) == "--errors") {
        for (const auto& [n, m] : {std::array<std::size_t, 2>{4, 4}, {6, 8}, {7, 8}, {7, 10}, {8, 10}, {10, 10}}) {
            const Fit fit(n, m, data);
            std::printf("%zu x %zu: %.1e, from μ = 0.01 on %.1e\n", n, m, fit.largest_error(between),
                        fit.largest_error(between, 0.01));
        }
        return 0;
    }
    const Fit fit(of_z, of_root, data);
    std::puts(
        "// Printed by fit/ggx_mean_cosine.cpp: where Schlick's weight has its mean over what GGX facets reflect.");
    std::puts("#pragma once\n\n#include <cstddef>\n\n// clang-format off\nnamespace gonio::shading::detail {\n");
    std::printf("inline constexpr std::size_t ggx_mean_cosine_of_z = %zu;\n", of_z);
    std::printf("inline constexpr std::size_t ggx_mean_cosine_of_root = %zu;\n\n", of_root);
    std::puts("// μ̂ = μ + α z Σᵢ Σⱼ c[i][j] Tᵢ(2z − 1) Tⱼ(2√α − 1), z = α/(μ + α), T Chebyshev's polynomials.");
    std::printf("// Largest error of B = S (1 − μ̂)⁵ for 1e-4 ≤ α ≤ 1: %.1e, from μ = 0.01 on %.1e.\n",
                fit.largest_error(between), fit.largest_error(between, 0.01));
    std::puts("inline constexpr float ggx_mean_cosine_terms[ggx_mean_cosine_of_z * ggx_mean_cosine_of_root] = {");
    for (std::size_t i = 0; i < fit.c.size(); ++i)
        std::printf("%s%.6fF,%s", i % 5 == 0 ? "    " : " ", fit.c[i], i % 5 == 4 ? "\n" : "");
    std::puts("};\n\n} // namespace gonio::shading::detail\n// clang-format on");
    return 0;
}
