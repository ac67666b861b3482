#include <gonio/web/direct_ratios.hpp>
#include <gonio/web/plane_rows.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace gonio {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;
constexpr std::size_t quarter = 45; // azimuths in a quarter, 2° apart

double azimuth_deg(std::size_t i) {
    return 2.0 * static_cast<double>(i) + 1.0;
}

// Light at one γ, summed over the four azimuths that are mirror images of each other.
using Quarter = std::array<double, quarter>;

// Azimuths between the stored planes: a look-up for each γ, none for each azimuth.
class FoldedRing {
public:
    FoldedRing(const Web& web, std::span<const double> gammas_deg) : web_(web), gammas_deg_(gammas_deg) {
        if (web.photometry() != Photometry::c) return;
        const std::span<const double> planes = web.planes_deg();
        const web_detail::PlaneRows rows(web, gammas_deg);
        for (const double plane : planes)
            rows.append(plane, candela_);
        for (std::size_t i = 0; i < 4 * quarter; ++i) {
            const double c_deg = web.folded_c_deg(azimuth_deg(i));
            if (web.stored_symmetry() == Symmetry::axial) {
                cells_.push_back({0, 0, 0.0, mirrored(i)});
                continue;
            }
            if (c_deg < planes.front() || c_deg > planes.back()) continue;
            const auto above =
                static_cast<std::size_t>(std::upper_bound(planes.begin(), planes.end(), c_deg) - planes.begin());
            const std::size_t high = std::min(above, planes.size() - 1);
            const std::size_t low = above - 1;
            const double width = planes[high] - planes[low];
            cells_.push_back({low, high, width > 0.0 ? (c_deg - planes[low]) / width : 0.0, mirrored(i)});
        }
    }

    // At one of the γ.
    [[nodiscard]] Quarter at(std::size_t gamma) const {
        Quarter light{};
        if (web_.photometry() != Photometry::c) {
            for (std::size_t i = 0; i < 4 * quarter; ++i)
                light[mirrored(i)] += std::max(0.0, web_.candela(azimuth_deg(i), gammas_deg_[gamma]));
            return light;
        }
        const auto on_plane = [&](std::size_t plane) { return candela_[plane * gammas_deg_.size() + gamma]; };
        for (const Cell& cell : cells_)
            light[cell.to] += std::max(0.0, std::lerp(on_plane(cell.low), on_plane(cell.high), cell.weight));
        return light;
    }

private:
    struct Cell {
        std::size_t low;
        std::size_t high;
        double weight;
        std::size_t to;
    };

    static std::size_t mirrored(std::size_t i) {
        const std::size_t in_half = i % (2 * quarter);
        return in_half < quarter ? in_half : 2 * quarter - 1 - in_half;
    }

    const Web& web_;
    std::span<const double> gammas_deg_;
    std::vector<Cell> cells_;
    std::vector<double> candela_; // [plane][γ]
};

} // namespace

std::array<double, 10> direct_ratios(const Web& web) {
    constexpr std::array indices{0.60, 0.80, 1.00, 1.25, 1.50, 2.00, 2.50, 3.00, 4.00, 5.00};
    constexpr int gamma_parts = 4; // per degree
    Quarter across{};              // cos C and sin C
    Quarter along{};
    for (std::size_t i = 0; i < quarter; ++i) {
        across.at(i) = std::cos(azimuth_deg(i) * radians_per_degree);
        along.at(i) = std::sin(azimuth_deg(i) * radians_per_degree);
    }
    std::array<double, std::size_t{90} * gamma_parts> gammas_deg{};
    for (std::size_t j = 0; j < gammas_deg.size(); ++j)
        gammas_deg.at(j) = (static_cast<double>(j) + 0.5) / gamma_parts;
    const FoldedRing ring(web, gammas_deg);
    std::array<double, 10> direct{};
    double down = 0.0;
    for (std::size_t j = 0; j < gammas_deg.size(); ++j) {
        const double gamma_deg = gammas_deg.at(j);
        const double out = std::tan(gamma_deg * radians_per_degree); // over the height of the fall
        const double weight = std::sin(gamma_deg * radians_per_degree);
        std::array<double, 10> reach{}; // over the side of the room
        for (std::size_t k = 0; k < indices.size(); ++k)
            reach[k] = out / (2.0 * indices[k]);
        const Quarter light = ring.at(j);
        for (std::size_t i = 0; i < quarter; ++i) {
            const double weighted = weight * light[i];
            if (weighted == 0.0) continue;
            down += weighted;
            // In the smallest rooms, all of it meets a wall.
            const double farthest = std::max(across[i], along[i]);
            std::size_t first = 0;
            while (first < indices.size() && !(1.0 - reach[first] * farthest > 0.0))
                ++first;
            for (std::size_t k = first; k < indices.size(); ++k)
                direct[k] +=
                    weighted * std::max(0.0, 1.0 - reach[k] * across[i]) * std::max(0.0, 1.0 - reach[k] * along[i]);
        }
    }
    for (double& ratio : direct)
        ratio = down > 0.0 ? ratio / down : 0.0;
    return direct;
}

} // namespace gonio
