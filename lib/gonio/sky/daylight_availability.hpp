// How much light the sun and the sky give: the daylight availability model of the IES.
//
// Recommended Practice for the Calculation of Daylight Availability (IES RP-21, 1984; Gillette and Kusuda 1983,
// Pierpoint 1983), with one sine power for the whole sky. Direct light: E = E₀ exp(−c m) through m = 1/sin γs air
// masses, with E₀ = 127.5 klx (1 + 0.034 cos(2π (J − 2)/365)) on day J and c = 0.21 for a clear sky, 0.80 for a partly
// cloudy one; an overcast sky hides the sun. Sky on the horizontal: E = A + B sin^C γs klx. The 1984 half-skies,
// doubled, differ by 1 % at 60° and 6 % at 10°.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>

#include <cstdint>
#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// How cloudy it is.
enum class Weather : std::uint8_t { clear, partly, overcast };

// A row of the model.
struct WeatherRow {
    std::string_view name;
    Weather weather;
    std::string_view summary;
    double extinction; // c; unused if the sun is hidden
    bool shows_sun;
    double at_horizon_klx;     // A
    double by_sine_klx;        // B
    double exponent;           // C
    std::string_view cie_type; // the CIE sky whose distribution goes with it: gonio's choice, not the model's
};

// All rows, and the one of a weather.
std::span<const WeatherRow> weathers();
const WeatherRow& info_of(Weather weather);

// "clear", "partly", "overcast". Fails (usage) on other names.
Result<Weather> parse_weather(std::string_view text);

// The illuminance of sun and sky.
struct DaylightAvailability {
    Lux sun; // on a plane perpendicular to its direction
    Lux sky; // on an open horizontal plane, without the sun
};

// Outside the atmosphere on a plane perpendicular to the sun, on a day of the year from 1 to 366.
Lux extraterrestrial(int day_of_year);

// For a sun at an elevation in (0, 90]; 0 for both at or below the horizon, where the model does not apply.
DaylightAvailability daylight_availability(double elevation_deg, int day_of_year, Weather weather);

} // namespace gonio
#pragma GCC visibility pop
