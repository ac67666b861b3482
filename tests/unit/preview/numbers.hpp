// Random numbers, points, directions and frames from a seed, the same with every standard library.
#pragma once

#include <gonio/base/frame.hpp>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <numbers>
#include <random>

namespace gonio::test {

class Numbers {
public:
    explicit Numbers(unsigned seed) : engine_(seed) {}

    double between(double low, double high) { return low + (high - low) * (static_cast<double>(engine_()) * 0x1p-32); }
    double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    glm::dvec3 in_box(double half) { return {between(-half, half), between(-half, half), between(-half, half)}; }
    glm::dvec3 direction() {
        const double z = between(-1.0, 1.0);
        const double phi = between(0.0, 2.0 * std::numbers::pi);
        return {std::sqrt(1.0 - z * z) * std::cos(phi), std::sqrt(1.0 - z * z) * std::sin(phi), z};
    }
    Frame frame(const glm::dvec3& origin = glm::dvec3(0.0)) {
        const glm::dvec3 z = direction();
        const glm::dvec3 x = glm::normalize(glm::cross(z, direction()));
        return {origin, x, glm::cross(z, x), z};
    }

private:
    std::mt19937 engine_;
};

} // namespace gonio::test
