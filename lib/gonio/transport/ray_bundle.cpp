#include <gonio/base/parallel.hpp>
#include <gonio/transport/part_links.hpp>
#include <gonio/transport/ray_bundle.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gonio::detail {

namespace {

// As of LinkedCells, of the half diagonals of a part of a flat patch.
constexpr double least_of_part = 4.0;
// The same for fine places: a ray for each part says whether it is seen past a pole.
constexpr double least_of_part_for_fine = 16.0;
constexpr double most_parts = 32.0; // of a patch along a thin solid

bool is_far(double distance2, double half_diagonal_m, double least_distance) {
    const double least = least_distance * half_diagonal_m;
    return distance2 > least * least;
}

// From a place to a sender.
struct Way {
    Way(const Receivers::Place& place, const glm::dvec3& position, const glm::dvec3& normal)
        : to(position - place.position),
          here(glm::dot(place.normal, to)),
          there(-glm::dot(normal, to)),
          distance2(glm::dot(to, to)) {}

    bool is_seen() const { return here > 0.0 && there > 0.0; }
    bool is_far(double half_diagonal_m, double least_distance) const {
        return detail::is_far(distance2, half_diagonal_m, least_distance);
    }

    glm::dvec3 to;
    double here, there; // cosines, times the distance
    double distance2;
};

// The direction of a way and the reciprocal of its length, once for all that asks for them.
struct Along {
    explicit Along(const Way& way) : per_distance(1.0 / std::sqrt(way.distance2)), direction(per_distance * way.to) {}

    double per_distance;
    glm::dvec3 direction;
};

// The rays and links of one place.
class Bundle {
public:
    Bundle(const Stage& stage, const Patches& patches, simd::InstructionSet set)
        : caster_(stage, patches, set),
          kernels_(transport::ray_kernels(set)),
          patches_(patches),
          linked_(patches.linked()),
          by_link_(patches.cells().size() + linked_.groups().size(), By::rays),
          has_link_(linked_.empty() ? 0 : patches.count(), 0),
          parts_(set) {}

    // `of_charts`: the sum of the shares of each.
    void make(const Receivers::Place& place, const DirectionArrays& directions, std::span<PatchPoint> ends,
              std::vector<Link>& links, std::vector<LinkSlope>& slopes, std::span<float> of_charts) {
        caster_.begin(frame_about(place.position, place.normal), place.own);
        link(place, links, slopes, of_charts);
        charts_.resize(directions.size());
        caster_.cast(directions, ends, charts_);
        // Counts in turn: rays of one bundle often meet the same chart, and one count would wait for itself.
        constexpr std::size_t turns = 4;
        const std::size_t charts = of_charts.size();
        count_.assign(turns * charts, 0);
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const std::uint32_t chart = charts_[i];
            if (chart == no_patch) continue;
            if (linked_.is_of_small(chart) && is_linked(ends[i].patch())) {
                ends[i] = PatchPoint(linked);
                continue;
            }
            ++count_[i % turns * charts + chart];
            if (linked_.is_bright(chart))
                of_charts[chart] -= (1.0F - patches_.by_rays(ends[i].patch())) / static_cast<float>(directions.size());
        }
        for (std::size_t chart = 0; chart < charts; ++chart) {
            std::uint32_t rays = 0;
            for (std::size_t turn = 0; turn < turns; ++turn)
                rays += count_[turn * charts + chart];
            of_charts[chart] += static_cast<float>(rays) / static_cast<float>(directions.size());
        }
    }

private:
    enum class By : unsigned char { rays, one, parts };

    bool is_linked(std::uint32_t patch) const {
        const std::uint32_t cell = patches_.cell_of(patch);
        if (by_link_[cell] == By::parts) return has_link_[patch] != 0;
        std::uint32_t number = cell;
        while (number != LinkedCells::no_group && by_link_[number] != By::one)
            number = linked_.group_of(number);
        return number != LinkedCells::no_group;
    }
    // The squared distance from the place to the nearest point of the length of a patch.
    double distance2_of(const Receivers::Place& place, const LinkedPatch& patch, std::uint32_t chart) const {
        glm::dvec3 to = patch.middle - place.position;
        if (patch.half_length_m > 0.0) {
            const glm::dvec3& axis = patches_.charts().all()[chart].frame.z;
            to += std::clamp(-glm::dot(to, axis), -patch.half_length_m, patch.half_length_m) * axis;
        }
        return glm::dot(to, to);
    }

