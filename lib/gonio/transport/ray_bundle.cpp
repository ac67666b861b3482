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

bool is_far(double distance2, double half_diagonal_m) {
    const double least = least_distance * half_diagonal_m;
    return distance2 > least * least;
}

double distance2_of(const Receivers::Place& place, const glm::dvec3& position) {
    const glm::dvec3 to = position - place.position;
    return glm::dot(to, to);
}

// From a place to a sender.
struct Way {
    Way(const Receivers::Place& place, const glm::dvec3& position, const glm::dvec3& normal)
        : to(position - place.position),
          here(glm::dot(place.normal, to)),
          there(-glm::dot(normal, to)),
          distance2(glm::dot(to, to)) {}

    bool is_seen() const { return here > 0.0 && there > 0.0; }
    bool is_far(double half_diagonal_m) const { return detail::is_far(distance2, half_diagonal_m); }

    glm::dvec3 to;
    double here, there; // cosines, times the distance
    double distance2;
};

// The rays and links of one place.
class Bundle {
public:
    Bundle(const Stage& stage, const RayCaster& caster, const Patches& patches, simd::InstructionSet set)
        : caster_(stage, caster, patches, set), patches_(patches), by_link_(patches.cells().size(), By::rays) {
        for (const Chart& chart : patches.charts().all())
            is_solid_.push_back(is_sheet(stage.surfaces[chart.surface].geometry) ? 0 : 1);
        is_before_.resize(is_solid_.size());
    }

    // `of_charts`: the sum of the shares of each.
    void make(const Receivers::Place& place, const DirectionArrays& directions, std::span<std::uint32_t> ends,
              std::vector<Link>& links, std::span<float> of_charts) {
        caster_.begin(frame_about(place.position, place.normal), place.own);
        link(place, links, of_charts);
        charts_.resize(directions.size());
        caster_.cast(directions, ends, charts_);
        // Counts in turn: rays of one bundle often meet the same chart, and one count would wait for itself.
        constexpr std::size_t turns = 4;
        const std::size_t charts = of_charts.size();
        count_.assign(turns * charts, 0);
        for (std::size_t i = 0; i < ends.size(); ++i) {
            if (charts_[i] == no_patch) continue;
            if (is_solid_[charts_[i]] != 0 && is_linked(place, ends[i]))
                ends[i] = linked;
            else
                ++count_[i % turns * charts + charts_[i]];
        }
        for (std::size_t chart = 0; chart < charts; ++chart) {
            std::uint32_t rays = 0;
            for (std::size_t turn = 0; turn < turns; ++turn)
                rays += count_[turn * charts + chart];
            of_charts[chart] += static_cast<float>(rays) / static_cast<float>(directions.size());
        }
    }

private:
    enum class By : unsigned char { rays, cell, patches };

    bool is_linked(const Receivers::Place& place, std::uint32_t patch) const {
        const By by = by_link_[patches_.cell_of(patch)];
        return by == By::cell || (by == By::patches &&
                                  is_far(distance2_of(place, patches_.middle(patch)), patches_.half_diagonal(patch)));
    }

    // Whether any point of the chart may see the place: not on the place's own solid or on a face that is turned away.
    static bool may_be_seen(const Receivers::Place& place, const Chart& chart) {
        return chart.surface != place.own &&
               (chart.kind == Chart::Kind::round || glm::dot(chart.frame.z, place.position - chart.frame.origin) > 0.0);
    }

    void link(const Receivers::Place& place, std::vector<Link>& links, std::span<float> of_charts) {
        possible_.clear();
        possible_charts_.clear();
        towards_.clear();
        const Frame frame = frame_about(place.position, place.normal);
        for (std::size_t chart = 0; chart < is_solid_.size(); ++chart)
            is_before_[chart] = may_be_seen(place, patches_.charts().all()[chart]) ? 1 : 0;
        for (const std::uint32_t of_solid : patches_.cells_of_solids()) {
            const Cell& sender = patches_.cells()[of_solid];
            by_link_[of_solid] = By::rays;
            if (is_before_[sender.chart] == 0) continue;
            const Way way(place, sender.position, sender.normal);
            // What faces away is seen at most at its edge, by rays.
            if (!way.is_seen()) continue;
            if (sender.covered) continue;
            if (way.is_far(sender.half_diagonal_m)) {
                by_link_[of_solid] = By::cell;
                consider(way, frame, patches_.cell_area_m2(of_solid),
                         static_cast<std::uint32_t>(patches_.count()) + of_solid, sender.chart);
                continue;
            }
            by_link_[of_solid] = By::patches;
            for (const std::uint32_t patch : patches_.patches_of(of_solid)) {
                const Way to_patch(place, patches_.middle(patch), patches_.normal(patch));
                if (to_patch.is_far(patches_.half_diagonal(patch)) && to_patch.is_seen())
                    consider(to_patch, frame, patches_.area_m2(patch), patch, sender.chart);
            }
        }
        charts_.resize(possible_.size());
        caster_.cast(towards_, charts_);
        for (std::size_t i = 0; i < possible_.size(); ++i) {
            if (charts_[i] != possible_charts_[i]) continue;
            links.push_back(possible_[i]);
            of_charts[charts_[i]] += possible_[i].share;
        }
    }

