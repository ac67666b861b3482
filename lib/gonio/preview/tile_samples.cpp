#include <gonio/preview/detail/tile_samples.hpp>
#include <gonio/scene/detail/rays_from.hpp>
#include <gonio/scene/emitter.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace gonio::detail {

namespace {

// The rays through the pixels of a tile and of one more pixel on each side.
RayCone cone_of(const CameraRays& rays, double left, double top, double right, double bottom) {
    RayCone cone;
    const Ray middle = rays.ray(0.5 * (left + right), 0.5 * (top + bottom));
    cone.apex = middle.origin;
    cone.axis = middle.direction;
    for (const double x : {left, right})
        for (const double y : {top, bottom})
            cone.cosine = std::min(cone.cosine, glm::dot(cone.axis, rays.ray(x, y).direction));
    cone.cosine = std::max(cone.cosine - 1e-9, 0.0);
    cone.sine = std::sqrt((1.0 - cone.cosine) * (1.0 + cone.cosine));
    return cone;
}

bool differ(const Seen& a, const Seen& b) {
    if (a.what != b.what) return true;
    if (a.what == Seen::What::emitter) return a.light != b.light;
    return a.what == Seen::What::surface && (a.hit.surface != b.hit.surface || a.hit.face != b.hit.face);
}

} // namespace

TileSamples::TileSamples(const RayScene& scene, int left, int top)
    : scene_(scene),
      left_(left),
      top_(top),
      right_(std::min(left + tile_size, scene.width)),
      bottom_(std::min(top + tile_size, scene.height)),
      stride_(right_ - left_ + 2) {
    const RayCone cone = cone_of(scene.rays, left_ - 1.0, top_ - 1.0, right_ + 1.0, bottom_ + 1.0);
    scene.bodies.meeting_cone(cone, seen_lights_);
    std::sort(seen_lights_.begin(), seen_lights_.end());
    for (std::uint32_t i = 0; i < scene.stage.surfaces.size(); ++i) {
        const std::optional<Ball> around = bounds(scene.stage.surfaces[i].geometry);
        if (!around || cone.meets(around->center, around->radius)) seen_surfaces_.push_back(i);
    }
    rays_.origin = eye();
    look_through_centers();
    on_outline_.resize(centers_.size());
    fine_index_.resize(centers_.size(), -1);
    find_outlines();
    collect();
    bound_surfaces();
}

void TileSamples::look_through_centers() {
    const auto columns = static_cast<std::size_t>(stride_);
    const auto rows = static_cast<std::size_t>(bottom_ - top_ + 2);
    rays_.resize(columns * rows);
    for (std::size_t row = 0; row < rows; ++row) {
        const auto of_row = [&](std::vector<double>& axis) { return std::span(axis).subspan(row * columns, columns); };
        scene_.rays.directions(left_ - 0.5, top_ - 0.5 + static_cast<double>(row), of_row(rays_.x), of_row(rays_.y),
                               of_row(rays_.z));
    }
    centers_.resize(rays_.size());
    look(centers_);
}

void TileSamples::look(std::span<Seen> seen) {
    first_.begin(rays_.size());
    for (const std::uint32_t i : seen_surfaces_)
        meet_first(scene_.stage.surfaces[i].geometry, rays_, i, first_);
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        const Ray ray = rays_.at(i);
        seen[i].view = -ray.direction;
        if (std::isfinite(first_.distance[i])) {
            seen[i].what = Seen::What::surface;
            seen[i].hit = hit_on(scene_.stage, first_.number[i], first_.distance[i], ray);
        }
        if (!seen_lights_.empty()) find_lights(ray, seen[i]);
    }
}

void TileSamples::find_lights(const Ray& ray, Seen& seen) const {
    for (const std::uint32_t light : seen_lights_) {
        const std::optional<double> distance = distance_to(scene_.lights[light], ray);
        if (!distance || (seen.what != Seen::What::nothing && *distance >= seen.hit.distance)) continue;
        seen.what = Seen::What::emitter;
        seen.light = light;
        seen.hit.distance = *distance;
    }
}

void TileSamples::find_outlines() {
    for (std::ptrdiff_t y = 1; y <= bottom_ - top_; ++y)
        for (std::ptrdiff_t x = 1; x <= right_ - left_; ++x) {
            const Seen* const center = &centers_[static_cast<std::size_t>(y * stride_ + x)];
            // An image may have outlines of its own within the pixel.
            const bool shows_image =
                center->what == Seen::What::emitter && scene_.lights[center->light].image != nullptr;
            const bool outline = shows_image || differ(center[0], center[-1]) || differ(center[0], center[1]) ||
                                 differ(center[0], center[-stride_]) || differ(center[0], center[stride_]);
            on_outline_[static_cast<std::size_t>(y * stride_ + x)] = outline ? 1 : 0;
        }
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
        rays_.resize(samples.size());
        std::size_t next = 0;
        for (int j = 0; j < edge_samples; ++j)
            for (int i = 0; i < edge_samples; ++i)
                rays_.set(next++, scene_.rays.ray(x + (i + 0.5) / edge_samples, y + (j + 0.5) / edge_samples));
        look(samples);
    }
    return fine_[static_cast<std::size_t>(index)];
}

