#include <gonio/web/direct_ratios.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace gonio {

std::array<double, 10> direct_ratios(const Web& web) {
    constexpr std::array indices{0.60, 0.80, 1.00, 1.25, 1.50, 2.00, 2.50, 3.00, 4.00, 5.00};
    constexpr double radians_per_degree = std::numbers::pi / 180.0;
    constexpr int gamma_parts = 4; // per degree
    const auto c_deg = [](std::size_t i) { return 2.0 * static_cast<double>(i) + 1.0; };
    std::array<double, 180> across{}; // |cos C| and |sin C|
    std::array<double, 180> along{};
    for (std::size_t i = 0; i < across.size(); ++i) {
        const double c = c_deg(i) * radians_per_degree;
        across[i] = std::abs(std::cos(c));
        along[i] = std::abs(std::sin(c));
    }
    std::array<double, 10> direct{};
    double down = 0.0;
    for (int j = 0; j < 90 * gamma_parts; ++j) {
        const double gamma = (j + 0.5) / gamma_parts;
        const double out = std::tan(gamma * radians_per_degree); // over the height of the fall
        const double weight = std::sin(gamma * radians_per_degree);
        std::array<double, 10> reach{}; // over the side of the room
        for (std::size_t k = 0; k < indices.size(); ++k)
            reach[k] = out / (2.0 * indices[k]);
        for (std::size_t i = 0; i < across.size(); ++i) {
            const double light = weight * std::max(0.0, web.candela(c_deg(i), gamma));
            if (light == 0.0) continue;
            down += light;
            for (std::size_t k = 0; k < indices.size(); ++k)
                direct[k] +=
                    light * std::max(0.0, 1.0 - reach[k] * across[i]) * std::max(0.0, 1.0 - reach[k] * along[i]);
        }
    }
    for (double& ratio : direct)
        ratio = down > 0.0 ? ratio / down : 0.0;
    return direct;
}

} // namespace gonio
