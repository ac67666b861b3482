// Previews: lights on a stage as a picture, and rigs.
#include <gonio/base/named.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/preview/render.hpp>
#include <gonio/scene/rig.hpp>
#include <gonio/scene/stage.hpp>

#include "binding.hpp"
#include "light_list.hpp"

#include <pybind11/stl.h>

namespace gonio::python {

namespace {

constexpr std::array shadow_names{Named{"off", Shadows::off}, Named{"hard", Shadows::hard},
                                  Named{"soft", Shadows::soft}};

// A rig with its lights resolved.
struct LoadedRig {
    Rig rig;
    std::vector<Light> lights;
    Stage stage; // with the rig's materials and what its surfaces emit
    Diagnostics diagnostics;
};

LoadedRig load(Rig&& rig) {
    if (rig.sky)
        throw Failed{fail(Failure::unsupported, "a rig with a sky is not for Python yet",
                          "take its 'sky' out, or use gonio preview and gonio probe", rig.source)
                         .value()};
    LoadedRig loaded;
    loaded.diagnostics = rig.diagnostics;
    loaded.stage = value_of(stage_of(rig));
    for (const SurfaceMaterial& given : rig.materials)
        for (Surface& surface : loaded.stage.surfaces)
            if (surface.name == given.surface) surface.material = given.material;
    if (rig.camera) loaded.stage.camera = *rig.camera;
    std::vector<LightDescription> emitting = value_of(emissive_lights(rig));
    loaded.lights = value_of(resolve_lights(rig, loaded.diagnostics));
    value_of(add_resolved(std::move(emitting), loaded.lights, loaded.diagnostics));
    loaded.rig = std::move(rig);
    return loaded;
}

struct CameraView {
    std::optional<py::object> position, target;
    std::optional<double> fov_deg;
};

Rendering render_on(const Stage& stage, const std::vector<Light>& lights, std::pair<int, int> size,
                    const CameraView& view, const std::string& shadows, int bounces, const std::string& method,
                    unsigned threads) {
    Camera camera = stage.camera;
    if (view.position) camera.position = vector_of(*view.position, "camera");
    if (view.target) camera.target = vector_of(*view.target, "target");
    if (view.fov_deg) {
        camera.vertical_fov_deg = *view.fov_deg;
        camera.least_horizontal_fov_deg = 0.0;
    }
    value_of(check_camera(stage, camera));
    RenderOptions options;
    options.width = size.first;
    options.height = size.second;
    options.shadows = value_of(find_value("shadows", shadows, shadow_names));
    options.bounces = bounces < 0 ? all_bounces : bounces;
    options.method = value_of(parse_irradiance_method(method));
    options.illuminance = true;
    options.threads = threads;
    return value_of(interruptible([&] { return render(stage, lights, camera, options); }));
}

Rendering preview(const py::object& of, const std::optional<std::string>& name, std::pair<int, int> size,
                  const std::map<std::string, std::string>& materials, const std::optional<py::object>& camera,
                  const std::optional<py::object>& target, std::optional<double> fov_deg, const std::string& shadows,
                  int bounces, const std::string& method, unsigned threads) {
    Stage stage = !name && py::isinstance<LoadedRig>(of) ? of.cast<const LoadedRig&>().stage
                                                         : value_of(make_stage(name.value_or("floor")));
    for (const auto& [surface, material] : materials) {
        const std::vector<std::string_view> known = surface_names(stage);
        if (std::find(known.begin(), known.end(), surface) == known.end())
            throw Failed{unknown_name("surface", surface, known).value()};
        for (Surface& one : stage.surfaces)
            if (one.name == surface) one.material = value_of(parse_material(material));
    }
    return render_on(stage, lights_of(of), size, {camera, target, fov_deg}, shadows, bounces, method, threads);
}

// Lights without a place, as the tool puts them on a stage.
Light hung(const std::string& shape, const std::optional<std::string>& intensity, const std::string& stage) {
    Diagnostics diagnostics;
    LightDescription description;
    description.shape = value_of(parse_shape(shape));
    if (intensity) description.intensity = value_of(parse_photometric_value(*intensity));
    hang(description, value_of(make_stage(stage)).light);
    Light light = value_of(resolve_light(std::move(description), diagnostics));
    warn(diagnostics);
    return light;
}

py::array channels_of(const py::object& owner, const Image& image) {
    const std::vector<py::ssize_t> shape = image.channels == 1
                                               ? std::vector<py::ssize_t>{image.height, image.width}
                                               : std::vector<py::ssize_t>{image.height, image.width, image.channels};
    return py::array_t<float>(shape, image.pixels.data(), owner);
}

} // namespace

void add_previews(py::module_& module) {
    py::class_<Rendering>(module, "Picture",
                          "A preview, scene-linear. As an array it is its luminance; a notebook shows it exposed.")
        .def_property_readonly(
            "luminance",
            [](const py::object& self) { return channels_of(self, self.cast<const Rendering&>().luminance_nt); },
            "Linear Rec.709 [cd/m²] (height, width, 3), float32, a view.")
        .def_property_readonly(
            "illuminance",
            [](const py::object& self) { return channels_of(self, self.cast<const Rendering&>().illuminance_lx); },
            "Of the visible surfaces [lx] (height, width), float32, a view; 0 where a light or nothing is seen.")
        .def(
            "__array__",
            [](const py::object& self, const py::object& type) {
                return type.is_none() ? self.attr("luminance") : self.attr("luminance").attr("astype")(type);
            },
            py::arg("dtype") = py::none())
        .def_property_readonly(
            "ev100",
            [](const Rendering& r) { return auto_exposure(r.luminance_nt, r.shows_light, r.shows_subject).value; },
            "The exposure that fits the picture, as an exposure value at ISO 100.")
        .def(
            "exposed",
            [](const py::object& self, std::optional<double> ev) {
                const double value = ev ? *ev : self.attr("ev100").cast<double>();
                return py::object(self.attr("luminance")) * py::float_(1.0 / white_luminance(Ev100(value)).value);
            },
            py::arg("ev100") = py::none(), "Linear Rec.709 in which 1 is the display's white (height, width, 3).")
        .def("_repr_png_",
             [](const py::object& self) {
                 return py::module_::import("gonio._png").attr("srgb_png")(self.attr("exposed")());
             })
        .def("__repr__", [](const Rendering& r) {
            return "<gonio.Picture " + std::to_string(r.luminance_nt.width) + " × " +
                   std::to_string(r.luminance_nt.height) + ">";
        });

    py::class_<LoadedRig>(module, "Rig",
                          "The lights of a scene and the stage that they are shown on, of schema gonio.rig/1.")
        .def_readonly("lights", &LoadedRig::lights, "Its lights, and the surfaces that emit.")
        .def_property_readonly(
            "stage", [](const LoadedRig& r) { return r.stage.name; }, "The name of its stage.")
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
        "'800lm'}], 'stage': 'floor'}). Files are relative to `folder`.");

    module.def(
        "preview", &preview, py::arg("lights"), py::arg("stage") = py::none(), py::kw_only(),
        py::arg("size") = std::pair(320, 240), py::arg("materials") = std::map<std::string, std::string>(),
        py::arg("camera") = py::none(), py::arg("target") = py::none(), py::arg("fov_deg") = py::none(),
        py::arg("shadows") = "soft", py::arg("bounces") = 0, py::arg("method") = "exact", py::arg("threads") = 0,
        "A picture of lights, or of a rig on its own stage, of `size` (width, height). `camera` and `target` are\n"
        "places (3) [m], `fov_deg` is the vertical field of view [°]; `shadows`: off, hard or soft; `bounces` −1:\n"
        "until all light is absorbed. Noise-free, the same for any number of threads.");
    module.def("hang", &hung, py::arg("shape"), py::arg("intensity") = py::none(), py::arg("stage") = "floor",
               "A light where the tool puts it on a stage.");
    module.def(
        "stages",
        [] {
            std::vector<std::pair<std::string, std::string>> names;
            for (const StageKind& stage : stage_kinds())
                names.emplace_back(stage.name, stage.summary);
            return names;
        },
        "The names of the stages, each with a summary.");
}

} // namespace gonio::python
