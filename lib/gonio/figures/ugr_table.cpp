#include <gonio/figures/position_index.hpp>
#include <gonio/figures/ugr_table.hpp>
#include <gonio/figures/web_means.hpp>
#include <gonio/light/projected_area.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
        const MeanIntensity mean(web);
        for (std::size_t i = 0; i < zones_lm_.size(); ++i) {
            const double gamma_deg = 10.0 * static_cast<double>(i) + 5.0;
            zones_lm_[i] = 2.0 * pi * std::sin(gamma_deg / degrees_per_radian) * (pi / 18.0) * mean.candela(gamma_deg);
        }
    }

    FirstFall first_fall(const UgrRoom& room) const {
        const auto up_to = [&](std::size_t zones, double of_next) {
            double sum = of_next * zones_lm_[zones];
            for (std::size_t i = 0; i < zones; ++i)
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
    std::array<double, 18> zones_lm_{};
};

// Luminance of the walls, where each of the room's luminaires has these lumens.
double background_nt(const UgrRoom& room, const RoomReflectances& reflectances, const FirstFall& first,
                     double spacing) {
    const FluxTransfer transfer = flux_transfer(room.across, room.along, reflectances);
    const double reflected_lm = first.floor_lm * transfer.walls_from.floor +
                                first.walls_lm * (transfer.walls_from.walls - 1.0) +
                                first.ceiling_lm * transfer.walls_from.ceiling;
    const double count = room.across * room.along / (spacing * spacing);
    const double area = 2.0 * (room.across + room.along);
    return std::max(reflected_lm, 0.0) * count / (pi * area);
}

// What the quarter of the web from crosswise to endwise shows: intensities over areas.
class Glare {
public:
    Glare(const Web& web, const Opening& opening, const UgrOptions& options)
        : web_(web), opening_(opening), first_c_deg_(options.crosswise_c_deg) {
        if (options.interpolation == UgrInterpolation::luminance) luminances_ = luminances_of(web, opening);
    }

    // L²A [cd²/m²] towards C from crosswise and γ; none if light comes from no area.
    std::optional<double> operator()(double from_crosswise_deg, double gamma_deg) const {
        const double c_deg = first_c_deg_ + from_crosswise_deg;
        const double area_m2 = area(c_deg, gamma_deg);
        const double value =
            std::max(luminances_ ? luminances_->candela(c_deg, gamma_deg) : web_.candela(c_deg, gamma_deg), 0.0);
        if (value == 0.0) return 0.0;
        if (!(area_m2 > 0.0)) return std::nullopt;
        return luminances_ ? value * value * area_m2 : value * value / area_m2;
    }

private:
    double area(double c_deg, double gamma_deg) const {
        return projected_area_m2(opening_, direction_of({degrees(c_deg), degrees(gamma_deg)}));
    }

    // A web of luminances at the measured directions, of a round light also every 15° of C. Where an opening shows no
    // area, as a flat one at the horizon, it is as bright as at the γ before.
    std::optional<Web> luminances_of(const Web& web, const Opening& opening) const {
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
                const double area_m2 = area(planes_deg[plane], web.gammas_deg()[j]);
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
    std::optional<Web> luminances_;
};

// Σ L²ω/p² of the rooms' luminaires for one direction of view. All rooms have their luminaires on one lattice, so the
// sum of a room is that of a rectangle of it.
class GlareSums {
public:
    // `endwise`: seen along the luminaire.
    static Figure<GlareSums> of(const Glare& glare, double spacing, bool endwise) {
        GlareSums sums(spacing);
        for (std::size_t i = 0; i < sums.columns_; ++i) {
            double column = 0.0;
            for (std::size_t j = 0; j < sums.rows_; ++j) {
                const double t = (static_cast<double>(i) + 0.5) * spacing;
                const double r = (static_cast<double>(j) + 0.5) * spacing;
                if (const std::optional<double> index = table_position_index(t / r, 1.0 / r)) {
                    const double aside_deg = std::atan2(t, r) * degrees_per_radian;
                    const double c_deg = endwise ? 90.0 - aside_deg : aside_deg;
                    const double gamma_deg = std::atan(std::hypot(r, t)) * degrees_per_radian;
                    const std::optional<double> bright = glare(c_deg, gamma_deg);
                    if (!bright)
                        return no_figure(fmt::format("the luminous opening has no area towards gamma {:.1f}°, where "
                                                     "the luminaire shines",
                                                     gamma_deg));
                    column += *bright / ((r * r + t * t + 1.0) * *index * *index);
                }
                sums.until_[i * sums.rows_ + j] = column + (i > 0 ? sums.until_[(i - 1) * sums.rows_ + j] : 0.0);
            }
        }
        return sums;
    }

    // Of both halves of the room.
    double operator()(const UgrRoom& room) const {
        const auto half = static_cast<std::size_t>(std::lround(0.5 * room.across / spacing_));
        const auto along = static_cast<std::size_t>(std::lround(room.along / spacing_));
        return 2.0 * until_[(half - 1) * rows_ + along - 1];
    }

private:
    explicit GlareSums(double spacing)
        : spacing_(spacing),
          columns_(static_cast<std::size_t>(std::lround(6.0 / spacing))),
          rows_(static_cast<std::size_t>(std::lround(12.0 / spacing))),
          until_(columns_ * rows_) {}

    double spacing_;
    std::size_t columns_; // of the half room of 12 H
    std::size_t rows_;
    std::vector<double> until_;
};

} // namespace

Figure<UgrTable> ugr_table(const Web& web, const Opening& opening, const UgrOptions& options) {
    if (!(options.spacing > 0.0 && std::round(1.0 / options.spacing) * options.spacing == 1.0))
        return no_figure("the spacing of the luminaires does not divide the rooms");
    if (opening.shape == OpeningShape::point) return no_figure("the file states no luminous opening");
    const Glare glare(web, opening, options);
    const ZonalFlux flux(web);
    UgrTable table{};
    bool is_seen = false;
    std::array<std::array<double, ugr_reflectances.size()>, ugr_rooms.size()> backgrounds_nt{};
    for (const bool endwise : {false, true}) {
        const Figure<GlareSums> sums = GlareSums::of(glare, options.spacing, endwise);
        if (!sums) return tl::unexpected(sums.error());
        for (std::size_t row = 0; row < ugr_rooms.size(); ++row) {
            const FirstFall first = flux.first_fall(ugr_rooms[row]);
            const double glare_sum = (*sums)(ugr_rooms[row]);
            for (std::size_t column = 0; column < ugr_reflectances.size(); ++column) {
                double& background = backgrounds_nt[row][column]; // whichever way the room is seen
                if (!endwise)
                    background = background_nt(ugr_rooms[row], ugr_reflectances[column], first, options.spacing);
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

double ugr_background_nt(const Web& web, std::size_t row, std::size_t column, double spacing) {
    return background_nt(ugr_rooms[row], ugr_reflectances[column], ZonalFlux(web).first_fall(ugr_rooms[row]), spacing);
}

} // namespace gonio
