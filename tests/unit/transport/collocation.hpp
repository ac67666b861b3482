// Radiosity of an empty box under an isotropic point light, by collocation: an independent solution for tests.
//
// Constant cells, form factors from a point to a rectangle in closed form (Lambert's integral over its edges), direct
// light as the exact mean of a cell (its solid angle). Cells are small in corners and where the light is close. Two
// divisions are extrapolated: the error falls with the number of cells.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace gonio::test {

// The box [0, size]; faces in the order x = 0, x = size.x, y = 0, y = size.y, z = 0, z = size.z.
struct BoxRoom {
    glm::dvec3 size{1.0};
    std::array<double, 6> albedo{};
    glm::dvec3 light{0.5};
    double intensity_cd = 100.0;
};

class Collocation {
public:
    Collocation(const BoxRoom& room, int cells_along) : room_(room) {
        for (int face = 0; face < 6; ++face) {
            const int axis = face / 2;
            const double distance = face % 2 == 0 ? room.light[axis] : room.size[axis] - room.light[axis];
            const auto u = static_cast<glm::length_t>((axis + 1) % 3);
            const auto v = static_cast<glm::length_t>((axis + 2) % 3);
            const std::vector<double> along_u = lines(room.size[u], room.light[u], distance, cells_along);
            const std::vector<double> along_v = lines(room.size[v], room.light[v], distance, cells_along);
            for (std::size_t i = 0; i + 1 < along_u.size(); ++i)
                for (std::size_t j = 0; j + 1 < along_v.size(); ++j)
                    cells_.push_back(cell(face, {along_u[i], along_v[j]}, {along_u[i + 1], along_v[j + 1]}));
        }
        const std::size_t count = cells_.size();
        std::vector<double> factor(count * count);
        std::vector<double> direct(count);
        for (std::size_t i = 0; i < count; ++i) {
            direct[i] = room.intensity_cd * solid_angle(cells_[i]) / cells_[i].area;
            for (std::size_t j = 0; j < count; ++j)
                factor[i * count + j] = form_factor(cells_[i].middle, cells_[i].normal, cells_[j]);
        }
        lx_ = direct;
        double change = 1.0;
        for (int step = 0; step < 200 && change > 1e-7; ++step) { // Gauss-Seidel
            change = 0.0;
            for (std::size_t i = 0; i < count; ++i) {
                double sum = direct[i];
                for (std::size_t j = 0; j < count; ++j)
                    sum += factor[i * count + j] * room.albedo[cells_[j].face] * lx_[j];
                change = std::max(change, std::abs(sum / lx_[i] - 1.0));
                lx_[i] = sum;
            }
        }
    }

    // The indirect illuminance of a point of a wall or inside the box.
    double indirect_lx(const glm::dvec3& at, const glm::dvec3& normal) const {
        double sum = 0.0;
        for (std::size_t j = 0; j < cells_.size(); ++j)
            sum += form_factor(at, normal, cells_[j]) * room_.albedo[cells_[j].face] * lx_[j];
        return sum;
    }

private:
    struct Cell {
        std::size_t face;
        std::array<glm::dvec3, 4> corners; // counter-clockwise as seen from inside
        glm::dvec3 middle;
        glm::dvec3 normal;
        double area;
    };

    // Close together at both ends and at the foot of the light, which is `distance` away.
    static std::vector<double> lines(double size, double light, double distance, int intervals) {
        const auto density = [&](double x) {
            const double edge = 0.08 * size;
            return 1.0 / (edge + x) + 1.0 / (edge + size - x) + 1.5 / (0.5 * distance + std::abs(x - light));
        };
        constexpr int steps = 4000;
        std::vector<double> below{0.0}; // the integral of the density
        for (int i = 0; i < steps; ++i)
            below.push_back(below.back() + density(size * (i + 0.5) / steps));
        std::vector<double> at{0.0};
        std::size_t step = 0;
        for (int i = 1; i < intervals; ++i) {
            const double wanted = below.back() * i / intervals;
            while (below[step + 1] < wanted)
                ++step;
            const double share = (wanted - below[step]) / (below[step + 1] - below[step]);
            at.push_back(size * (static_cast<double>(step) + share) / steps);
        }
        at.push_back(size);
        return at;
    }

    Cell cell(int face, const glm::dvec2& low, const glm::dvec2& high) const {
        const int axis = face / 2;
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        Cell made;
        made.face = static_cast<std::size_t>(face);
        made.normal = glm::dvec3(0.0);
        made.normal[axis] = face % 2 == 0 ? 1.0 : -1.0;
        const auto corner = [&](double at_u, double at_v) {
            glm::dvec3 at(0.0);
            at[axis] = face % 2 == 0 ? 0.0 : room_.size[axis];
            at[u] = at_u;
            at[v] = at_v;
            return at;
        };
        made.corners = {corner(low.x, low.y), corner(high.x, low.y), corner(high.x, high.y), corner(low.x, high.y)};
        if (face % 2 == 1) std::reverse(made.corners.begin(), made.corners.end());
        made.middle = 0.5 * (made.corners[0] + made.corners[2]);
        made.area = glm::distance(made.corners[0], made.corners[1]) * glm::distance(made.corners[1], made.corners[2]);
        return made;
    }

    // Points on the edge of a wall are a limit: faces in the receiver's own plane or behind it give nothing.
    static double form_factor(const glm::dvec3& at, const glm::dvec3& normal, const Cell& cell) {
        double sum = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            const glm::dvec3 a = cell.corners[k] - at;
            const glm::dvec3 b = cell.corners[(k + 1) % 4] - at;
            const glm::dvec3 across = glm::cross(a, b);
            const double length = glm::length(across);
            if (length < 1e-14) continue;
            sum += std::atan2(length, glm::dot(a, b)) * glm::dot(normal, across) / length;
        }
        return std::max(0.5 * std::numbers::inv_pi * -sum, 0.0);
    }

    // Of two triangles (van Oosterom and Strackee 1983).
    double solid_angle(const Cell& cell) const {
        const auto triangle = [&](std::size_t i, std::size_t j, std::size_t k) {
            const glm::dvec3 a = glm::normalize(cell.corners[i] - room_.light);
            const glm::dvec3 b = glm::normalize(cell.corners[j] - room_.light);
            const glm::dvec3 c = glm::normalize(cell.corners[k] - room_.light);
            return std::abs(2.0 * std::atan2(glm::dot(a, glm::cross(b, c)),
                                             1.0 + glm::dot(a, b) + glm::dot(b, c) + glm::dot(c, a)));
        };
        return triangle(0, 1, 2) + triangle(0, 2, 3);
    }

    BoxRoom room_;
    std::vector<Cell> cells_;
    std::vector<double> lx_;
};

// Extrapolated from 864 and 1944 cells.
class ExtrapolatedCollocation {
public:
    explicit ExtrapolatedCollocation(const BoxRoom& room) : coarse_(room, 12), fine_(room, 18) {}

    double indirect_lx(const glm::dvec3& at, const glm::dvec3& normal) const {
        const double fine = fine_.indirect_lx(at, normal);
        return fine + (fine - coarse_.indirect_lx(at, normal)) / (18.0 * 18.0 / (12.0 * 12.0) - 1.0);
    }

private:
    Collocation coarse_;
    Collocation fine_;
};

} // namespace gonio::test
