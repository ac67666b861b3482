// Many rays from one point, and what they meet of a stage: the hits of first_hit() to the last bit.
#pragma once

#include <gonio/scene/camera.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/scene/stage.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace gonio::detail {

// Their directions (unit) by axis.
struct RaysFrom {
    glm::dvec3 origin{0.0};
    std::vector<double> x, y, z;

    std::size_t size() const { return x.size(); }
    void resize(std::size_t count) {
        for (auto* const axis : {&x, &y, &z})
            axis->resize(count);
    }
    Ray at(std::size_t i) const { return {origin, {x[i], y[i], z[i]}}; }
    void set(std::size_t i, const Ray& ray) {
        x[i] = ray.direction.x;
        y[i] = ray.direction.y;
        z[i] = ray.direction.z;
    }
};

// What each ray meets first: the distance, infinite for nothing, and the number of what it meets.
struct FirstMet {
    std::vector<double> distance;
    std::vector<double> number; // whole; as kernels put it

    void begin(std::size_t rays) {
        distance.assign(rays, std::numeric_limits<double>::infinity());
        number.assign(rays, 0.0);
    }
};

// The hit of a ray that meets a surface of the stage at this distance.
Hit hit_on(const Stage& stage, std::size_t surface, double distance, const Ray& ray);

} // namespace gonio::detail
