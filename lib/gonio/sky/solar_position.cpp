#include <gonio/base/unit_text.hpp>
#include <gonio/sky/detail/angle_pair.hpp>
#include <gonio/sky/solar_position.hpp>

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>

namespace gonio {

namespace {

double sin_deg(double angle_deg) {
    return std::sin(degrees(angle_deg).value);
}
double cos_deg(double angle_deg) {
    return std::cos(degrees(angle_deg).value);
}

// Terrestrial time less universal time. It has been between 29 s and 70 s since 1950; 40 s move the sun by 0.0005°.
constexpr double delta_t_s = 69.0;
constexpr double seconds_per_day = 86400.0;
constexpr double days_per_century = 36525.0;

// A sine term of the sun's longitude: its phase grows with the centuries since 1900.
struct LongitudeTerm {
    double amplitude_deg;
    double phase_deg;
    double rate_deg;
};

// All of these as cosines but the last two.
constexpr std::array cosine_terms{LongitudeTerm{0.00134, 153.23, 22518.7541},
                                  LongitudeTerm{0.00154, 216.57, 45037.5082},
                                  LongitudeTerm{0.00200, 312.69, 32964.3577}};
constexpr std::array sine_terms{LongitudeTerm{0.00179, 350.74, 445267.1142}, LongitudeTerm{0.00178, 231.19, 20.20}};

Unexpected no_time(std::string_view text) {
    return fail("USE0105", fmt::format("'{}' is not a time", text),
                "write the date, the time and its zone as 2024-06-21T12:00+02:00 or 2024-06-21T10:00Z");
}

// Takes exactly `count` digits from the front; empty if there are other characters.
std::optional<int> take_digits(std::string_view& text, std::size_t count) {
    if (text.size() < count) return std::nullopt;
    int value = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const char c = text[i];
        if (c < '0' || c > '9') return std::nullopt;
        value = 10 * value + (c - '0');
    }
    text.remove_prefix(count);
    return value;
}

bool take(std::string_view& text, char c) {
    if (!text.starts_with(c)) return false;
    text.remove_prefix(1);
    return true;
}

// A written date and time of day. The members are not checked for their ranges.
struct WrittenTime {
    int year = 0;
    int month = 0;
    int day = 0;
    int hour = 0;
    int minute = 0;
    double second = 0.0;
    std::string_view zone; // what follows
};

std::optional<WrittenTime> read_date_and_time(std::string_view text) {
    WrittenTime at;
    const auto number = [&](int& to, std::size_t digits) {
        const std::optional<int> value = take_digits(text, digits);
        if (value) to = *value;
        return value.has_value();
    };
    if (!number(at.year, 4) || !take(text, '-') || !number(at.month, 2) || !take(text, '-') || !number(at.day, 2) ||
        !take(text, 'T') || !number(at.hour, 2) || !take(text, ':') || !number(at.minute, 2))
        return std::nullopt;
    if (take(text, ':')) {
        std::size_t length = 0;
        while (length < text.size() && ((text[length] >= '0' && text[length] <= '9') || text[length] == '.'))
            ++length;
        const std::string_view digits = text.substr(0, length);
        if (digits.size() < 2 || digits.substr(0, 2).find('.') != std::string_view::npos ||
            (digits.size() > 2 && (digits[2] != '.' || digits.size() == 3)))
            return std::nullopt;
        const std::optional<double> second = parse_number(digits);
        if (!second) return std::nullopt;
        at.second = *second;
        text.remove_prefix(length);
    }
    at.zone = text;
    return at;
}

// Minutes east of universal time; empty if the text is not a zone.
std::optional<int> read_zone(std::string_view text) {
    if (text == "Z") return 0;
    const bool west = text.starts_with('-');
    if (!take(text, '+') && !take(text, '-')) return std::nullopt;
    const std::optional<int> hours = take_digits(text, 2);
    if (!hours || !take(text, ':')) return std::nullopt;
    const std::optional<int> minutes = take_digits(text, 2);
    if (!minutes || !text.empty() || *hours > 14 || *minutes > 59) return std::nullopt;
    const int east = 60 * *hours + *minutes;
    return west ? -east : east;
}

constexpr std::chrono::sys_days j2000_day = std::chrono::sys_days{std::chrono::January / 1 / 2000};

} // namespace

Result<Place> parse_place(std::string_view text) {
    Result<detail::AnglePair> pair = detail::parse_angle_pair(text, "a place", "latitude/longitude", "52.52/13.405");
    if (!pair) return pass_on(pair);
    const Place place{pair->first_deg, pair->second_deg};
    if (!(std::abs(place.latitude_deg) <= 90.0))
        return fail(
            "USE0106",
            fmt::format("the latitude must lie between -90 and 90 degrees, not {}", shortest(place.latitude_deg)),
            "the latitude comes first, as in 52.52/13.405 for Berlin");
    if (!(std::abs(place.longitude_deg) <= 180.0))
        return fail(
            "USE0106",
            fmt::format("the longitude must lie between -180 and 180 degrees, not {}", shortest(place.longitude_deg)),
            "east is positive");
    return place;
}

