#include <gonio/figures/position_index.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace gonio {

namespace {

constexpr std::size_t columns = 17;
using Row = std::array<int, columns>;

// 100 p in steps of 0.1: a row for each T/R from 0, first the value at H/R = 0, then what each step of H/R adds. The
// two steps of 100 and 20 in the row of T/R = 2.7 are a misprint of the standard that all tables of UGR are made with.
constexpr std::array steps{
    Row{100, 26, 27, 37, 45, 51, 64, 70, 80, 100, 100, 110, 115, 110, 135, 145, 155},
    Row{105, 17, 24, 34, 40, 55, 65, 70, 70, 100, 100, 120, 110, 120, 130, 140, 160},
    Row{112, 18, 20, 30, 40, 46, 52, 70, 72, 90, 100, 110, 115, 110, 135, 150, 130},
    Row{122, 16, 22, 37, 28, 45, 55, 65, 70, 85, 100, 95, 100, 110, 135, 125, 160},
    Row{132, 15, 23, 26, 39, 45, 50, 60, 70, 80, 100, 90, 100, 110, 120, 130, 130},
    Row{143, 17, 22, 28, 38, 43, 49, 58, 72, 80, 90, 90, 100, 110, 110, 125, 125},
    Row{155, 17, 26, 32, 35, 45, 50, 50, 70, 70, 90, 95, 105, 100, 110, 120, 130},
    Row{170, 18, 24, 36, 39, 43, 48, 52, 58, 72, 90, 90, 110, 100, 100, 120, 115},
    Row{182, 18, 32, 38, 38, 42, 42, 58, 60, 65, 85, 90, 110, 90, 110, 115, 105},
    Row{196, 24, 34, 36, 40, 40, 50, 55, 55, 70, 75, 95, 100, 95, 110, 105, 110},
    Row{211, 29, 35, 35, 40, 41, 49, 60, 60, 60, 80, 90, 90, 95, 105, 110, 105},
    Row{230, 25, 37, 38, 42, 48, 50, 55, 55, 75, 65, 95, 85, 90, 105, 105, 100},
    Row{240, 35, 37, 38, 40, 45, 50, 65, 55, 65, 80, 80, 90, 80, 102, 108, 100},
    Row{255, 35, 40, 40, 50, 45, 55, 50, 60, 70, 70, 85, 80, 85, 100, 105, 95},
    Row{270, 40, 40, 40, 45, 50, 50, 50, 65, 75, 75, 70, 80, 90, 100, 100, 85},
    Row{285, 30, 50, 45, 45, 45, 50, 70, 60, 70, 70, 65, 85, 85, 95, 100, 80},
    Row{295, 45, 40, 45, 50, 45, 55, 55, 70, 65, 75, 60, 80, 100, 95, 85, 80},
    Row{310, 45, 45, 50, 40, 50, 55, 55, 70, 60, 70, 70, 80, 85, 100, 90, 70},
    Row{325, 45, 50, 45, 45, 50, 50, 65, 65, 60, 65, 70, 75, 90, 90, 90, 70},
    Row{343, 43, 44, 45, 45, 50, 60, 60, 60, 67, 63, 70, 70, 80, 100, 82, 73},
    Row{350, 50, 50, 40, 45, 45, 60, 70, 60, 60, 60, 70, 80, 70, 90, 85, 75},
    Row{360, 57, 48, 40, 45, 50, 60, 60, 62, 63, 55, 75, 75, 70, 90, 80, 80},
    Row{375, 50, 47, 48, 40, 50, 60, 65, 65, 55, 60, 70, 75, 70, 80, 80, 80},
    Row{385, 50, 45, 45, 45, 52, 58, 60, 70, 55, 65, 60, 80, 70, 80, 75, 75},
    Row{395, 45, 50, 45, 45, 50, 60, 60, 70, 60, 60, 60, 80, 70, 75, 75, 75},
    Row{400, 50, 46, 44, 45, 55, 55, 60, 70, 60, 65, 55, 80, 70, 75, 70, 80},
    Row{407, 48, 50, 42, 48, 51, 54, 65, 70, 60, 60, 55, 80, 70, 72, 68, 80},
    Row{410, 50, 50, 43, 47, 50, 100, 20, 70, 60, 60, 56, 76, 71, 72, 65, 80},
    Row{415, 47, 53, 41, 49, 50, 53, 65, 72, 60, 60, 55, 75, 70, 70, 65, 80},
    Row{420, 45, 52, 43, 47, 50, 55, 63, 75, 60, 60, 53, 72, 70, 70, 65, 80},
    Row{422, 45, 53, 45, 47, 48, 55, 65, 75, 57, 58, 53, 72, 70, 70, 65, 80},
};

using Table = std::array<std::array<double, columns>, steps.size()>;

constexpr Table summed() {
    Table table{};
    for (std::size_t row = 0; row < steps.size(); ++row) {
        int sum = 0;
        for (std::size_t column = 0; column < columns; ++column) {
            sum += steps[row][column];
            table[row][column] = 0.01 * sum;
        }
    }
    return table;
}

constexpr Table table = summed();

} // namespace

std::optional<double> table_position_index(double t_over_r, double h_over_r) {
    // Distances of luminaires are sums in floating point: an edge may be missed by a rounding.
    constexpr double rounding = 1e-9;
    const double row = 10.0 * t_over_r;
    const double column = 10.0 * h_over_r;
    if (!(row >= 0.0 && row <= table.size() - 1 + rounding && column >= 0.0 && column <= columns - 1 + rounding))
        return std::nullopt;
    const std::size_t i = std::min(static_cast<std::size_t>(row), table.size() - 2);
    const std::size_t j = std::min(static_cast<std::size_t>(column), columns - 2);
    const double a = row - static_cast<double>(i);
    const double b = column - static_cast<double>(j);
    return std::lerp(std::lerp(table[i][j], table[i][j + 1], b), std::lerp(table[i + 1][j], table[i + 1][j + 1], b), a);
}

double closed_position_index(double t, double r, double h) {
    constexpr double to_degrees = 180.0 / std::numbers::pi;
    const double off = std::hypot(t, h);
    if (h < 0.0) return 1.0 + (off < 0.6 * r ? 0.8 : 1.2) * off / r;
    const double sigma = to_degrees * std::atan2(off, r);
    const double tau = to_degrees * std::atan2(std::abs(t), h);
    return std::exp((35.2 - 0.31889 * tau - 1.22 * std::exp(-2.0 / 9.0 * tau)) * 1e-3 * sigma +
                    (21.0 + 0.26667 * tau - 0.002963 * tau * tau) * 1e-5 * sigma * sigma);
}

} // namespace gonio
