// What the readers of scenes share: errors, places, amounts, colours, transformations, axes.
#pragma once

#include <gonio/base/codes/scene.hpp>
#include <gonio/base/result.hpp>
#include <gonio/interchange/found_light.hpp>
#include <gonio/interchange/scene_format.hpp>

#include <glm/ext/vector_int3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio::interchange_detail {

// A failure with a code of the family SCN: unsupported for an extension, else malformed.
Unexpected scene_error(SceneCode code, Location location, std::string message, std::string hint = {});

// Lines of ascending offsets; the whole series takes one pass over the text.
class LinePlaces {
public:
    LinePlaces(std::string_view text, std::string source)
        : text_(text), source_(std::move(source)), line_end_(text.find('\n')) {}
    Location at(std::size_t offset);

private:
    std::string_view text_;
    std::string source_;
    std::size_t line_begin_ = 0;
    std::size_t line_end_; // npos: the last line
    std::uint32_t line_ = 1;
};

// The amount of light in a unit of unit_text.hpp: "cd", "nt", "lx", "lm".
PhotometricValue amount(double number, std::string_view unit);

void remark(FoundLight& light, SceneCode code, std::string message, std::string hint = {});

// A remark about the whole scene.
void warn(FoundScene& scene, SceneCode code, Location location, std::string message, std::string hint = {});

// No shape, and why.
void only_list(FoundLight& light, std::string why, std::string hint = {});

// The name of a profile, for files of ours: '_' instead of what is not a letter, a digit or '-'.
std::string plain_name(std::string_view name);

// "1 0.8 0.6".
std::string numbers_text(const glm::dvec3& v);

// Sets the light's colour, and returns the luminance of it: 1 for white, 0 for black or for one that is not above 0,
// where the colour stays white.
double take_color(FoundLight& light, const glm::dvec3& rgb);

// Linear Rec.709 of luminance 1 of a black body, clipped to Rec.709 at constant luminance with a remark. A temperature
// that gonio has no colour for is a remark, and white.
glm::dvec3 blackbody_color(FoundLight& light, double kelvin);

// A world with Y up, or Z up, in gonio's axes.
inline glm::dvec3 z_up(const glm::dvec3& v, char up) {
    return up == 'y' ? glm::dvec3(v.x, -v.z, v.y) : v;
}

// Places a light by its transformation: `aim` and `up` are directions of its own axes. A transformation that is not
// finite or has no direction makes it a light that is only listed. Returns false then.
bool place_light(FoundLight& light, const glm::dmat4& world, const glm::dvec3& aim, const glm::dvec3& up, char up_axis,
                 double meters_per_unit);

// The lengths of the axes of a transformation.
glm::dvec3 axis_lengths(const glm::dmat4& world);

// Whether two lengths agree to 1e-6.
bool nearly(double a, double b);

// Tubes here are cylinders of the file. Those with a sphere of the same radius and luminance at each end stay tubes;
// the spheres go. The others become cylinders.
void join_capsules(std::vector<FoundLight>& lights);

// An area light of triangles, in the world of the file: a rectangle, a disk or an ellipse if it is one, else only
// listed. `points` are in metres. The light's intensity must be its luminance.
void take_mesh(FoundLight& light, const std::vector<glm::dvec3>& points, const std::vector<glm::ivec3>& faces, char up);

// A flat area light at a transformation of a unit shape, whose X and Y run along the axes of the world: a rectangle of
// 2 × 2 if `round` is false, else a disk of radius 1. `aim` is ±Z. Only listed if the axes are not at right angles.
void take_flat(FoundLight& light, const glm::dmat4& world, bool round, double aim, bool two_sided, char up,
               double meters_per_unit);

// Readers, one per format.
bool is_engine_export(std::string_view bytes);
Result<FoundScene> read_engine_export(std::string_view bytes, const std::string& source,
                                      const SceneReadOptions& options);
bool is_gdtf(std::string_view bytes);
Result<FoundScene> read_gdtf(std::string_view bytes, const std::string& source, const SceneReadOptions& options);
Result<FoundScene> read_gldf_lights(std::string_view bytes, const std::string& source, const SceneReadOptions& options);
bool is_gltf(std::string_view bytes);
Result<FoundScene> read_gltf(std::string_view bytes, const std::string& source, const SceneReadOptions& options);
bool is_pbrt(std::string_view bytes);
Result<FoundScene> read_pbrt(std::string_view bytes, const std::string& source, const SceneReadOptions& options);
bool is_mitsuba(std::string_view bytes);
Result<FoundScene> read_mitsuba(std::string_view bytes, const std::string& source, const SceneReadOptions& options);
bool is_usda(std::string_view bytes);
bool is_usd(std::string_view bytes); // as text, or an archive
Result<FoundScene> read_usd(std::string_view bytes, const std::string& source, const SceneReadOptions& options);
bool is_luxcore(std::string_view bytes);
Result<FoundScene> read_luxcore(std::string_view bytes, const std::string& source, const SceneReadOptions& options);

} // namespace gonio::interchange_detail
