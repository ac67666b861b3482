#include <gonio/transport/surface_samples.hpp>

#include <span>

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

std::size_t SurfaceSamples::add_pixels(const glm::dvec3& first_position, const PixelBlock& block) {
    const std::size_t first = size();
    if (first == 0) anchor = first_position;
    const std::size_t all = first + block.columns * block.rows;
    for (auto* arrays : {&position, &normal, &view})
        for (std::vector<float>& array : *arrays)
            array.resize(all);
    share.resize(all, 1.0F);
    pixel.resize(all);
    center.resize(all);
    for (std::size_t row = 0; row < block.rows; ++row) {
        std::uint32_t* const pixels = pixel.data() + first + row * block.columns;
        std::int32_t* const centers = center.data() + first + row * block.columns;
        const std::uint32_t first_pixel = block.first_pixel + static_cast<std::uint32_t>(row) * block.pixels_of_row;
        const std::int32_t first_center = block.first_center + static_cast<std::int32_t>(row) * block.centers_of_row;
        for (std::size_t i = 0; i < block.columns; ++i) {
            pixels[i] = first_pixel + static_cast<std::uint32_t>(i);
            centers[i] = first_center + static_cast<std::int32_t>(i);
        }
    }
    return first;
}

void SurfaceSamples::finish_chunk() {
    const std::size_t first = chunks.empty() ? 0 : chunks.back().first + chunks.back().count;
    if (first == size()) return;
    BoundsBuilder builder;
    const auto added = [&](const std::array<std::vector<float>, 3>& arrays) {
        return std::array{std::span(arrays[0]).subspan(first), std::span(arrays[1]).subspan(first),
                          std::span(arrays[2]).subspan(first)};
    };
    builder.add(anchor, added(position), added(normal));
    chunks.push_back({first, size() - first, builder.bounds()});
    bounds_builder.add(builder);
}

} // namespace gonio::detail
