// Radiosity of an empty box under an isotropic point light, by collocation: an independent solution for tests.
//
// Constant cells, form factors from a point to a rectangle in closed form (Lambert's integral over its edges), direct
// light as the exact mean of a cell (its solid angle). Two divisions are extrapolated: the error falls with the number
// of cells.
#pragma once

#include <glm/geometric.hpp>
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
        for (int face = 0; face < 6; ++face)
            for (int i = 0; i < cells_along; ++i)
                for (int j = 0; j < cells_along; ++j)
                    cells_.push_back(cell(face, i, j, cells_along));
        const std::size_t count = cells_.size();
        std::vector<double> factor(count * count);
        std::vector<double> direct(count);
        for (std::size_t i = 0; i < count; ++i) {
            direct[i] = room.intensity_cd * solid_angle(cells_[i]) / cells_[i].area;
            for (std::size_t j = 0; j < count; ++j)
                factor[i * count + j] = form_factor(cells_[i].middle, cells_[i].normal, cells_[j]);
        }
        lx_ = direct;
        for (int step = 0; step < 200; ++step)
            for (std::size_t i = 0; i < count; ++i) { // Gauss-Seidel
                double sum = direct[i];
                for (std::size_t j = 0; j < count; ++j)
                    sum += factor[i * count + j] * room.albedo[cells_[j].face] * lx_[j];
                lx_[i] = sum;
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

    Cell cell(int face, int i, int j, int along) const {
        const int axis = face / 2;
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        Cell made;
        made.face = static_cast<std::size_t>(face);
        made.normal = glm::dvec3(0.0);
        made.normal[axis] = face % 2 == 0 ? 1.0 : -1.0;
        const auto corner = [&](int a, int b) {
            glm::dvec3 at(0.0);
            at[axis] = face % 2 == 0 ? 0.0 : room_.size[axis];
            at[u] = room_.size[u] * (i + a) / along;
            at[v] = room_.size[v] * (j + b) / along;
            return at;
        };
        made.corners = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
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

// Extrapolated from 384 and 864 cells: within 0.1 % away from corners (its check is in interreflection.cpp).
class ExtrapolatedCollocation {
public:
    explicit ExtrapolatedCollocation(const BoxRoom& room) : coarse_(room, 8), fine_(room, 12) {}

    double indirect_lx(const glm::dvec3& at, const glm::dvec3& normal) const {
        const double fine = fine_.indirect_lx(at, normal);
        return fine + (fine - coarse_.indirect_lx(at, normal)) / (144.0 / 64.0 - 1.0);
    }

private:
    Collocation coarse_;
    Collocation fine_;
};

} // namespace gonio::test