    // Whether any point of the chart may see the place: not on the place's own solid or on a face that is turned away.
    static bool may_be_seen(const Receivers::Place& place, const Chart& chart) {
        return chart.surface != place.own &&
               (chart.kind == Chart::Kind::round || glm::dot(chart.frame.z, place.position - chart.frame.origin) > 0.0);
    }

    // A function of its own: inlined into the loop over places, its own loops are slower.
    [[gnu::noinline]] void link(const Receivers::Place& place, std::vector<Link>& links, std::vector<LinkSlope>& slopes,
                                std::span<float> of_charts) {
        const Frame frame = frame_about(place.position, place.normal);
        if (!linked_.empty()) std::fill(by_link_.begin(), by_link_.end(), By::rays);
        for (const LinkedCells::OfChart& chart : linked_.by_chart()) {
            const Chart& of = patches_.charts().all()[chart.chart];
            if (!may_be_seen(place, of)) continue;
            possible_.clear();
            towards_.clear();
            may_be_hidden_ = caster_.find_nearer(chart.chart);
            parts_.begin(frame, of.frame, place.is_fine ? least_of_part_for_fine : least_of_part);
            link(place, frame, chart);
            add_parts();
            if (may_be_hidden_) drop_hidden(chart.chart);
            of_charts[chart.chart] += add_possible(links, slopes);
        }
    }

    // Takes what the possible links carry where something else is met first.
    void drop_hidden(std::uint32_t chart) {
        charts_.resize(possible_.size());
        caster_.cast_toward(towards_, charts_);
        std::size_t seen = 0;
        for (std::size_t i = 0; i < possible_.size(); ++i) {
            possible_[seen] = possible_[i];
            seen += charts_[i] == chart ? 1U : 0U;
        }
        possible_.resize(seen);
    }

    void add_parts() {
        parts_.find();
        for (std::size_t i = 0; i < parts_.size(); ++i)
            consider(parts_.towards(i), parts_.share(i), parts_.number(i), parts_.moment(i));
    }

    // The parts of a patch, which come one after the other, as one link. The sum of what the links carry.
    float add_possible(std::vector<Link>& links, std::vector<LinkSlope>& slopes) {
        float sum = 0.0F;
        for (std::size_t i = 0; i < possible_.size();) {
            const std::uint32_t sender = possible_[i].sender;
            Link link{sender, 0.0F};
            LinkSlope slope{sender, 0.0F, 0.0F};
            for (; i < possible_.size() && possible_[i].sender == sender; ++i) {
                link.share += possible_[i].share;
                slope.along_u += possible_[i].along_u;
                slope.along_v += possible_[i].along_v;
            }
            links.push_back(link);
            if (slope.along_u != 0.0F || slope.along_v != 0.0F) slopes.push_back(slope);
            sum += link.share * patches_.carried(sender);
        }
        return sum;
    }

    // A chart by groups, and those that are too close by their cells and these by their patches.
    void link(const Receivers::Place& place, const Frame& frame, const LinkedCells::OfChart& chart) {
        level_.assign(1, chart.whole);
        while (!level_.empty()) {
            divided_.clear();
            for (std::size_t first = 0; first < level_.size();) {
                // Those that follow each other closely are computed at once, with what is between.
                constexpr std::size_t close = 32;
                std::size_t last = first + 1;
                while (last < level_.size() && level_[last].first - level_[last - 1].last < close)
                    ++last;
                const LinkedCells::Range all{level_[first].first, level_[last - 1].last};
                linked_.find_links(kernels_, frame, place.is_coarse, chart, all, cell_links_);
                for (; first < last; ++first) {
                    const LinkedCells::Range range = level_[first];
                    for (std::size_t i = range.first; i < range.last; ++i)
                        link(place, frame, chart, i, i - all.first);
                }
            }
            std::swap(level_, divided_);
        }
    }

    // A part of a chart, which is at this place of the links.
    void link(const Receivers::Place& place, const Frame& frame, const LinkedCells::OfChart& chart, std::size_t index,
              std::size_t at) {
        const float share = cell_links_.share[at];
        if (index >= chart.patches) {
            const std::uint32_t patch = linked_.part(index).number;
            const bool is_whole = share != 0.0F && share != transport::RayLinks::divided;
            has_link_[patch] = is_whole ? 1 : 0;
            if (is_whole) add(patch, at);
            return;
        }
        if (share == 0.0F) return;
        const LinkedCells::Part& part = linked_.part(index);
        if (share != transport::RayLinks::divided) {
            by_link_[part.number] = By::one;
            add(static_cast<std::uint32_t>(patches_.count()) + part.number, at);
            return;
        }
        if (!part.has_parts) {
            link(place, frame, part);
            return;
        }
        by_link_[part.number] = By::parts;
        divided_.push_back(part.parts);
    }

