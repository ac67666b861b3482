#include <gonio/base/parallel.hpp>
#include <gonio/sky/blurred_sky.hpp>
#include <gonio/sky/sky_direction.hpp>

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace gonio {

namespace {

constexpr int finest_side = 128;
constexpr int coarsest_side = 4;
constexpr int faces = 6;

// The mean width of a texel of a cube [rad]: √(4π/6) over the side.
double texel_width(int side) {
    return 1.4472 / side;
}

std::size_t texel_count(int side) {
    return faces * static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
}

std::size_t texel_of(int side, int face, int row, int column) {
    const auto sides = static_cast<std::size_t>(face) * static_cast<std::size_t>(side) + static_cast<std::size_t>(row);
    return sides * static_cast<std::size_t>(side) + static_cast<std::size_t>(column);
}

struct FacePoint {
    int face;
    double s, t; // in [−1, 1]
};

FacePoint locate(const glm::dvec3& d) {
    const double x = std::abs(d.x);
    const double y = std::abs(d.y);
    const double z = std::abs(d.z);
    if (z >= x && z >= y) return {d.z >= 0.0 ? 4 : 5, d.x / z, d.y / z};
    if (x >= y) return {d.x >= 0.0 ? 0 : 1, d.y / x, d.z / x};
    return {d.y >= 0.0 ? 2 : 3, d.x / y, d.z / y};
}

// Not unit. Points beyond the edge of the face have directions too.
glm::dvec3 direction_of(int face, double s, double t) {
    const double sign = face % 2 == 0 ? 1.0 : -1.0;
    if (face < 2) return {sign, s, t};
    if (face < 4) return {s, sign, t};
    return {s, t, sign};
}

std::size_t texel_of(int side, const glm::dvec3& direction) {
    const FacePoint at = locate(direction);
    const auto index = [&](double value) {
        return std::clamp(static_cast<int>(0.5 * (value + 1.0) * side), 0, side - 1);
    };
    return texel_of(side, at.face, index(at.t), index(at.s));
}

// Σ L Ω and Σ Ω of the parts of the image's texels that lie in each texel of the cube.
std::vector<glm::dvec4> sums_over_cube(const EnvironmentMap& image, int side, unsigned threads) {
    const EnvironmentGrid& grid = image.grid();
    // The widest texels of a lat-long are those at the horizon; others are about as wide as a cube's.
    const double own_width = grid.layout() == EnvironmentLayout::latlong
                                 ? std::numbers::pi / grid.height()
                                 : texel_width(side_like(grid.layout(), grid.side(), EnvironmentLayout::cube_strip));
    const int parts = std::clamp(static_cast<int>(std::ceil(1.5 * own_width / texel_width(side))), 1, 64);
    // Slabs of rows have sums of their own, added in their order.
    const int slabs = std::min(grid.height(), 8);
    std::vector<std::vector<glm::dvec4>> of_slab(static_cast<std::size_t>(slabs));
    parallel_for(of_slab.size(), threads, [&](std::size_t slab) {
        std::vector<glm::dvec4>& sums = of_slab[slab];
        sums.assign(texel_count(side), glm::dvec4(0.0));
        const auto first = static_cast<int>(slab) * grid.height() / slabs;
        const auto end = (static_cast<int>(slab) + 1) * grid.height() / slabs;
        for (int row = first; row < end; ++row)
            for (int column = 0; column < grid.width(); ++column) {
                const TexelIndex texel{column, row};
                if (!grid.covers(texel)) continue;
                const double sr = grid.solid_angle(texel) / (parts * parts);
                const glm::dvec4 share(sr * image.texel(texel), sr);
                for (int j = 0; j < parts; ++j)
                    for (int i = 0; i < parts; ++i)
                        sums[texel_of(side, grid.direction({column + (i + 0.5) / parts, row + (j + 0.5) / parts}))] +=
                            share;
            }
    });
    std::vector<glm::dvec4> sums = std::move(of_slab.front());
    for (std::size_t slab = 1; slab < of_slab.size(); ++slab)
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] += of_slab[slab][i];
    for (int face = 0; face < faces; ++face)
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                glm::dvec4& sum = sums[texel_of(side, face, row, column)];
                if (sum.w > 0.0) continue;
                const glm::dvec3 middle =
                    direction_of(face, 2.0 * (column + 0.5) / side - 1.0, 2.0 * (row + 0.5) / side - 1.0);
                sum = glm::dvec4(1e-9 * image.radiance(middle), 1e-9);
            }
    return sums;
}

