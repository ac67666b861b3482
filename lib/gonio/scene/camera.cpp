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
    right_ = frame.x * pixel;
    down_ = -frame.y * pixel;
    ahead_ = -frame.z;
    corner_ = -frame.z - 0.5 * width * right_ - 0.5 * height * down_;
}

Ray CameraRays::ray(double x, double y) const {
    return {origin_, glm::normalize(corner_ + x * right_ + y * down_)};
}

void CameraRays::directions(double x, double y, std::span<double> along_x, std::span<double> along_y,
                            std::span<double> along_z) const {
    // Copies, which the compiler knows that the results do not change.
    const glm::dvec3 corner = corner_;
    const glm::dvec3 right = right_;
    const glm::dvec3 down = y * down_;
    const std::size_t count = along_x.size();
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 direction = glm::normalize(corner + (x + static_cast<double>(i)) * right + down);
        along_x[i] = direction.x;
        along_y[i] = direction.y;
        along_z[i] = direction.z;
    }
}

std::optional<glm::dvec2> CameraRays::place_of(const glm::dvec3& position) const {
    const glm::dvec3 from_eye = position - origin_;
    const double depth = glm::dot(from_eye, ahead_);
    if (!(depth > 0.0)) return std::nullopt;
    const glm::dvec3 from_corner = from_eye / depth - corner_;
    const double pixel2 = glm::dot(right_, right_);
    return glm::dvec2(glm::dot(from_corner, right_) / pixel2, glm::dot(from_corner, down_) / pixel2);
}

} // namespace gonio
