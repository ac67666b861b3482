#include "polar_text.hpp"

#include <gonio/web/metrics.hpp>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace gonio::cli {

std::string polar_text(const Web& web, int columns, int rows) {
    const double top = peak(web).intensity.value;
    if (!(top > 0.0)) return {};
    // A braille character is two dots wide and four high (Unicode block 2800), so its dots are about equally far apart
    // in both directions.
    const int width = 2 * columns;
    const int height = 4 * rows;
    std::vector<unsigned char> cells(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
    const auto cell = [&](int column, int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    };
    const auto dot = [&](double x, double y) {
        const int column = static_cast<int>(std::lround(x));
        const int row = static_cast<int>(std::lround(y));
        if (column < 0 || row < 0 || column >= width || row >= height) return;
        constexpr unsigned char bits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
        cells[cell(column / 2, row / 4)] |= bits[row % 4][column % 2];
    };
    const double center_x = 0.5 * (width - 1);
    const double center_y = 0.5 * (height - 1);
    const double radius = std::fmin(center_x, center_y);
    for (int step = -1800; step <= 1800; ++step) {
        const double signed_gamma = step * 0.1;
        const double share = web.candela(signed_gamma >= 0.0 ? 0.0 : 180.0, std::abs(signed_gamma)) / top;
        const double angle = signed_gamma * std::numbers::pi / 180.0;
        dot(center_x + radius * share * std::sin(angle), center_y + radius * share * std::cos(angle));
    }
    dot(center_x, center_y);

    std::string text;
    for (int row = 0; row < rows; ++row) {
        std::string line;
        for (int column = 0; column < columns; ++column) {
            const unsigned code = 0x2800U + cells[cell(column, row)];
            line += static_cast<char>(0xe0U | (code >> 12U));
            line += static_cast<char>(0x80U | ((code >> 6U) & 0x3fU));
            line += static_cast<char>(0x80U | (code & 0x3fU));
        }
        text += "  " + line + "\n";
    }
    return text;
}

} // namespace gonio::cli
