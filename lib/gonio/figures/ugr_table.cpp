#include <gonio/base/frame.hpp>
#include <gonio/figures/position_index.hpp>
#include <gonio/figures/ugr_table.hpp>
#include <gonio/figures/web_means.hpp>
#include <gonio/light/projected_area.hpp>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

namespace gonio {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double degrees_per_radian = 180.0 / pi;

// CIE 190: the share of the light that falls on the floor first is Σ aᵢ φᵢ, with the flux φᵢ within cones of 41.4°,
// 60°, 75.5° and 90° and weights that depend on the room index k = XY/(X + Y).
struct ConeWeights {
    double room_index;
    std::array<double, 4> thousandths;
};

constexpr std::array cone_weights{
    ConeWeights{1.00, {690, 109, 85, -16}},  ConeWeights{1.20, {578, 200, 127, -18}},
    ConeWeights{1.33, {528, 218, 170, -17}}, ConeWeights{1.50, {485, 215, 222, -12}},
    ConeWeights{1.60, {466, 207, 249, -6}},  ConeWeights{1.71, {448, 198, 272, 5}},
    ConeWeights{2.00, {338, 257, 351, -18}}, ConeWeights{2.40, {296, 203, 449, -6}},
    ConeWeights{2.67, {280, 165, 499, 6}},   ConeWeights{3.00, {264, 125, 541, 27}},
    ConeWeights{3.43, {248, 58, 628, 32}},   ConeWeights{4.00, {239, -12, 690, 58}},
    ConeWeights{4.80, {232, -84, 740, 98}},
};

const std::array<double, 4>& weights_of(const UgrRoom& room) {
    const double k = static_cast<double>(room.across * room.along) / (room.across + room.along);
    return std::min_element(cone_weights.begin(), cone_weights.end(),
                            [k](const ConeWeights& a, const ConeWeights& b) {
                                return std::abs(a.room_index - k) < std::abs(b.room_index - k);
                            })
        ->thousandths;
}

// Lumens that fall on floor, walls and ceiling first.
struct FirstFall {
    double floor_lm;
    double walls_lm;
    double ceiling_lm;
};

// CIE 190's zonal flux: in steps of 10°, the mean intensity at the middle of each.
class ZonalFlux {
public:
    explicit ZonalFlux(const Web& web) {
        std::array<double, zones> middles_deg;
        for (std::size_t i = 0; i < zones; ++i)
            middles_deg[i] = 10.0 * static_cast<double>(i) + 5.0;
        const std::vector<double> mean_cd = mean_candela(web, middles_deg);
        for (std::size_t i = 0; i < zones; ++i)
            zones_lm_[i] = 2.0 * pi * std::sin(middles_deg[i] / degrees_per_radian) * (pi / 18.0) * mean_cd[i];
    }

    FirstFall first_fall(const UgrRoom& room) const {
        const auto up_to = [&](std::size_t whole, double of_next) {
            double sum = of_next * zones_lm_[whole];
            for (std::size_t i = 0; i < whole; ++i)
                sum += zones_lm_[i];
            return sum;
        };
        const std::array cones{up_to(4, 0.130), up_to(6, 0.0), up_to(7, 0.547), up_to(9, 0.0)};
        const std::array<double, 4>& weights = weights_of(room);
        double floor_lm = 0.0;
        for (std::size_t i = 0; i < cones.size(); ++i)
            floor_lm += 1e-3 * weights[i] * cones[i];
        double ceiling_lm = 0.0;
        for (std::size_t i = 9; i < zones_lm_.size(); ++i)
            ceiling_lm += zones_lm_[i];
        return {floor_lm, cones[3] - floor_lm, ceiling_lm};
    }

private:
    static constexpr std::size_t zones = 18;
    std::array<double, zones> zones_lm_{};
};

// Luminance of the walls, where each of the room's luminaires has these lumens.
double background_nt(std::size_t row, std::size_t column, const FirstFall& first, double spacing) {
    static const auto transfers = flux_transfers<ugr_rooms.size()>(
        ugr_reflectances, [](std::size_t of) { return glm::dvec2(ugr_rooms[of].across, ugr_rooms[of].along); });
    const FluxTransfer::Sources& from = transfers[row][column].walls_from;
    const UgrRoom& room = ugr_rooms[row];
    const double reflected_lm =
        first.floor_lm * from.floor + first.walls_lm * (from.walls - 1.0) + first.ceiling_lm * from.ceiling;
    const double count = room.across * room.along / (spacing * spacing);
    const double area = 2.0 * (room.across + room.along);
    return std::max(reflected_lm, 0.0) * count / (pi * area);
}

// Where the luminaires of half of the largest room lie, as the eye sees them. All rooms have theirs on one lattice.
class Lattice {
public:
    struct Place {
        double aside_deg; // from the line of sight
        double gamma_deg;
        glm::dvec3 to_eye; // from the luminaire, seen crosswise along its X
        double weight;     // 1/(d²p²); 0 outside the table of p
    };

