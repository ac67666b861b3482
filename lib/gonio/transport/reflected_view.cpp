#include <gonio/transport/exchange_geometry.hpp>
#include <gonio/transport/reflected_view.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gonio::detail {

namespace {

constexpr std::size_t together = 4096;   // rays that are cast at once
constexpr std::size_t least_rays = 8;    // of a lobe that is wide enough for squares
constexpr std::size_t least_beyond = 16; // rays of a second lobe, for all of a first

// How far apart the ends of a square's rays may lie: over the distance between the rays of a lobe, and over the size of
// a patch. What round surfaces send back bends more.
struct Reach {
    float between_rays;
    float squares;
};
constexpr Reach on_flat{1.5F, 2.0F};
constexpr Reach on_round{0.5F, 1.0F};

} // namespace

ReflectedView::ReflectedView(const ExchangeGeometry& geometry, const Interreflection* indirect, const BlurredSky* sky,
                             const SurroundingsReflectances& surfaces, simd::InstructionSet set)
    : geometry_(geometry),
      indirect_(indirect),
      sky_(sky),
      surfaces_(surfaces),
      caster_(geometry.stage(), geometry.patches(), set) {
    if (indirect != nullptr && indirect->bounces() == all_bounces)
        has_metals_ = std::any_of(surfaces.begin(), surfaces.end(),
                                  [](const auto& surface) { return surface->by_metal != glm::vec3(0.0F); });
    for (const Chart& chart : geometry.patches().charts().all()) {
        const bool is_round = chart.kind == Chart::Kind::round;
        width_m_.push_back(static_cast<float>(
            is_round ? 2.0 * chart.radius : std::min(chart.u.high - chart.u.low, chart.v.high - chart.v.low)));
        per_turn_.push_back(is_round ? static_cast<float>(chart.radius) : 1.0F);
    }
}

ReflectedView::Mirror ReflectedView::mirror(const SurfaceSamples& samples, std::size_t sample,
                                            const LobeRays& lobe) const {
    return mirror(samples.position_of(sample) - samples.anchor, glm::normalize(samples.normal_of(sample)),
                  samples.view_of(sample), lobe);
}

ReflectedView::Mirror ReflectedView::mirror(const glm::dvec3& from_anchor, const glm::dvec3& normal,
                                            const glm::dvec3& view, const LobeRays& lobe) const {
    Mirror mirror;
    const double cosine = glm::dot(normal, view);
    if (!(cosine > 0.0)) return mirror;
    mirror.is_seen = true;
    const glm::dvec3 aside = view - cosine * normal;
    const double length = glm::length(aside);
    const glm::dvec3 x = length > 1e-9 ? aside / length : frame_about(glm::dvec3(0.0), normal).x;
    mirror.view = lobe.view(cosine, normal, x);
    mirror.x = glm::vec3(x);
    mirror.z = glm::vec3(normal);
    mirror.y = glm::cross(mirror.z, mirror.x);
    const double lift_m = Patches::lift(geometry_.patches().square_m());
    mirror.origin = glm::vec3(from_anchor + lift_m * normal);
    return mirror;
}

void ReflectedView::add(const Mirror& mirror, const LobeRay& ray, std::uint32_t of, std::size_t index) {
    if (ray.weight == glm::vec3(0.0F)) return;
    const glm::vec3 direction = ray.direction.x * mirror.x + ray.direction.y * mirror.y + ray.direction.z * mirror.z;
    for (int axis = 0; axis < 3; ++axis) {
        origin_[static_cast<std::size_t>(axis)].push_back(mirror.origin[axis]);
        direction_[static_cast<std::size_t>(axis)].push_back(direction[axis]);
    }
    weight_.push_back(ray.weight);
    ray_width_.push_back(ray.width);
    of_.push_back(of);
    index_.push_back(static_cast<std::uint32_t>(index));
}

void ReflectedView::clear_rays() {
    for (auto* const axes : {&origin_, &direction_})
        for (std::vector<float>& axis : *axes)
            axis.clear();
    weight_.clear();
    ray_width_.clear();
    of_.clear();
    index_.clear();
}

// What a ray shows of the surface that it met, without what it will show beyond that.
glm::vec3 ReflectedView::seen_at(const glm::dvec3& anchor, std::size_t ray, float between_m, const glm::vec3& weight,
                                 bool goes_on) {
    const PatchPlace& end = ends_[ray];
    const glm::vec3 direction(direction_[0][ray], direction_[1][ray], direction_[2][ray]);
    const Chart& chart = geometry_.patches().charts().all()[end.chart];
    const glm::vec3 by_metal = goes_on && has_metals_ ? surfaces_[chart.surface]->by_metal : glm::vec3(0.0F);
    if (by_metal != glm::vec3(0.0F)) {
        const glm::dvec3 origin(origin_[0][ray], origin_[1][ray], origin_[2][ray]);
        const Chart::Spot at =
            chart.nearest(anchor + origin + static_cast<double>(end.distance_m) * glm::dvec3(direction));
        on_metal_.push_back({static_cast<std::uint32_t>(chart.surface), at.position, at.normal,
                             -glm::normalize(glm::dvec3(direction)), weight, ray_width_[ray], of_[ray], index_[ray]});
    }
    return indirect_->luminance_at(end, between_m, -direction, by_metal);
}

