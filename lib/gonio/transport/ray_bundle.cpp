#include <gonio/base/parallel.hpp>
#include <gonio/transport/ray_bundle.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio::detail {

namespace {

// A link stands for a part of a solid that is at least as many of its half diagonals away.
constexpr double least_distance = 5.0;

// The rays and links of one place.
class Bundle {
public:
    Bundle(const Stage& stage, const RayCaster& caster, const Patches& patches, simd::InstructionSet set)
        : caster_(caster),
          bundle_caster_(stage, caster, patches, set),
          patches_(patches),
          by_link_(patches.cells().size(), By::rays) {}

    void make(const Receivers::Place& place, const DirectionArrays& directions, std::span<std::uint32_t> ends,
              std::vector<Link>& links) {
        link(place, links);
        bundle_caster_.cast(frame_about(place.position, place.normal), place.own, directions, ends);
        for (std::uint32_t& end : ends)
            if (end != no_patch && is_linked(place, end)) end = linked;
    }

private:
    enum class By : unsigned char { rays, cell, patches };

    bool is_far(const Receivers::Place& place, const glm::dvec3& position, double half_diagonal_m) const {
        const glm::dvec3 to = position - place.position;
        const double least = least_distance * half_diagonal_m;
        return glm::dot(to, to) > least * least;
    }

    bool is_linked(const Receivers::Place& place, std::uint32_t patch) const {
        const By by = by_link_[patches_.cell_of(patch)];
        return by == By::cell ||
               (by == By::patches && is_far(place, patches_.middle(patch), patches_.half_diagonal(patch)));
    }

    void link(const Receivers::Place& place, std::vector<Link>& links) {
        for (const std::uint32_t of_solid : patches_.cells_of_solids()) {
            const Cell& sender = patches_.cells()[of_solid];
            const std::size_t surface = patches_.charts().all()[sender.chart].surface;
            by_link_[of_solid] = By::rays;
            if (sender.covered || surface == place.own) continue;
            if (is_far(place, sender.position, sender.half_diagonal_m)) {
                by_link_[of_solid] = By::cell;
                add(place, sender.position, sender.normal, surface, patches_.cell_area_m2(of_solid),
                    static_cast<std::uint32_t>(patches_.count()) + of_solid, links);
                continue;
            }
            by_link_[of_solid] = By::patches;
            for (const std::uint32_t patch : patches_.patches_of(of_solid)) {
                const glm::dvec3 middle = patches_.middle(patch);
                if (is_far(place, middle, patches_.half_diagonal(patch)))
                    add(place, middle, patches_.normal(patch), surface, patches_.area_m2(patch), patch, links);
            }
        }
    }

    void add(const Receivers::Place& place, const glm::dvec3& position, const glm::dvec3& normal, std::size_t surface,
             double area_m2, std::uint32_t sender, std::vector<Link>& links) const {
        const glm::dvec3 to = position - place.position;
        const double here = glm::dot(place.normal, to);
        const double there = -glm::dot(normal, to);
        if (!(here > 0.0) || !(there > 0.0) || !(area_m2 > 0.0)) return;
        const double distance2 = glm::dot(to, to);
        const RayEnd end = caster_.cast({place.position, to / std::sqrt(distance2)}, place.own);
        if (end.surface != surface) return;
        const double share = here * there * area_m2 / (std::numbers::pi * distance2 * distance2);
        links.push_back({sender, static_cast<float>(share)});
    }

    const RayCaster& caster_;
    BundleCaster bundle_caster_;
    const Patches& patches_;
    std::vector<By> by_link_; // by cell, for the current place
};

} // namespace

std::vector<glm::dvec3> cosine_directions(std::size_t count) {
    constexpr double golden_angle = std::numbers::pi * (3.0 - 2.2360679774997896964);
    std::vector<glm::dvec3> directions;
    directions.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double sine2 = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        const double sine = std::sqrt(sine2);
        const double azimuth = golden_angle * static_cast<double>(i);
        directions.emplace_back(sine * std::cos(azimuth), sine * std::sin(azimuth), std::sqrt(1.0 - sine2));
    }
    return directions;
}

Frame frame_about(const glm::dvec3& origin, const glm::dvec3& normal) {
    // Without a seam but at −Z (T. Duff et al., "Building an Orthonormal Basis, Revisited", 2017).
    const double sign = std::copysign(1.0, normal.z);
    const double a = -1.0 / (sign + normal.z);
    const double b = normal.x * normal.y * a;
    return {origin,
            {1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x},
            {b, sign + normal.y * normal.y * a, -normal.y},
            normal};
}

Bundles::Bundles(const Stage& stage, const Patches& patches, std::span<const Receivers::Place> places, std::size_t rays,
                 unsigned threads, simd::InstructionSet set)
    : rays_(rays), ends_(places.size() * rays, no_patch) {
    const DirectionArrays directions(cosine_directions(rays));
    const RayCaster caster(stage);
    constexpr std::size_t together = 64;
    const std::size_t blocks = (places.size() + together - 1) / together;
    std::vector<std::vector<Link>> links(blocks);
    std::vector<std::uint32_t> count(places.size(), 0);
    parallel_for(blocks, threads, [&](std::size_t block) {
        Bundle bundle(stage, caster, patches, set);
        for (std::size_t i = block * together; i < std::min((block + 1) * together, places.size()); ++i) {
            if (places[i].left_out) continue;
            const std::size_t before = links[block].size();
            bundle.make(places[i], directions, std::span(ends_).subspan(i * rays, rays), links[block]);
            count[i] = static_cast<std::uint32_t>(links[block].size() - before);
        }
    });
    first_link_.assign(places.size() + 1, 0);
    for (std::size_t i = 0; i < places.size(); ++i)
        first_link_[i + 1] = first_link_[i] + count[i];
    links_.reserve(first_link_.back());
    for (const std::vector<Link>& of_block : links)
        links_.insert(links_.end(), of_block.begin(), of_block.end());
}

glm::dvec3 Bundles::gathered(std::size_t place, std::span<const glm::dvec3> sent) const {
    glm::dvec3 by_rays(0.0);
    for (const std::uint32_t end : ends(place))
        if (end < linked) by_rays += sent[end];
    glm::dvec3 by_links(0.0);
    for (std::uint32_t i = first_link_[place]; i < first_link_[place + 1]; ++i)
        by_links += static_cast<double>(links_[i].share) * sent[links_[i].sender];
    return by_rays / static_cast<double>(rays_) + by_links;
}

double Bundles::escaping(std::size_t place) const {
    const std::span<const std::uint32_t> of_place = ends(place);
    return static_cast<double>(std::count(of_place.begin(), of_place.end(), no_patch)) / static_cast<double>(rays_);
}

std::vector<glm::dvec3> with_cells(const Patches& patches, std::vector<glm::dvec3> of_patches) {
    const std::size_t count = patches.count();
    of_patches.resize(count + patches.cells().size(), glm::dvec3(0.0));
    for (std::uint32_t patch = 0; patch < count; ++patch) {
        const std::uint32_t cell = patches.cell_of(patch);
        const double area_m2 = patches.cell_area_m2(cell);
        if (area_m2 > 0.0) of_patches[count + cell] += patches.area_m2(patch) / area_m2 * of_patches[patch];
    }
    return of_patches;
}

} // namespace gonio::detail
