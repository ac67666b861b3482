#include <gonio/sky/solar_position.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace gonio {
namespace {

Instant at(const std::string& text) {
    const Result<Instant> time = parse_time(text);
    EXPECT_TRUE(time) << text;
    return time.value_or(Instant());
}

double apart_deg(const SkyAngles& a, const SkyAngles& b) {
    const double chord = glm::length(direction_of(a) - direction_of(b));
    return to_degrees(Radians(2.0 * std::asin(0.5 * chord)));
}

// Positions of PyEphem 4.1 (VSOP87), geometric: zenith angle and azimuth.
struct Almanac {
    const char* time;
    Place place;
    double zenith_deg;
    double azimuth_deg;
};
constexpr Almanac almanac[] = {
    {"2003-10-17T19:30:30Z", {39.742476, -105.1786}, 50.12795, 194.34023},
    {"2024-06-20T11:00Z", {52.52, 13.405}, 29.1243, 176.1917},
    {"2025-12-21T09:30Z", {59.3293, 18.0686}, 84.2348, 162.5612},
    {"2026-03-20T03:15Z", {35.6762, 139.6503}, 36.3770, 191.0282},
    {"2030-01-15T01:00Z", {-33.8688, 151.2093}, 19.0846, 52.3113},
    {"2023-09-01T18:45Z", {-0.1807, -78.4678}, 24.1924, 290.7100},
    {"2000-01-01T12:00Z", {51.4769, 0.0}, 74.5152, 179.2156},
};

TEST(SolarPosition, IsThatOfTheAlmanac) {
    for (const Almanac& row : almanac)
        EXPECT_LT(apart_deg(solar_position(row.place, at(row.time)), {row.azimuth_deg, 90.0 - row.zenith_deg}), 0.0045)
            << row.time;
}

// I. Reda and A. Andreas, Solar Position Algorithm for Solar Radiation Applications (NREL 2003, revised 2008), table
// A5.1: topocentric, with refraction at 820 hPa and 11 °C.
TEST(SolarPosition, IsThatOfNrelWithRefraction) {
    const SkyAngles sun =
        apparent_solar_position({39.742476, -105.1786}, at("2003-10-17T12:30:30-07:00"), {820.0, 11.0});
    EXPECT_LT(apart_deg(sun, {194.34024, 90.0 - 50.11162}), 0.001);
}

TEST(SolarPosition, RefractionFollowsSaemundsson) {
    EXPECT_NEAR(refraction_deg(0.0), 0.483, 5e-4);
    EXPECT_NEAR(refraction_deg(5.0), 0.161, 5e-4);
    EXPECT_NEAR(refraction_deg(90.0), 0.0, 1e-4);
    EXPECT_GE(refraction_deg(90.0), 0.0);
    EXPECT_EQ(refraction_deg(-1.5), 0.0);
    EXPECT_NEAR(refraction_deg(10.0, {505.0, 10.0}), 0.5 * refraction_deg(10.0), 1e-15);
}

// At the poles the sun's elevation is its declination at every hour, and a quarter of a day turns it by 90°.
TEST(SolarPosition, CirclesThePoles) {
    for (const double latitude_deg : {90.0, -90.0}) {
        const SkyAngles first = solar_position({latitude_deg, 0.0}, at("2024-06-20T06:00Z"));
        const SkyAngles later = solar_position({latitude_deg, 0.0}, at("2024-06-20T12:00Z"));
        EXPECT_NEAR(std::abs(first.elevation_deg), 23.44, 0.01);
        EXPECT_NEAR(first.elevation_deg, later.elevation_deg, 0.002);
        const double turn = std::remainder(later.azimuth_deg - first.azimuth_deg, 360.0);
        EXPECT_NEAR(turn, latitude_deg > 0.0 ? 90.0 : -90.0, 0.02); // and its path
    }
}

// Fifteen degrees to the east are an hour earlier, but for the hour's motion of the sun along its orbit.
TEST(SolarPosition, FollowsTheLongitude) {
    const SkyAngles here = solar_position({40.0, 0.0}, at("2024-06-20T12:00Z"));
    const SkyAngles east = solar_position({40.0, 15.0}, at("2024-06-20T11:00Z"));
    EXPECT_LT(apart_deg(here, east), 0.005);
}

TEST(SolarPosition, TimesAreRead) {
    EXPECT_EQ(at("2000-01-01T12:00Z").days_since_j2000, 0.0);
    EXPECT_EQ(at("2000-01-01T14:00+02:00").days_since_j2000, 0.0);
    EXPECT_EQ(at("2000-01-01T06:30-05:30").days_since_j2000, 0.0);
    EXPECT_EQ(at("2000-01-02T00:00:00Z").days_since_j2000, 0.5);
    EXPECT_NEAR(at("2000-01-01T12:00:43.2Z").days_since_j2000, 43.2 / 86400.0, 1e-15);
    EXPECT_EQ(at("1999-12-31T12:00Z").days_since_j2000, -1.0);
    EXPECT_EQ(at("2024-02-29T00:00Z").day_of_year(), 60);
    EXPECT_EQ(at("2024-12-31T23:59Z").day_of_year(), 366);
    EXPECT_EQ(at("1999-01-01T00:00Z").day_of_year(), 1);
    for (const char* bad : {"",
                            "2024-06-21",
                            "2024-06-21T12:00",
                            "2024-06-21 12:00Z",
                            "2024-6-21T12:00Z",
                            "2024-06-21T12:00z",
                            "2024-06-21T12Z",
                            "2024-06-21T12:00+2",
                            "2024-06-21T12:00+0200",
                            "2024-06-21T12:00+15:00",
                            "2024-02-30T12:00Z",
                            "2023-02-29T12:00Z",
                            "2024-13-01T12:00Z",
                            "2024-06-21T24:00Z",
                            "2024-06-21T12:60Z",
                            "2024-06-21T12:00:60Z",
                            "2024-06-21T12:00:5Z",
                            "2024-06-21T12:00:05.Z",
                            "2024-06-21T12:00:.5Z",
                            "1949-12-31T12:00Z",
                            "2101-01-01T12:00Z",
                            "2024-06-21T12:00Z ",
                            "-024-06-21T12:00Z"})
        EXPECT_FALSE(parse_time(bad)) << bad;
    const Result<Instant> without_zone = parse_time("2024-06-21T12:00");
    EXPECT_EQ(without_zone.error().diagnostics.back().hint,
              "add Z for universal time, or the zone: 2024-06-21T12:00+02:00");
}

TEST(SolarPosition, PlacesAreRead) {
    const Place berlin = parse_place("52.52/13.405").value();
    EXPECT_EQ(berlin.latitude_deg, 52.52);
    EXPECT_EQ(berlin.longitude_deg, 13.405);
    EXPECT_EQ(parse_place("-33.5deg/151deg").value().latitude_deg, -33.5);
    EXPECT_NEAR(parse_place("0.5rad/0").value().latitude_deg, 90.0 / std::numbers::pi, 1e-12);
    for (const char* bad : {"", "/", "52", "52/", "/13", "91/0", "0/181", "1/2/3", "52,13", "nan/0", "1m/2m"})
        EXPECT_FALSE(parse_place(bad)) << bad;
}

TEST(SkyDirection, AnglesComeBack) {
    EXPECT_LT(glm::length(direction_of({0.0, 0.0}) - glm::dvec3(0, 1, 0)), 1e-15);
    EXPECT_LT(glm::length(direction_of({90.0, 0.0}) - glm::dvec3(1, 0, 0)), 1e-15);
    EXPECT_LT(glm::length(direction_of({180.0, 90.0}) - glm::dvec3(0, 0, 1)), 1e-15);
    for (double azimuth_deg = 0.0; azimuth_deg < 360.0; azimuth_deg += 22.5)
        for (double elevation_deg = -85.0; elevation_deg < 90.0; elevation_deg += 17.0) {
            const SkyAngles angles = sky_angles_of(3.0 * direction_of({azimuth_deg, elevation_deg}));
            EXPECT_NEAR(angles.azimuth_deg, azimuth_deg, 1e-12);
            EXPECT_NEAR(angles.elevation_deg, elevation_deg, 1e-12);
            const SkyAngles turn = sky_angles_of(turned(direction_of({azimuth_deg, elevation_deg}), degrees(30.0)));
            EXPECT_NEAR(std::remainder(turn.azimuth_deg - azimuth_deg - 30.0, 360.0), 0.0, 1e-12);
        }
    EXPECT_EQ(sky_angles_of({0.0, 0.0, 2.0}).azimuth_deg, 0.0);
    EXPECT_EQ(sky_angles_of({-1e-300, 1.0, 0.0}).azimuth_deg, 0.0); // not 360
}

} // namespace
} // namespace gonio
