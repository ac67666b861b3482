#include <gonio/transport/surface_samples.hpp>

namespace gonio::detail {

void SurfaceSamples::reserve(std::size_t count) {
    for (auto* arrays : {&position, &normal, &view})
        for (std::vector<float>& array : *arrays)
            array.reserve(count);
    share.reserve(count);
    pixel.reserve(count);
    center.reserve(count);
}

void SurfaceSamples::add(const SurfacePoint& point, std::uint32_t of_pixel, double share_of_pixel,
                         std::int32_t of_center) {
    if (pixel.empty()) anchor = point.position;
    const glm::dvec3 at = point.position - anchor;
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        position[a].push_back(static_cast<float>(at[axis]));
        normal[a].push_back(static_cast<float>(point.normal[axis]));
        view[a].push_back(static_cast<float>(point.view[axis]));
    }
    share.push_back(static_cast<float>(share_of_pixel));
    pixel.push_back(of_pixel);
    center.push_back(of_center);
}

void SurfaceSamples::finish_chunk() {
    const std::size_t first = chunks.empty() ? 0 : chunks.back().first + chunks.back().count;
    if (first == size()) return;
    BoundsBuilder builder;
    for (std::size_t i = first; i < size(); ++i)
        builder.add(position_of(i), normal_of(i));
    chunks.push_back({first, size() - first, builder.bounds()});
    bounds_builder.add(builder);
}

} // namespace gonio::detail
