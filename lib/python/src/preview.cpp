// Previews: lights on a stage as a picture, and its exposure.
#include <gonio/base/named.hpp>
#include <gonio/preview/capture.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/preview/render.hpp>

#include "light_list.hpp"
#include "rig.hpp"

#include <algorithm>
#include <pybind11/stl.h>

namespace gonio::python {

namespace {

struct CameraView {
    std::optional<py::object> position, target;
    std::optional<double> fov_deg;
};

// How the surroundings reach surfaces.
struct Surroundings {
    std::optional<py::object> sky;
    bool shows_sky = true;
    std::string method;
    std::optional<py::object> probe_at;
};

Camera camera_of(const Stage& stage, const CameraView& view) {
    Camera camera = stage.camera;
    if (view.position) camera.position = vector_of(*view.position, "camera");
    if (view.target) camera.target = vector_of(*view.target, "target");
    if (view.fov_deg) {
        if (!(*view.fov_deg > 0.0 && *view.fov_deg < 180.0))
            throw Failed{fail("USE0106", "fov_deg must lie between 0 and 180").value()};
        camera.vertical_fov_deg = *view.fov_deg;
        camera.least_horizontal_fov_deg = 0.0;
    }
    value_of(check_camera(stage, camera));
    return camera;
}

SurroundingsMethod surroundings_named(const std::string& name) {
    if (name == to_text(SurroundingsMethod::exact)) return SurroundingsMethod::exact;
    std::vector<std::string_view> known{to_text(SurroundingsMethod::exact)};
    for (const SurroundingsMethodInfo& method : gonio::surroundings_methods()) {
        if (method.name == name) return method.method;
        known.push_back(method.name);
    }
    throw Failed{unknown_name("method of surroundings", name, known).value()};
}

Rendering preview(const py::object& of, const std::optional<std::string>& name, std::pair<int, int> size,
                  const std::map<std::string, std::string>& materials, const CameraView& view,
                  const Surroundings& around, RenderOptions options, const std::string& shadows,
                  const std::string& method) {
    std::vector<Light> lights = lights_of(of);
    const Stage stage = stage_of(of, name, materials);
    const Camera camera = camera_of(stage, view);
    options.width = size.first;
    options.height = size.second;
    options.sky = sky_over(of, around.sky, lights).sky;
    options.shows_sky = around.shows_sky && !options.sky.is_dark();
    options.shadows = shadows_named(shadows);
    options.method = value_of(parse_irradiance_method(method));
    options.surroundings = surroundings_named(around.method);
    options.illuminance = true;
    if (has_local_probe(options.surroundings) != around.probe_at.has_value())
        throw Failed{fail("USE0104",
                          around.probe_at ? "probe_at is for the surroundings parallax-box and parallax-sphere"
                                          : "these surroundings need the place of a probe",
                          "for example surroundings='parallax-box', probe_at=(0, 0, 1.2)")
                         .value()};
    if (around.probe_at) {
        const glm::dvec3 at = vector_of(*around.probe_at, "probe_at");
        options.probe = std::make_shared<const LocalProbe>(
            value_of(interruptible([&] { return local_probe(stage, lights, at, options); })));
    }
    return value_of(interruptible([&] { return render(stage, lights, camera, options); }));
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

// A mask of the picture's pixels.
py::array mask_of(const Rendering& picture, const std::vector<std::uint8_t>& pixels) {
    py::array_t<bool> mask(std::vector<py::ssize_t>{picture.luminance_nt.height, picture.luminance_nt.width});
    std::transform(pixels.begin(), pixels.end(), mask.mutable_data(), [](std::uint8_t one) { return one != 0; });
    return mask;
}

// EV of each, which must be greater than 0 where `work` needs it.
template<class Work>
py::object each_of(const Doubles& numbers, const char* name, bool above_zero, const Work& work) {
    Doubles result = like(numbers);
    for (py::ssize_t i = 0; i < numbers.size(); ++i) {
        const double number = numbers.data()[i];
        if (above_zero && !(number > 0.0))
            throw Failed{fail("USE0106", std::string(name) + " must be greater than 0").value()};
        result.mutable_data()[i] = work(number);
    }
    return number_or_array(result);
}

} // namespace

void add_previews(py::module_& module) {
    py::class_<Rendering>(module, "Picture",
                          "A preview, scene-linear. As an array it is its luminance; a notebook shows it exposed.")
        .def_property_readonly(
            "luminance",
            [](const py::object& self) { return view_of(self, self.cast<const Rendering&>().luminance_nt); },
            "Linear Rec.709 [cd/m²] (height, width, 3), float32, a view.")
        .def_property_readonly(
            "illuminance",
            [](const py::object& self) { return view_of(self, self.cast<const Rendering&>().illuminance_lx); },
            "Of the visible surfaces [lx] (height, width), float32, a view; 0 where a light or nothing is seen.")
        .def_property_readonly(
            "shows_light", [](const Rendering& r) { return mask_of(r, r.shows_light); },
            "Where a light itself is seen, even in a part of the pixel (height, width), bool.")
        .def_property_readonly(
            "shows_subject", [](const Rendering& r) { return mask_of(r, r.shows_subject); },
            "Where the pixel's middle shows what the stage is meant to show (height, width), bool.")
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

    module.def(
        "preview",
        [](const py::object& lights, const std::optional<std::string>& stage, std::pair<int, int> size,
           const std::map<std::string, std::string>& materials, const std::optional<py::object>& camera,
           const std::optional<py::object>& target, std::optional<double> fov_deg, const std::string& shadows,
           int bounces, const std::string& method, const std::optional<py::object>& sky, bool shows_sky,
           bool shows_lights, bool specular, const std::string& surroundings, const std::optional<py::object>& probe_at,
           unsigned threads) {
            RenderOptions options;
            options.bounces = bounces_of(bounces);
            options.shows_lights = shows_lights;
            options.specular = specular;
            options.threads = threads;
            return preview(lights, stage, size, materials, {camera, target, fov_deg},
                           {sky, shows_sky, surroundings, probe_at}, options, shadows, method);
        },
        py::arg("lights"), py::arg("stage") = py::none(), py::kw_only(), py::arg("size") = std::pair(320, 240),
        py::arg("materials") = std::map<std::string, std::string>(), py::arg("camera") = py::none(),
        py::arg("target") = py::none(), py::arg("fov_deg") = py::none(), py::arg("shadows") = "soft",
        py::arg("bounces") = 0, py::arg("method") = "exact", py::arg("sky") = py::none(), py::arg("shows_sky") = true,
        py::arg("shows_lights") = true, py::arg("specular") = true, py::arg("surroundings") = "exact",
        py::arg("probe_at") = py::none(), py::arg("threads") = 0,
        "A picture of lights, or of a rig on its own stage, of `size` (width, height). `camera` and `target` are\n"
        "places (3) [m], `fov_deg` is the vertical field of view [°]; `shadows`: off, hard or soft; `bounces` −1:\n"
        "until all light is absorbed. `sky` is a text, an environment or a gonio.Sky, shown where nothing else is "
        "seen\n"
        "unless `shows_sky` is false; `surroundings` is how it is reflected, of surroundings_methods(), and "
        "`probe_at`\n"
        "(3) [m] the place of the probe that some of these need. Noise-free, the same for any number of threads.");
    module.def("hang", &hung, py::arg("shape"), py::arg("intensity") = py::none(), py::arg("stage") = "floor",
               "A light where the tool puts it on a stage.");
    module.def(
        "surroundings_methods", [] { return summaries_of(gonio::surroundings_methods()); },
        "How engines reflect the surroundings: the names of the methods besides 'exact', each with a summary.");
    module.def(
        "auto_ev100",
        [](const py::object& luminance) {
            Image image = image_of(luminance, "luminance");
            if (image.channels != 3)
                throw Failed{fail("USE0105", "luminance must be pixels (height, width, 3)").value()};
            return auto_exposure(image).value;
        },
        py::arg("luminance"),
        "The exposure value at ISO 100 that fits a picture of linear Rec.709 [cd/m²] (height, width, 3).");
    module.def(
        "white_luminance_nt",
        [](const Doubles& ev) {
            return each_of(ev, "ev100", false, [](double e) { return white_luminance(Ev100(e)).value; });
        },
        py::arg("ev100"), "The luminance that is the display's white at an exposure value [cd/m²].");
    module.def(
        "card_illuminance_lx",
        [](const Doubles& ev) {
            return each_of(ev, "ev100", false, [](double e) { return card_illuminance(Ev100(e)).value; });
        },
        py::arg("ev100"), "The illuminance at which a matte 18 % card is middle grey at an exposure value [lx].");
    module.def(
        "ev100_of_card",
        [](const Doubles& lux) {
            return each_of(lux, "illuminance_lx", true, [](double e) { return exposure_of_card(Lux(e)).value; });
        },
        py::arg("illuminance_lx"),
        "The exposure value at which a matte 18 % card with this illuminance is middle grey.");
}

} // namespace gonio::python
