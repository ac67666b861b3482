// The sun: as a light, its position by place and time, and how much light it and the sky give.
#include <gonio/light/light_color.hpp>
#include <gonio/sky/cie_sky.hpp>
#include <gonio/sky/daylight_availability.hpp>
#include <gonio/sky/sky_direction.hpp>
#include <gonio/sky/solar_position.hpp>

#include "sky_types.hpp"

#include <pybind11/stl.h>

namespace gonio::python {

namespace {

// A moment, or an array of them: ISO 8601 with a zone, datetime, or numpy.datetime64, which is universal time.
Doubles days_since_j2000(const py::object& time) {
    if (py::isinstance<py::str>(time)) {
        Doubles one(std::vector<py::ssize_t>{});
        *one.mutable_data() = value_of(parse_time(time.cast<std::string>())).days_since_j2000;
        return one;
    }
    if (py::hasattr(time, "isoformat")) return days_since_j2000(time.attr("isoformat")());
    const py::module_ numpy = py::module_::import("numpy");
    const py::object array = numpy.attr("asarray")(time);
    if (array.attr("dtype").attr("kind").cast<std::string>() == "M") {
        const py::object epoch = numpy.attr("datetime64")("2000-01-01T12:00:00");
        const Doubles days(py::object((array - epoch) / numpy.attr("timedelta64")(1, "D")));
        const double first = value_of(parse_time(std::to_string(first_solar_year) + "-01-01T00:00Z")).days_since_j2000;
        const double last = value_of(parse_time(std::to_string(last_solar_year) + "-12-31T23:59Z")).days_since_j2000;
        for (py::ssize_t i = 0; i < days.size(); ++i)
            if (!(days.data()[i] >= first && days.data()[i] < last + 1.0 / 1440.0))
                throw Failed{fail("USE0106", "the position of the sun is known from " +
                                                 std::to_string(first_solar_year) + " to " +
                                                 std::to_string(last_solar_year))
                                 .value()};
        return days;
    }
    const py::object as_text = py::cpp_function([](const py::object& one) { return *days_since_j2000(one).data(); });
    return Doubles(py::object(numpy.attr("vectorize")(as_text, "otypes"_a = "d")(numpy.attr("asarray")(time, "O"))));
}

py::tuple solar_position_of(double latitude, double longitude, const py::object& time, bool refraction) {
    if (!(std::abs(latitude) <= 90.0 && std::abs(longitude) <= 180.0))
        throw Failed{fail("USE0106", "latitude_deg must be in −90…90 and longitude_deg in −180…180").value()};
    const Doubles days = days_since_j2000(time);
    Doubles azimuth = like(days);
    Doubles elevation = like(days);
    for (py::ssize_t i = 0; i < days.size(); ++i) {
        const Instant at{days.data()[i]};
        const Place place{latitude, longitude};
        const SkyAngles sun = refraction ? apparent_solar_position(place, at) : solar_position(place, at);
        azimuth.mutable_data()[i] = sun.azimuth_deg;
        elevation.mutable_data()[i] = sun.elevation_deg;
    }
    return py::make_tuple(number_or_array(azimuth), number_or_array(elevation));
}

py::tuple daylight(const Doubles& elevation, const Doubles& day, const std::string& weather) {
    const Weather of = value_of(parse_weather(weather));
    const auto [elevations, days] = broadcast(elevation, day);
    Doubles sun = like(elevations);
    Doubles sky = like(elevations);
    for (py::ssize_t i = 0; i < elevations.size(); ++i) {
        const double number = days.data()[i];
        if (!(number >= 1.0 && number <= 366.0)) throw Failed{fail("USE0106", "day_of_year must be in 1…366").value()};
        const DaylightAvailability light = daylight_availability(elevations.data()[i], static_cast<int>(number), of);
        sun.mutable_data()[i] = light.sun.value;
        sky.mutable_data()[i] = light.sky.value;
    }
    return py::make_tuple(number_or_array(sun), number_or_array(sky));
}

Doubles sky_direction(const Doubles& azimuth, const Doubles& elevation) {
    const auto [azimuths, elevations] = broadcast(azimuth, elevation);
    std::vector<py::ssize_t> shape(azimuths.shape(), azimuths.shape() + azimuths.ndim());
    shape.push_back(3);
    Doubles result(shape);
    double* to = result.mutable_data();
    for (py::ssize_t i = 0; i < azimuths.size(); ++i, to += 3) {
        const glm::dvec3 direction = direction_of(SkyAngles{azimuths.data()[i], elevations.data()[i]});
        for (int k = 0; k < 3; ++k)
            to[k] = direction[k];
    }
    return result;
}

py::tuple sky_angles(const Doubles& directions) {
    require_vectors(directions, "directions");
    Doubles azimuth(shape_of_vectors(directions));
    Doubles elevation(shape_of_vectors(directions));
    const double* from = directions.data();
    for (py::ssize_t i = 0; i < azimuth.size(); ++i, from += 3) {
        const SkyAngles at = sky_angles_of(direction_of_length({from[0], from[1], from[2]}, "a direction"));
        azimuth.mutable_data()[i] = at.azimuth_deg;
        elevation.mutable_data()[i] = at.elevation_deg;
    }
    return py::make_tuple(number_or_array(azimuth), number_or_array(elevation));
}

py::object cie_sky_luminance(const std::string& type, const Doubles& directions, double azimuth, double elevation) {
    if (!(elevation >= 0.0 && elevation <= 90.0))
        throw Failed{
            fail("USE0106", "the sun of a CIE sky stands above the horizon: sun_elevation_deg in 0…90").value()};
    const CieSky sky(*value_of(find_cie_sky(type)), direction_of(SkyAngles{azimuth, elevation}));
    return for_each_vector(directions, "directions", [&](const glm::dvec3& at) {
        const double length = glm::length(at);
        return length > 0.0 ? sky.relative(at / length) : std::numeric_limits<double>::quiet_NaN();
    });
}

SunLight make_sun(double azimuth, double elevation, double illuminance, const std::string& color, double diameter) {
    if (!(illuminance > 0.0) || !std::isfinite(illuminance))
        throw Failed{fail("USE0106", "illuminance_lx must be greater than 0").value()};
    Diagnostics diagnostics;
    SunLight sun;
    sun.direction = direction_of(SkyAngles{azimuth, elevation});
    sun.illuminance = Lux(illuminance);
    sun.color = value_of(parse_light_color(color, &diagnostics));
    sun.diameter = degrees(diameter);
    warn(diagnostics);
    return sun;
}

} // namespace

Light light_of(const SunLight& sun, const std::string& name) {
    LightDescription description;
    description.name = name;
    description.shape = SunShape{sun.diameter};
    description.intensity = PhotometricValue{sun.illuminance.value, value_of(parse_photometric_unit("lx"))};
    description.color = sun.color;
    description.direction = -sun.direction;
    Diagnostics diagnostics;
    Light light = value_of(resolve_light(std::move(description), diagnostics));
    warn(diagnostics);
    return light;
}

void add_suns(py::module_& module) {
    py::class_<SunLight>(module, "Sun", "The sun beside a sky. z is up, +Y is north and +X is east.")
        .def(py::init(&make_sun), py::arg("azimuth_deg"), py::arg("elevation_deg"), py::arg("illuminance_lx"),
             py::kw_only(), py::arg("color") = "rgb(1,1,1)", py::arg("diameter_deg") = to_degrees(sun_diameter),
             "A sun by its azimuth from north over east [°], its elevation [°] and its illuminance on a plane that\n"
             "faces it [lx].")
        .def_property_readonly(
            "direction", [](const SunLight& s) { return to_array(s.direction); }, "Unit, towards the sun (3).")
        .def_property_readonly(
            "azimuth_deg", [](const SunLight& s) { return sky_angles_of(s.direction).azimuth_deg; },
            "From north over east [°].")
        .def_property_readonly(
            "elevation_deg", [](const SunLight& s) { return sky_angles_of(s.direction).elevation_deg; },
            "Above the horizon [°].")
        .def_property_readonly(
            "illuminance_lx", [](const SunLight& s) { return s.illuminance.value; }, "On a plane that faces it [lx].")
        .def_property_readonly(
            "color", [](const SunLight& s) { return to_array(s.color); }, "Linear Rec.709 of luminance 1 (3).")
        .def_property_readonly(
            "diameter_deg", [](const SunLight& s) { return to_degrees(s.diameter); }, "Of its disc [°].")
        .def("light", &light_of, py::arg("name") = "sun", "The sun as a gonio.Light.")
        .def("__repr__", [](const SunLight& s) {
            const SkyAngles at = sky_angles_of(s.direction);
            return "<gonio.Sun at " + rounded(at.azimuth_deg) + "/" + rounded(at.elevation_deg) + "°, " +
                   rounded(s.illuminance.value) + " lx>";
        });

    module.def(
        "solar_position", &solar_position_of, py::arg("latitude_deg"), py::arg("longitude_deg"), py::arg("time"),
        py::kw_only(), py::arg("refraction") = false,
        "Azimuth from north over east and elevation [°] of the sun as seen from a place (north and east positive).\n"
        "`time` is ISO 8601 with its zone, a datetime with its zone, a numpy.datetime64, which is universal time, or\n"
        "an array of these; 1950 to 2100, within 0.005°. `refraction` lifts it as standard air does.");
    module.def("daylight", &daylight, py::arg("elevation_deg"), py::arg("day_of_year"), py::arg("weather") = "clear",
               "Illuminance [lx] by the sun on a plane that faces it, and by the sky on an open horizontal plane, for\n"
               "elevations of the sun [°] and days from 1 to 366, which are broadcast (IES RP-21). `weather`: clear,\n"
               "partly or overcast. 0 below the horizon.");
    module.def(
        "extraterrestrial_lx",
        [](int day) {
            if (day < 1 || day > 366) throw Failed{fail("USE0106", "day_of_year must be in 1…366").value()};
            return extraterrestrial(day).value;
        },
        py::arg("day_of_year"), "Illuminance by the sun outside the atmosphere on a plane that faces it [lx].");
    module.def(
        "refraction_deg",
        [](const Doubles& elevation, double pressure_hpa, double temperature_c) {
            Doubles lift = like(elevation);
            for (py::ssize_t i = 0; i < elevation.size(); ++i)
                lift.mutable_data()[i] = refraction_deg(elevation.data()[i], {pressure_hpa, temperature_c});
            return number_or_array(lift);
        },
        py::arg("elevation_deg"), py::kw_only(), py::arg("pressure_hpa") = Air{}.pressure_hpa,
        py::arg("temperature_c") = Air{}.temperature_c, "By how much air lifts geometric elevations [°]; 0 below −1°.");
    module.def(
        "day_of_year",
        [](const py::object& time) {
            const Doubles days = days_since_j2000(time);
            py::array_t<int> numbers(std::vector<py::ssize_t>(days.shape(), days.shape() + days.ndim()));
            for (py::ssize_t i = 0; i < days.size(); ++i)
                numbers.mutable_data()[i] = Instant{days.data()[i]}.day_of_year();
            return days.ndim() == 0 ? py::object(py::int_(*numbers.data())) : py::object(numbers);
        },
        py::arg("time"), "The day of the year of times, 1 to 366, in universal time; as solar_position() takes them.");
    module.def("sky_direction", &sky_direction, py::arg("azimuth_deg"), py::arg("elevation_deg"),
               "Unit directions (…, 3) of azimuths from north over east and elevations [°], which are broadcast.");
    module.def("sky_angles", &sky_angles, py::arg("directions"),
               "Azimuth from north over east, in 0…360, and elevation [°] of directions (…, 3) of any length.");
    module.def("cie_sky_luminance", &cie_sky_luminance, py::arg("type"), py::arg("directions"), py::kw_only(),
               py::arg("sun_azimuth_deg") = 0.0, py::arg("sun_elevation_deg") = 90.0,
               "Luminance over that of the zenith (…) of a CIE sky ('1' to '16', or a name of cie_skies()) towards\n"
               "directions (…, 3); 0 below the horizon.");
    module.def(
        "cie_skies",
        [] {
            std::vector<std::tuple<int, std::string, std::string>> rows;
            for (const CieSkyType& type : cie_sky_types())
                rows.emplace_back(type.number, type.name, type.summary);
            return rows;
        },
        "The sixteen skies of the CIE as (number, name, summary).");
    module.def(
        "weathers", [] { return summaries_of(weathers()); }, "The names of the weathers, each with a summary.");
}

} // namespace gonio::python