// Casts the rays that metals send on, and adds what each shows.
void ReflectedView::go_on(const glm::dvec3& anchor, std::vector<Shown>& shown) {
    std::vector<OnMetal> from;
    std::swap(from, on_metal_);
    // Rays from one surface are cast together.
    std::stable_sort(from.begin(), from.end(),
                     [](const OnMetal& a, const OnMetal& b) { return a.surface < b.surface; });
    for (std::size_t i = 0; i < from.size();) {
        const std::uint32_t surface = from[i].surface;
        for (; i < from.size() && from[i].surface == surface; ++i)
            for (const LobeRays& lobe : surfaces_[surface]->lobes)
                if (lobe.is_metal()) add(anchor, from[i], lobe);
        if (of_.empty()) continue;
        caster_.cast(anchor, geometry_.own(surface), origin_, direction_, of_.size(), ends_);
        for (std::size_t ray = 0; ray < of_.size(); ++ray)
            if (ends_[ray].chart != no_patch && ends_[ray].chart != back_side)
                shown[of_[ray]].nt +=
                    weight_[ray] * seen_at(anchor, ray, ray_width_[ray] * ends_[ray].distance_m, weight_[ray], false);
        clear_rays();
    }
}

// Some rays of the lobe of a metal that another ray met.
void ReflectedView::add(const glm::dvec3& anchor, const OnMetal& at, const LobeRays& lobe) {
    const Mirror of_metal = mirror(at.position - anchor, at.normal, at.view, lobe);
    if (!of_metal.is_seen) return;
    const std::size_t all = lobe.count();
    const std::size_t some = std::clamp<std::size_t>(least_beyond / rays_of_lobe_, 1, all);
    const float share = static_cast<float>(all) / static_cast<float>(some);
    for (std::size_t k = 0; k < some; ++k) {
        // A lattice over both lobes.
        constexpr std::size_t stride = 13;
        LobeRay ray = lobe.ray(of_metal.view, (at.index * stride + k * all / some) % all);
        ray.weight *= share * at.weight;
        ray.width = std::max(at.width, ray.width * std::sqrt(share / static_cast<float>(rays_of_lobe_)));
        add(of_metal, ray, at.of, at.index);
    }
}

// Casts the rays that were added, and adds what each shows.
void ReflectedView::cast(const SurfaceSamples& samples, std::vector<Shown>& shown, std::vector<CornerEnd>* ends) {
    if (of_.empty()) return;
    caster_.cast(samples.anchor, geometry_.own(samples.surface), origin_, direction_, of_.size(), ends_);
    for (std::size_t i = 0; i < of_.size(); ++i) {
        const glm::vec3 direction(direction_[0][i], direction_[1][i], direction_[2][i]);
        Shown& of = shown[of_[i]];
        if (ends != nullptr) (*ends)[of_[i]] = {ends_[i], direction, ray_width_[i], true};
        of.all += weight_[i];
        if (ends_[i].chart == no_patch || ends_[i].chart == back_side) {
            of.kept += weight_[i];
            if (sky_ != nullptr && ends_[i].chart == no_patch)
                of.nt += weight_[i] * glm::vec3(sky_->radiance(glm::dvec3(direction), 1.5F * ray_width_[i]));
            continue;
        }
        // A single ray that meets a thing much narrower than the distance between rays would draw a line: it counts
        // less, and the others more.
        const float between_m = ray_width_[i] * ends_[i].distance_m;
        const float width_m = width_m_[ends_[i].chart];
        const glm::vec3 weight = width_m < between_m ? width_m / between_m * weight_[i] : weight_[i];
        of.kept += weight;
        if (indirect_ != nullptr) of.nt += weight * seen_at(samples.anchor, i, between_m, weight, true);
    }
    clear_rays();
    go_on(samples.anchor, shown);
}

// Whether what a ray of the lobe shows changes little between these corners.
bool ReflectedView::is_even(const std::array<std::uint32_t, 4>& corners, std::size_t ray, std::size_t rays) const {
    const std::vector<Chart>& charts = geometry_.patches().charts().all();
    const CornerEnd& first = corner_ends_[corners[0] * rays + ray];
    for (const std::uint32_t corner : corners) {
        const CornerEnd& end = corner_ends_[corner * rays + ray];
        if (end.is_cast != first.is_cast || end.place.chart != first.place.chart) return false;
        if (!first.is_cast || first.place.chart == back_side) continue;
        if (first.place.chart == no_patch) {
            if (sky_ != nullptr && glm::distance(end.direction, first.direction) > on_round.between_rays * first.width)
                return false;
            continue;
        }
        const float u_m = per_turn_[first.place.chart] * (end.place.u - first.place.u);
        const float v_m = end.place.v - first.place.v;
        const Reach& reach = charts[first.place.chart].kind == Chart::Kind::round ? on_round : on_flat;
        const float most_m =
            std::min(reach.squares * static_cast<float>(geometry_.patches().square_m()),
                     reach.between_rays * first.width * std::min(first.place.distance_m, end.place.distance_m));
        if (!(u_m * u_m + v_m * v_m <= most_m * most_m)) return false;
    }
    return true;
}