    // What is at this place of the links, if nothing stands between.
    void add(std::uint32_t sender, std::size_t at) {
        const float share = cell_links_.share[at];
        if (!(share > transport::RayLinks::least)) return;
        possible_.push_back({sender, share, 0.0F, 0.0F});
        if (!may_be_hidden_) return;
        for (std::size_t axis = 0; axis < 3; ++axis)
            towards_.axes[axis].push_back(cell_links_.towards[axis][at]);
    }

    // A cell that no kernel links: one that is uneven and flat, which may be linked as a whole, or its patches.
    void link(const Receivers::Place& place, const Frame& frame, const LinkedCells::Part& part) {
        const std::uint32_t cell = part.number;
        const Cell& sender = patches_.cells()[cell];
        if (sender.covered) return;
        const std::span<const LinkedPatch> patches = linked_.single_patches(part);
        const Way way(place, sender.linked_middle, sender.normal);
        if (sender.is_uneven() && way.is_far(sender.half_diagonal_m, LinkedCells::least_of_flat)) {
            by_link_[cell] = By::one;
            const double area_m2 = patches_.cell_area_m2(cell);
            const Along along(way);
            const double share = form_factor(way, along, facing(way, along, sender.spread), area_m2);
            const glm::dvec2 slopes = slopes_of_form_factor(way, place, sender, area_m2);
            const std::uint32_t number = static_cast<std::uint32_t>(patches_.count()) + cell;
            if (sender.is_bright)
                link_bright(frame, share, number, slopes, patches);
            else
                consider(frame.to_local(way.to), share, number, slopes);
            return;
        }
        by_link_[cell] = By::parts;
        for (const LinkedPatch& patch : patches) {
            std::uint8_t& has_link = has_link_[patch.number];
            has_link = 1;
            if (sender.is_on_sheet || sender.is_bright) {
                parts_.add(patch.flat, patch.number, patch.over_rays);
                continue;
            }
            const double distance2 = distance2_of(place, patch, sender.chart);
            has_link = is_far(distance2, patch.half_across_m, LinkedCells::least_of_patch) ? 1 : 0;
            if (has_link == 0) continue;
            if (patch.half_length_m > 0.0) {
                link_stretched(place, frame, patch, sender.chart, distance2);
                continue;
            }
            const Way to_patch(place, patch.middle, patch.normal);
            if (!(to_patch.here > 0.0)) continue;
            const Along along(to_patch);
            const double cosine = patch.cosine.mean(-along.direction);
            consider(frame.to_local(to_patch.to), form_factor(to_patch, along, cosine, patch.area_m2), patch.number);
        }
    }

    // A cell close to a light, which sends much: something may hide one part of it, so each of its patches is asked
    // for.
    void link_bright(const Frame& frame, double share, std::uint32_t sender, const glm::dvec2& slopes,
                     std::span<const LinkedPatch> patches) {
        if (!may_be_hidden_) {
            consider(glm::dvec3(0.0), share, sender, slopes);
            return;
        }
        for (const LinkedPatch& patch : patches)
            consider(frame.to_local(patch.middle - frame.origin), patch.of_bright * share, sender,
                     patch.of_bright * slopes);
    }

    // A patch along a thin solid, in parts that are far enough away for the form factor of what is small. `distance2`:
    // to its nearest point.
    void link_stretched(const Receivers::Place& place, const Frame& frame, const LinkedPatch& patch,
                        std::uint32_t chart, double distance2) {
        const double across2 = patch.half_across_m * patch.half_across_m;
        const double least2 = distance2 / (LinkedCells::least_of_patch * LinkedCells::least_of_patch);
        const double half_part2 = std::max(least2 - across2, across2);
        double parts = 1.0;
        if (patch.half_length_m * patch.half_length_m > half_part2)
            parts = std::min(std::ceil(patch.half_length_m / std::sqrt(half_part2)), most_parts);
        const glm::dvec3& axis = patches_.charts().all()[chart].frame.z;
        for (double i = 0.0; i < parts; i += 1.0) {
            const double at = (i + 0.5) / parts - 0.5;
            const Way way(place, patch.middle + 2.0 * patch.half_length_m * at * axis, patch.normal);
            if (!(way.here > 0.0)) continue;
            const Along along(way);
            const double cosine = patch.cosine.mean(-along.direction);
            const double share = form_factor(way, along, cosine, patch.area_m2 / parts);
            consider(frame.to_local(way.to), share, patch.number, {0.0, share * at});
        }
    }

