#include <gonio/sky/daylight_availability.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace gonio {
namespace {

struct Row {
    double elevation_deg;
    double sun_clear_klx;
    double sun_partly_klx;
    double sky_clear_klx;
    double sky_partly_klx;
    double sky_overcast_klx;
};
constexpr Row rows[] = {
    {10.0, 38.045, 1.273, 7.259, 8.114, 3.947},
    {30.0, 83.773, 25.742, 11.760, 22.800, 10.800},
    {60.0, 100.046, 50.620, 15.224, 39.271, 18.487},
};

TEST(DaylightAvailability, IsTheModelsTable) {
    constexpr int day = 100;
    // The table has the mean distance of the sun.
    const double distance = extraterrestrial(day).value / 127.5e3;
    for (const Row& row : rows) {
        const auto clear = daylight_availability(row.elevation_deg, day, Weather::clear);
        const auto partly = daylight_availability(row.elevation_deg, day, Weather::partly);
        const auto overcast = daylight_availability(row.elevation_deg, day, Weather::overcast);
        EXPECT_NEAR(clear.sun.value / distance, 1e3 * row.sun_clear_klx, 0.6);
        EXPECT_NEAR(partly.sun.value / distance, 1e3 * row.sun_partly_klx, 0.6);
        EXPECT_EQ(overcast.sun.value, 0.0);
        EXPECT_NEAR(clear.sky.value, 1e3 * row.sky_clear_klx, 0.6);
        EXPECT_NEAR(partly.sky.value, 1e3 * row.sky_partly_klx, 0.6);
        EXPECT_NEAR(overcast.sky.value, 1e3 * row.sky_overcast_klx, 0.6);
    }
}

// The half-skies of 1984, doubled.
TEST(DaylightAvailability, IsNearTheHalfSkies) {
    for (const double elevation_deg : {10.0, 30.0, 60.0, 90.0}) {
        const double sine = std::sin(degrees(elevation_deg).value);
        const double limit = elevation_deg < 20.0 ? 0.065 : 0.03;
        const auto sky = [&](Weather weather) { return daylight_availability(elevation_deg, 1, weather).sky.value; };
        EXPECT_NEAR(sky(Weather::clear) / (16.4e3 * std::sqrt(sine)), 1.0, limit);
        EXPECT_NEAR(sky(Weather::partly) / (45.4e3 * sine), 1.0, limit);
        EXPECT_NEAR(sky(Weather::overcast) / (21.4e3 * sine), 1.0, limit);
    }
}

TEST(DaylightAvailability, FollowsTheDistanceOfTheSun) {
    EXPECT_NEAR(extraterrestrial(2).value, 1.034 * 127.5e3, 1e-6);
    EXPECT_NEAR(extraterrestrial(2).value / extraterrestrial(184).value, 1.034 / 0.966, 1e-4);
}

TEST(DaylightAvailability, IsDarkAtNight) {
    for (const Weather weather : {Weather::clear, Weather::partly, Weather::overcast})
        for (const double elevation_deg : {0.0, -3.0, -90.0, std::nan("")}) {
            EXPECT_EQ(daylight_availability(elevation_deg, 1, weather).sun.value, 0.0);
            EXPECT_EQ(daylight_availability(elevation_deg, 1, weather).sky.value, 0.0);
        }
    EXPECT_EQ(daylight_availability(1e-300, 1, Weather::clear).sun.value, 0.0); // no NaN
    EXPECT_EQ(parse_weather("partly").value(), Weather::partly);
    EXPECT_FALSE(parse_weather("cloudy"));
}

} // namespace
} // namespace gonio
