// Rigs: the lights, the sky and the stage of a scene, from files and dicts.
#include "rig.hpp"

#include <gonio/base/named.hpp>
#include <gonio/scene/emissive_lights.hpp>
#include <gonio/scene/material_charts.hpp>

#include <algorithm>
#include <pybind11/stl.h>

namespace gonio::python {

namespace {

constexpr std::array shadow_names{Named{"off", Shadows::off}, Named{"hard", Shadows::hard},
                                  Named{"soft", Shadows::soft}};

void give(Stage& stage, const std::string& name, const Material& material) {
    const std::vector<std::string_view> known = surface_names(stage);
    if (std::find(known.begin(), known.end(), name) == known.end())
        throw Failed{unknown_name("surface", name, known, stage.name).value()};
    for (Surface& surface : stage.surfaces)
        if (surface.name == name) surface.material = material;
}

LoadedSky sky_of_rig(const Rig& rig) {
    try {
        return load_sky(*rig.sky, "of " + rig.source);
    } catch (const Failed& failed) {
        throw Failed{failed_sky(rig, failed.error).value()};
    }
}

LoadedRig load(Rig&& rig) {
    LoadedRig loaded;
    loaded.diagnostics = rig.diagnostics;
    loaded.stage = value_of(gonio::stage_of(rig));
    for (const SurfaceMaterial& given : rig.materials)
        give(loaded.stage, given.surface, given.material);
    for (const NamedEmission& emission : rig.emits)
        value_of(let_emit(loaded.stage, emission));
    if (rig.camera) loaded.stage.camera = *rig.camera;
    std::vector<LightDescription> emitting = value_of(emissive_lights(rig));
    loaded.lights = value_of(interruptible([&] { return resolve_lights(rig, loaded.diagnostics); }));
    value_of(add_resolved(std::move(emitting), loaded.lights, loaded.diagnostics));
    if (rig.sky) {
        loaded.sky = sky_of_rig(rig);
        const Diagnostics& remarks = loaded.sky->diagnostics;
        loaded.diagnostics.insert(loaded.diagnostics.end(), remarks.begin(), remarks.end());
        if (const std::optional<SunLight>& sun = loaded.sky->sky.sun()) loaded.lights.push_back(light_of(*sun, "sun"));
    }
    loaded.rig = std::move(rig);
    return loaded;
}

} // namespace

Stage stage_of(const py::object& lights, const std::optional<std::string>& name,
               const std::map<std::string, std::string>& materials) {
    Stage stage = !name && py::isinstance<LoadedRig>(lights) ? lights.cast<const LoadedRig&>().stage
                                                             : value_of(make_stage(name.value_or("floor")));
    for (const auto& [surface, text] : materials) {
        const Material material = value_of(parse_material(text));
        warn(check_charts(material));
        give(stage, surface, material);
    }
    return stage;
}

LoadedSky sky_over(const py::object& of, const std::optional<py::object>& given, std::vector<Light>& lights) {
    if (given) {
        LoadedSky sky = sky_of(*given);
        warn(sky.diagnostics);
        if (const std::optional<SunLight>& sun = sky.sky.sun()) lights.push_back(light_of(*sun, "sun"));
        return sky;
    }
    if (py::isinstance<LoadedRig>(of))
        if (const std::optional<LoadedSky>& sky = of.cast<const LoadedRig&>().sky) return *sky;
    return {};
}

Shadows shadows_named(const std::string& name) {
    return value_of(find_value("shadows", name, shadow_names));
}

int bounces_of(int number) {
    return number < 0 ? all_bounces : number;
}

void add_rigs(py::module_& module) {
    py::class_<LoadedRig>(module, "Rig",
                          "The lights of a scene, its sky and the stage that they are shown on, of schema gonio.rig/1.")
        .def_readonly("lights", &LoadedRig::lights, "Its lights, the surfaces that emit, and the sun of its sky.")
        .def_readonly("sky", &LoadedRig::sky, "Its sky; None without one.")
        .def_property_readonly(
            "stage", [](const LoadedRig& r) { return r.stage.name; }, "The name of its stage.")
        .def_property_readonly(
            "surfaces",
            [](const LoadedRig& r) {
                std::vector<std::string> names;
                for (const std::string_view name : surface_names(r.stage))
                    names.emplace_back(name);
                return names;
            },
            "The names of its stage's surfaces, which materials are given to.")
        .def_property_readonly(
            "files", [](const LoadedRig& r) { return r.rig.files; }, "The files that were read for it.")
        .def_readonly("diagnostics", &LoadedRig::diagnostics, "Warnings and notes of reading it.")
        .def("__repr__", [](const LoadedRig& r) {
            return "<gonio.Rig '" + r.rig.source + "', " + std::to_string(r.lights.size()) + " lights>";
        });
    module.def(
        "read_rig",
        [](const py::object& path, bool allow_outside) {
            return load(value_of(read_rig_file(path_of(path), {allow_outside, "allow_outside=True allows it"})));
        },
        py::arg("path"), py::kw_only(), py::arg("allow_outside") = false,
        "Reads a rig. Its files must lie under its own folder unless `allow_outside` is true.");
    module.def(
        "make_rig",
        [](const py::dict& content, const py::object& folder, bool allow_outside) {
            py::dict whole("schema"_a = "gonio.rig/1");
            whole.attr("update")(content);
            const auto text = py::module_::import("json").attr("dumps")(whole).cast<std::string>();
            return load(
                value_of(read_rig(text, "rig", path_of(folder), {allow_outside, "allow_outside=True allows it"})));
        },
        py::arg("content"), py::kw_only(), py::arg("folder") = "", py::arg("allow_outside") = false,
        "A rig from a dict with the keys of gonio.rig/1: make_rig({'lights': [{'shape': 'sphere:r=10cm', 'intensity':\n"
        "'800lm'}], 'stage': 'floor', 'sky': '500lx'}). Files are relative to `folder`.");
    module.def(
        "rig_keys",
        [] {
            const auto list = [](std::span<const std::string_view> keys) {
                return std::vector<std::string>(keys.begin(), keys.end());
            };
            return py::dict("rig"_a = list(gonio::rig_keys()), "light"_a = list(rig_light_keys()),
                            "camera"_a = list(rig_camera_keys()));
        },
        "The keys that a rig, one of its lights and its camera may have, by 'rig', 'light' and 'camera'.");
}

} // namespace gonio::python
