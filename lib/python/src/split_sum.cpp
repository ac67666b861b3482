// The split sum: what glossy surfaces reflect of uniform light, and its table.
#include <gonio/ibl/roughness_mapping.hpp>
#include <gonio/ibl/split_sum.hpp>
#include <gonio/ibl/split_sum_table.hpp>

#include "binding.hpp"

#include <pybind11/stl.h>

namespace gonio::python {

namespace {

void require_range(double value, double low, double high, const char* what) {
    if (!(value >= low && value <= high)) throw Failed{fail("USE0106", std::string(what)).value()};
}

// (…, 3): scale, bias and diffuse for numbers that are broadcast.
template<class Work>
Doubles sums_of(const Doubles& n_dot_v, const Doubles& roughness, const Work& work) {
    const auto [cosines, widths] = broadcast(n_dot_v, roughness);
    std::vector<py::ssize_t> shape(cosines.shape(), cosines.shape() + cosines.ndim());
    shape.push_back(3);
    Doubles result(shape);
    double* to = result.mutable_data();
    for (py::ssize_t i = 0; i < cosines.size(); ++i) {
        require_range(cosines.data()[i], 0.0, 1.0, "n_dot_v must be in 0…1");
        require_range(widths.data()[i], 0.0, 1.0, "roughness must be in 0…1");
    }
    const py::gil_scoped_release released;
    for (py::ssize_t i = 0; i < cosines.size(); ++i, to += 3) {
        const SplitSum sum = work(cosines.data()[i], widths.data()[i]);
        to[0] = sum.scale;
        to[1] = sum.bias;
        to[2] = sum.diffuse;
    }
    return result;
}

// A number for each of an array.
template<class Work>
py::object each_number(const Doubles& numbers, const char* what, const Work& work) {
    Doubles result = like(numbers);
    for (py::ssize_t i = 0; i < numbers.size(); ++i) {
        require_range(numbers.data()[i], 0.0, 1.0, what);
        result.mutable_data()[i] = work(numbers.data()[i]);
    }
    return number_or_array(result);
}

py::object specular_albedo_of(const Doubles& f0, double n_dot_v, double roughness, const std::string& model_name,
                              const std::string& scheme_name) {
    const SplitSumModel model = value_of(parse_split_sum_model(model_name));
    const MultipleScattering scheme = value_of(parse_multiple_scattering(scheme_name));
    require_range(n_dot_v, 1e-6, 1.0, "n_dot_v must be above 0, at most 1");
    require_range(roughness, 0.0, 1.0, "roughness must be in 0…1");
    const SplitSum sum = split_sum(n_dot_v, roughness, model);
    const double mean = mean_albedo(roughness, model);
    return each_number(f0, "f0 must be in 0…1", [&](double f) { return specular_albedo(f, sum, mean, scheme); });
}

} // namespace

void add_split_sums(py::module_& module) {
    py::class_<SplitSumTable>(module, "SplitSumTable", "The split sum as a table, as engines look it up.")
        .def(py::init([](int size, const std::string& model, unsigned threads) {
                 const SplitSumModel of = value_of(parse_split_sum_model(model));
                 return value_of(interruptible([&] { return SplitSumTable::create(size, of, threads); }));
             }),
             py::arg("size") = 128, py::arg("model") = "ggx", py::kw_only(), py::arg("threads") = 0,
             "A table of size × size texels, 2 to 1024, of a model of split_sum_models().")
        .def_property_readonly(
            "image", [](const py::object& self) { return view_of(self, self.cast<const SplitSumTable&>().image()); },
            "Scale, bias and diffuse (size, size, 3), float32, a view. Row j is the roughness (j + ½)/size, column i "
            "is\n"
            "n·v = (i + ½)/size.")
        .def(
            "__array__",
            [](const py::object& self, const py::object& type) {
                return type.is_none() ? self.attr("image") : self.attr("image").attr("astype")(type);
            },
            py::arg("dtype") = py::none())
        .def_property_readonly("size", &SplitSumTable::size, "Texels a side.")
        .def_property_readonly(
            "model", [](const SplitSumTable& t) { return info_of(t.model()).name; }, "Its model's name.")
        .def(
            "lookup",
            [](const SplitSumTable& t, const Doubles& n_dot_v, const Doubles& roughness) {
                return sums_of(n_dot_v, roughness, [&](double c, double r) { return t.lookup(c, r); });
            },
            py::arg("n_dot_v"), py::arg("roughness"),
            "Scale, bias and diffuse (…, 3) by bilinear lookup at numbers in 0…1, which are broadcast.")
        .def(
            "mean_albedo",
            [](const SplitSumTable& t, const Doubles& roughness) {
                return each_number(roughness, "roughness must be in 0…1", [&](double r) { return t.mean_albedo(r); });
            },
            py::arg("roughness"), "The share of uniform light that is reflected at F = 1, over all views.")
        .def(
            "lookup_error",
            [](const SplitSumTable& t, int stride, unsigned threads) {
                if (stride < 1) throw Failed{fail("USE0106", "stride must be at least 1").value()};
                return interruptible([&] { return t.lookup_error(stride, threads); });
            },
            py::arg("stride") = 1, py::kw_only(), py::arg("threads") = 0,
            "The greatest error of a lookup between texels, at every `stride`-th of them.")
        .def("_repr_png_",
             [](const py::object& self) {
                 return py::module_::import("gonio._png").attr("srgb_png")(self.attr("image"));
             })
        .def("__repr__", [](const SplitSumTable& t) {
            return "<gonio.SplitSumTable " + std::string(info_of(t.model()).name) + ", " + std::to_string(t.size()) +
                   " × " + std::to_string(t.size()) + ">";
        });

    module.def(
        "split_sum",
        [](const Doubles& n_dot_v, const Doubles& roughness, const std::string& model) {
            const SplitSumModel of = value_of(parse_split_sum_model(model));
            return sums_of(n_dot_v, roughness, [&](double c, double r) { return split_sum(c, r, of); });
        },
        py::arg("n_dot_v"), py::arg("roughness"), py::kw_only(), py::arg("model") = "ggx",
        "Scale A, bias B and diffuse (…, 3): a glossy surface reflects A F0 + B F90 of uniform light. For n·v in 0…1\n"
        "(NaN at 0) and linear roughnesses in 0…1, which are broadcast; by quadrature to 1e-7.");
    module.def(
        "mean_albedo",
        [](const Doubles& roughness, const std::string& model) {
            const SplitSumModel of = value_of(parse_split_sum_model(model));
            return each_number(roughness, "roughness must be in 0…1", [&](double r) { return mean_albedo(r, of); });
        },
        py::arg("roughness"), py::kw_only(), py::arg("model") = "ggx",
        "The share of uniform light that is reflected at F = 1, over all views, scattered once.");
    module.def(
        "specular_albedo", &specular_albedo_of, py::arg("f0"), py::kw_only(), py::arg("n_dot_v"), py::arg("roughness"),
        py::arg("model") = "ggx", py::arg("multiple_scattering") = "none",
        "What a surface with these F0 (…) and F90 = 1 reflects of uniform light, with light that is scattered more\n"
        "than once as one of multiple_scattering_schemes() has it.");
    module.def(
        "level_of_roughness",
        [](const Doubles& roughness, int last, const std::string& mapping) {
            const RoughnessMapping of = value_of(parse_roughness_mapping(mapping));
            if (last < 0) throw Failed{fail("USE0106", "last must be at least 0").value()};
            return each_number(roughness, "roughness must be in 0…1", [&](double r) { return level_of(of, r, last); });
        },
        py::arg("roughness"), py::arg("last"), py::kw_only(), py::arg("mapping") = "linear",
        "The level, 0 to `last`, in which a program looks up a linear roughness.");
    module.def(
        "roughness_of_level",
        [](const Doubles& level, int last, const std::string& mapping) {
            const RoughnessMapping of = value_of(parse_roughness_mapping(mapping));
            Doubles result = like(level);
            for (py::ssize_t i = 0; i < level.size(); ++i) {
                require_range(level.data()[i], 0.0, last, "a level must be in 0…last");
                result.mutable_data()[i] = roughness_of(of, level.data()[i], last);
            }
            return number_or_array(result);
        },
        py::arg("level"), py::arg("last"), py::kw_only(), py::arg("mapping") = "linear",
        "The linear roughness that a level, 0 to `last`, holds.");
    module.def(
        "split_sum_models", [] { return summaries_of(split_sum_models()); },
        "The models of the split sum, each with a summary.");
    module.def(
        "multiple_scattering_schemes", [] { return summaries_of(multiple_scattering_schemes()); },
        "The schemes for light that is scattered more than once, each with a summary.");
    module.def(
        "roughness_mappings",
        [] {
            std::vector<std::pair<std::string, std::string>> rows;
            for (const RoughnessMappingInfo& row : roughness_mappings())
                rows.emplace_back(row.name, row.formula);
            return rows;
        },
        "Which level holds which roughness: the names of the mappings, each with its formula.");
}

} // namespace gonio::python
