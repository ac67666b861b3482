// Luminous openings: where the light of a luminaire leaves it, and from which distance on it is a point.
#include <gonio/light/far_field.hpp>
#include <gonio/light/luminous_body.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/profile/luminous_opening.hpp>

#include "binding.hpp"

#include <pybind11/stl.h>

namespace gonio::python {

namespace {

LuminousBody body_of(const Opening& opening, const Web& web) {
    std::optional<LuminousBody> body = LuminousBody::of(opening, web);
    if (!body)
        throw Failed{fail("USE0101", "the opening is a point, or the web is dark: there is no luminous surface",
                          "for example gonio.Opening('rect:w=1.2m,h=0.3m')")
                         .value()};
    return std::move(*body);
}

} // namespace

void add_openings(py::module_& module) {
    py::class_<Opening>(
        module, "Opening",
        "The luminous opening of a luminaire: Opening('rect:w=1.2m,h=0.3m'), or `Profile.opening`. All of its points\n"
        "have the same luminance towards a direction: the intensity over the projected area.")
        .def(py::init([](const std::string& text) { return value_of(parse_opening(text)); }), py::arg("text"),
             "An opening from the text that the tool takes: rect, box, disk, ellipse, cylinder, tube, sphere or point.")
        .def_property_readonly(
            "kind", [](const Opening& o) { return to_text(o.shape); }, "'rectangle', 'box', 'disk', …, or 'point'.")
        .def_property_readonly(
            "size_m", [](const Opening& o) { return to_array(o.size_m); },
            "Along C0, along C90 and up (3) [m]; a round one has its diameters.")
        .def_property_readonly("largest_m", &Opening::largest_m, "The greatest of these [m].")
        .def(
            "projected_area_m2",
            [](const Opening& o, const Web& web, const Doubles& directions) {
                const LuminousBody body = body_of(o, web);
                return for_each_vector(directions, "directions",
                                       [&](const glm::dvec3& at) { return body.projected_area_m2(at); });
            },
            py::arg("web"), py::arg("directions"),
            "The area of the faces from which the web emits, projected towards directions (…, 3) of its frame [m²].")
        .def(
            "luminance",
            [](const Opening& o, const Web& web, const Doubles& directions) {
                const LuminousBody body = body_of(o, web);
                return for_each_vector(directions, "directions", [&](const glm::dvec3& at) {
                    const double area = body.projected_area_m2(at);
                    return area > 0.0 ? web.candela(at) / area : 0.0;
                });
            },
            py::arg("web"), py::arg("directions"), "Luminance [cd/m²] (…) towards directions (…, 3) of its frame.")
        .def(
            "mean_luminance_nt",
            [](const Opening& o, const Web& web) { return body_of(o, web).mean_luminance().value; }, py::arg("web"),
            "The luminance whose uniform emission from all faces has the flux of the web [cd/m²].")
        .def(
            "point_distance_m",
            [](const Opening& o, const Web& web, double tolerance) {
                if (!(tolerance > 0.0 && std::isfinite(tolerance)))
                    throw Failed{fail("USE0106", "tolerance must be greater than 0").value()};
                const LuminousBody body = body_of(o, web);
                return interruptible([&] { return point_distance(body, web, tolerance); }).value;
            },
            py::arg("web"), py::arg("tolerance") = 0.01,
            "The distance [m] from which on a point with the web's intensities gives receivers the same within\n"
            "`tolerance`.")
        .def("__str__", [](const Opening& o) { return to_text(o); })
        .def("__repr__", [](const Opening& o) { return "<gonio.Opening " + to_text(o) + ">"; });
}

} // namespace gonio::python