    void consider(const Way& way, const Frame& frame, double area_m2, std::uint32_t number, std::uint32_t chart) {
        if (!(area_m2 > 0.0)) return;
        possible_.push_back({number, static_cast<float>(way.here * way.there * area_m2 /
                                                        (std::numbers::pi * way.distance2 * way.distance2))});
        possible_charts_.push_back(chart);
        towards_.add(frame.to_local(way.to / std::sqrt(way.distance2)));
    }

    BundleCaster caster_;
    const Patches& patches_;
    std::vector<std::uint8_t> is_solid_;  // by chart
    std::vector<std::uint8_t> is_before_; // by chart, of the current place
    // For the current place:
    std::vector<By> by_link_; // by cell
    std::vector<Link> possible_;
    std::vector<std::uint32_t> possible_charts_;
    DirectionArrays towards_;
    std::vector<std::uint32_t> charts_;
    std::vector<std::uint32_t> count_; // of rays, by chart
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
    : rays_(rays),
      ends_(places.size() * rays, no_patch),
      charts_(patches.charts().all().size()),
      of_charts_(places.size() * charts_, 0.0F) {
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
            bundle.make(places[i], directions, std::span(ends_).subspan(i * rays, rays), links[block],
                        std::span(of_charts_).subspan(i * charts_, charts_));
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

glm::dvec3 Bundles::gathered(std::size_t place, std::span<const Sent> sent) const {
    // Floats in runs that keep their digits, then doubles.
    constexpr std::size_t run = 64;
    const std::span<const std::uint32_t> of_place = ends(place);
    glm::dvec3 by_rays(0.0);
    for (std::size_t first = 0; first < of_place.size(); first += run) {
        Sent sum;
        for (std::size_t i = first; i < std::min(first + run, of_place.size()); ++i)
            if (of_place[i] < back_side) sum.add(sent[of_place[i]]);
        by_rays += sum.rgb();
    }
    glm::dvec3 by_links(0.0);
    for (std::uint32_t i = first_link_[place]; i < first_link_[place + 1]; ++i)
        by_links += static_cast<double>(links_[i].share) * sent[links_[i].sender].rgb();
    return by_rays / static_cast<double>(rays_) + by_links;
}

double Bundles::escaping(std::size_t place) const {
    const std::span<const std::uint32_t> of_place = ends(place);
    const auto lost = std::count_if(of_place.begin(), of_place.end(),
                                    [](std::uint32_t end) { return end == no_patch || end == back_side; });
    return static_cast<double>(lost) / static_cast<double>(rays_);
}

glm::dvec3 Bundles::leaving(std::size_t place, std::span<const glm::dvec3> along) const {
    const std::span<const std::uint32_t> of_place = ends(place);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < of_place.size(); ++i)
        if (of_place[i] == no_patch) sum += along[i];
    return sum / static_cast<double>(rays_);
}

std::vector<Sent> with_cells(const Patches& patches, std::span<const glm::dvec3> of_patches) {
    const std::size_t count = patches.count();
    std::vector<Sent> sent(count + patches.cells().size());
    std::vector<glm::dvec3> of_cells(patches.cells().size(), glm::dvec3(0.0));
    for (std::uint32_t patch = 0; patch < count; ++patch) {
        sent[patch] = Sent(of_patches[patch]);
        const std::uint32_t cell = patches.cell_of(patch);
        const double area_m2 = patches.cell_area_m2(cell);
        if (area_m2 > 0.0) of_cells[cell] += patches.area_m2(patch) / area_m2 * of_patches[patch];
    }
    for (std::size_t cell = 0; cell < of_cells.size(); ++cell)
        sent[count + cell] = Sent(of_cells[cell]);
    return sent;
}

} // namespace gonio::detail
