#include <gonio/preview/detail/thin_lights.hpp>
#include <gonio/preview/detail/tile_samples.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

namespace gonio::detail {

namespace {

// The rays through the pixels of a tile and of one more pixel on each side; nothing where they are a right angle or
// more from the middle, in a wide picture of few pixels.
std::optional<RayCone> cone_of(const CameraRays& rays, double left, double top, double right, double bottom) {
    RayCone cone;
    const Ray middle = rays.ray(0.5 * (left + right), 0.5 * (top + bottom));
    cone.apex = middle.origin;
    cone.axis = middle.direction;
    for (const double x : {left, right})
        for (const double y : {top, bottom})
            cone.cosine = std::min(cone.cosine, glm::dot(cone.axis, rays.ray(x, y).direction));
    cone.cosine -= 1e-9;
    if (!(cone.cosine > 0.0)) return std::nullopt;
    cone.sine = std::sqrt((1.0 - cone.cosine) * (1.0 + cone.cosine));
    return cone;
}

} // namespace

TileSamples::TileSamples(const RayScene& scene, int left, int top)
    : scene_(scene),
      left_(left),
      top_(top),
      right_(std::min(left + tile_size, scene.width)),
      bottom_(std::min(top + tile_size, scene.height)),
      stride_(right_ - left_ + 2),
      centers_(scene),
      within_pixel_(scene) {
    const std::optional<RayCone> cone = cone_of(scene.rays, left_ - 1.0, top_ - 1.0, right_ + 1.0, bottom_ + 1.0);
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    if (cone)
        scene.bodies.meeting_cone(*cone, seen_lights_);
    else
        scene.bodies.meeting_box(glm::dvec3(-everywhere), glm::dvec3(everywhere), seen_lights_);
    std::sort(seen_lights_.begin(), seen_lights_.end());
    for (std::uint32_t i = 0; i < scene.stage.surfaces.size(); ++i) {
        const std::optional<Ball> around = bounds(scene.stage.surfaces[i].geometry);
        if (!around || !cone || cone->meets(around->center, around->radius)) seen_surfaces_.push_back(i);
    }
    const ThinLights thin(scene, {left_, top_, right_, bottom_}, seen_lights_, seen_surfaces_);
    look_through_centers();
    mixed_.resize(centers_.size());
    fine_index_.resize(centers_.size(), -1);
    find_outlines();
    look_at(thin);
    collect();
    bound_surfaces();
}

void TileSamples::look_through_centers() {
    const auto columns = static_cast<std::size_t>(stride_);
    const std::size_t rows = static_cast<std::size_t>(bottom_ - top_) + 2;
    centers_.begin_grid(left_ - 0.5, top_ - 0.5, columns, rows);
    centers_.cast(seen_surfaces_, seen_lights_);
}

void TileSamples::find_outlines() {
    centers_.put_changes(static_cast<std::size_t>(stride_), mixed_);
    if (seen_lights_.empty()) return;
    // An image may have outlines of its own within the pixel.
    for (std::size_t at = 0; at < centers_.size(); ++at)
        if (centers_.is_emitter(at) && scene_.lights[centers_.light_of(at)].image != nullptr) mixed_[at] = outline;
}

void TileSamples::look_at(const ThinLights& thin) {
    std::span<const ThinLights::Part> left = thin.parts();
    if (!left.empty()) thin_of_pixel_.resize(centers_.size());
    constexpr std::size_t of_part = ThinLights::points_of_part;
    std::vector<std::uint32_t> surfaces, lights;
    while (!left.empty()) {
        const ThinLights::Part& first = left.front();
        const auto end = std::find_if(left.begin(), left.end(), [&](const ThinLights::Part& part) {
            return part.y != first.y || part.x != first.x;
        });
        const auto parts = left.first(static_cast<std::size_t>(end - left.begin()));
        left = left.subspan(parts.size());

        surfaces = seen_surfaces_;
        lights = seen_lights_;
        RaysFrom& rays = within_pixel_.begin(parts.size() * of_part);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const ThinLights::Thing& thing = thin.thing(parts[i]);
            (thing.is_surface ? surfaces : lights).push_back(thing.number);
            for (std::size_t k = 0; k < of_part; ++k)
                rays.set(i * of_part + k, scene_.rays.ray(parts[i].points[k].x, parts[i].points[k].y));
        }
        std::sort(surfaces.begin(), surfaces.end());
        std::sort(lights.begin(), lights.end());
        within_pixel_.cast(surfaces, lights);

        const std::size_t center = center_at(first.x, first.y);
        ThinOfPixel& here = thin_of_pixel_[center];
        here.first = static_cast<std::uint32_t>(thin_seen_.size());
        double covered = 0.0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const ThinLights::Thing& thing = thin.thing(parts[i]);
            const double share = parts[i].share / of_part;
            for (std::size_t ray = i * of_part; ray < (i + 1) * of_part; ++ray) {
                if (!within_pixel_.shows(ray, thing.is_surface, thing.number)) continue;
                covered += share;
                thin_seen_.push_back(
                    {within_pixel_.at(ray), static_cast<float>(share), static_cast<float>(thing.widening)});
            }
        }
        here.count = static_cast<std::uint32_t>(thin_seen_.size()) - here.first;
        here.left = static_cast<float>(std::max(1.0 - covered, 0.0));
        // A surface that emits is added up by the points of its pixel.
        if (here.count > 0) mixed_[center] |= scene_.emitted.empty() ? thin_light : outline;
    }
}

