// The luminance of a sky as rays see it that are some distance apart: what lies between two of them counts too.
#pragma once

#include <gonio/sky/sky.hpp>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace gonio {

// Of an image the means over cubes of ever larger texels; sky and ground are kept apart at the horizon. Skies by
// formula are smooth enough without. Reading is safe from any thread.
class BlurredSky {
public:
    // The sky is copied. Takes about 50 ns a texel of an image; 0 threads: all. The same for any number of threads.
    explicit BlurredSky(const Sky& sky, unsigned threads = 0);

    // Of a unit direction, RGB [cd/m²]: the mean over a spot about `width` rad wide.
    glm::dvec3 radiance(const glm::dvec3& direction, double width) const;

private:
    // A cube's faces side by side, each with a border of one texel, in the order +x −x +y −y +z −z.
    struct Level {
        int side = 0;
        std::vector<glm::vec3> texels;

        glm::dvec3 at(const glm::dvec3& direction) const;
    };
    static Level bordered(int side, const std::vector<glm::dvec4>& sums);

    Sky sky_;
    std::vector<Level> levels_; // the finest first; empty for a sky by formula
};

} // namespace gonio