    // The mean of the cosine at a sender that is round, 0 where it faces away: its cosines lie close together.
    static double facing(const Way& way, const Along& along, double spread) {
        const double cosine = way.there * along.per_distance;
        const double half = std::numbers::sqrt2 * 0.5 * spread; // to the sides, not to the corners
        if (cosine >= half) return cosine;
        return cosine > -half ? (cosine + half) * (cosine + half) / (4.0 * half) : 0.0;
    }

    // Along u and v of the sender's chart.
    glm::dvec2 slopes_of_form_factor(const Way& way, const Receivers::Place& place, const Cell& sender,
                                     double area_m2) const {
        if (!way.is_seen()) return glm::dvec2(0.0);
        const glm::dvec3 slope =
            area_m2 / (std::numbers::pi * way.distance2 * way.distance2) *
            (way.there * place.normal - way.here * sender.normal - 4.0 * way.here * way.there / way.distance2 * way.to);
        const Frame& chart = patches_.charts().all()[sender.chart].frame;
        return {glm::dot(slope, chart.x), glm::dot(slope, chart.y)};
    }

    // Of what is small as seen from the place. `cosine`: at the sender.
    static double form_factor(const Way& way, const Along& along, double cosine, double area_m2) {
        return way.here * cosine * area_m2 * std::numbers::inv_pi * along.per_distance * along.per_distance *
               along.per_distance;
    }

    // `towards`: in the place's frame, of any length; `moments`: of the form factor.
    void consider(const glm::dvec3& towards, double share, std::uint32_t number,
                  const glm::dvec2& moments = glm::dvec2(0.0)) {
        const auto of_link = static_cast<float>(share);
        if (!(of_link > 0.0F)) return;
        possible_.push_back({number, of_link, static_cast<float>(moments.x), static_cast<float>(moments.y)});
        if (may_be_hidden_) towards_.add(glm::normalize(towards));
    }