void TileSamples::add_thin_lights(std::size_t center) {
    if (thin_of_pixel_.empty()) return;
    const ThinOfPixel& here = thin_of_pixel_[center];
    for (std::uint32_t i = here.first; i < here.first + here.count; ++i)
        add(thin_seen_[i].seen, pixel_of(center), static_cast<double>(thin_seen_[i].share), -1, thin_seen_[i].widening);
}

std::uint32_t TileSamples::pixel_of(std::size_t center) const {
    const auto at = static_cast<std::ptrdiff_t>(center);
    const auto x = static_cast<std::uint32_t>(left_ - 1 + at % stride_);
    const auto y = static_cast<std::uint32_t>(top_ - 1 + at / stride_);
    return y * static_cast<std::uint32_t>(scene_.width) + x;
}

const TileSamples::FineSamples& TileSamples::fine(std::size_t center) {
    std::int32_t& index = fine_index_[center];
    if (index < 0) {
        index = static_cast<std::int32_t>(fine_.size());
        auto& samples = fine_.emplace_back();
        const auto at = static_cast<std::ptrdiff_t>(center);
        const auto x = static_cast<double>(left_ - 1 + at % stride_);
        const std::ptrdiff_t row = at / stride_;
        const auto y = static_cast<double>(top_ - 1 + row);
        RaysFrom& rays = within_pixel_.begin(samples.size());
        std::size_t next = 0;
        for (int j = 0; j < edge_samples; ++j)
            for (int i = 0; i < edge_samples; ++i)
                rays.set(next++, scene_.rays.ray(x + (i + 0.5) / edge_samples, y + (j + 0.5) / edge_samples));
        within_pixel_.cast(seen_surfaces_, seen_lights_);
        for (std::size_t i = 0; i < samples.size(); ++i)
            samples[i] = within_pixel_.at(i);
    }
    return fine_[static_cast<std::size_t>(index)];
}

void TileSamples::add(const Seen& seen, std::uint32_t pixel, double share, std::int32_t center, float widening) {
    if (seen.what == Seen::What::nothing) {
        open_.push_back({pixel, static_cast<float>(share), -seen.view});
        return;
    }
    if (seen.what == Seen::What::emitter) {
        emitters_.push_back({pixel, seen.light, static_cast<float>(share), widening, seen.view});
        return;
    }
    if (const std::optional<std::uint32_t> own = scene_.emitted.at(seen.hit))
        emitters_.push_back({pixel, *own, static_cast<float>(share), widening, seen.view});
    samples_of(seen.hit.surface).add({seen.hit.position, seen.hit.normal, seen.view}, pixel, share, center);
}

