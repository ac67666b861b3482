// Skies: the light from all around, by a text, a formula or an image.
#include <gonio/base/codes/result.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/sky/environment_resample.hpp>
#include <gonio/sky/sky_direction.hpp>
#include <gonio/sky/sky_measures.hpp>

#include "sky_types.hpp"

#include <pybind11/stl.h>

namespace gonio::python {

namespace {

struct Measured {
    SkyMeasures measures;
    std::optional<Cct> cct;
};

Measured measured(const Sky& sky, unsigned threads) {
    Measured found{interruptible([&] { return measure(sky, threads); }), {}};
    if (found.measures.color == glm::dvec3(0.0)) return found;
    const Result<Uv> at = uv_of_rgb(found.measures.color, *find_rgb_space("rec709"));
    if (!at) return found;
    const Result<Cct> cct = exact_cct(*at);
    if (cct) found.cct = *cct;
    return found;
}

SkyDescription described(const Environment& environment, std::optional<double> horizontal, std::optional<double> mean,
                         std::optional<double> zenith, double rotate_deg) {
    if ((horizontal ? 1 : 0) + (mean ? 1 : 0) + (zenith ? 1 : 0) > 1)
        throw Failed{fail("USE0107", "a sky has one amount", "horizontal_lx, mean_nt or zenith_nt").value()};
    SkyDescription description{ImageSkyKind{}, {}, glm::dvec3(1.0), degrees(rotate_deg), 0.0};
    std::get<ImageSkyKind>(description.kind).layout = environment.map->grid().layout();
    if (horizontal) description.amount = SkyAmount{SkyMeasure::horizontal, *horizontal};
    if (mean) description.amount = SkyAmount{SkyMeasure::mean, *mean};
    if (zenith) description.amount = SkyAmount{SkyMeasure::zenith, *zenith};
    return description;
}

LoadedSky make_sky(const py::object& of, std::optional<double> horizontal, std::optional<double> mean,
                   std::optional<double> zenith, double rotate_deg) {
    if (!py::isinstance<Environment>(of)) {
        if (horizontal || mean || zenith || rotate_deg != 0.0)
            throw Failed{fail("USE0107", "a sky as text has its amount and its rotation in the text",
                              "for example 'cie:12,sun=180/40,horizontal=20klx,rotate=30deg'")
                             .value()};
        return sky_of(of);
    }
    const auto& environment = of.cast<const Environment&>();
    LoadedSky loaded;
    loaded.text = "image";
    const SkyDescription description = described(environment, horizontal, mean, zenith, rotate_deg);
    loaded.sky = value_of(interruptible([&] { return resolve_sky(description, environment.map); }));
    return loaded;
}

// A light that is too small for texels: the tool says so too.
void remark_on_sun(const EnvironmentMap& map, const SkyDescription& description, Diagnostics& diagnostics) {
    const std::optional<BrightestSpot> spot = sun_like_spot(map);
    if (!spot) return;
    const SkyAngles at = sky_angles_of(turned(spot->direction, description.rotation));
    diagnostics.push_back(result_diagnostic(
        "RES0504",
        rounded(100.0 * spot->share, 3) + " % of the light comes from within " + rounded(spot_radius_deg) +
            "° of azimuth " + rounded(at.azimuth_deg, 4) + "°, elevation " + rounded(at.elevation_deg, 4) + "°",
        "extract_sun() takes a sun out of the pixels of an environment",
        std::get<ImageSkyKind>(description.kind).file));
}

} // namespace

LoadedSky load_sky(SkyDescription description, std::string text) {
    LoadedSky loaded;
    loaded.text = std::move(text);
    std::shared_ptr<const EnvironmentMap> image;
    if (const auto* const kind = std::get_if<ImageSkyKind>(&description.kind)) {
        Environment environment = read_environment(*kind);
        image = environment.map;
        loaded.diagnostics = std::move(environment.diagnostics);
        remark_on_sun(*image, description, loaded.diagnostics);
    }
    loaded.sky = value_of(interruptible([&] { return resolve_sky(description, image); }));
    return loaded;
}

LoadedSky sky_of(const py::object& sky) {
    if (py::isinstance<LoadedSky>(sky)) return sky.cast<LoadedSky>();
    if (py::isinstance<Environment>(sky)) return make_sky(sky, {}, {}, {}, 0.0);
    if (!py::isinstance<py::str>(sky)) throw py::type_error("expected a text, a gonio.Environment or a gonio.Sky");
    Diagnostics diagnostics;
    const auto text = sky.cast<std::string>();
    LoadedSky loaded = load_sky(value_of(parse_sky_description(text, &diagnostics)), text);
    loaded.diagnostics.insert(loaded.diagnostics.begin(), diagnostics.begin(), diagnostics.end());
    return loaded;
}

void add_skies(py::module_& module) {
    py::class_<Measured>(module, "SkyMeasures", "What a light meter reads under a sky, without its sun.")
        .def_property_readonly(
            "horizontal_lx", [](const Measured& m) { return m.measures.horizontal.value; },
            "Of an open plane that faces up [lx].")
        .def_property_readonly(
            "vertical_lx",
            [](const Measured& m) {
                const auto& walls = m.measures.vertical;
                return py::dict("north"_a = walls[0].value, "east"_a = walls[1].value, "south"_a = walls[2].value,
                                "west"_a = walls[3].value);
            },
            "Of open walls that face north, east, south and west [lx], by these names.")
        .def_property_readonly(
            "mean_nt", [](const Measured& m) { return m.measures.mean.value; }, "Mean luminance [cd/m²].")
        .def_property_readonly(
            "zenith_nt", [](const Measured& m) { return m.measures.zenith.value; }, "Of the zenith [cd/m²].")
        .def_property_readonly(
            "brightest", [](const Measured& m) { return m.measures.spot; },
            "Where it is brightest; None if all directions are equal.")
        .def_property_readonly(
            "color", [](const Measured& m) { return to_array(m.measures.color); },
            "Of the light on a sphere: linear Rec.709 of luminance 1 (3).")
        .def_property_readonly(
            "temperature_k",
            [](const Measured& m) { return m.cct ? std::optional(m.cct->temperature.value) : std::nullopt; },
            "Correlated colour temperature of that [K]; None if it has none.")
        .def_property_readonly(
            "duv", [](const Measured& m) { return m.cct ? std::optional(m.cct->duv) : std::nullopt; },
            "Its distance from the black bodies in u, v of 1960; None if it has none.");

    py::class_<LoadedSky>(
        module, "Sky",
        "The light from all around: Sky('cie:12,sun=180/40,horizontal=20klx'), Sky('500lx'), Sky('daylight:place=\n"
        "52.52/13.405,time=2026-06-21T12:00+02:00'), or of an environment. z is up, +Y is north and +X is east.\n"
        "The sun of daylight is beside it: no method but those of `sun` includes its light.")
        .def(py::init(&make_sky), py::arg("sky"), py::kw_only(), py::arg("horizontal_lx") = py::none(),
             py::arg("mean_nt") = py::none(), py::arg("zenith_nt") = py::none(), py::arg("rotate_deg") = 0.0,
             "A sky from the text that the tool takes; or from an environment, scaled to an illuminance of an open\n"
             "horizontal plane [lx] or a luminance [cd/m²], and turned so that azimuths grow by `rotate_deg`.")
        .def_readonly("text", &LoadedSky::text, "How it was described.")
        .def_readonly("diagnostics", &LoadedSky::diagnostics, "Warnings and notes of reading it.")
        .def_property_readonly(
            "sun", [](const LoadedSky& s) { return s.sky.sun(); }, "The sun beside it; None without one.")
        .def(
            "radiance",
            [](const LoadedSky& s, const Doubles& directions) {
                return for_each_vector_rgb(directions, "directions",
                                           [&](const glm::dvec3& at) { return s.sky.radiance(at / glm::length(at)); });
            },
            py::arg("directions"),
            "Luminance of the three channels [cd/m²] (…, 3) towards directions (…, 3) of any length; below the\n"
            "horizon that of the ground.")
        .def(
            "luminance",
            [](const LoadedSky& s, const Doubles& directions) {
                return for_each_vector(directions, "directions", [&](const glm::dvec3& at) {
                    return luminance_of(s.sky.radiance(at / glm::length(at)));
                });
            },
            py::arg("directions"), "Luminance [cd/m²] (…) towards directions (…, 3) of any length.")
        .def(
            "illuminance",
            [](const LoadedSky& s, const Doubles& normals, unsigned threads) {
                return illuminance_under(s.sky, normals, threads);
            },
            py::arg("normals"), py::kw_only(), py::arg("threads") = 0,
            "Illuminance [lx] (…) of open planes with normals (…, 3), once for each different normal.")
        .def(
            "scalar_illuminance_lx",
            [](const LoadedSky& s, unsigned threads) {
                return luminance_of(interruptible([&] { return s.sky.light(threads); }));
            },
            py::kw_only(), py::arg("threads") = 0,
            "∫ L dω over all directions [lx]: four times the mean over a sphere's surface.")
        .def(
            "measures", [](const LoadedSky& s, unsigned threads) { return measured(s.sky, threads); }, py::kw_only(),
            py::arg("threads") = 0, "What a light meter reads under it.")
        .def(
            "environment",
            [](const LoadedSky& s, const std::string& layout, std::optional<std::pair<int, int>> size, bool sun,
               unsigned threads) {
                const EnvironmentGrid grid = grid_of(layout, size);
                EnvironmentMap map = interruptible([&] { return environment_of(s.sky, grid, threads); });
                if (sun && s.sky.sun()) map = with_sun(map, *s.sky.sun());
                return python::environment_of(std::move(map));
            },
            py::arg("layout") = "latlong", py::arg("size") = py::none(), py::kw_only(), py::arg("sun") = false,
            py::arg("threads") = 0,
            "As an image of `size` (width, height): means over its texels [cd/m²]; with the disc of its sun if `sun`.")
        .def("_repr_png_",
             [](const py::object& self) {
                 return self.attr("environment")("latlong", py::make_tuple(256, 128)).attr("_repr_png_")();
             })
        .def("__repr__", [](const LoadedSky& s) { return "<gonio.Sky " + s.text + ">"; });

    module.def(
        "skies",
        [] {
            std::vector<std::pair<std::string, std::string>> kinds;
            for (const SkyKindInfo& kind : sky_kinds())
                kinds.emplace_back(kind.grammar, kind.summary);
            return kinds;
        },
        "The grammar of the skies, each with a summary.");
}

} // namespace gonio::python
