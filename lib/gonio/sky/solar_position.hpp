// Where the sun stands, by place and time.
//
// J. Meeus, Astronomical Algorithms (2nd edition 1998, chapters 12, 13, 22 and 25: low precision), with the five terms
// for Venus, Jupiter, the Moon and one of long period of his Astronomical Formulae for Calculators (1979, chapter 18).
// The direction is within 0.005° of the theory VSOP87 from 1950 to 2100. Only a failure to read a text allocates.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/sky/sky_direction.hpp>

#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// A place on the earth.
struct Place {
    double latitude_deg = 0.0;  // [−90, 90], north is positive
    double longitude_deg = 0.0; // [−180, 180], east is positive
};

// "52.52/13.405": latitude and longitude in degrees, with or without the unit. Fails (usage) outside the ranges above.
Result<Place> parse_place(std::string_view text);

// A moment of universal time.
struct Instant {
    double days_since_j2000 = 0.0; // days of 86400 s since 2000-01-01 12:00 UT

    // Of the year, from 1 to 366, in universal time.
    int day_of_year() const;
};

// The years for which the position of the sun is computed.
inline constexpr int first_solar_year = 1950;
inline constexpr int last_solar_year = 2100;

// ISO 8601: "2024-06-21T12:00+02:00", "2024-06-21T10:00:30.5Z". Seconds may be left out, the zone may not. Fails
// (usage) on anything else, on dates and times that do not exist, and on years outside 1950 to 2100.
Result<Instant> parse_time(std::string_view text);

// The air between the sun and the observer, for its refraction.
struct Air {
    double pressure_hpa = 1010.0;
    double temperature_c = 10.0;
};

// The centre of the sun as seen from the place: geometric, as if there were no air. The elevation includes the parallax
// of an observer on the surface.
SkyAngles solar_position(const Place& place, Instant at);

// By how much the air lifts a geometric elevation [°]: T. Saemundsson (1986), as in Meeus, chapter 16. 0 below −1°,
// where nothing of the sun is above the horizon.
double refraction_deg(double elevation_deg, const Air& air = {});

// The position with refraction.
SkyAngles apparent_solar_position(const Place& place, Instant at, const Air& air = {});

} // namespace gonio
#pragma GCC visibility pop