SurfaceSamples& TileSamples::samples_of(std::size_t surface) {
    const auto found = std::find_if(surfaces_.begin(), surfaces_.end(),
                                    [&](const SurfaceSamples& samples) { return samples.surface == surface; });
    if (found != surfaces_.end()) return *found;
    SurfaceSamples& made = surfaces_.emplace_back();
    made.surface = surface;
    made.reserve(std::size_t{tile_size} * tile_size);
    return made;
}

void TileSamples::add_block(std::size_t first, std::size_t columns, std::size_t rows) {
    const auto stride = static_cast<std::size_t>(stride_);
    if (!centers_.is_surface(first) || !scene_.emitted.empty()) {
        for (std::size_t row = first; row < first + rows * stride; row += stride)
            for (std::size_t i = row; i < row + columns; ++i)
                add(centers_.at(i), pixel_of(i), 1.0, static_cast<std::int32_t>(i));
        return;
    }
    SurfaceSamples& samples = samples_of(centers_.surface_of(first));
    const Primitive& geometry = scene_.stage.surfaces[samples.surface].geometry;
    std::size_t to = samples.add_pixels(centers_.position_of(first),
                                        {pixel_of(first), static_cast<std::int32_t>(first), columns, rows,
                                         static_cast<std::uint32_t>(scene_.width), static_cast<std::int32_t>(stride_)});
    const bool is_flat = is_sheet(geometry) || std::holds_alternative<Box>(geometry);
    const glm::vec3 normal(is_flat ? centers_.normal_of(first) : glm::dvec3(0.0));
    for (std::size_t row = first; row < first + rows * stride; row += stride, to += columns) {
        float* const positions[3] = {samples.position[0].data() + to, samples.position[1].data() + to,
                                     samples.position[2].data() + to};
        float* const views[3] = {samples.view[0].data() + to, samples.view[1].data() + to, samples.view[2].data() + to};
        centers_.put_positions(row, columns, samples.anchor, positions);
        centers_.put_views(row, columns, views);
        for (std::size_t i = 0; i < columns; ++i) {
            const glm::vec3 at = is_flat ? normal : glm::vec3(centers_.normal_of(row + i));
            for (std::size_t axis = 0; axis < 3; ++axis)
                samples.normal[axis][to + i] = at[static_cast<int>(axis)];
        }
    }
}

void TileSamples::add_mixed_rows(std::size_t first, std::size_t columns, std::size_t rows) {
    const auto stride = static_cast<std::size_t>(stride_);
    for (std::size_t row = first; row < first + rows * stride; row += stride)
        for (std::size_t center = row; center < row + columns;) {
            if (mixed_[center] != 0) {
                const auto left = static_cast<double>(share_of(center));
                add_thin_lights(center);
                if (!on_outline(center))
                    add(centers_.at(center), pixel_of(center), left, static_cast<std::int32_t>(center));
                else
                    for (const Seen& seen : fine(center))
                        add(seen, pixel_of(center), left / (edge_samples * edge_samples), -1);
                ++center;
                continue;
            }
            const std::size_t begin = center;
            while (center < row + columns && mixed_[center] == 0)
                ++center;
            add_block(begin, center - begin, 1);
        }
}

void TileSamples::collect() {
    const auto stride = static_cast<std::size_t>(stride_);
    for (int block_y = top_; block_y < bottom_; block_y += block_size)
        for (int block_x = left_; block_x < right_; block_x += block_size) {
            const auto columns = static_cast<std::size_t>(std::min(block_size, right_ - block_x));
            const auto rows = static_cast<std::size_t>(std::min(block_size, bottom_ - block_y));
            const std::size_t first = center_at(block_x, block_y);
            unsigned mixed = 0;
            for (std::size_t row = first; row < first + rows * stride; row += stride)
                for (std::size_t i = row; i < row + columns; ++i)
                    mixed |= mixed_[i];
            // Beside each other without an outline between them, pixels show the same.
            if (mixed == 0)
                add_block(first, columns, rows);
            else
                add_mixed_rows(first, columns, rows);
            for (SurfaceSamples& samples : surfaces_)
                samples.finish_chunk();
        }
}

