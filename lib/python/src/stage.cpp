// Lights on a stage: what reaches points past all that stands there, and what is seen from a point all around.
#include <gonio/preview/capture.hpp>
#include <gonio/scene/primitives.hpp>
#include <gonio/scene/probe.hpp>
#include <gonio/transport/receiver_light.hpp>

#include "light_list.hpp"
#include "rig.hpp"

#include <pybind11/stl.h>

namespace gonio::python {

namespace {

// Of each point, with the shape of the points.
struct StageIlluminance {
    py::object total, direct, sky, indirect, each;
};

struct Totals {
    std::vector<double> direct_lx;
    std::vector<double> each_lx;
    ReceiverLight::Shares shares;
    ProbeRemarks remarks;
};

Totals totals_of(const Stage& stage, const std::vector<Light>& lights, const std::vector<Receiver>& receivers,
                 const LightingOptions& options) {
    const ReceiverLight on_stage = value_of(ReceiverLight::on(stage, lights, options));
    ProbeOptions alone;
    alone.method = options.method;
    alone.threads = options.threads;
    alone.parts = true;
    ProbeResult open = value_of(probe(lights, receivers, alone));
    Totals totals{std::vector<double>(receivers.size(), 0.0), std::move(open.parts_lx), on_stage.at(receivers),
                  open.remarks};
    for (std::size_t i = 0; i < receivers.size(); ++i)
        for (std::size_t part = i * lights.size(); part < (i + 1) * lights.size(); ++part) {
            totals.each_lx[part] *= totals.shares.visible[part];
            totals.direct_lx[i] += totals.each_lx[part];
        }
    return totals;
}

Doubles array_of(const std::vector<double>& values, const std::vector<py::ssize_t>& shape) {
    Doubles array(shape);
    std::copy(values.begin(), values.end(), array.mutable_data());
    return array;
}

// What a stage is lit with beside `lights`, which get the sun of a sky that is given.
LightingOptions lighting_of(const py::object& of, const std::optional<py::object>& given_sky, int bounces,
                            const std::string& shadows, unsigned threads, std::vector<Light>& lights) {
    LightingOptions options;
    options.sky = sky_over(of, given_sky, lights).sky;
    options.bounces = bounces_of(bounces);
    options.shadows = shadows_named(shadows);
    options.threads = threads;
    return options;
}

StageIlluminance illuminance_on_stage(const py::object& of, const Doubles& positions, const Doubles& normals,
                                      const std::optional<std::string>& stage_name,
                                      const std::map<std::string, std::string>& materials,
                                      const std::optional<py::object>& given_sky, int bounces,
                                      const std::string& shadows, const std::string& method, unsigned threads) {
    std::vector<Light> lights = lights_of(of);
    const Stage stage = stage_of(of, stage_name, materials);
    LightingOptions options = lighting_of(of, given_sky, bounces, shadows, threads, lights);
    options.method = value_of(parse_irradiance_method(method));
    const std::vector<Receiver> receivers = receivers_of(positions, normals);
    warn(check_receivers(stage, receivers));
    const Totals totals = interruptible([&] { return totals_of(stage, lights, receivers, options); });
    warn(to_diagnostics(totals.remarks, lights));
    const std::vector<py::ssize_t> shape = shape_of_vectors(broadcast(positions, normals)[0]);
    std::vector<py::ssize_t> with_lights = shape;
    with_lights.push_back(static_cast<py::ssize_t>(lights.size()));
    Doubles total(shape);
    for (std::size_t i = 0; i < receivers.size(); ++i)
        total.mutable_data()[i] = totals.direct_lx[i] + totals.shares.sky_lx[i] + totals.shares.indirect_lx[i];
    return {number_or_array(total), number_or_array(array_of(totals.direct_lx, shape)),
            number_or_array(array_of(totals.shares.sky_lx, shape)),
            number_or_array(array_of(totals.shares.indirect_lx, shape)), array_of(totals.each_lx, with_lights)};
}

Environment captured(const py::object& of, const py::object& position, const std::optional<std::string>& stage_name,
                     int side, const std::map<std::string, std::string>& materials,
                     const std::optional<py::object>& given_sky, int bounces, const std::string& shadows,
                     bool shows_lights, unsigned threads) {
    std::vector<Light> lights = lights_of(of);
    const Stage stage = stage_of(of, stage_name, materials);
    RenderOptions options;
    static_cast<LightingOptions&>(options) = lighting_of(of, given_sky, bounces, shadows, threads, lights);
    options.shows_lights = shows_lights;
    const glm::dvec3 at = vector_of(position, "position");
    return python::environment_of(value_of(interruptible([&] { return capture(stage, lights, at, side, options); })));
}

// Distances along rays to the surfaces of a stage; inf where nothing is hit.
py::tuple first_hits(const py::object& stage_name, const Doubles& origins, const Doubles& directions) {
    require_vectors(origins, "origins");
    require_vectors(directions, "directions");
    const Stage stage = stage_of(
        stage_name, py::isinstance<py::str>(stage_name) ? std::optional(stage_name.cast<std::string>()) : std::nullopt,
        {});
    const auto [from, along] = broadcast(origins, directions);
    const std::vector<py::ssize_t> shape = shape_of_vectors(from);
    Doubles distances(shape);
    Doubles normals = like(from);
    py::list names;
    const double* origin = from.data();
    const double* direction = along.data();
    double* normal = normals.mutable_data();
    for (py::ssize_t i = 0; i < distances.size(); ++i, origin += 3, direction += 3, normal += 3) {
        const glm::dvec3 way = direction_of_length({direction[0], direction[1], direction[2]}, "a direction");
        const std::optional<Hit> hit = first_hit(stage, {{origin[0], origin[1], origin[2]}, way});
        distances.mutable_data()[i] = hit ? hit->distance : std::numeric_limits<double>::infinity();
        for (int k = 0; k < 3; ++k)
            normal[k] = hit ? hit->normal[k] : std::numeric_limits<double>::quiet_NaN();
        if (hit)
            names.append(stage.surfaces[hit->surface].name);
        else
            names.append(py::none());
    }
    const py::object as_array =
        py::module_::import("numpy").attr("array")(names, "dtype"_a = "object").attr("reshape")(py::cast(shape));
    return py::make_tuple(number_or_array(distances), normals, as_array);
}

} // namespace

void add_stages(py::module_& module) {
    py::class_<StageIlluminance>(module, "StageIlluminance", "The illuminance of points on a stage, in its parts.")
        .def_readonly("total", &StageIlluminance::total, "All of it [lx] (…).")
        .def_readonly("direct", &StageIlluminance::direct, "Of the lights, past what stands on the stage [lx] (…).")
        .def_readonly("sky", &StageIlluminance::sky, "Of the sky, past what stands on the stage [lx] (…).")
        .def_readonly("indirect", &StageIlluminance::indirect, "What the surfaces of the stage reflect [lx] (…).")
        .def_readonly("each", &StageIlluminance::each,
                      "Of each light directly [lx] (…, lights); the sun of a sky is the last.");

    module.def(
        "illuminance_on_stage", &illuminance_on_stage, py::arg("lights"), py::arg("positions"), py::arg("normals"),
        py::arg("stage") = py::none(), py::kw_only(), py::arg("materials") = std::map<std::string, std::string>(),
        py::arg("sky") = py::none(), py::arg("bounces") = -1, py::arg("shadows") = "soft", py::arg("method") = "exact",
        py::arg("threads") = 0,
        "Illuminance [lx] at positions (…, 3) [m] with normals (…, 3), which are broadcast, on a stage by name or "
        "that\n"
        "of the rig: with its shadows, a sky (a text, an environment or a gonio.Sky) and the light that is reflected\n"
        "between its surfaces; `bounces` −1: until all light is absorbed. As `gonio probe --indirect`.");
    module.def(
        "capture", &captured, py::arg("lights"), py::arg("position"), py::arg("stage") = py::none(), py::kw_only(),
        py::arg("side") = 256, py::arg("materials") = std::map<std::string, std::string>(), py::arg("sky") = py::none(),
        py::arg("bounces") = 0, py::arg("shadows") = "soft", py::arg("shows_lights") = true, py::arg("threads") = 0,
        "A lit stage as it looks from a position (3) [m] in all directions: a cube-strip environment with faces of\n"
        "`side` pixels [cd/m²].");
    module.def(
        "first_hit", &first_hits, py::arg("stage"), py::arg("origins"), py::arg("directions"),
        "Where rays from origins (…, 3) [m] along directions (…, 3), which are broadcast, first meet a stage, by name\n"
        "or that of a rig: distances [m] (…), inf where nothing is met; normals (…, 3), NaN there; and the names of "
        "the\n"
        "surfaces (…), None there.");
    module.def(
        "stages", [] { return summaries_of(stage_kinds()); }, "The names of the stages, each with a summary.");
}

} // namespace gonio::python
