#include <gonio/web/direct_ratios.hpp>
#include <gonio/web/web_rows.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <span>
#include <utility>

namespace gonio {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;
constexpr std::size_t azimuths = 180;  // 2° apart
constexpr std::size_t eighth = 23;     // of them; the last, at 45°, is in two eighths of the turn
constexpr std::size_t gamma_parts = 4; // per degree
constexpr std::size_t gammas = 90 * gamma_parts;

double azimuth_deg(std::size_t i) {
    return 2.0 * static_cast<double>(i) + 1.0;
}

// A square room is the same from its eight azimuths that are mirror images of each other: the place in the first
// eighth.
std::size_t mirrored(std::size_t azimuth) {
    const std::size_t in_quarter = azimuth % (azimuths / 4);
    return std::min(in_quarter, azimuths / 4 - 1 - in_quarter);
}

// Light at each γ, [azimuth in the first eighth][γ], summed over the mirror images. Azimuths that a symmetry of the web
// makes the same are looked up once.
using EighthLight = std::array<std::array<double, gammas>, eighth>;

EighthLight light_of(const Web& web, std::span<const double> gammas_deg) {
    std::map<std::pair<std::size_t, double>, int> counts; // by eighth and C
    for (std::size_t i = 0; i < azimuths; ++i)
        ++counts[{mirrored(i), web.photometry() == Photometry::c ? web.folded_c_deg(azimuth_deg(i)) : azimuth_deg(i)}];
    EighthLight light{};
    web_detail::WebRows rows(web, gammas_deg);
    for (const auto& [at, count] : counts) {
        const auto& [to, c_deg] = at;
        const std::span<const double> row = rows.quick(c_deg);
        for (std::size_t j = 0; j < gammas; ++j)
            light[to][j] += count * std::max(0.0, row[j]);
    }
    return light;
}

} // namespace

std::array<double, 10> direct_ratios(const Web& web) {
    constexpr std::array indices{0.60, 0.80, 1.00, 1.25, 1.50, 2.00, 2.50, 3.00, 4.00, 5.00};
    std::array<double, gammas> gammas_deg;
    for (std::size_t j = 0; j < gammas; ++j)
        gammas_deg[j] = (static_cast<double>(j) + 0.5) / gamma_parts;
    const EighthLight light = light_of(web, gammas_deg);
    std::array<double, eighth> across; // cos C and sin C
    std::array<double, eighth> along;
    for (std::size_t i = 0; i < eighth; ++i) {
        across[i] = std::cos(azimuth_deg(i) * radians_per_degree);
        along[i] = std::sin(azimuth_deg(i) * radians_per_degree);
    }
    std::array<double, 10> direct{};
    double down = 0.0;
    for (std::size_t j = 0; j < gammas; ++j) {
        const double out = std::tan(gammas_deg[j] * radians_per_degree); // over the height of the fall
        const double weight = std::sin(gammas_deg[j] * radians_per_degree);
        std::array<double, 10> reach; // over the side of the room
        for (std::size_t k = 0; k < indices.size(); ++k)
            reach[k] = out / (2.0 * indices[k]);
        for (std::size_t i = 0; i < eighth; ++i) {
            const double weighted = weight * light[i][j];
            if (weighted == 0.0) continue;
            down += weighted;
            for (std::size_t k = 0; k < indices.size(); ++k)
                direct[k] +=
                    weighted * (std::max(0.0, 1.0 - reach[k] * across[i]) * std::max(0.0, 1.0 - reach[k] * along[i]));
        }
    }
    for (double& ratio : direct)
        ratio = down > 0.0 ? ratio / down : 0.0;
    return direct;
}

} // namespace gonio