void ReflectedView::cast_at_corners(const SampleSquares& squares, const LobeRays& lobe) {
    const std::size_t rays = lobe.count();
    const SurfaceSamples& corners = squares.corners;
    at_corners_.assign(corners.size() * rays, {});
    corner_ends_.assign(corners.size() * rays, {});
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
        const Mirror at = mirror(corners, corner, lobe);
        for (std::size_t ray = 0; at.is_seen && ray < rays; ++ray)
            add(at, lobe.ray(at.view, ray), static_cast<std::uint32_t>(corner * rays + ray), ray);
        if (of_.size() >= together) cast(corners, at_corners_, &corner_ends_);
    }
    cast(corners, at_corners_, &corner_ends_);
    between_.assign(squares.squares.size(), {});
    uneven_.clear();
    first_uneven_.assign(1, 0);
    for (std::size_t square = 0; square < squares.squares.size(); ++square) {
        const std::array<std::uint32_t, 4>& of = squares.squares[square];
        for (std::size_t ray = 0; ray < rays; ++ray) {
            if (!is_even(of, ray, rays)) {
                uneven_.push_back(static_cast<std::uint32_t>(ray));
                continue;
            }
            for (std::size_t corner = 0; corner < of.size(); ++corner)
                between_[square][corner].add(1.0F, at_corners_[of[corner] * rays + ray]);
        }
        first_uneven_.push_back(uneven_.size());
    }
}

namespace {

// Some of the rays of a lobe, and how many each stands for.
struct Some {
    std::size_t first = 0;
    std::size_t step = 1;
    float weight = 1.0F;
};

// The points of a pixel on an outline, which come one after the other, share the rays that a whole pixel has.
Some rays_of(const SurfaceSamples& samples, std::size_t i, std::size_t rays) {
    if (samples.center[i] >= 0) return {};
    const auto is_beside = [&](std::size_t other) {
        return samples.center[other] < 0 && samples.pixel[other] == samples.pixel[i];
    };
    std::size_t first = i;
    while (first > 0 && is_beside(first - 1))
        --first;
    std::size_t last = i + 1;
    while (last < samples.size() && is_beside(last))
        ++last;
    constexpr std::size_t least = 16; // of a point
    Some some;
    some.step = std::clamp<std::size_t>(rays / least, 1, last - first);
    some.first = (i - first) % some.step;
    const std::size_t count = (rays - some.first + some.step - 1) / some.step;
    some.weight = static_cast<float>(rays) / static_cast<float>(count);
    return some;
}

} // namespace

const std::vector<glm::vec3>& ReflectedView::luminance(const SurfaceSamples& samples, const SampleSquares& squares,
                                                       const LobeRays& lobe) {
    const bool has_squares = lobe.count() >= least_rays && !squares.squares.empty();
    rays_of_lobe_ = lobe.count();
    if (has_squares) cast_at_corners(squares, lobe);
    shown_.assign(samples.size(), {});
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto of = static_cast<std::uint32_t>(i);
        const SampleSquares::Within within = has_squares ? squares.of_sample[i] : SampleSquares::Within();
        if (within.square == SampleSquares::none) {
            const Mirror at = mirror(samples, i, lobe);
            const Some some = rays_of(samples, i, lobe.count());
            for (std::size_t ray = some.first; at.is_seen && ray < lobe.count(); ray += some.step) {
                LobeRay one = lobe.ray(at.view, ray);
                one.weight *= some.weight;
                add(at, one, of, ray);
            }
        } else {
            const std::array<Shown, 4>& corners = between_[within.square];
            shown_[i].add((1.0F - within.u) * (1.0F - within.v), corners[0]);
            shown_[i].add(within.u * (1.0F - within.v), corners[1]);
            shown_[i].add((1.0F - within.u) * within.v, corners[2]);
            shown_[i].add(within.u * within.v, corners[3]);
            const std::size_t first = first_uneven_[within.square];
            const std::size_t last = first_uneven_[within.square + 1];
            if (first < last) {
                const Mirror at = mirror(samples, i, lobe);
                for (std::size_t ray = first; at.is_seen && ray < last; ++ray)
                    add(at, lobe.ray(at.view, uneven_[ray]), of, uneven_[ray]);
            }
        }
        if (of_.size() >= together) cast(samples, shown_, nullptr);
    }
    cast(samples, shown_, nullptr);
    luminance_.resize(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        luminance_[i] = shown_[i].nt;
        for (int channel = 0; channel < 3; ++channel)
            if (shown_[i].kept[channel] > 0.0F)
                luminance_[i][channel] *= shown_[i].all[channel] / shown_[i].kept[channel];
    }
    return luminance_;
}

} // namespace gonio::detail
