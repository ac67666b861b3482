// The surfaces of a stage as charts: faces on which two coordinates name every point.
//
// A panel and each face of a box are a rectangle with metres along X and Y. A plane is the same without an end. A
// sphere and a capsule have the azimuth about their axis [rad] and the length of arc along their outline from the end
// at −axis [m].
#pragma once

#include <gonio/base/frame.hpp>
#include <gonio/scene/stage.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace gonio::detail {

// What a stage is about, for charts without an end or with a distant one: where they are divided finely.
struct Interest {
    glm::dvec3 center{0.0};
    double radius = 1.0; // [m], > 0
};

// The sphere about the camera and what it looks at, the stage's place for a light, its small solids and `lights`.
Interest interest_of(const Stage& stage, const std::vector<glm::dvec3>& lights);

// A range of one coordinate, which is divided more coarsely farther than `core` from the middle.
struct Range {
    double low = 0.0;
    double high = 0.0;
    double middle = 0.0;
    double core = 0.0; // 0: alike everywhere
};

struct Chart {
    enum class Kind : unsigned char { flat, round };

    std::size_t surface = 0;
    int face = 0; // of a box
    Kind kind = Kind::flat;
    Frame frame; // flat: Z is the normal; round: Z is the axis
    double half_length = 0.0;
    double radius = 0.0;
    Range u, v;
    bool endless = false; // of a plane

    // The coordinates of a point on the surface; unwrapped azimuths lie in [0, 2π).
    glm::dvec2 coordinates(const glm::dvec3& position) const;
    // The same on a sphere, from the azimuth about Z from X, in [−π, π], and the elevation [rad].
    glm::dvec2 on_sphere(double azimuth, double elevation) const;
    glm::dvec3 position(const glm::dvec2& at) const;
    glm::dvec3 normal(const glm::dvec2& at) const;
    // Of a point near the surface, the nearest one on it, flat ones continued without an end.
    struct Spot {
        glm::dvec3 position;
        glm::dvec3 normal;
    };
    Spot nearest(const glm::dvec3& position) const;
    // Of the rectangle of coordinates [m²].
    double area(const glm::dvec2& low, const glm::dvec2& high) const;
};

class Charts {
public:
    Charts(const Stage& stage, const Interest& interest);

    const std::vector<Chart>& all() const { return charts_; }
    bool endless() const;       // whether there is a plane
    bool uses_interest() const; // whether the division depends on the interest
    std::size_t index_of(std::size_t surface, int face) const {
        return first_[surface] + static_cast<std::size_t>(face);
    }
    // A length that divides the area into about `count` squares [m]; endless and distant parts count as far as the
    // interest reaches.
    double square_of(double count) const;

private:
    std::vector<Chart> charts_;
    std::vector<std::size_t> first_; // of each surface
    double area_ = 0.0;
};

} // namespace gonio::detail