std::vector<glm::dvec4> halved(const std::vector<glm::dvec4>& sums, int side) {
    const int half = side / 2;
    std::vector<glm::dvec4> result(texel_count(half), glm::dvec4(0.0));
    for (int face = 0; face < faces; ++face)
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                result[texel_of(half, face, row / 2, column / 2)] += sums[texel_of(side, face, row, column)];
    return result;
}

} // namespace

BlurredSky::Level BlurredSky::bordered(int side, const std::vector<glm::dvec4>& sums) {
    Level level;
    level.side = side;
    level.texels.reserve(texel_count(side + 2));
    for (int face = 0; face < faces; ++face)
        for (int row = -1; row <= side; ++row)
            for (int column = -1; column <= side; ++column) {
                const glm::dvec3 middle =
                    direction_of(face, 2.0 * (column + 0.5) / side - 1.0, 2.0 * (row + 0.5) / side - 1.0);
                const glm::dvec4& sum = sums[texel_of(side, middle)];
                level.texels.emplace_back(glm::dvec3(sum) / sum.w);
            }
    return level;
}

BlurredSky::BlurredSky(const Sky& sky, unsigned threads) : sky_(sky) {
    if (!sky.image() || sky.is_dark()) return;
    const EnvironmentGrid& grid = sky.image()->grid();
    int side = finest_side;
    while (side > coarsest_side && side > side_like(grid.layout(), grid.side(), EnvironmentLayout::cube_strip))
        side /= 2;
    std::vector<glm::dvec4> sums = sums_over_cube(*sky.image(), side, threads);
    levels_.push_back(bordered(side, sums));
    for (; side > coarsest_side; side /= 2) {
        sums = halved(sums, side);
        levels_.push_back(bordered(side / 2, sums));
    }
}

glm::dvec3 BlurredSky::Level::at(const glm::dvec3& direction) const {
    FacePoint point = locate(direction);
    // Texels on one side of the horizon do not mix with those on the other.
    if (point.face < 4) {
        const double nearest = 1.0 / side;
        point.t = direction.z >= 0.0 ? std::max(point.t, nearest) : std::min(point.t, -nearest);
    }
    const double x = 0.5 * (point.s + 1.0) * side + 0.5; // in texels, from the middle of the border's
    const double y = 0.5 * (point.t + 1.0) * side + 0.5;
    const int column = std::clamp(static_cast<int>(x), 0, side);
    const int row = std::clamp(static_cast<int>(y), 0, side);
    const auto right = static_cast<float>(x - column);
    const auto below = static_cast<float>(y - row);
    const int stride = side + 2;
    const glm::vec3* const texel =
        texels.data() + static_cast<std::ptrdiff_t>((point.face * stride + row) * stride + column);
    const glm::vec3 nt = (1.0F - below) * ((1.0F - right) * texel[0] + right * texel[1]) +
                         below * ((1.0F - right) * texel[stride] + right * texel[stride + 1]);
    return nt;
}

glm::dvec3 BlurredSky::radiance(const glm::dvec3& direction, double width) const {
    if (levels_.empty() || width < texel_width(levels_.front().side)) return sky_.radiance(direction);
    const double level =
        std::min(std::log2(width / texel_width(levels_.front().side)), static_cast<double>(levels_.size() - 1));
    const auto fine = static_cast<std::size_t>(level);
    const double share = level - static_cast<double>(fine);
    const glm::dvec3 own = turned(direction, Radians(-sky_.rotation().value));
    glm::dvec3 nt = levels_[fine].at(own);
    if (share > 0.0) nt += share * (levels_[fine + 1].at(own) - nt);
    return sky_.image_scale() * nt;
}

} // namespace gonio
