#include <gonio/base/frame.hpp>
#include <gonio/scene/camera.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gonio {

CameraRays::CameraRays(const Camera& camera, int width, int height) : origin_(camera.position) {
    const Frame frame = aimed_frame(camera.position, camera.target - camera.position, camera.up);
    const double half_height = std::tan(0.5 * degrees(camera.vertical_fov_deg).value);
    const double half_width = std::tan(0.5 * degrees(camera.least_horizontal_fov_deg).value);
    const double pixel = 2.0 * std::max(half_height / height, half_width / width);
    plane_.right = frame.x * pixel;
    plane_.down = -frame.y * pixel;
    ahead_ = -frame.z;
    plane_.corner = -frame.z - 0.5 * width * plane_.right - 0.5 * height * plane_.down;
}

Ray CameraRays::ray(double x, double y) const {
    return {origin_, glm::normalize(plane_.corner + x * plane_.right + y * plane_.down)};
}

std::optional<glm::dvec2> CameraRays::place_of(const glm::dvec3& position) const {
    const glm::dvec3 from_eye = position - origin_;
    const double depth = glm::dot(from_eye, ahead_);
    if (!(depth > 0.0)) return std::nullopt;
    const glm::dvec3 from_corner = from_eye / depth - plane_.corner;
    const double pixel2 = glm::dot(plane_.right, plane_.right);
    return glm::dvec2(glm::dot(from_corner, plane_.right) / pixel2, glm::dot(from_corner, plane_.down) / pixel2);
}

} // namespace gonio