    BundleCaster caster_;
    const transport::RayKernels& kernels_;
    const Patches& patches_;
    const LinkedCells& linked_;
    // For the current place:
    CellLinks cell_links_;                    // of parts of one chart
    std::vector<LinkedCells::Range> level_;   // parts to be linked
    std::vector<LinkedCells::Range> divided_; // what those that are too close are divided into
    std::vector<By> by_link_;                 // by cell and then by group
    std::vector<std::uint8_t> has_link_;      // by patch, of cells that are linked by patches
    struct Possible {                         // a link, or a part of one, if nothing stands between
        std::uint32_t sender;
        float share;
        float along_u, along_v;
    };
    std::vector<Possible> possible_;    // of one chart
    bool may_be_hidden_ = false;        // something else may be met before the chart
    PartLinks parts_;                   // of flat patches of one chart
    DirectionArrays towards_;           // of possible links that may be hidden
    std::vector<std::uint32_t> charts_; // which rays meet
    std::vector<std::uint32_t> count_;  // of rays, by chart
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
    : charts_(patches.charts().all().size()), of_charts_(places.size() * charts_, 0.0F) {
    first_end_.assign(places.size() + 1, 0);
    for (std::size_t i = 0; i < places.size(); ++i)
        first_end_[i + 1] = first_end_[i] + (places[i].left_out ? 0 : places[i].ray_factor * rays);
    ends_.resize(first_end_.back());
    std::vector<std::size_t> factors;
    for (const Receivers::Place& place : places)
        if (std::find(factors.begin(), factors.end(), place.ray_factor) == factors.end())
            factors.push_back(place.ray_factor);
    for (const std::size_t factor : factors)
        directions_.emplace_back(cosine_directions(factor * rays));
    blocks_.resize((places.size() + places_together - 1) / places_together);
    first_link_.assign(places.size() + 1, 0);
    first_link_slope_.assign(places.size() + 1, 0);
    parallel_for(blocks_.size(), threads, [&](std::size_t block) {
        Bundle bundle(stage, patches, set);
        std::vector<Link> links;
        std::vector<LinkSlope> slopes;
        const std::size_t first = block * places_together;
        for (std::size_t i = first; i < std::min(first + places_together, places.size()); ++i) {
            if (places[i].left_out) continue;
            const std::span<PatchPoint> ends_of_place =
                std::span(ends_).subspan(first_end_[i], first_end_[i + 1] - first_end_[i]);
            const std::size_t before = links.size();
            const std::size_t slopes_before = slopes.size();
            bundle.make(places[i], directions(i), ends_of_place, links, slopes,
                        std::span(of_charts_).subspan(i * charts_, charts_));
            first_link_[i + 1] = static_cast<std::uint32_t>(links.size() - before);
            first_link_slope_[i + 1] = static_cast<std::uint32_t>(slopes.size() - slopes_before);
        }
        // Copies, which have no room for more.
        blocks_[block].links = links;
        blocks_[block].slopes = slopes;
    });
    for (std::size_t i = 0; i < places.size(); ++i) {
        first_link_[i + 1] += first_link_[i];
        first_link_slope_[i + 1] += first_link_slope_[i];
    }
}

namespace {

// Calls add(sum, i) for `count` indices from 0 on, and adds up the sums: floats in runs that keep their digits, then
// doubles. Four sums take turns, since one would wait for itself.
template<class Add>
glm::dvec3 sum_over(std::size_t count, const Add& add) {
    constexpr std::size_t run = 64;
    glm::dvec3 sum(0.0);
    for (std::size_t first = 0; first < count; first += run) {
        const std::size_t last = std::min(first + run, count);
        std::array<SentSum, 4> parts;
        std::size_t i = first;
        for (; i + parts.size() <= last; i += parts.size())
            for (std::size_t turn = 0; turn < parts.size(); ++turn)
                add(parts.at(turn), i + turn);
        for (; i < last; ++i)
            add(parts[0], i);
        for (const SentSum& part : parts)
            sum += part.rgb();
    }
    return sum;
}

template<class Add>
glm::dvec3 mean_over(std::span<const PatchPoint> ends, std::size_t step, const Add& add) {
    const std::size_t used = (ends.size() + step - 1) / step;
    const glm::dvec3 sum = sum_over(used, [&](SentSum& part, std::size_t i) {
        if (ends[i * step].is_on_patch()) add(part, ends[i * step]);
    });
    return sum / static_cast<double>(used);
}

} // namespace

glm::dvec3 Bundles::gathered(std::size_t place, std::span<const Sent> sent, std::size_t step) const {
    const glm::dvec3 by_rays =
        mean_over(ends(place), step, [&](SentSum& sum, const PatchPoint& end) { sum.add(sent[end.patch()]); });
    const std::span<const Link> of_place = links(place);
    const glm::dvec3 by_links = sum_over(
        of_place.size(), [&](SentSum& sum, std::size_t i) { sum.add(of_place[i].share, sent[of_place[i].sender]); });
    return by_rays + by_links;
}

glm::dvec3 Bundles::gathered(std::size_t place, const SentSlopes& slopes) const {
    constexpr std::size_t step = 2; // they add a little
    const glm::dvec3 by_rays = mean_over(ends(place), step, [&](SentSum& sum, const PatchPoint& end) {
        const SentSlope& slope = slopes.by_rays[end.patch()];
        sum.add(end.u(), slope.along_u);
        sum.add(end.v(), slope.along_v);
    });
    const std::span<const LinkSlope> of_place = link_slopes(place);
    const glm::dvec3 by_links = sum_over(of_place.size(), [&](SentSum& sum, std::size_t i) {
        const SentSlope& slope = slopes.of_links(of_place[i].sender);
        sum.add(of_place[i].along_u, slope.along_u);
        sum.add(of_place[i].along_v, slope.along_v);
    });
    return by_rays + by_links;
}

std::size_t Bundles::memory() const {
    std::size_t of_links = 0;
    for (const OfBlock& block : blocks_)
        of_links += block.links.size() * sizeof(Link) + block.slopes.size() * sizeof(LinkSlope);
    return ends_.size() * sizeof(PatchPoint) + of_links + of_charts_.size() * sizeof(float) +
           first_end_.size() * sizeof(std::size_t);
}

double Bundles::escaping(std::size_t place) const {
    const std::span<const PatchPoint> of_place = ends(place);
    if (of_place.empty()) return 1.0;
    const auto lost = std::count_if(of_place.begin(), of_place.end(), [](const PatchPoint& end) {
        return end.number() == no_patch || end.number() == back_side;
    });
    return static_cast<double>(lost) / static_cast<double>(of_place.size());
}

glm::dvec3 Bundles::leaving(std::size_t place, std::span<const glm::dvec3> along) const {
    const std::span<const PatchPoint> of_place = ends(place);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < of_place.size(); ++i)
        if (of_place[i].number() == no_patch) sum += along[i];
    return sum / static_cast<double>(std::max<std::size_t>(of_place.size(), 1));
}

