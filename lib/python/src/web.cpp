// Webs: intensities by direction, their figures, and what changes them.
#include <gonio/base/named.hpp>
#include <gonio/plot/diagram.hpp>
#include <gonio/plot/svg.hpp>
#include <gonio/web/author.hpp>
#include <gonio/web/combine.hpp>
#include <gonio/web/compare.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/resample.hpp>
#include <gonio/web/symmetry.hpp>
#include <gonio/web/transform.hpp>

#include "binding.hpp"

#include <pybind11/stl.h>

namespace gonio::python {

namespace {

constexpr std::array symmetries{Named{"axial", Symmetry::axial}, Named{"quadrant", Symmetry::quadrant},
                                Named{"bilateral-0-180", Symmetry::bilateral_0_180},
                                Named{"bilateral-90-270", Symmetry::bilateral_90_270}, Named{"none", Symmetry::none}};
constexpr std::array photometries{Named{"a", Photometry::a}, Named{"b", Photometry::b}, Named{"c", Photometry::c}};
constexpr std::array mirrors{Named{"c0-180", MirrorPlane::c0_180}, Named{"c90-270", MirrorPlane::c90_270}};

std::vector<double> list_of(const Doubles& array) {
    return {array.data(), array.data() + array.size()};
}

// The web's own memory as an array that cannot be written; `owner` keeps it alive.
py::array view(const py::object& owner, std::vector<py::ssize_t> shape, const double* numbers) {
    py::array_t<double> array(std::move(shape), numbers, owner);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

std::string photometry_name(const Web& web) {
    return web.photometry() == Photometry::a ? "a" : web.photometry() == Photometry::b ? "b" : "c";
}

std::optional<double> degrees_of(std::optional<Radians> angle) {
    if (!angle) return std::nullopt;
    return to_degrees(*angle);
}

py::object sample(const Web& web, const Doubles& c_deg, const Doubles& gamma_deg) {
    const auto [c, gamma] = broadcast(c_deg, gamma_deg);
    Doubles result = like(c);
    const double* const cs = c.data();
    const double* const gammas = gamma.data();
    double* const candela = result.mutable_data();
    const py::ssize_t count = result.size();
    {
        const py::gil_scoped_release released;
        for (py::ssize_t i = 0; i < count; ++i)
            candela[i] = web.candela(cs[i], gammas[i]);
    }
    return number_or_array(result);
}

py::object sample_directions(const Web& web, const Doubles& directions) {
    return for_each_vector(directions, "directions", [&](const glm::dvec3& at) { return web.candela(at); });
}

std::string diagram(const Web& web, const std::string& kind, int width, int height, const std::string& title) {
    const DiagramKind* const found = value_of(find_diagram(kind));
    if (found->draw == nullptr)
        throw Failed{fail(Failure::unsupported, "the diagram '" + kind + "' is of lights, not of a web").value()};
    PlotOptions options;
    options.width_px = width;
    options.height_px = height;
    options.title = title;
    const PlottedWeb plotted{"", &web, ""};
    return to_svg(value_of(found->draw({&plotted, 1}, options)));
}

} // namespace

void add_webs(py::module_& module) {
    py::class_<Peak>(module, "Peak", "The greatest intensity of a web, and its direction.")
        .def_property_readonly(
            "candela", [](const Peak& p) { return p.intensity.value; }, "Greatest intensity [cd].")
        .def_readonly("c_deg", &Peak::c_deg, "C-plane [°].")
        .def_readonly("gamma_deg", &Peak::gamma_deg, "Angle from the nadir [°].");

    py::class_<WebDifference>(module, "WebDifference", "The difference of two webs.")
        .def_property_readonly(
            "greatest_cd", [](const WebDifference& d) { return d.greatest.value; }, "Greatest |a − b| [cd].")
        .def_readonly("relative", &WebDifference::relative, "The greatest, over the greater of the two peaks.")
        .def_readonly("c_deg", &WebDifference::c_deg, "Where it is [°].")
        .def_readonly("gamma_deg", &WebDifference::gamma_deg, "Where it is [°].")
        .def_property_readonly(
            "rms_cd", [](const WebDifference& d) { return d.rms.value; }, "Root mean square over the sphere [cd].")
        .def_readonly("exact", &WebDifference::exact,
                      "Whether the greatest is that of the interpolants, not of samples.");

    py::class_<Web, std::shared_ptr<Web>> web(
        module, "Web",
        "The photometric web: candela by direction, linear in both angles between the grid's and 0 outside.\n\n"
        "A web does not change: what edits it returns a new one. The grid is the file's own, in its goniometer type;\n"
        "its arrays are views of the web's memory.");
    web.def(py::init([](const Doubles& horizontal, const Doubles& vertical, const Doubles& candela,
                        const std::string& symmetry, const std::string& photometry) {
                return value_of(Web::create(value_of(find_value("type", photometry, photometries)),
                                            value_of(find_value("symmetry", symmetry, symmetries)), list_of(horizontal),
                                            list_of(vertical), list_of(candela)));
            }),
            py::arg("horizontal_deg"), py::arg("vertical_deg"), py::arg("candela"), py::kw_only(),
            py::arg("symmetry") = "none", py::arg("photometry") = "c",
            "A web from C-planes [°] (n), gamma [°] (m) and candela (n, m). `symmetry` says which mirror images the\n"
            "planes leave out: axial, quadrant, bilateral-0-180, bilateral-90-270 or none.")
        .def("sample", &sample, py::arg("c_deg"), py::arg("gamma_deg"),
             "Intensity [cd] towards C and gamma [°], which are broadcast. Gamma is in 0…180 from the nadir.")
        .def("sample_directions", &sample_directions, py::arg("directions"),
             "Intensity [cd] along directions (…, 3) of any length in the light's frame: the nadir is −Z, C0 is +X.")
        .def_property_readonly(
            "horizontal_deg",
            [](const py::object& self) {
                const auto angles = self.cast<const Web&>().horizontal_deg();
                return view(self, {static_cast<py::ssize_t>(angles.size())}, angles.data());
            },
            "C-planes, or H of types A and B [°] (n), a view.")
        .def_property_readonly(
            "vertical_deg",
            [](const py::object& self) {
                const auto angles = self.cast<const Web&>().vertical_deg();
                return view(self, {static_cast<py::ssize_t>(angles.size())}, angles.data());
            },
            "Gamma, or V of types A and B [°] (m), a view.")
        .def_property_readonly(
            "candela",
            [](const py::object& self) {
                const auto& of = self.cast<const Web&>();
                return view(self,
                            {static_cast<py::ssize_t>(of.horizontal_deg().size()),
                             static_cast<py::ssize_t>(of.vertical_deg().size())},
                            of.column(0).data());
            },
            "The table [cd] (n, m), a view.")
        .def_property_readonly("photometry", &photometry_name, "The goniometer type: 'a', 'b' or 'c'.")
        .def_property_readonly(
            "symmetry", [](const Web& of) { return to_text(of.stored_symmetry()); }, "The symmetry of the stored grid.")
        .def_property_readonly(
            "flux_lm", [](const Web& of) { return flux(of).value; }, "The exact integral of the interpolant [lm].")
        .def_property_readonly(
            "zonal_flux_lm", [](const Web& of) { return zonal_flux(of).value; },
            "The value that photometric software prints [lm].")
        .def_property_readonly("peak", &peak, "The greatest intensity and its direction.")
        .def_property_readonly(
            "center_beam_cd", [](const Web& of) { return center_beam(of).value; }, "The intensity along the axis [cd].")
        .def(
            "spread_angle_deg",
            [](const Web& of, double c_deg, double fraction) { return degrees_of(spread_angle(of, c_deg, fraction)); },
            py::arg("c_deg") = 0.0, py::arg("fraction") = 0.5,
            "Full angle [°] in the plane C within which the light has `fraction` of the peak; None if it never has.\n"
            "0.5 gives the beam angle, 0.1 the field angle.")
        .def(
            "cie_beam_angle_deg", [](const Web& of, double c_deg) { return degrees_of(cie_beam_angle(of, c_deg)); },
            py::arg("c_deg") = 0.0,
            "Full angle [°] at half of the intensity along the axis, as CIE and IEC define the beam angle; None if "
            "the\n"
            "axis is dark.")
        .def(
            "rotated", [](const Web& of, double angle) { return rotated(of, angle); }, py::arg("angle_deg"),
            "Rotated about the axis: the light towards C goes to C + angle.")
        .def(
            "mirrored",
            [](const Web& of, const std::string& plane) {
                return mirrored(of, value_of(find_value("plane", plane, mirrors)));
            },
            py::arg("plane"), "Mirrored in the plane 'c0-180' or 'c90-270'.")
        .def(
            "tilted",
            [](const Web& of, double angle, double towards, double tolerance) {
                return interruptible([&] { return tilted(of, angle, towards, tolerance); });
            },
            py::arg("angle_deg"), py::arg("towards_c_deg") = 0.0, py::kw_only(),
            py::arg("tolerance") = resampling_tolerance,
            "The axis tilted towards a C-plane; resampled to `tolerance` of the peak.")
        .def(
            "resampled",
            [](const Web& of, const Doubles& planes, const Doubles& gammas) {
                return value_of(resampled_to_c(of, list_of(planes), list_of(gammas)));
            },
            py::arg("planes_deg"), py::arg("gammas_deg"),
            "The intensities at these C-planes (n) and gammas (m) [°] as a web of type C, with the resulting error.")
        .def(
            "symmetrized",
            [](const Web& of, const std::string& how) {
                return value_of(symmetrized(of, value_of(find_value("symmetry", how, symmetries))));
            },
            py::arg("symmetry"), "The mean of the light and its mirror images; the flux stays the same.")
        .def(
            "compacted", [](const Web& of) { return compacted(of); },
            "The same light under the highest symmetry that it has.")
        .def(
            "cropped", [](const Web& of, double low, double high) { return value_of(cropped(of, low, high)); },
            py::arg("gamma_low_deg"), py::arg("gamma_high_deg"), "Dark outside these gammas [°].")
        .def(
            "scaled_to", [](const Web& of, double lumens) { return value_of(scaled_to(of, Lumens(lumens))); },
            py::arg("flux_lm"), "Every intensity scaled so that the flux is this [lm].")
        .def(
            "scaled_by", [](const Web& of, double factor) { return value_of(scaled_by(of, factor)); },
            py::arg("factor"), "Every intensity multiplied by a number greater than 0.")
        .def(
            "difference",
            [](const Web& a, const Web& b, double smallest) {
                return interruptible([&] { return difference(a, b, smallest); });
            },
            py::arg("other"), py::arg("smallest_deg") = 0.0,
            "How far two webs are apart. Steps narrower than `smallest_deg` do not count for the greatest.")
        .def("svg", &diagram, py::arg("kind") = "polar", py::kw_only(), py::arg("width_px") = 480,
             py::arg("height_px") = 480, py::arg("title") = "",
             "A diagram as SVG text: polar, cartesian, heat-map, isolux or cone.")
        .def("_repr_svg_", [](const Web& of) { return diagram(of, "polar", 480, 480, ""); })
        .def("__repr__", [](const Web& of) {
            return "<gonio.Web " + std::to_string(of.horizontal_deg().size()) + " × " +
                   std::to_string(of.vertical_deg().size()) + ", type " + photometry_name(of) + ", " +
                   to_text(of.stored_symmetry()) + ">";
        });

    py::class_<ResampledWeb>(module, "ResampledWeb", "A web that was resampled if need be, and what that cost.")
        .def_property_readonly(
            "web", [](const ResampledWeb& r) { return r.web; }, "The web, of type C if it was resampled.")
        .def_property_readonly(
            "max_error_cd", [](const ResampledWeb& r) { return r.max_error.value; },
            "Greatest difference to the original [cd]; 0 if it is exact.")
        .def_property_readonly(
            "flux_error_lm", [](const ResampledWeb& r) { return r.flux_error.value; },
            "Its flux minus that of the original [lm].");

    module.def(
        "nema_type", [](double angle) { return nema_type(degrees(angle)); }, py::arg("field_angle_deg"),
        "The NEMA type of a floodlight by its field angle in one plane [°], 1 to 7.");
    module.def(
        "diagrams", [] { return summaries_of(diagram_kinds()); }, "The names of the diagrams, each with a summary.");
    module.def(
        "make_web",
        [](const std::string& kind, double lumens, double horizontal, double vertical) {
            AuthorOptions options;
            options.flux = Lumens(lumens);
            options.horizontal_step_deg = horizontal;
            options.vertical_step_deg = vertical;
            return value_of(authored(value_of(parse_authored(kind)), options));
        },
        py::arg("kind"), py::arg("flux_lm") = 1000.0, py::kw_only(), py::arg("c_step_deg") = 5.0,
        py::arg("gamma_step_deg") = 2.5,
        "A web from a formula, as `gonio make`: 'downlight:beam=30deg', 'cosine', …, scaled to a flux [lm].");
}

} // namespace gonio::python
