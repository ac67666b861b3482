#include <gonio/bake/mirror_images.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace gonio {

namespace {

// How a mirror maps a direction: x and y may be swapped, then each may change sign.
struct Reflection {
    bool swap = false;
    bool x = false;
    bool y = false;

    glm::dvec3 operator()(const glm::dvec3& d) const {
        const glm::dvec3 e = swap ? glm::dvec3(d.y, d.x, d.z) : d;
        return {x ? -e.x : e.x, y ? -e.y : e.y, e.z};
    }
};

std::vector<Reflection> reflections_of(const Web& web) {
    switch (web.stored_symmetry()) {
    case Symmetry::axial:
        return {{false, true, false}, {false, false, true}, {false, true, true}, {true, false, false},
                {true, true, false},  {true, false, true},  {true, true, true}};
    case Symmetry::quadrant:
        return {{false, true, false}, {false, false, true}, {false, true, true}};
    case Symmetry::bilateral_0_180:
        return {{false, false, true}};
    case Symmetry::bilateral_90_270:
        return {{false, true, false}};
    case Symmetry::none:
        break;
    }
    return {};
}

struct Found {
    std::size_t chart;
    glm::dvec2 at;
};

std::optional<Found> locate(std::span<const PlacedChart> charts, const glm::dvec3& direction) {
    for (std::size_t k = 0; k < charts.size(); ++k)
        if (const std::optional<glm::dvec2> at = charts[k].chart->locate(direction)) return Found{k, *at};
    return std::nullopt;
}

glm::dvec2 mapped(glm::dvec2 at, bool swapped, bool s_backwards, bool t_backwards) {
    if (swapped) std::swap(at.x, at.y);
    return {s_backwards ? 1.0 - at.x : at.x, t_backwards ? 1.0 - at.y : at.y};
}

// Points off every line on which charts fold or meet.
constexpr std::array<std::array<double, 2>, 6> probes{
    {{0.11, 0.23}, {0.37, 0.81}, {0.9, 0.42}, {0.61, 0.07}, {0.53, 0.47}, {0.29, 0.94}}};

} // namespace

MirrorImages::MirrorImages(std::span<const PlacedChart> charts, const Web& web) : charts_(charts) {
    for (const Reflection& reflect : reflections_of(web)) {
        Mirror mirror;
        for (std::size_t k = 0; k < charts.size(); ++k) {
            std::array<std::optional<Found>, probes.size()> found;
            for (std::size_t p = 0; p < probes.size(); ++p)
                found[p] = locate(charts, reflect(charts[k].chart->at(probes[p][0], probes[p][1]).direction));
            for (int kind = 0; kind < 8 && mirror.size() == k; ++kind) {
                const ChartMap map{found[0] ? found[0]->chart : 0, (kind & 4) != 0, (kind & 2) != 0, (kind & 1) != 0};
                bool holds = true;
                for (std::size_t p = 0; p < probes.size() && holds; ++p) {
                    const glm::dvec2 want =
                        mapped({probes[p][0], probes[p][1]}, map.swapped, map.s_backwards, map.t_backwards);
                    holds = found[p] && found[p]->chart == map.chart && std::abs(found[p]->at.x - want.x) < 1e-9 &&
                            std::abs(found[p]->at.y - want.y) < 1e-9;
                }
                const bool fits = !map.swapped || charts[k].width == charts[k].height;
                if (holds && fits) mirror.push_back(map);
            }
            if (mirror.size() == k) break; // not a mirror of the layout
        }
        if (mirror.size() == charts.size()) mirrors_.push_back(std::move(mirror));
    }
}

TexelPlace MirrorImages::image(const Mirror& mirror, const TexelPlace& texel) const {
    const ChartMap& map = mirror[texel.chart];
    const PlacedChart& to = charts_[map.chart];
    int column = texel.column;
    int row = texel.row;
    if (map.swapped) std::swap(column, row);
    return {map.chart, map.s_backwards ? to.width - 1 - column : column, map.t_backwards ? to.height - 1 - row : row};
}

TexelPlace MirrorImages::first_of(const TexelPlace& texel) const {
    const auto order = [](const TexelPlace& place) { return std::tuple(place.chart, place.row, place.column); };
    TexelPlace first = texel;
    for (const Mirror& mirror : mirrors_)
        first = std::min(first, image(mirror, texel),
                         [&](const TexelPlace& a, const TexelPlace& b) { return order(a) < order(b); });
    return first;
}

std::size_t MirrorImages::count_of(const TexelPlace& texel) const {
    // The images form an orbit; each of its members occurs equally often.
    std::size_t itself = 1;
    for (const Mirror& mirror : mirrors_)
        if (image(mirror, texel) == texel) ++itself;
    return (mirrors_.size() + 1) / itself;
}

} // namespace gonio
