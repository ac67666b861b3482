#include <gonio/light/light_color.hpp>
#include <gonio/sky/detail/sphere_quadrature.hpp>
#include <gonio/sky/sky_measures.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr glm::dvec3 up{0.0, 0.0, 1.0};

double luminance(const glm::dvec3& rgb) {
    return glm::dot(rgb, rec709_luminance);
}

// The brightest of a ring of neighbours, closer and closer. The first guess comes from a grid of 1°: CIE skies have
// their maximum at the sun, at the zenith or at the horizon, and no second one as narrow as the grid.
glm::dvec3 brightest_direction(const CieSky& sky) {
    glm::dvec3 best = sky.axis();
    double most = sky.relative(best);
    const auto consider = [&](const glm::dvec3& direction) {
        if (direction.z < 0.0 || !(sky.relative(direction) > most)) return false;
        best = direction;
        most = sky.relative(direction);
        return true;
    };
    consider(up);
    for (int elevation_deg = 0; elevation_deg < 90; ++elevation_deg)
        for (int azimuth_deg = 0; azimuth_deg < 360; ++azimuth_deg)
            consider(direction_of({static_cast<double>(azimuth_deg), static_cast<double>(elevation_deg)}));
    for (double step_deg = 0.5; step_deg > 1e-6; step_deg *= 0.5)
        for (bool moved = true; moved;) {
            moved = false;
            const SkyAngles at = sky_angles_of(best);
            for (const SkyAngles& shift : {SkyAngles{step_deg, 0.0}, SkyAngles{-step_deg, 0.0},
                                           SkyAngles{0.0, step_deg}, SkyAngles{0.0, -step_deg}})
                moved = consider(direction_of({at.azimuth_deg + shift.azimuth_deg,
                                               std::clamp(at.elevation_deg + shift.elevation_deg, 0.0, 90.0)})) ||
                        moved;
        }
    return best;
}

// ∫ L dω over a cap, by midpoints of rings about its middle.
double light_of_cap(const Sky& sky, const glm::dvec3& middle, double radius) {
    constexpr int rings = 64;
    constexpr int sectors = 256;
    const auto [e, f] = detail::perpendicular(middle);
    double sum = 0.0;
    for (int i = 0; i < rings; ++i) {
        const double from = std::cos(radius * i / rings);
        const double to = std::cos(radius * (i + 1) / rings);
        const double cosine = 0.5 * (from + to);
        const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
        for (int j = 0; j < sectors; ++j) {
            const double psi = 2.0 * pi * (j + 0.5) / sectors;
            sum +=
                luminance(sky.radiance(cosine * middle + sine * (std::cos(psi) * e + std::sin(psi) * f))) * (from - to);
        }
    }
    return sum * 2.0 * pi / sectors;
}

// The spot around a texel of an image that has `total` lx of light.
BrightestSpot spot_around(const EnvironmentMap& map, TexelIndex at, double total) {
    const glm::dvec3 middle = map.grid().direction({at.column + 0.5, at.row + 0.5});
    const double around = luminance(map.light_within(middle, degrees(spot_radius_deg)));
    return {middle, Nits(luminance(map.texel(at))), around / total};
}

} // namespace

std::optional<BrightestSpot> sun_like_spot(const EnvironmentMap& map, unsigned threads) {
    const double total = luminance(map.light(threads));
    const TexelIndex at = map.brightest();
    const double sine = std::sin(0.5 * degrees(spot_radius_deg).value);
    // A texel at the edge may reach out of the spot.
    const double widest = 4.0 * pi * sine * sine + 9.0 * map.grid().solid_angle(at);
    if (!(luminance(map.texel(at)) * widest >= sun_like_share * total) || !(total > 0.0)) return std::nullopt;
    BrightestSpot spot = spot_around(map, at, total);
    if (!(spot.share >= sun_like_share)) return std::nullopt;
    return spot;
}

SkyMeasures measure(const Sky& sky, unsigned threads) {
    SkyMeasures result;
    std::vector<glm::dvec3> normals{up};
    for (const double azimuth_deg : wall_azimuths_deg)
        normals.push_back(direction_of({azimuth_deg, 0.0}));
    const std::vector<glm::dvec3> lux = sky.irradiance(normals, threads);
    result.horizontal = Lux(luminance(lux.front()));
    for (std::size_t i = 0; i < wall_azimuths_deg.size(); ++i)
        result.vertical.at(i) = Lux(luminance(lux[i + 1]));
    result.mean = sky.mean(threads);
    result.zenith = sky.zenith();
    const glm::dvec3 all = sky.light(threads);
    const double total = luminance(all);
    if (total > 0.0) result.color = all / total;
    if (sky.image() && total > 0.0) {
        BrightestSpot spot = spot_around(*sky.image(), sky.image()->brightest(), total / sky.image_scale());
        spot.direction = turned(spot.direction, sky.rotation());
        spot.luminance = Nits(sky.image_scale() * spot.luminance.value);
        // Rounding of a uniform image is no spot.
        if (spot.luminance.value > (1.0 + 1e-6) * result.mean.value) result.spot = spot;
    }
    if (sky.cie()) {
        BrightestSpot spot;
        spot.direction = brightest_direction(*sky.cie());
        spot.luminance = Nits(luminance(sky.radiance(spot.direction)));
        if (total > 0.0) spot.share = light_of_cap(sky, spot.direction, degrees(spot_radius_deg).value) / total;
        // A sky without gradation is as bright everywhere.
        const bool varies =
            sky.cie()->relative(spot.direction) > 1.0 + 1e-12 || sky.cie()->relative({1.0, 0.0, 0.0}) < 1.0 - 1e-12;
        if (varies) result.spot = spot;
    }
    return result;
}

} // namespace gonio
