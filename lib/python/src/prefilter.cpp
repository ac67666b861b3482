// Image-based lighting: prefiltered environments and spherical harmonics.
#include <gonio/ibl/environment_tree.hpp>
#include <gonio/ibl/irradiance_sh.hpp>
#include <gonio/ibl/parallax.hpp>
#include <gonio/ibl/prefilter.hpp>
#include <gonio/ibl/prefilter_error.hpp>
#include <gonio/ibl/prefilter_methods.hpp>
#include <gonio/ibl/prefilter_variant.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/sky/environment_resample.hpp>

#include "sky_types.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <pybind11/stl.h>

namespace gonio::python {

namespace {

PrefilteredEnvironment prefiltered_as(const Environment& source, const std::string& variant_name,
                                      const std::string& layout_name, std::optional<int> side,
                                      std::optional<int> levels, double tolerance, unsigned threads) {
    const PrefilterVariant& variant = *value_of(parse_prefilter_variant(variant_name));
    PrefilterOptions options;
    options.layout = value_of(parse_environment_layout(layout_name));
    options.side = side ? *side : side_like(EnvironmentLayout::cube_strip, variant.side, options.layout);
    const bool is_cube =
        options.layout != EnvironmentLayout::latlong && options.layout != EnvironmentLayout::octahedral;
    options.levels = levels ? *levels : levels_of(variant, options.side, is_cube ? 1 : 2);
    options.mapping = variant.mapping;
    options.tolerance = tolerance;
    options.threads = threads;
    value_of(check_levels(options)); // before the work
    return value_of(interruptible([&] { return prefilter(*source.map, options); }));
}

// A roughness for each direction; (…, 3) from directions and roughnesses, which are broadcast.
struct Lobes {
    std::vector<LobeQuery> queries;
    std::vector<py::ssize_t> shape;
};

Lobes lobes_of(const Doubles& directions, const Doubles& roughness, double least) {
    require_vectors(directions, "directions");
    const Doubles with_axis(py::object(roughness.attr("__getitem__")(py::make_tuple(py::ellipsis(), py::none()))));
    const auto [ways, widths] = broadcast(directions, with_axis);
    Lobes lobes{{}, {ways.shape(), ways.shape() + ways.ndim()}};
    lobes.queries.resize(static_cast<std::size_t>(ways.size()) / 3);
    const double* way = ways.data();
    const double* width = widths.data();
    for (LobeQuery& query : lobes.queries) {
        if (!(*width >= least && *width <= 1.0))
            throw Failed{fail("USE0106",
                              least > 0.0 ? "a lobe has a roughness above 0, at most 1" : "a roughness must be in 0…1")
                             .value()};
        query = {direction_of_length({way[0], way[1], way[2]}, "a direction"), *width};
        way += 3;
        width += 3;
    }
    return lobes;
}

Doubles to_array_of(const std::vector<glm::dvec3>& values, const std::vector<py::ssize_t>& shape) {
    Doubles result(shape);
    double* to = result.mutable_data();
    for (const glm::dvec3& value : values)
        for (int channel = 0; channel < 3; ++channel)
            *to++ = value[channel];
    return result;
}

Doubles lobe_radiance(const Environment& source, const Doubles& directions, const Doubles& roughness,
                      const std::string& method, int samples, double tolerance, unsigned threads) {
    const Lobes lobes = lobes_of(directions, roughness, GgxLobe::least_roughness);
    if (samples < 1) throw Failed{fail("USE0106", "samples must be at least 1").value()};
    const auto each = [&](const auto& value) {
        std::vector<glm::dvec3> all;
        all.reserve(lobes.queries.size());
        for (const LobeQuery& query : lobes.queries)
            all.push_back(value(query));
        return all;
    };
    const EnvironmentMap& map = *source.map;
    std::vector<glm::dvec3> values;
    if (method == "tree")
        values = interruptible([&] {
            const EnvironmentTree tree(map, threads);
            return each([&](const LobeQuery& q) { return tree.mean(GgxLobe(q.roughness), q.direction, tolerance); });
        });
    else if (method == "quadrature")
        values = interruptible([&] { return prefiltered_by_quadrature(map, lobes.queries, threads); });
    else if (method == "samples")
        values = interruptible(
            [&] { return each([&](const LobeQuery& q) { return prefiltered_by_samples(map, q, samples); }); });
    else if (method == "filtered-samples")
        values = interruptible([&] {
            const EnvironmentMips mips(map, threads);
            return each([&](const LobeQuery& q) { return prefiltered_by_filtered_samples(mips, q, samples); });
        });
    else
        throw Failed{
            fail("USE0103", "unknown method '" + method + "'", "there are: tree, quadrature, samples, filtered-samples")
                .value()};
    return to_array_of(values, lobes.shape);
}

// (n, 3) of a list of colours.
Doubles rows_of(std::span<const glm::dvec3> colors) {
    return to_array_of({colors.begin(), colors.end()}, {static_cast<py::ssize_t>(colors.size()), 3});
}

IrradianceSh harmonics_of_array(const Doubles& radiance) {
    const bool fits = radiance.ndim() == 2 && radiance.shape(1) == 3;
    const double order = fits ? std::sqrt(static_cast<double>(radiance.shape(0))) - 1.0 : -1.0;
    if (order != std::floor(order) || order < 0.0 || order > most_sh_order)
        throw Failed{fail("USE0105", "radiance must be ((order + 1)², 3) coefficients of an order up to 3").value()};
    std::vector<glm::dvec3> list;
    for (py::ssize_t i = 0; i < radiance.shape(0); ++i)
        list.emplace_back(radiance.at(i, 0), radiance.at(i, 1), radiance.at(i, 2));
    return IrradianceSh(std::move(list));
}

Doubles harmonics_at(const Doubles& directions) {
    require_vectors(directions, "directions");
    std::vector<py::ssize_t> shape = shape_of_vectors(directions);
    shape.push_back(16);
    Doubles result(shape);
    const double* from = directions.data();
    double* to = result.mutable_data();
    for (py::ssize_t i = 0; i < directions.size() / 3; ++i, from += 3) {
        const auto values = spherical_harmonics(direction_of_length({from[0], from[1], from[2]}, "a direction"));
        to = std::copy(values.begin(), values.end(), to);
    }
    return result;
}

Doubles parallax(const Doubles& directions, const py::object& position, const py::object& captured_at,
                 const std::optional<py::object>& low, const std::optional<py::object>& high,
                 const std::optional<py::object>& center, std::optional<double> radius_m) {
    const glm::dvec3 from = vector_of(position, "position");
    const glm::dvec3 at = vector_of(captured_at, "captured_at");
    const bool is_box = low && high && !center && !radius_m;
    const bool is_sphere = center && radius_m && !low && !high;
    if (!is_box && !is_sphere)
        throw Failed{fail("USE0104", "the body around the capture is a box of low and high, or a sphere of center and "
                                     "radius_m")
                         .value()};
    const auto corrected = [&](const auto& body) {
        return for_each_vector_rgb(directions, "directions", [&](const glm::dvec3& way) {
            return parallax_corrected(body, at, from, way / glm::length(way));
        });
    };
    if (is_sphere) return corrected(ParallaxSphere{vector_of(*center, "center"), *radius_m});
    return corrected(ParallaxBox{vector_of(*low, "low"), vector_of(*high, "high")});
}

} // namespace

void add_prefiltering(py::module_& module) {
    py::class_<PrefilterError>(module, "PrefilterError", "The error of a prefiltered level, against quadrature.")
        .def_readonly("mean_nt", &PrefilterError::mean_nt, "Luminance of the level at the texels checked [cd/m²].")
        .def_readonly("rms", &PrefilterError::rms, "Root mean square of all channels, over that mean.")
        .def_readonly("greatest", &PrefilterError::greatest, "The greatest, over that mean.")
        .def_readonly("texels", &PrefilterError::texels, "How many were checked; 0 for a level of roughness 0.");

    py::class_<PrefilteredEnvironment>(module, "PrefilteredEnvironment",
                                       "What a glossy surface of each roughness mirrors, one image per level.")
        .def_property_readonly(
            "levels",
            [](const PrefilteredEnvironment& p) {
                std::vector<Environment> levels;
                for (const PrefilteredLevel& level : p.levels())
                    levels.push_back(python::environment_of(EnvironmentMap(level.map)));
                return levels;
            },
            "The images, the sharpest first.")
        .def_property_readonly(
            "roughness",
            [](const PrefilteredEnvironment& p) {
                Doubles all(static_cast<py::ssize_t>(p.levels().size()));
                for (std::size_t i = 0; i < p.levels().size(); ++i)
                    all.mutable_data()[i] = p.levels()[i].roughness;
                return all;
            },
            "Linear roughness of each level (n).")
        .def_property_readonly(
            "mapping", [](const PrefilteredEnvironment& p) { return info_of(p.mapping()).name; },
            "Which level holds which roughness: linear, filament, frostbite or ue4.")
        .def(
            "radiance",
            [](const PrefilteredEnvironment& p, const Doubles& directions, const Doubles& roughness) {
                const Lobes lobes = lobes_of(directions, roughness, 0.0);
                std::vector<glm::dvec3> values;
                for (const LobeQuery& lobe : lobes.queries)
                    values.push_back(p.radiance(lobe.direction, lobe.roughness));
                return to_array_of(values, lobes.shape);
            },
            py::arg("directions"), py::arg("roughness"),
            "Luminance of the three channels [cd/m²] (…, 3) for directions (…, 3) and roughnesses (…), which are\n"
            "broadcast: bilinear in a level and linear between levels, as a texture unit does it.")
        .def(
            "errors",
            [](const PrefilteredEnvironment& p, const Environment& source, int per_level, unsigned threads) {
                if (per_level < 1) throw Failed{fail("USE0106", "per_level must be at least 1").value()};
                return interruptible([&] { return prefilter_errors(*source.map, p.levels(), per_level, threads); });
            },
            py::arg("source"), py::arg("per_level") = 24, py::kw_only(), py::arg("threads") = 0,
            "The error of each level at some of its texels, against quadrature over the source.")
        .def("__repr__", [](const PrefilteredEnvironment& p) {
            return "<gonio.PrefilteredEnvironment of " + std::to_string(p.levels().size()) + " levels>";
        });

    py::class_<IrradianceSh>(
        module, "SphericalHarmonics",
        "The light of an environment in real spherical harmonics, stored at l(l + 1) + m, without the phase of Condon\n"
        "and Shortley; bands up to `order`. They give the illuminance of an open plane within a few per cent.")
        .def(py::init(&harmonics_of_array), py::arg("radiance"), "Of coefficients ((order + 1)², 3).")
        .def_property_readonly("order", &IrradianceSh::order, "The highest band, 0 to 3.")
        .def_property_readonly(
            "radiance", [](const IrradianceSh& s) { return rows_of(s.radiance()); },
            "Coefficients of the luminance ((order + 1)², 3) [cd/m²·sr^½].")
        .def_property_readonly(
            "irradiance_coefficients", [](const IrradianceSh& s) { return rows_of(s.irradiance_coefficients()); },
            "Those of the illuminance of a plane by its normal ((order + 1)², 3) [lx·sr^½].")
        .def(
            "illuminance",
            [](const IrradianceSh& s, const Doubles& normals) {
                return for_each_vector(normals, "normals", [&](const glm::dvec3& n) {
                    return glm::dot(s.irradiance(n / glm::length(n)), rec709_luminance);
                });
            },
            py::arg("normals"), "Illuminance [lx] (…) of open planes with normals (…, 3); may be negative.")
        .def_property_readonly(
            "least", [](const IrradianceSh& s) { return to_array(s.least()); },
            "The least illuminance of each channel over all normals (3) [lx]; below 0 where light comes from few\n"
            "directions.")
        .def("__repr__", [](const IrradianceSh& s) {
            return "<gonio.SphericalHarmonics of order " + std::to_string(s.order()) + ">";
        });

    const py::object environment = module.attr("Environment");
    auto& type = static_cast<py::class_<Environment>&>(const_cast<py::object&>(environment));
    type.def(
            "prefiltered", &prefiltered_as, py::arg("variant") = "linear", py::kw_only(),
            py::arg("layout") = "cube-strip", py::arg("side") = py::none(), py::arg("levels") = py::none(),
            py::arg("tolerance") = PrefilterOptions{}.tolerance, py::arg("threads") = 0,
            "What glossy surfaces mirror, as a program of prefilter_variants() looks it up. `side` is that of level 0\n"
            "(of a cube's face, the height of a latlong); each level has half of the one before.")
        .def(
            "irradiance_map",
            [](const Environment& source, const std::string& layout, int side, double tolerance, unsigned threads) {
                const EnvironmentGrid to = value_of(environment_grid(value_of(parse_environment_layout(layout)), side));
                return python::environment_of(interruptible(
                    [&] { return irradiance_map(EnvironmentTree(*source.map, threads), to, tolerance, threads); }));
            },
            py::arg("layout") = "cube-strip", py::arg("side") = 32, py::kw_only(),
            py::arg("tolerance") = PrefilterOptions{}.tolerance, py::arg("threads") = 0,
            "The luminance of a matte white surface that faces each texel: its illuminance over π [cd/m²].")
        .def("lobe_radiance", &lobe_radiance, py::arg("directions"), py::arg("roughness"), py::kw_only(),
             py::arg("method") = "tree", py::arg("samples") = 1024, py::arg("tolerance") = PrefilterOptions{}.tolerance,
             py::arg("threads") = 0,
             "The mean of the light over GGX lobes [cd/m²] (…, 3) about directions (…, 3) of roughnesses (…), which "
             "are\n"
             "broadcast, by the method tree, quadrature, samples or filtered-samples.")
        .def(
            "spherical_harmonics",
            [](const Environment& source, int order, unsigned threads) {
                if (order < 0 || order > most_sh_order) throw Failed{fail("USE0106", "order must be in 0…3").value()};
                return interruptible([&] { return irradiance_sh(*source.map, order, threads); });
            },
            py::arg("order") = 2, py::kw_only(), py::arg("threads") = 0, "Its light in bands up to `order`, 0 to 3.");

    module.def("spherical_harmonics", &harmonics_at, py::arg("directions"),
               "Y(l, m) at directions (…, 3): (…, 16), bands 0 to 3, at l(l + 1) + m.");
    module.def("cosine_factor", &cosine_factor, py::arg("band"),
               "What turns a band's luminance into illuminance: π, 2π/3, π/4, 0.");
    module.def("parallax_corrected", &parallax, py::arg("directions"), py::kw_only(), py::arg("position"),
               py::arg("captured_at"), py::arg("low") = py::none(), py::arg("high") = py::none(),
               py::arg("center") = py::none(), py::arg("radius_m") = py::none(),
               "From `captured_at` (3) to where rays from `position` (3) along directions (…, 3) leave a box with the\n"
               "corners `low` and `high` (3), or a sphere [m]: (…, 3), of any length.");
    module.def(
        "prefilter_variants", [] { return summaries_of(prefilter_variants()); },
        "The programs whose prefiltering is known, each with a summary.");
}

} // namespace gonio::python
