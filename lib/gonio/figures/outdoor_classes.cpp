#include <gonio/figures/outdoor_classes.hpp>
#include <gonio/light/projected_area.hpp>
#include <gonio/web/web_rows.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace gonio {

namespace {

using Limits = std::array<double, 5>; // of the ratings 0 to 4

constexpr Limits back_low_and_high{110, 500, 1000, 2500, 5000};
constexpr Limits back_medium{220, 1000, 2500, 5000, 8500};
constexpr Limits up{0, 10, 50, 500, 1000};
constexpr Limits very_high{10, 100, 225, 500, 750};
constexpr Limits front_high{660, 1800, 5000, 7500, 12000}; // for type V to the back too

// Sums of zones have rounding errors: no light is no more than this.
constexpr double nothing_lm = 1e-6;

int rating_of(Lumens lumens, const Limits& limits) {
    const auto* const found =
        std::find_if(limits.begin(), limits.end(), [&](double limit) { return lumens.value <= limit + nothing_lm; });
    return static_cast<int>(found - limits.begin());
}

} // namespace

std::string to_text(const BugRating& rating, bool type_v) {
    return fmt::format("B{} U{} G{}", rating.backlight, rating.uplight, type_v ? rating.glare_type_v : rating.glare);
}

BugRating bug_rating(const LuminaireClassification& classes) {
    enum { low, medium, high, very };
    BugRating rating;
    rating.backlight =
        std::max({rating_of(classes.back[high], back_low_and_high), rating_of(classes.back[low], back_low_and_high),
                  rating_of(classes.back[medium], back_medium)});
    rating.uplight = std::max(rating_of(classes.up_low, up), rating_of(classes.up_high, up));
    const int front = std::max({rating_of(classes.front[very], very_high), rating_of(classes.back[very], very_high),
                                rating_of(classes.front[high], front_high)});
    rating.glare = std::max(front, rating_of(classes.back[high], back_low_and_high));
    rating.glare_type_v = std::max(front, rating_of(classes.back[high], front_high));
    return rating;
}

const char* to_text(CutOff cut_off) {
    switch (cut_off) {
    case CutOff::full_cutoff:
        return "full cutoff";
    case CutOff::cutoff:
        return "cutoff";
    case CutOff::semi_cutoff:
        return "semi-cutoff";
    case CutOff::non_cutoff:
        break;
    }
    return "non-cutoff";
}

HighAngles high_angles(const Web& web) {
    HighAngles high;
    const auto take = [&](double gamma_deg, double candela) {
        const auto raise = [candela](double& greatest) { greatest = std::max(greatest, candela); };
        if (gamma_deg >= 70.0) raise(high.from_70_cd);
        if (gamma_deg >= 80.0) raise(high.from_80_cd);
        if (gamma_deg >= 90.0) raise(high.from_90_cd);
        if (gamma_deg > 90.0) raise(high.above_90_cd);
        if (gamma_deg > 95.0) raise(high.above_95_cd);
    };
    constexpr double beyond = 1e-6;
    if (web.photometry() == Photometry::c) {
        // The interpolant is greatest at a point of the grid or at a limit itself.
        for (std::size_t plane = 0; plane < web.planes_deg().size(); ++plane) {
            for (const double gamma_deg : {70.0, 80.0, 90.0, 90.0 + beyond, 95.0 + beyond})
                take(gamma_deg, web.candela(web.planes_deg()[plane], gamma_deg));
            for (std::size_t j = 0; j < web.gammas_deg().size(); ++j)
                take(web.gammas_deg()[j], web.column(plane)[j]);
        }
        return high;
    }
    std::vector<double> gammas_deg;
    for (int gamma_deg = 70; gamma_deg <= 180; ++gamma_deg)
        gammas_deg.push_back(gamma_deg);
    web_detail::WebRows rows(web, gammas_deg);
    for (int c_deg = 0; c_deg < 360; c_deg += 2) {
        const std::span<const double> row = rows.quick(c_deg);
        for (std::size_t j = 0; j < row.size(); ++j)
            take(gammas_deg[j], row[j]);
    }
    return high;
}

CutOff cut_off(const HighAngles& high, Lumens lamps) {
    const double from_90 = 1000.0 * high.from_90_cd / lamps.value;
    const double from_80 = 1000.0 * high.from_80_cd / lamps.value;
    constexpr double rounding = 1e-9;
    if (from_90 <= rounding && from_80 <= 100.0) return CutOff::full_cutoff;
    if (from_90 <= 25.0 && from_80 <= 100.0) return CutOff::cutoff;
    return from_90 <= 50.0 && from_80 <= 200.0 ? CutOff::semi_cutoff : CutOff::non_cutoff;
}

int luminous_intensity_class(const HighAngles& high, Lumens lumens) {
    struct Class {
        double from_70;
        double from_80;
        double from_90;
        double HighAngles::*dark; // nullptr: nothing has to be dark
    };
    constexpr double any = std::numeric_limits<double>::infinity();
    constexpr std::array classes{Class{any, 200, 50, nullptr},
                                 Class{any, 150, 30, nullptr},
                                 Class{any, 100, 20, nullptr},
                                 Class{500, 100, 10, &HighAngles::above_95_cd},
                                 Class{350, 100, 10, &HighAngles::above_95_cd},
                                 Class{350, 100, 0, &HighAngles::above_90_cd}};
    constexpr double nothing = 1.0;
    const auto per_klm = [&](double candela) { return 1000.0 * candela / lumens.value; };
    for (std::size_t i = classes.size(); i-- > 0;) {
        const Class& limits = classes.at(i);
        if (per_klm(high.from_70_cd) <= limits.from_70 && per_klm(high.from_80_cd) <= limits.from_80 &&
            per_klm(high.from_90_cd) <= std::max(limits.from_90, nothing) &&
            (limits.dark == nullptr || per_klm(high.*limits.dark) <= nothing))
            return static_cast<int>(i) + 1;
    }
    return 0;
}

Figure<GlareIndex> glare_index(const Web& web, const Opening& opening) {
    if (opening.shape == OpeningShape::point) return no_figure("the file states no luminous opening");
    GlareIndex index;
    for (double c_deg = 0.0; c_deg < 360.0; c_deg += 2.5) {
        const double area_m2 = projected_area_m2(opening, direction_of({degrees(c_deg), degrees(85.0)}));
        const double intensity_cd = std::max(web.candela(c_deg, 85.0), 0.0);
        if (intensity_cd == 0.0) continue;
        if (!(area_m2 > 0.0))
            return no_figure(fmt::format("the luminous opening has no area towards C {}°, gamma 85°, where the "
                                         "luminaire shines",
                                         c_deg));
        index.cd_per_m = std::max(index.cd_per_m, intensity_cd / std::sqrt(area_m2));
    }
    constexpr std::array<double, 6> limits{7000, 5500, 4000, 2000, 1000, 500};
    for (const double limit : limits)
        if (index.cd_per_m <= limit) ++index.glare_index_class;
    return index;
}

char distribution_class(double downward_share) {
    constexpr double rounding = 1e-9;
    constexpr std::array limits{0.9, 0.6, 0.4, 0.1};
    char letter = 'A';
    for (const double limit : limits)
        if (downward_share < limit - rounding) ++letter;
    return letter;
}

} // namespace gonio