    explicit Lattice(double spacing)
        : spacing_(spacing),
          columns_(static_cast<std::size_t>(std::lround(6.0 / spacing))),
          rows_(static_cast<std::size_t>(std::lround(12.0 / spacing))) {
        for (std::size_t i = 0; i < columns_; ++i)
            for (std::size_t j = 0; j < rows_; ++j) {
                const double t = (static_cast<double>(i) + 0.5) * spacing;
                const double r = (static_cast<double>(j) + 0.5) * spacing;
                const std::optional<double> index = table_position_index(t / r, 1.0 / r);
                const double d = std::sqrt(r * r + t * t + 1.0);
                places_.push_back({std::atan2(t, r) * degrees_per_radian,
                                   std::atan(std::hypot(r, t)) * degrees_per_radian,
                                   {r / d, t / d, -1.0 / d},
                                   index ? 1.0 / (d * d * *index * *index) : 0.0});
            }
    }

    [[nodiscard]] double spacing() const { return spacing_; }
    [[nodiscard]] std::size_t columns() const { return columns_; } // across the line of sight
    [[nodiscard]] std::size_t rows() const { return rows_; }
    [[nodiscard]] const Place& at(std::size_t column, std::size_t row) const { return places_[column * rows_ + row]; }

private:
    double spacing_;
    std::size_t columns_;
    std::size_t rows_;
    std::vector<Place> places_;
};

// What the quarter of the web from crosswise to endwise shows: intensities over areas.
class Glare {
public:
    Glare(const Web& web, const Opening& opening, const UgrOptions& options)
        : web_(web),
          opening_(opening),
          first_c_deg_(options.crosswise_c_deg),
          x_(direction_of({degrees(first_c_deg_), degrees(90.0)})) {
        if (options.interpolation == UgrInterpolation::luminance) luminances_ = luminances_of(web, opening);
    }

    // L²A [cd²/m²] towards the eye; none if light comes from no area.
    std::optional<double> operator()(const Lattice::Place& place, bool endwise) const {
        const double c_deg = first_c_deg_ + (endwise ? 90.0 - place.aside_deg : place.aside_deg);
        const glm::dvec3& seen = place.to_eye;
        const glm::dvec3 to = endwise ? glm::dvec3(seen.y, seen.x, seen.z) : seen;
        const double area_m2 =
            projected_area_m2(opening_, {to.x * x_.x - to.y * x_.y, to.x * x_.y + to.y * x_.x, to.z});
        const Web& looked_up = luminances_ ? *luminances_ : web_;
        const double value = std::max(looked_up.candela(c_deg, place.gamma_deg), 0.0);
        if (value == 0.0) return 0.0;
        if (!(area_m2 > 0.0)) return std::nullopt;
        return luminances_ ? value * value * area_m2 : value * value / area_m2;
    }

private:
    // A web of luminances at the measured directions, of a round light also every 15° of C. Where an opening shows no
    // area, as a flat one at the horizon, it is as bright as at the γ before.
    static std::optional<Web> luminances_of(const Web& web, const Opening& opening) {
        if (web.photometry() != Photometry::c) return std::nullopt; // its directions are no C and γ
        const bool is_round = web.stored_symmetry() == Symmetry::axial;
        std::vector<double> planes_deg(web.planes_deg().begin(), web.planes_deg().end());
        if (is_round) {
            planes_deg.clear();
            for (int i = 0; i <= 24; ++i)
                planes_deg.push_back(15.0 * i);
        }
        std::vector<double> values;
        for (std::size_t plane = 0; plane < planes_deg.size(); ++plane) {
            double last = 0.0;
            for (std::size_t j = 0; j < web.gammas_deg().size(); ++j) {
                const double area_m2 = projected_area_m2(
                    opening, direction_of({degrees(planes_deg[plane]), degrees(web.gammas_deg()[j])}));
                if (area_m2 > 1e-9 * opening.largest_m() * opening.largest_m())
                    last = web.column(is_round ? 0 : plane)[j] / area_m2;
                values.push_back(last);
            }
        }
        Result<Web> made = Web::create(is_round ? Symmetry::none : web.stored_symmetry(), std::move(planes_deg),
                                       {web.gammas_deg().begin(), web.gammas_deg().end()}, std::move(values));
        return made ? std::optional(std::move(*made)) : std::nullopt;
    }

