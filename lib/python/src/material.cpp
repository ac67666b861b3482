// Materials: reflectances over arrays of directions.
#include <gonio/scene/core_material.hpp>
#include <gonio/scene/directional_albedo.hpp>
#include <gonio/scene/material.hpp>
#include <gonio/scene/probe.hpp>

#include "binding.hpp"
#include "packs.hpp"
#include "short_call.hpp"

#include <algorithm>
#include <pybind11/stl.h>

namespace gonio::python {

namespace {

using Vector = shading::vec3<double>;

// A direction of any length; fails (usage) on one without.
Vector unit_of(const double* numbers) {
    const std::optional<glm::dvec3> unit = unit_vector({numbers[0], numbers[1], numbers[2]});
    if (!unit) throw Failed{fail("USE0105", "a direction must be finite and longer than 0").value()};
    return {unit->x, unit->y, unit->z};
}

Doubles evaluate(const Material& material, const Doubles& to_light, const Doubles& to_eye) {
    require_vectors(to_light, "to_light");
    require_vectors(to_eye, "to_eye");
    const auto [lights, eyes] = broadcast(to_light, to_eye);
    Doubles result = like(lights);
    const double* light = lights.data();
    const double* eye = eyes.data();
    double* to = result.mutable_data();
    const CoreMaterial core = core_material(material);
    const py::ssize_t count = result.size() / 3;
    const py::gil_scoped_release released;
    std::visit(
        [&](const auto& kind) {
            for (py::ssize_t i = 0; i < count; ++i, light += 3, eye += 3, to += 3) {
                const Vector value = brdf(kind, Vector{0.0, 0.0, 1.0}, unit_of(light), unit_of(eye));
                to[0] = value.x;
                to[1] = value.y;
                to[2] = value.z;
            }
        },
        core);
    return result;
}

// The result lies as the longer array does.
Floats in_packs(const Material& material, const Floats& to_light, const Floats& to_eye, unsigned threads) {
    const Floats& longer = to_light.ndim() == 2 ? to_light : to_eye;
    const py::ssize_t count = longer.shape(0);
    const bool by_columns = vectors_of(longer).are_columns() && count > 1;
    constexpr auto size_of_float = static_cast<py::ssize_t>(sizeof(float));
    const std::vector<py::ssize_t> strides = by_columns ? std::vector<py::ssize_t>{size_of_float, count * size_of_float}
                                                        : std::vector<py::ssize_t>{3 * size_of_float, size_of_float};
    Floats result(std::vector<py::ssize_t>{count, 3}, strides);
    const WaysOfLight ways{vectors_of(to_light), vectors_of(to_eye), static_cast<std::size_t>(count)};
    float* const rgb = result.mutable_data();
    short_or_interruptible(ways.count, [&] { reflectance_in_packs(material, ways, by_columns, threads, rgb); });
    return result;
}

py::object reflectance(const Material& material, const py::object& to_light, const py::object& to_eye,
                       unsigned threads) {
    const py::array lights = as_array(to_light);
    const py::array eyes = as_array(to_eye);
    if (is_float_vectors(lights) && is_float_vectors(eyes) && std::max(lights.ndim(), eyes.ndim()) == 2 &&
        (lights.ndim() == 1 || eyes.ndim() == 1 || lights.shape(0) == eyes.shape(0)))
        return in_packs(material, lights, eyes, threads);
    return evaluate(material, Doubles(lights), Doubles(eyes));
}

Doubles albedo(const Material& material, const Doubles& cosines) {
    std::vector<py::ssize_t> shape(cosines.shape(), cosines.shape() + cosines.ndim());
    shape.push_back(3);
    Doubles result(shape);
    const double* const cosine = cosines.data();
    double* to = result.mutable_data();
    const py::ssize_t count = cosines.size();
    const py::gil_scoped_release released;
    const DirectionalAlbedo of(core_material(material));
    for (py::ssize_t i = 0; i < count; ++i, to += 3) {
        const glm::dvec3 value = of(cosine[i]);
        for (int channel = 0; channel < 3; ++channel)
            to[channel] = value[channel];
    }
    return result;
}

} // namespace

void add_materials(py::module_& module) {
    struct Bound {
        std::string text;
        Material material;
    };
    py::class_<Bound>(
        module, "Material",
        "How a surface reflects light, by name and parameters: Material('ue4:roughness=0.4,metallic=1').\n"
        "Directions are in the surface's frame: its normal is +Z. They point away from it, at any length.")
        .def(py::init([](const std::string& text) {
                 return Bound{text, value_of(parse_material(text))};
             }),
             py::arg("text"), "A material from the text that the tool takes.")
        .def(
            "brdf",
            [](const Bound& of, const py::object& light, const py::object& eye, unsigned threads) {
                return reflectance(of.material, light, eye, threads);
            },
            py::arg("to_light"), py::arg("to_eye"), py::kw_only(), py::arg("threads") = 0,
            "The reflectance [1/sr] (…, 3) of the three channels for directions (…, 3), which are broadcast; 0 below\n"
            "the surface. Arrays of float32 (n, 3), of which one may be (3), run on the vector units and give float32\n"
            "in the order of the array; others are computed in double.")
        .def(
            "albedo", [](const Bound& of, const Doubles& cosines) { return albedo(of.material, cosines); },
            py::arg("cosine"),
            "The share of a uniform sky that is reflected (…, 3) towards an eye at this cosine to the normal.")
        .def("__str__", [](const Bound& of) { return of.text; })
        .def("__repr__", [](const Bound& of) { return "<gonio.Material " + of.text + ">"; });
    module.def(
        "coat_orders", [] { return summaries_of(gonio::coat_orders()); },
        "How a clear coat attenuates what is below it: the names of the orders, each with a summary.");
    module.def(
        "materials",
        [] {
            std::vector<std::pair<std::string, std::string>> kinds;
            for (const MaterialKind& kind : material_kinds())
                kinds.emplace_back(kind.grammar, kind.summary);
            return kinds;
        },
        "The grammar of the materials, each with a summary.");
}

} // namespace gonio::python
