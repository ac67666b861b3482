// Lights, and the illuminance and luminance that they give to points.
#include <gonio/base/parallel.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/transport/shading_constants.hpp>

#include "binding.hpp"
#include "light_list.hpp"

#include <cmath>
#include <cstring>
#include <pybind11/stl.h>

namespace gonio::python {

namespace {

using Floats = py::array_t<float>;

Light make_light(const std::string& shape, const std::optional<std::string>& intensity, const std::string& color,
                 const py::object& position, const py::object& direction, const py::object& up, double rotate_deg,
                 std::optional<double> range_m, const std::string& name) {
    Diagnostics diagnostics;
    LightDescription description;
    description.name = name;
    description.shape = value_of(parse_shape(shape));
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
    require_vectors(directions, "directions");
    Doubles result(shape_of_vectors(directions));
    const double* from = directions.data();
    for (py::ssize_t i = 0; i < result.size(); ++i, from += 3)
        result.mutable_data()[i] = light.intensity_towards({from[0], from[1], from[2]}).value;
    return number_or_array(result);
}

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

// Whether the packs compute this light as the closed form does: uniform, of one part, or a point.
bool is_simple(const Light& light) {
    return light.parts == nullptr && light.body == nullptr && light.emission == nullptr && light.image == nullptr &&
           (class_of(light.shape) == ShapeClass::punctual || !light.has_pattern());
}

// Three numbers of each point, wherever they lie: rows (n, 3), or columns that the packs read in place.
struct Vectors {
    const char* data;
    py::ssize_t row;    // bytes from one point to the next; 0: the same for all
    py::ssize_t column; // bytes from one component to the next
    bool has_columns() const { return row == static_cast<py::ssize_t>(sizeof(float)); }
    float at(std::size_t point, int component) const {
        float value;
        std::memcpy(&value, data + static_cast<py::ssize_t>(point) * row + component * column, sizeof value);
        return value;
    }
};

Vectors vectors_of(const Floats& array) {
    return {static_cast<const char*>(static_cast<const void*>(array.data())), array.ndim() == 1 ? 0 : array.strides(0),
            array.strides(array.ndim() - 1)};
}

// Copies a piece into columns, or points to it.
void take(const Vectors& vectors, std::size_t begin, std::size_t size, float* room, std::size_t piece,
          const float* (&columns)[3]) {
    for (int component = 0; component < 3; ++component) {
        if (vectors.has_columns()) {
            const char* const at =
                vectors.data + static_cast<py::ssize_t>(begin * sizeof(float)) + component * vectors.column;
            columns[component] = static_cast<const float*>(static_cast<const void*>(at));
            continue;
        }
        float* const to = room + static_cast<std::size_t>(component) * piece;
        for (std::size_t i = 0; i < size; ++i)
            to[i] = vectors.at(begin + i, component);
        columns[component] = to;
    }
}

// Makes normals of any length unit ones; those that are, stay where they are.
void make_unit(std::size_t size, float* room, std::size_t piece, const float* (&columns)[3]) {
    int others = 0;
    for (std::size_t i = 0; i < size; ++i) {
        const float square =
            columns[0][i] * columns[0][i] + columns[1][i] * columns[1][i] + columns[2][i] * columns[2][i];
        others += std::abs(square - 1.0F) <= 1e-5F ? 0 : 1; // NaN is another
    }
    if (others == 0) return;
    for (std::size_t i = 0; i < size; ++i) {
        const std::optional<glm::dvec3> unit = unit_vector({columns[0][i], columns[1][i], columns[2][i]});
        if (!unit) throw Failed{fail("USE0105", "a normal must be finite and longer than 0").value()};
        for (int component = 0; component < 3; ++component)
            room[static_cast<std::size_t>(component) * piece + i] = static_cast<float>((*unit)[component]);
    }
    for (int component = 0; component < 3; ++component)
        columns[component] = room + static_cast<std::size_t>(component) * piece;
}

// In packs of floats, one piece after the other and on all threads.
Floats in_packs(const std::vector<Light>& lights, const Floats& positions, const Floats& normals, unsigned threads) {
    const auto count = static_cast<std::size_t>(positions.size()) / 3;
    Floats result(static_cast<py::ssize_t>(count));
    float* const lx = result.mutable_data();
    const Vectors places = vectors_of(positions);
    const Vectors ways = vectors_of(normals);
    const shading::Kernels& kernels = shading::kernels(simd::best_available());
    constexpr std::size_t piece = 4096;
    interruptible([&] {
        parallel_for((count + piece - 1) / piece, threads, [&](std::size_t index) {
            const std::size_t begin = index * piece;
            const std::size_t size = std::min(piece, count - begin);
            const auto rooms = std::make_unique_for_overwrite<float[]>(8 * piece);
            float* const room = rooms.get();
            float* const way_room = room + 5 * piece;
            float* const share = room + 3 * piece;
            float* const intensity = room + 4 * piece;
            shading::Surfaces surfaces;
            surfaces.count = size;
            take(places, begin, size, room, piece, surfaces.position);
            take(ways, begin, size, way_room, piece, surfaces.normal);
            make_unit(size, way_room, piece, surfaces.normal);
            std::fill_n(lx + begin, size, 0.0F);
            for (const Light& light : lights) {
                shading::LightConstants constants = light_constants(light);
                double scale = light.luminance.value;
                if (constants.kind == shading::LightConstants::Kind::punctual) {
                    for (std::size_t i = 0; i < size; ++i) {
                        const glm::dvec3 at(surfaces.position[0][i], surfaces.position[1][i], surfaces.position[2][i]);
                        intensity[i] = static_cast<float>(light.intensity_towards(at - light.frame.origin).value);
                    }
                    constants.intensity_cd = intensity;
                    scale = 1.0;
                }
                kernels.irradiance(surfaces, constants, share);
                for (std::size_t i = 0; i < size; ++i)
                    lx[begin + i] += static_cast<float>(scale) * share[i];
            }
        });
        return true;
    });
    return result;
}

// Both float32, of shape (n, 3) or one normal (3) for all, by exact closed forms of simple lights.
bool fits_packs(const std::vector<Light>& lights, const py::array& positions, const py::array& normals) {
    const auto is_float = [](const py::array& array) { return py::isinstance<py::array_t<float, 0>>(array); };
    return is_float(positions) && is_float(normals) && positions.ndim() == 2 && positions.shape(1) == 3 &&
           (normals.ndim() == 1 || (normals.ndim() == 2 && normals.shape(0) == positions.shape(0))) &&
           normals.shape(normals.ndim() - 1) == 3 && std::all_of(lights.begin(), lights.end(), is_simple);
}

py::array as_array(const py::object& numbers) {
    const py::array array = py::array::ensure(numbers);
    if (!array) throw py::error_already_set();
    return array;
}

py::object illuminance(const py::object& of, const py::object& at, const py::object& facing, const std::string& method,
                       unsigned threads) {
    const std::vector<Light> lights = lights_of(of);
    const py::array positions = as_array(at);
    const py::array normals = as_array(facing);
    if (method == "exact" && fits_packs(lights, positions, normals))
        return in_packs(lights, positions, normals, threads);
    const Doubles places(positions);
    const Doubles ways(normals);
    ProbeOptions options;
    options.method = value_of(parse_irradiance_method(method));
    options.threads = threads;
    ProbeResult result = probed(lights, receivers_of(places, ways), options);
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

py::object luminance(const py::object& of, const Doubles& positions, const Doubles& normals, const py::object& eye,
                     const std::string& material, const std::string& method, unsigned threads) {
    const std::vector<Light> lights = lights_of(of);
    ProbeOptions options;
    options.method = value_of(parse_irradiance_method(method));
    options.threads = threads;
    options.view = ProbeView{{0.0, 0.0, 1.0}, value_of(parse_material(material)), vector_of(eye, "eye")};
    const ProbeResult result = probed(lights, receivers_of(positions, normals), options);
    Doubles values(shape_of_result(positions, normals));
    for (py::ssize_t i = 0; i < values.size(); ++i)
        values.mutable_data()[i] = result.luminance[static_cast<std::size_t>(i)].total().value;
    return number_or_array(values);
}

} // namespace

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
             "Light('sphere:r=3cm', '800lm', color='2700K', position=(0, 0, 2.5)): the texts are those of the tool.\n"
             "`direction` is where it emits, C90 of a profile points `up`, `rotate_deg` turns it about its direction "
             "[°].")
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
        .def("intensity_towards", &intensity_towards, py::arg("directions"),
             "Intensity [cd] towards directions (…, 3) of the world, from the light to the receiver, as from far away.")
        .def("__repr__", [](const Light& l) {
            return "<gonio.Light " + std::string(kind_of(l.shape)) + (l.name.empty() ? "" : " '" + l.name + "'") + ">";
        });