int Instant::day_of_year() const {
    using namespace std::chrono;
    const sys_days day = j2000_day + days(static_cast<int>(std::floor(days_since_j2000 + 0.5)));
    const year_month_day date{day};
    return static_cast<int>((day - sys_days{date.year() / January / 1}).count()) + 1;
}

Result<Instant> parse_time(std::string_view text) {
    using namespace std::chrono;
    const std::optional<WrittenTime> at = read_date_and_time(text);
    if (!at) return no_time(text);
    if (at->zone.empty())
        return fail("USE0104", fmt::format("the time '{}' has no zone", text),
                    fmt::format("add Z for universal time, or the zone: {}+02:00", text));
    const std::optional<int> east_min = read_zone(at->zone);
    if (!east_min) return no_time(text);
    const year_month_day date{year(at->year), month(static_cast<unsigned>(at->month)),
                              day(static_cast<unsigned>(at->day))};
    if (!date.ok() || at->hour > 23 || at->minute > 59 || !(at->second < 60.0))
        return fail("USE0106", fmt::format("there is no such date or time of day: '{}'", text));
    if (at->year < first_solar_year || at->year > last_solar_year)
        return fail(
            "USE0106",
            fmt::format("the year must lie between {} and {}, not {}", first_solar_year, last_solar_year, at->year),
            "the formula of the sun's position is accurate in this time");
    const auto whole_days = static_cast<double>((sys_days{date} - j2000_day).count());
    const double minutes = 60.0 * (at->hour - 12) + at->minute - *east_min;
    return Instant{whole_days + (60.0 * minutes + at->second) / seconds_per_day};
}

SkyAngles solar_position(const Place& place, Instant at) {
    const double days = at.days_since_j2000;
    const double t = (days + delta_t_s / seconds_per_day) / days_per_century;
    const double mean_longitude = 280.46646 + 36000.76983 * t + 0.0003032 * t * t;
    const double anomaly = 357.52911 + 35999.05029 * t - 0.0001537 * t * t;
    const double center = (1.914602 - 0.004817 * t) * sin_deg(anomaly) +
                          (0.019993 - 0.000101 * t) * sin_deg(2.0 * anomaly) + 0.000289 * sin_deg(3.0 * anomaly);
    const double node = 125.04 - 1934.136 * t;
    double longitude = mean_longitude + center - 0.00569 - 0.00478 * sin_deg(node);
    const double since_1900 = t + 1.0;
    for (const LongitudeTerm& term : cosine_terms)
        longitude += term.amplitude_deg * cos_deg(term.phase_deg + term.rate_deg * since_1900);
    for (const LongitudeTerm& term : sine_terms)
        longitude += term.amplitude_deg * sin_deg(term.phase_deg + term.rate_deg * since_1900);
    const double obliquity = 23.4392911 - 0.0130042 * t + 0.00256 * cos_deg(node);

    const double right_ascension =
        to_degrees(Radians(std::atan2(cos_deg(obliquity) * sin_deg(longitude), cos_deg(longitude))));
    const double sin_declination = sin_deg(obliquity) * sin_deg(longitude);
    const double cos_declination = std::sqrt((1.0 - sin_declination) * (1.0 + sin_declination));
    const double hour_angle = 280.46061837 + 360.98564736629 * days - 0.00478 * sin_deg(node) * cos_deg(obliquity) +
                              place.longitude_deg - right_ascension;

    // East, north and up: also at the poles, where the quotients of textbooks are 0/0.
    const double sin_latitude = sin_deg(place.latitude_deg);
    const double cos_latitude = cos_deg(place.latitude_deg);
    const double east = -cos_declination * sin_deg(hour_angle);
    const double north = cos_latitude * sin_declination - sin_latitude * cos_declination * cos_deg(hour_angle);
    const double up = sin_latitude * sin_declination + cos_latitude * cos_declination * cos_deg(hour_angle);
    SkyAngles angles = sky_angles_of({east, north, up});
    constexpr double horizontal_parallax_deg = 0.00244;
    angles.elevation_deg -= horizontal_parallax_deg * cos_deg(angles.elevation_deg);
    return angles;
}

double refraction_deg(double elevation_deg, const Air& air) {
    if (elevation_deg < -1.0) return 0.0;
    const double arc_minutes = 1.02 / std::tan(degrees(elevation_deg + 10.3 / (elevation_deg + 5.11)).value);
    // Towards the zenith the formula ends at -0.002': the air lifts nothing there.
    return std::fmax(arc_minutes, 0.0) / 60.0 * (air.pressure_hpa / 1010.0) * (283.0 / (273.0 + air.temperature_c));
}

SkyAngles apparent_solar_position(const Place& place, Instant at, const Air& air) {
    SkyAngles angles = solar_position(place, at);
    angles.elevation_deg += refraction_deg(angles.elevation_deg, air);
    return angles;
}

} // namespace gonio