SampleSquares TileSamples::squares_of(const SurfaceSamples& samples) const {
    const int width = right_ - left_;
    const int height = bottom_ - top_;
    const int across = (width + square_size - 1) / square_size;
    const int down = (height + square_size - 1) / square_size;
    constexpr std::uint32_t none = SampleSquares::none;
    SampleSquares made;
    made.corners.surface = samples.surface;
    made.of_sample.resize(samples.size());
    const auto index_of = [](int column, int row, int columns) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
    };
    const auto square_at = [&](int column, int row) { return index_of(column, row, across); };
    std::vector<int> used(index_of(0, down, across), 0);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples.center[i] < 0) continue;
        const auto at = static_cast<int>(samples.center[i]);
        const auto stride = static_cast<int>(stride_);
        ++used[square_at((at % stride - 1) / square_size, (at / stride - 1) / square_size)];
    }
    // A tile's last corners are pixels of the next one.
    std::vector<std::uint32_t> corner_at(index_of(0, down + 1, across + 1), none);
    const auto center_at = [&](int column, int row) {
        const int x = std::min(column * square_size, width);
        const int y = std::min(row * square_size, height);
        return index_of(x + 1, y + 1, static_cast<int>(stride_));
    };
    const auto corner = [&](int column, int row) {
        std::uint32_t& index = corner_at[index_of(column, row, across + 1)];
        if (index != none) return index;
        index = static_cast<std::uint32_t>(made.corners.size());
        const std::size_t center = center_at(column, row);
        made.corners.add({centers_.position_of(center), centers_.normal_of(center), centers_.view_of(center)}, 0, 1.0,
                         -1);
        return index;
    };
    constexpr int least_used = 6; // corners cost as much as pixels, and are shared
    std::vector<std::uint32_t> made_at(used.size(), none);
    for (int row = 0; row < down; ++row)
        for (int column = 0; column < across; ++column) {
            if (used[square_at(column, row)] < least_used) continue;
            const std::size_t first = center_at(column, row);
            if (!centers_.is_surface(first) || centers_.surface_of(first) != samples.surface ||
                !centers_.show_the_same(first, center_at(column + 1, row)) ||
                !centers_.show_the_same(first, center_at(column, row + 1)) ||
                !centers_.show_the_same(first, center_at(column + 1, row + 1)))
                continue;
            made_at[square_at(column, row)] = static_cast<std::uint32_t>(made.squares.size());
            made.squares.push_back(
                {corner(column, row), corner(column + 1, row), corner(column, row + 1), corner(column + 1, row + 1)});
        }
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples.center[i] < 0) continue;
        const auto center = static_cast<std::size_t>(samples.center[i]);
        const int x = static_cast<int>(samples.center[i] % stride_) - 1;
        const int y = static_cast<int>(samples.center[i] / stride_) - 1;
        const int column = x / square_size;
        const int row = y / square_size;
        const std::uint32_t square = made_at[square_at(column, row)];
        if (square == none || centers_.face_of(center) != centers_.face_of(center_at(column, row))) continue;
        const auto share = [](int at, int index, int end) {
            const int first = index * square_size;
            return static_cast<float>(at - first) / static_cast<float>(std::min(first + square_size, end) - first);
        };
        made.of_sample[i] = {square, share(x, column, width), share(y, row, height)};
    }
    return made;
}

void TileSamples::bound_surfaces() {
    for (SurfaceSamples& samples : surfaces_) {
        // Includes the rows and columns around the tile: points between pixels may lie beyond the centres.
        const auto add = [&](std::ptrdiff_t center) {
            const auto at = static_cast<std::size_t>(center);
            if (centers_.is_surface(at) && centers_.surface_of(at) == samples.surface)
                samples.bounds_builder.add(centers_.position_of(at), glm::dvec3(glm::vec3(centers_.normal_of(at))));
        };
        const std::ptrdiff_t rows = bottom_ - top_ + 2;
        for (std::ptrdiff_t x = 0; x < stride_; ++x) {
            add(x);
            add((rows - 1) * stride_ + x);
        }
        for (std::ptrdiff_t y = 1; y + 1 < rows; ++y) {
            add(y * stride_);
            add(y * stride_ + stride_ - 1);
        }
        samples.bounds = samples.bounds_builder.bounds();
    }
}

} // namespace gonio::detail