void TileSamples::add(const Seen& seen, std::uint32_t pixel, double share, std::int32_t center) {
    if (seen.what == Seen::What::nothing) {
        open_.push_back({pixel, static_cast<float>(share), -seen.view});
        return;
    }
    if (seen.what == Seen::What::emitter) {
        emitters_.push_back({pixel, seen.light, static_cast<float>(share), seen.view});
        return;
    }
    if (const std::optional<std::uint32_t> own = scene_.emitted.at(seen.hit))
        emitters_.push_back({pixel, *own, static_cast<float>(share), seen.view});
    auto of_surface = std::find_if(surfaces_.begin(), surfaces_.end(),
                                   [&](const SurfaceSamples& s) { return s.surface == seen.hit.surface; });
    if (of_surface == surfaces_.end()) {
        surfaces_.emplace_back().surface = seen.hit.surface;
        of_surface = surfaces_.end() - 1;
        of_surface->reserve(std::size_t{tile_size} * tile_size);
    }
    of_surface->add({seen.hit.position, seen.hit.normal, seen.view}, pixel, share, center);
}

void TileSamples::collect() {
    for (int block_y = top_; block_y < bottom_; block_y += block_size)
        for (int block_x = left_; block_x < right_; block_x += block_size) {
            for (int y = block_y; y < std::min(block_y + block_size, bottom_); ++y)
                for (int x = block_x; x < std::min(block_x + block_size, right_); ++x) {
                    const auto center = static_cast<std::size_t>((y - top_ + 1) * stride_ + (x - left_ + 1));
                    const std::uint32_t pixel = pixel_of(center);
                    if (!on_outline(center)) {
                        add(centers_[center], pixel, 1.0, static_cast<std::int32_t>(center));
                        continue;
                    }
                    for (const Seen& seen : fine(center))
                        add(seen, pixel, 1.0 / (edge_samples * edge_samples), -1);
                }
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
    const auto seen_at = [&](int column, int row) -> const Seen& {
        const int x = std::min(column * square_size, width);
        const int y = std::min(row * square_size, height);
        return centers_[index_of(x + 1, y + 1, static_cast<int>(stride_))];
    };
    const auto corner = [&](int column, int row) {
        std::uint32_t& index = corner_at[index_of(column, row, across + 1)];
        if (index != none) return index;
        index = static_cast<std::uint32_t>(made.corners.size());
        const Seen& seen = seen_at(column, row);
        made.corners.add({seen.hit.position, seen.hit.normal, seen.view}, 0, 1.0, -1);
        return index;
    };
    constexpr int least_used = 6; // corners cost as much as pixels, and are shared
    std::vector<std::uint32_t> made_at(used.size(), none);
    for (int row = 0; row < down; ++row)
        for (int column = 0; column < across; ++column) {
            if (used[square_at(column, row)] < least_used) continue;
            const Seen& first = seen_at(column, row);
            const auto shows_the_same = [&](const Seen& seen) {
                return seen.what == Seen::What::surface && seen.hit.surface == samples.surface &&
                       seen.hit.face == first.hit.face;
            };
            if (!shows_the_same(first) || !shows_the_same(seen_at(column + 1, row)) ||
                !shows_the_same(seen_at(column, row + 1)) || !shows_the_same(seen_at(column + 1, row + 1)))
                continue;
            made_at[square_at(column, row)] = static_cast<std::uint32_t>(made.squares.size());
            made.squares.push_back(
                {corner(column, row), corner(column + 1, row), corner(column, row + 1), corner(column + 1, row + 1)});
        }
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples.center[i] < 0) continue;
        const Seen& seen = centers_[static_cast<std::size_t>(samples.center[i])];
        const int x = static_cast<int>(samples.center[i] % stride_) - 1;
        const int y = static_cast<int>(samples.center[i] / stride_) - 1;
        const int column = x / square_size;
        const int row = y / square_size;
        const std::uint32_t square = made_at[square_at(column, row)];
        if (square == none || seen.hit.face != seen_at(column, row).hit.face) continue;
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
            const Seen& seen = centers_[static_cast<std::size_t>(center)];
            if (seen.what == Seen::What::surface && seen.hit.surface == samples.surface)
                samples.bounds_builder.add(seen.hit.position, glm::dvec3(glm::vec3(seen.hit.normal)));
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
