#include <gonio/base/named.hpp>
#include <gonio/sky/daylight_availability.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace gonio {

namespace {

constexpr std::array rows{
    WeatherRow{"clear", Weather::clear, "clear sky with the sun", 0.21, true, 0.8, 15.5, 0.5, "12"},
    WeatherRow{"partly", Weather::partly, "partly cloudy with a veiled sun", 0.80, true, 0.3, 45.0, 1.0, "7"},
    WeatherRow{"overcast", Weather::overcast, "overcast, the sun hidden", 0.0, false, 0.3, 21.0, 1.0, "1"},
};
static_assert(in_enum_order(rows, &WeatherRow::weather, Weather::overcast));

constexpr double lux_per_klx = 1000.0;
constexpr Lux solar_constant{127.5 * lux_per_klx}; // the extinctions were fitted with it

} // namespace

std::span<const WeatherRow> weathers() {
    return rows;
}

const WeatherRow& info_of(Weather weather) {
    return rows.at(static_cast<std::size_t>(weather));
}

Result<Weather> parse_weather(std::string_view text) {
    return find_named("weather", text, rows).map([](const auto* row) { return row->weather; });
}

Lux extraterrestrial(int day_of_year) {
    return solar_constant * (1.0 + 0.034 * std::cos(2.0 * std::numbers::pi * (day_of_year - 2) / 365.0));
}

DaylightAvailability daylight_availability(double elevation_deg, int day_of_year, Weather weather) {
    if (!(elevation_deg > 0.0)) return {};
    const WeatherRow& row = info_of(weather);
    const double sine = std::sin(degrees(elevation_deg).value);
    const Lux sun = row.shows_sun ? extraterrestrial(day_of_year) * std::exp(-row.extinction / sine) : Lux();
    return {sun, Lux(lux_per_klx * (row.at_horizon_klx + row.by_sine_klx * std::pow(sine, row.exponent)))};
}

} // namespace gonio