    module.def(
        "illuminance", &illuminance, py::arg("lights"), py::arg("positions"), py::arg("normals"), py::kw_only(),
        py::arg("method") = "exact", py::arg("threads") = 0,
        "Illuminance [lx] at positions (…, 3) [m] with normals (…, 3), which are broadcast, of a light, a list of\n"
        "lights or a rig together. Closed forms with exact clipping at the horizon, in double; nothing occludes.\n"
        "Arrays of float32 (n, 3) and unit normals (n, 3) or (3) run on the vector units and give float32; they\n"
        "are read in place if each column is contiguous (order='F'). `threads` 0: all.");
    module.def("illuminance_of_each", &illuminance_of_each, py::arg("lights"), py::arg("positions"), py::arg("normals"),
               py::kw_only(), py::arg("method") = "exact", py::arg("threads") = 0,
               "The same with the share of each light in the last axis [lx] (…, lights).");
    module.def("luminance", &luminance, py::arg("lights"), py::arg("positions"), py::arg("normals"), py::kw_only(),
               py::arg("eye"), py::arg("material") = "lambert:albedo=0.5", py::arg("method") = "exact",
               py::arg("threads") = 0,
               "Luminance [cd/m²] of a material at positions (…, 3) with normals (…, 3), seen from `eye` (3) [m].");
    module.def(
        "irradiance_methods",
        [] {
            std::vector<std::string> names;
            for (const IrradianceMethodName& known : irradiance_methods())
                names.emplace_back(known.name);
            return names;
        },
        "The names of the methods: 'exact', 'reference', those of engines.");
}

} // namespace gonio::python