SentSlopes slopes_of(const Patches& patches, std::span<const glm::dvec3> sent) {
    std::vector<glm::dvec3> carried(sent.begin(), sent.end());
    const auto slopes = [&] {
        std::vector<SentSlope> of_all;
        of_all.reserve(sent.size());
        for (std::uint32_t patch = 0; patch < sent.size(); ++patch) {
            const std::array<glm::dvec3, 2> change = patches.change_over(patch, carried);
            of_all.push_back({Sent(change[0]), Sent(change[1])});
        }
        return of_all;
    };
    SentSlopes made;
    for (std::uint32_t patch = 0; patch < sent.size(); ++patch)
        carried[patch] = static_cast<double>(patches.by_rays(patch)) * sent[patch];
    made.by_rays = slopes();
    if (!patches.has_moments()) return made;
    for (std::uint32_t patch = 0; patch < sent.size(); ++patch)
        carried[patch] = patches.cells()[patches.cell_of(patch)].is_of_small
                             ? sent[patch]
                             : (1.0 - static_cast<double>(patches.by_rays(patch))) * sent[patch];
    made.by_links = slopes();
    made.by_links.resize(patches.count() + patches.cells().size());
    for (const std::uint32_t cell : patches.linked_cells()) {
        const Cell& of = patches.cells()[cell];
        if (!of.is_uneven() || !(patches.cell_area_m2(cell) > 0.0)) continue;
        const Frame& frame = patches.charts().all()[of.chart].frame;
        glm::dvec3 moment_u(0.0);
        glm::dvec3 moment_v(0.0);
        for (const std::uint32_t patch : patches.patches_of(cell)) {
            const double share = patches.area_m2(patch) / patches.cell_area_m2(cell);
            const glm::dvec3 from_middle = patches.middle(patch) - of.linked_middle;
            const std::array<glm::dvec3, 4> corners = patches.corners(patch);
            const SentSlope& slope = made.by_links[patch];
            const double width = glm::distance(corners[0], corners[1]) / 12.0;
            const double height = glm::distance(corners[0], corners[3]) / 12.0;
            moment_u += share * (glm::dot(from_middle, frame.x) * carried[patch] + width * slope.along_u.rgb());
            moment_v += share * (glm::dot(from_middle, frame.y) * carried[patch] + height * slope.along_v.rgb());
        }
        made.by_links[patches.count() + cell] = {Sent(moment_u), Sent(moment_v)};
    }
    return made;
}

std::vector<Sent> by_sender(const Patches& patches, std::span<const glm::dvec3> of_patches) {
    const std::size_t count = patches.count();
    const std::vector<CellGroup>& groups = patches.linked().groups();
    std::vector<Sent> sent(count + patches.cells().size());
    sent.reserve(sent.size() + groups.size());
    std::vector<glm::dvec3> of_cells(patches.cells().size(), glm::dvec3(0.0));
    for (std::uint32_t patch = 0; patch < count; ++patch) {
        const double by_rays = patches.by_rays(patch);
        sent[patch] = Sent(by_rays * of_patches[patch]);
        const std::uint32_t cell = patches.cell_of(patch);
        const double area_m2 = patches.cell_area_m2(cell);
        const double by_links = patches.cells()[cell].is_bright ? 1.0 - by_rays : 1.0;
        if (area_m2 > 0.0) of_cells[cell] += by_links * patches.area_m2(patch) / area_m2 * of_patches[patch];
    }
    for (std::size_t cell = 0; cell < of_cells.size(); ++cell)
        sent[count + cell] = Sent(of_cells[cell]);
    for (const CellGroup& group : groups) {
        glm::dvec3 sum(0.0);
        for (const std::uint32_t cell : group.cells)
            sum += patches.cell_area_m2(cell) * of_cells[cell];
        sent.emplace_back(sum / group.area_m2);
    }
    return sent;
}

} // namespace gonio::detail
