// Units: photometric values of a shape, from one quantity to another, and in the numbers of other programs.
#include <gonio/base/unit_text.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/light/policy.hpp>
#include <gonio/light/shape.hpp>
#include <gonio/scene/surface_emission.hpp>

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
        : from_(from), to_(value_of(parse_photometric_unit(to))), surface_(value_of(parse_surface_size(shape))) {
        const Policy& program = *value_of(find_policy(policy));
        if (surface_) {
            if (&program != &policies().front())
                throw Failed{fail("USE0107", "a surface that emits has no policy of another program").value()};
            return;
        }
        const Shape loaded = loaded_shape(shape);
        meaning_ = value_of(policy_meaning(program, loaded, from.unit->dimension));
        if (!same_quantity(from_, to_)) photometry_ = value_of(ShapePhotometry::of(loaded));
    }

    double operator()(double number, ConversionSteps* steps = nullptr) const {
        if (surface_) {
            const Nits luminance = value_of(emitted_luminance(*surface_, {number, from_}, steps));
            return value_of(express_emission(*surface_, luminance, to_, steps));
        }
        const PhotometricValue value = physical_value(meaning_, {number, from_});
        if (!photometry_) return value_of(convert_unit(value, to_, steps));
        const Emission emission = value_of(photometry_->emission_of(value, steps));
        return value_of(photometry_->express(emission, to_, steps));
    }

private:
    PhotometricUnit from_;
    PhotometricUnit to_;
    std::optional<Primitive> surface_; // a box, panel or capsule of a stage
    PolicyMeaning meaning_;
    mutable std::optional<ShapePhotometry> photometry_; // it integrates a flux when one is first needed
};

// The same lamp in another shape.
double convert_to_shape(const std::string& value, const std::string& to, const std::string& shape,
                        const std::string& to_shape) {
    const Shape from = loaded_shape(shape);
    const Shape into = loaded_shape(to_shape);
    const Emission emission = value_of(emission_of(from, value_of(parse_photometric_value(value))));
    return value_of(
        express(into, value_of(with_same_flux(from, emission, into)), value_of(parse_photometric_unit(to))));
}

// What to enter in a program, which may have another lobe.
double program_number(const std::string& value, const std::string& unit, const std::string& policy_name,
                      const std::string& shape) {
    const Policy& policy = *value_of(find_policy(policy_name));
    const ProgramShape shown = program_shape(policy, loaded_shape(shape));
    const PhotometricUnit to = value_of(parse_photometric_unit(unit));
    const PolicyMeaning meaning = value_of(policy_meaning(policy, shown.shape, to.unit->dimension));
    const PhotometricValue amount = value_of(parse_photometric_value(value));
    const double physical = same_quantity(amount.unit, to)
                                ? value_of(convert_unit(amount, to))
                                : value_of(express(shown.shape, value_of(emission_of(shown.shape, amount)), to));
    return policy_number(meaning, to, physical);
}

py::object convert_numbers(const Doubles& numbers, const std::string& from, const std::string& to,
                           const std::string& shape, const std::string& policy) {
    const Conversion conversion(value_of(parse_photometric_unit(from)), to, shape, policy);
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
        "convert",
        [](const std::string& value, const std::string& to, const std::string& shape, const std::string& policy,
           const std::optional<std::string>& to_shape) {
            if (!to_shape) return convert_text(value, to, shape, policy);
            if (policy != policies().front().name)
                throw Failed{fail("USE0107", "a value of another program has one shape", "leave to_shape out").value()};
            return convert_to_shape(value, to, shape, *to_shape);
        },
        py::arg("value"), py::arg("to"), py::kw_only(), py::arg("shape") = "point", py::arg("policy") = "physical",
        py::arg("to_shape") = py::none(),
        "A value with its unit in another unit, for the shape of the light: convert('800lm', 'nt',\n"
        "shape='sphere:r=3cm'). Units: lm, cd, lx@DISTANCE, nt, ev, evlx@DISTANCE, fc@DISTANCE, fL, W@EFFICACY.\n"
        "`policy` reads the value as another program does; `to_shape` is the same lamp, of the same flux, in another\n"
        "shape. Surfaces that emit are shapes too: 'box:w=20cm,h=10cm,d=5cm', 'panel:w=1m,h=50cm', 'capsule:r=2cm,\n"
        "l=30cm'.");
    module.def("program_number", &program_number, py::arg("value"), py::arg("unit"), py::kw_only(), py::arg("policy"),
               py::arg("shape") = "point",
               "The number to enter in a program of policies(), in its unit, so that it emits `value`.");
    module.def(
        "units",
        [] {
            std::vector<std::tuple<std::string, std::string, std::string>> rows;
            for (const Unit& unit : all_units())
                rows.emplace_back(unit.symbol, unit.name, dimension_name(unit.dimension));
            return rows;
        },
        "All units that texts may have, as (symbol, name, dimension).");
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
        "policies", [] { return names_of(gonio::policies()); },
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
