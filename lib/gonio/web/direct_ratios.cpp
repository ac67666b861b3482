#include <gonio/web/direct_ratios.hpp>
#include <gonio/web/native_rows.hpp>
#include <gonio/web/plane_rows.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <tuple>
#include <vector>

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

// Light at each γ, [azimuth in the first eighth][γ], summed over the mirror images.
using EighthLight = std::array<std::array<double, gammas>, eighth>;

// A γ is looked up once in each stored plane, and azimuths that a symmetry makes the same are taken once.
void add_type_c(const Web& web, std::span<const double> gammas_deg, EighthLight& light) {
    struct Cell {
        std::size_t to;
        std::size_t low; // planes
        std::size_t high;
        double weight;
    };
    const std::span<const double> planes = web.planes_deg();
    std::vector<double> candela; // [plane][γ]
    const web_detail::PlaneRows rows(web, gammas_deg);
    for (const double plane : planes)
        rows.append(plane, candela);
    std::vector<Cell> cells;
    for (std::size_t i = 0; i < azimuths; ++i) {
        const double c_deg = web.folded_c_deg(azimuth_deg(i));
        if (web.stored_symmetry() == Symmetry::axial) {
            cells.push_back({mirrored(i), 0, 0, 0.0});
            continue;
        }
        if (c_deg < planes.front() || c_deg > planes.back()) continue;
        const auto above =
            static_cast<std::size_t>(std::upper_bound(planes.begin(), planes.end(), c_deg) - planes.begin());
        const std::size_t high = std::min(above, planes.size() - 1);
        const std::size_t low = above - 1;
        const double width = planes[high] - planes[low];
        cells.push_back({mirrored(i), low, high, width > 0.0 ? (c_deg - planes[low]) / width : 0.0});
    }
    const auto key = [](const Cell& cell) { return std::tuple(cell.to, cell.low, cell.weight); };
    std::sort(cells.begin(), cells.end(), [&](const Cell& a, const Cell& b) { return key(a) < key(b); });
    for (auto first = cells.begin(); first != cells.end();) {
        const auto end = std::find_if(first, cells.end(), [&](const Cell& cell) { return key(cell) != key(*first); });
        const auto count = static_cast<double>(end - first);
        const double* const low = candela.data() + first->low * gammas;
        const double* const high = candela.data() + first->high * gammas;
        const double weight = first->weight;
        std::array<double, gammas>& to = light.at(first->to);
        for (std::size_t j = 0; j < gammas; ++j)
            to[j] += count * std::max(0.0, low[j] + weight * (high[j] - low[j]));
        first = end;
    }
}

void add_native(const Web& web, std::span<const double> gammas_deg, EighthLight& light) {
    web_detail::NativeRows rows(web, gammas_deg);
    std::array<double, gammas> candela;
    for (std::size_t i = 0; i < azimuths; ++i) {
        rows.quick(azimuth_deg(i), candela);
        std::array<double, gammas>& to = light.at(mirrored(i));
        for (std::size_t j = 0; j < gammas; ++j)
            to[j] += std::max(0.0, candela[j]);
    }
}

} // namespace

std::array<double, 10> direct_ratios(const Web& web) {
    constexpr std::array indices{0.60, 0.80, 1.00, 1.25, 1.50, 2.00, 2.50, 3.00, 4.00, 5.00};
    std::array<double, gammas> gammas_deg;
    for (std::size_t j = 0; j < gammas; ++j)
        gammas_deg[j] = (static_cast<double>(j) + 0.5) / gamma_parts;
    EighthLight light{};
    if (web.photometry() == Photometry::c)
        add_type_c(web, gammas_deg, light);
    else
        add_native(web, gammas_deg, light);
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
