// Lights, and the illuminance and luminance that they give to points.
#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/light/light_image.hpp>
#include <gonio/scene/probe.hpp>

#include "light_list.hpp"
#include "packs.hpp"
#include "short_call.hpp"
#include "sky_types.hpp"

#include <algorithm>
#include <cmath>
#include <pybind11/stl.h>

namespace gonio::python {

namespace {

// Before a spot or a frustum, or on a rectangle.
void set_image(Shape& shape, const py::object& pixels) {
    auto image = std::make_shared<const LightImage>(value_of(LightImage::create(image_of(pixels, "image"))));
    const bool takes_one = std::visit(
        [&](auto& kind) {
            if constexpr (requires { kind.image; }) {
                if (!kind.mask_file.empty())
                    throw Failed{fail("USE0107", "the light has a mask and an image", "leave one of them out").value()};
                kind.mask_file = "array.exr"; // an image by its name; it is loaded already
                kind.image = std::move(image);
                return true;
            } else {
                return false;
            }
        },
        shape);
    if (!takes_one)
        throw Failed{fail("USE0107", std::string("a ") + kind_of(shape) + " takes no image",
                          "a spot and a frustum project one, a rect shows it")
                         .value()};
}

Light make_light(const std::string& shape, const std::optional<std::string>& intensity, const std::string& color,
                 const py::object& position, const py::object& direction, const py::object& up, double rotate_deg,
                 std::optional<double> range_m, const std::string& name, const std::optional<py::object>& image) {
    Diagnostics diagnostics;
    LightDescription description;
    description.name = name;
    description.shape = value_of(parse_shape(shape));
    if (image) set_image(description.shape, *image);
    if (intensity) description.intensity = value_of(parse_photometric_value(*intensity));
    description.color = value_of(parse_light_color(color, &diagnostics));
    description.position = vector_of(position, "position");
    description.direction = vector_of(direction, "direction");
    description.up = vector_of(up, "up");
    description.rotation = degrees(rotate_deg);
    if (range_m) description.range = Meters(*range_m);
    Light light = value_of(resolve_light(std::move(description), diagnostics));
    warn(diagnostics);
    return light;
}

py::object intensity_towards(const Light& light, const Doubles& directions) {
    return for_each_vector(directions, "directions",
                           [&](const glm::dvec3& towards) { return light.intensity_towards(towards).value; });
}

// The shape of a result with a value for each receiver.
std::vector<py::ssize_t> shape_of_result(const Doubles& positions, const Doubles& normals) {
    return shape_of_vectors(broadcast(positions, normals)[0]);
}

Doubles to_array(std::vector<double>&& values, std::vector<py::ssize_t> shape) {
    // The vector moves into the array's keeping; its numbers stay where they are.
    auto kept = std::make_unique<std::vector<double>>(std::move(values));
    const double* const data = kept->data();
    const py::capsule owner(kept.get(), [](void* list) { delete static_cast<std::vector<double>*>(list); });
    kept.release(); // NOLINT(bugprone-unused-return-value): the capsule owns it
    return Doubles(std::move(shape), data, owner);
}

ProbeResult probed(const std::vector<Light>& lights, const std::vector<Receiver>& receivers,
                   const ProbeOptions& options) {
    ProbeResult result = value_of(interruptible([&] { return probe(lights, receivers, options); }));
    warn(to_diagnostics(result.remarks, lights));
    return result;
}

Floats in_packs(const std::vector<Light>& lights, const Floats& positions, const Floats& normals, unsigned threads) {
    Floats result(positions.shape(0));
    const Points points{vectors_of(positions), vectors_of(normals), static_cast<std::size_t>(positions.shape(0))};
    float* const lx = result.mutable_data();
    short_or_interruptible(points.count * lights.size(), [&] { illuminance_in_packs(lights, points, threads, lx); });
    return result;
}

// Both float32, of shape (n, 3) or one normal (3) for all, under simple lights.
bool fits_packs(const std::vector<Light>& lights, const py::array& positions, const py::array& normals) {
    return is_float_vectors(positions) && is_float_vectors(normals) && positions.ndim() == 2 &&
           (normals.ndim() == 1 || normals.shape(0) == positions.shape(0)) &&
           std::all_of(lights.begin(), lights.end(), fits_packs_alone);
}

// The open sky of a rig, if it has one.
std::optional<Sky> sky_of_rig(const py::object& lights) {
    if (!py::hasattr(lights, "sky")) return std::nullopt;
    const py::object sky = lights.attr("sky");
    if (sky.is_none()) return std::nullopt;
    return sky.cast<const LoadedSky&>().sky;
}

// Once for each different normal.
void add_sky(const Sky& sky, const std::vector<Receiver>& receivers, unsigned threads, std::vector<double>& lx) {
    std::vector<glm::dvec3> normals;
    normals.reserve(receivers.size());
    for (const Receiver& receiver : receivers)
        normals.push_back(direction_of_length(receiver.normal, "a normal"));
    const auto light = interruptible([&] { return sky.irradiance(normals, threads); });
    for (std::size_t i = 0; i < lx.size(); ++i)
        lx[i] += glm::dot(light[i], rec709_luminance);
}

py::object illuminance(const py::object& of, const py::object& at, const py::object& facing, const std::string& method,
                       unsigned threads) {
    const std::vector<Light> lights = lights_of(of);
    const py::array positions = as_array(at);
    const py::array normals = as_array(facing);
    const std::optional<Sky> sky = sky_of_rig(of);
    if (method == "exact" && !sky && fits_packs(lights, positions, normals))
        return in_packs(lights, positions, normals, threads);
    const Doubles places(positions);
    const Doubles ways(normals);
    ProbeOptions options;
    options.method = value_of(parse_irradiance_method(method));
    options.threads = threads;
    const std::vector<Receiver> receivers = receivers_of(places, ways);
    ProbeResult result = probed(lights, receivers, options);
    if (sky) add_sky(*sky, receivers, threads, result.illuminance_lx);
    return number_or_array(to_array(std::move(result.illuminance_lx), shape_of_result(places, ways)));
}

py::object illuminance_of_each(const py::object& of, const Doubles& positions, const Doubles& normals,
                               const std::string& method, unsigned threads) {
    const std::vector<Light> lights = lights_of(of);
    ProbeOptions options;
    options.method = value_of(parse_irradiance_method(method));
    options.threads = threads;
    options.parts = true;
    ProbeResult result = probed(lights, receivers_of(positions, normals), options);
    std::vector<py::ssize_t> shape = shape_of_result(positions, normals);
    shape.push_back(static_cast<py::ssize_t>(lights.size()));
    return to_array(std::move(result.parts_lx), std::move(shape));
}

Floats luminance_in_packs(const std::vector<Light>& lights, const Floats& positions, const Floats& normals,
                          const glm::dvec3& eye, const Material& material, unsigned threads) {
    Floats result(positions.shape(0));
    const Points points{vectors_of(positions), vectors_of(normals), static_cast<std::size_t>(positions.shape(0))};
    float* const nits = result.mutable_data();
    short_or_interruptible(points.count * lights.size(),
                           [&] { luminance_in_packs(lights, points, eye, material, threads, nits); });
    return result;
}

py::object luminance(const py::object& of, const py::object& at, const py::object& facing, const py::object& eye,
                     const std::string& material_text, const std::string& method, unsigned threads) {
    const std::vector<Light> lights = lights_of(of);
    const py::array positions = as_array(at);
    const py::array normals = as_array(facing);
    const Material material = value_of(parse_material(material_text));
    const glm::dvec3 from = vector_of(eye, "eye");
    if (method == "ltc" && fits_packs(lights, positions, normals))
        return luminance_in_packs(lights, positions, normals, from, material, threads);
    const Doubles places(positions);
    const Doubles ways(normals);
    ProbeOptions options;
    options.method = value_of(parse_irradiance_method(method));
    options.threads = threads;
    options.view = ProbeView{{0.0, 0.0, 1.0}, material, from};
    const ProbeResult result = probed(lights, receivers_of(places, ways), options);
    Doubles values(shape_of_result(places, ways));
    for (py::ssize_t i = 0; i < values.size(); ++i)
        values.mutable_data()[i] = result.luminance[static_cast<std::size_t>(i)].total().value;
    return number_or_array(values);
}

} // namespace

// Positions and normals in one shape.
std::vector<Receiver> receivers_of(const Doubles& positions, const Doubles& normals) {
    require_vectors(positions, "positions");
    require_vectors(normals, "normals");
    const auto [places, ways] = broadcast(positions, normals);
    std::vector<Receiver> receivers(static_cast<std::size_t>(places.size()) / 3);
    const double* place = places.data();
    const double* way = ways.data();
    for (Receiver& receiver : receivers) {
        receiver = {{place[0], place[1], place[2]}, {way[0], way[1], way[2]}};
        place += 3;
        way += 3;
    }
    return receivers;
}

std::vector<Light> lights_of(const py::object& lights) {
    if (py::isinstance<Light>(lights)) return {lights.cast<Light>()};
    if (py::hasattr(lights, "lights")) return lights.attr("lights").cast<std::vector<Light>>();
    try {
        return lights.cast<std::vector<Light>>();
    } catch (const py::cast_error&) {
        throw py::type_error("expected a gonio.Light, a list of them, or a gonio.Rig: gonio.make_rig(…) makes one of a "
                             "dict");
    }
}

void add_lights(py::module_& module) {
    const auto zero = py::make_tuple(0.0, 0.0, 0.0);
    py::class_<Light>(
        module, "Light",
        "A light: a shape, its amount, colour and place, resolved once. A profile without an amount emits as\n"
        "measured; other shapes need one.")
        .def(py::init(&make_light), py::arg("shape"), py::arg("intensity") = py::none(), py::kw_only(),
             py::arg("color") = "rgb(1,1,1)", py::arg("position") = zero,
             py::arg("direction") = py::make_tuple(0.0, 0.0, -1.0), py::arg("up") = py::make_tuple(0.0, 1.0, 0.0),
             py::arg("rotate_deg") = 0.0, py::arg("range_m") = py::none(), py::arg("name") = "",
             py::arg("image") = py::none(),
             "Light('sphere:r=3cm', '800lm', color='2700K', position=(0, 0, 2.5)): the texts are those of the tool.\n"
             "`direction` is where it emits, C90 of a profile points `up`, `rotate_deg` turns it about its direction "
             "[°].\n"
             "`image`, pixels (height, width) or (height, width, 3) of linear Rec.709, is what a spot or a frustum\n"
             "projects and a rectangle shows: the light times the pixels over the brightest one.")
        .def_readonly("name", &Light::name, "Its name.")
        .def_property_readonly(
            "shape", [](const Light& l) { return kind_of(l.shape); }, "The kind of its shape: 'sphere', 'ies', ….")
        .def_property_readonly(
            "position", [](const Light& l) { return python::to_array(l.frame.origin); }, "Of its centre [m] (3).")
        .def_property_readonly(
            "direction", [](const Light& l) { return python::to_array(-l.frame.z); }, "Where it emits, unit (3).")
        .def_property_readonly(
            "color", [](const Light& l) { return python::to_array(l.color); }, "Linear Rec.709 of luminance 1 (3).")
        .def_property_readonly(
            "intensity_cd", [](const Light& l) { return l.intensity.value; },
            "Along its direction, before a mask; of a profile its peak [cd].")
        .def_property_readonly(
            "luminance_nt", [](const Light& l) { return l.luminance.value; }, "Of area lights and the sun [cd/m²].")
        .def_property_readonly(
            "illuminance_lx", [](const Light& l) { return l.illuminance.value; },
            "Of the sun, on a plane that faces it [lx].")
        .def(
            "luminance_towards",
            [](const Light& l, const Doubles& directions) {
                return for_each_vector(directions, "directions", [&](const glm::dvec3& towards) {
                    return l.luminance.value * l.luminance_share(towards);
                });
            },
            py::arg("directions"),
            "Luminance [cd/m²] (…) of an area light towards directions (…, 3) of the world, from the light to the\n"
            "receiver; of an image its mean. 0 of a point.")
        .def("intensity_towards", &intensity_towards, py::arg("directions"),
             "Intensity [cd] towards directions (…, 3) of the world, from the light to the receiver, as from far away.")
        .def("__repr__", [](const Light& l) {
            return "<gonio.Light " + std::string(kind_of(l.shape)) + (l.name.empty() ? "" : " '" + l.name + "'") + ">";
        });

    module.def(
        "illuminance", &illuminance, py::arg("lights"), py::arg("positions"), py::arg("normals"), py::kw_only(),
        py::arg("method") = "exact", py::arg("threads") = 0,
        "Illuminance [lx] at positions (…, 3) [m] with normals (…, 3), which are broadcast, of a light, a list of\n"
        "lights or a rig together. Closed forms with exact clipping at the horizon, in double; nothing occludes,\n"
        "and the sky of a rig is open: illuminance_on_stage() has shadows and bounced light. Arrays of float32 (n, 3)\n"
        "and normals (n, 3) or (3) run on the vector units and give float32; they are read in place if each column is\n"
        "contiguous (order='F'). `threads` 0: all.");
    module.def("illuminance_of_each", &illuminance_of_each, py::arg("lights"), py::arg("positions"), py::arg("normals"),
               py::kw_only(), py::arg("method") = "exact", py::arg("threads") = 0,
               "The same with the share of each light in the last axis [lx] (…, lights).");
    module.def(
        "luminance", &luminance, py::arg("lights"), py::arg("positions"), py::arg("normals"), py::kw_only(),
        py::arg("eye"), py::arg("material") = "lambert:albedo=0.5", py::arg("method") = "exact", py::arg("threads") = 0,
        "Luminance [cd/m²] of a material at positions (…, 3) with normals (…, 3), seen from `eye` (3) [m]. Highlights\n"
        "of area lights by quadrature in double, 0.1 to 1 ms a point; method 'ltc' with arrays of float32 (n, 3)\n"
        "runs on the vector units.");
    module.def(
        "falloffs", [] { return summaries_of(gonio::falloffs()); },
        "The names of the falloffs of spots, each with a summary.");
    module.def(
        "irradiance_methods", [] { return names_of(gonio::irradiance_methods()); },
        "The names of the methods: 'exact', 'reference', those of engines.");
}

} // namespace gonio::python