    const Web& web_;
    const Opening& opening_;
    double first_c_deg_;
    glm::dvec3 x_; // crosswise
    std::optional<Web> luminances_;
};

// Σ L²ω/p² of the rooms' luminaires for one direction of view: the sum of a room is that of a rectangle of the lattice.
class GlareSums {
public:
    // `endwise`: seen along the luminaire.
    static Figure<GlareSums> of(const Glare& glare, const Lattice& lattice, bool endwise) {
        GlareSums sums(lattice);
        for (std::size_t i = 0; i < lattice.columns(); ++i) {
            double column = 0.0;
            for (std::size_t j = 0; j < lattice.rows(); ++j) {
                const Lattice::Place& place = lattice.at(i, j);
                if (place.weight > 0.0) {
                    const std::optional<double> bright = glare(place, endwise);
                    if (!bright)
                        return no_figure(fmt::format("the luminous opening has no area towards gamma {:.1f}°, where "
                                                     "the luminaire shines",
                                                     place.gamma_deg));
                    column += *bright * place.weight;
                }
                sums.until_.push_back(column + (i > 0 ? sums.until_[(i - 1) * lattice.rows() + j] : 0.0));
            }
        }
        return sums;
    }

    // Of both halves of the room.
    double operator()(const UgrRoom& room) const {
        const auto half = static_cast<std::size_t>(std::lround(0.5 * room.across / lattice_.spacing()));
        const auto along = static_cast<std::size_t>(std::lround(room.along / lattice_.spacing()));
        return 2.0 * until_[(half - 1) * lattice_.rows() + along - 1];
    }

private:
    explicit GlareSums(const Lattice& lattice) : lattice_(lattice) {}

    const Lattice& lattice_;
    std::vector<double> until_; // [column][row]
};

Figure<UgrTable> table_of(const Web& web, const Opening& opening, const UgrOptions& options, const Lattice& lattice) {
    const Glare glare(web, opening, options);
    const ZonalFlux flux(web);
    UgrTable table{};
    bool is_seen = false;
    std::array<std::array<double, ugr_reflectances.size()>, ugr_rooms.size()> backgrounds_nt{};
    for (const bool endwise : {false, true}) {
        const Figure<GlareSums> sums = GlareSums::of(glare, lattice, endwise);
        if (!sums) return tl::unexpected(sums.error());
        for (std::size_t row = 0; row < ugr_rooms.size(); ++row) {
            const FirstFall first = flux.first_fall(ugr_rooms[row]);
            const double glare_sum = (*sums)(ugr_rooms[row]);
            for (std::size_t column = 0; column < ugr_reflectances.size(); ++column) {
                double& background = backgrounds_nt[row][column]; // whichever way the room is seen
                if (!endwise) background = background_nt(row, column, first, lattice.spacing());
                if (!(background > 0.0)) return no_figure("no light is reflected in the standard rooms");
                is_seen = is_seen || glare_sum > 0.0;
                table[row][column + (endwise ? ugr_reflectances.size() : 0)] =
                    8.0 * std::log10(0.25 / background * glare_sum);
            }
        }
    }
    if (!is_seen) return no_figure("no light reaches the eye in the standard rooms");
    return table;
}

} // namespace

Figure<UgrTable> ugr_table(const Web& web, const Opening& opening, const UgrOptions& options) {
    if (!(options.spacing > 0.0 && std::round(1.0 / options.spacing) * options.spacing == 1.0))
        return no_figure("the spacing of the luminaires does not divide the rooms");
    if (opening.shape == OpeningShape::point) return no_figure("the file states no luminous opening");
    static const Lattice standard(UgrOptions().spacing);
    if (options.spacing == UgrOptions().spacing) return table_of(web, opening, options, standard);
    return table_of(web, opening, options, Lattice(options.spacing));
}

double ugr_background_nt(const Web& web, std::size_t row, std::size_t column, double spacing) {
    return background_nt(row, column, ZonalFlux(web).first_fall(ugr_rooms[row]), spacing);
}

} // namespace gonio
