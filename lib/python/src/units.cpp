// Units: photometric values of a shape, from one quantity to another, and in the numbers of other programs.
#include <gonio/base/unit_text.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/light/policy.hpp>
#include <gonio/light/shape.hpp>

#include "binding.hpp"

#include <pybind11/stl.h>

namespace gonio::python {

namespace {

Shape loaded_shape(const std::string& text) {
    Shape shape = value_of(parse_shape(text));
    Diagnostics diagnostics;
    value_of(load_profile(shape, diagnostics));
    warn(diagnostics);
    return shape;
}

// A conversion, prepared once for many numbers: what they mean by a policy, then photometry.
class Conversion {
public:
    Conversion(const PhotometricUnit& from, const std::string& to, const std::string& shape, const std::string& policy)
        : from_(from),
          to_(value_of(parse_photometric_unit(to))),
          shape_(loaded_shape(shape)),
          meaning_(value_of(policy_meaning(*value_of(find_policy(policy)), shape_, from.unit->dimension))) {
        if (!same_quantity(from_, to_)) photometry_ = value_of(ShapePhotometry::of(shape_));
    }

    double operator()(double number, ConversionSteps* steps = nullptr) {
        const PhotometricValue value = physical_value(meaning_, {number, from_});
        if (!photometry_) return value_of(convert_unit(value, to_, steps));
        const Emission emission = value_of(photometry_->emission_of(value, steps));
        return value_of(photometry_->express(emission, to_, steps));
    }

private:
    PhotometricUnit from_;
    PhotometricUnit to_;
    Shape shape_;
    PolicyMeaning meaning_;
    std::optional<ShapePhotometry> photometry_;
};

py::object convert_numbers(const Doubles& numbers, const std::string& from, const std::string& to,
                           const std::string& shape, const std::string& policy) {
    Conversion conversion(value_of(parse_photometric_unit(from)), to, shape, policy);
    Doubles result = like(numbers);
    for (py::ssize_t i = 0; i < numbers.size(); ++i)
        result.mutable_data()[i] = conversion(numbers.data()[i]);
    return number_or_array(result);
}

double convert_text(const std::string& value, const std::string& to, const std::string& shape,
                    const std::string& policy) {
    const PhotometricValue from = value_of(parse_photometric_value(value));
    return Conversion(from.unit, to, shape, policy)(from.number);
}

} // namespace

void add_units(py::module_& module) {
    module.def(
        "convert", &convert_text, py::arg("value"), py::arg("to"), py::kw_only(), py::arg("shape") = "point",
        py::arg("policy") = "physical",
        "A value with its unit in another unit, for the shape of the light: convert('800lm', 'nt',\n"
        "shape='sphere:r=3cm'). Units: lm, cd, lx@DISTANCE, nt, ev, evlx@DISTANCE, fc@DISTANCE, fL, W@EFFICACY.\n"
        "`policy` reads the value as another program does.");
    module.def("convert_numbers", &convert_numbers, py::arg("numbers"), py::arg("unit"), py::arg("to"), py::kw_only(),
               py::arg("shape") = "point", py::arg("policy") = "physical",
               "The same for an array of numbers in `unit`, of any shape; the light's shape is prepared once.");
    module.def(
        "convert_steps",
        [](const std::string& value, const std::string& to, const std::string& shape, const std::string& policy) {
            const PhotometricValue from = value_of(parse_photometric_value(value));
            ConversionSteps steps;
            Conversion(from.unit, to, shape, policy)(from.number, &steps);
            std::vector<std::tuple<std::string, double, std::string>> rows;
            rows.reserve(steps.size());
            for (const ConversionStep& step : steps)
                rows.emplace_back(step.formula, step.value, step.unit);
            return rows;
        },
        py::arg("value"), py::arg("to"), py::kw_only(), py::arg("shape") = "point", py::arg("policy") = "physical",
        "The steps of a conversion as (formula, value, unit).");
    module.def(
        "light_distance_m",
        [](const std::string& value, double lux, const std::string& shape) {
            const Shape of = loaded_shape(shape);
            const Emission emission = value_of(emission_of(of, value_of(parse_photometric_value(value))));
            return value_of(distance_of(of, emission, Lux(lux))).value;
        },
        py::arg("value"), py::arg("illuminance_lx"), py::kw_only(), py::arg("shape") = "point",
        "The distance [m] from the light's centre beyond which a receiver that faces it gets less than this [lx].");
    module.def(
        "policies",
        [] {
            std::vector<std::string> names;
            for (const Policy& policy : policies())
                names.emplace_back(policy.name);
            return names;
        },
        "The names of the policies: what other programs mean by a photometric number.");
    module.def(
        "shapes",
        [] {
            std::vector<std::pair<std::string, std::string>> kinds;
            for (const ShapeKind& kind : shape_kinds())
                kinds.emplace_back(kind.grammar, kind.summary);
            return kinds;
        },
        "The grammar of the shapes of lights, each with a summary.");
}

} // namespace gonio::python
