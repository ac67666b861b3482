// Exports: lights, skies and whole stages as the files of engines and renderers.
#include <gonio/asset/light_scene.hpp>
#include <gonio/asset/measured_light.hpp>
#include <gonio/asset/sky_picture.hpp>
#include <gonio/asset/stage_scene.hpp>
#include <gonio/base/file_set.hpp>
#include <gonio/base/folder.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/media/asset_bytes.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/profile/write.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/to_profile.hpp>

#include "light_list.hpp"
#include "rig.hpp"

#include <pybind11/stl.h>

namespace gonio::python {

namespace {

// What `gonio import` writes into the folder of a target.
struct Export {
    std::string target;
    std::vector<media::NamedBytes> files;
    std::vector<std::string> instead;
    std::string readme;
    Diagnostics diagnostics;
};

Export encoded(LightScene&& scene, std::string target, unsigned threads) {
    Export made{std::move(target), {}, std::move(scene.instead), {}, {}};
    for (const AssetFile& file : scene.files) {
        auto bytes = value_of(interruptible([&] { return media::bytes_of(file, threads); }));
        for (media::NamedBytes& one : bytes)
            made.files.push_back(std::move(one));
    }
    return made;
}

std::string checked_name(const std::string& name) {
    if (name.empty() || asset_name(name + ".") != name)
        throw Failed{fail("USE0105", "a name of files has letters, digits, '_' and '-', not '" + name + "'",
                          "for example name='studio'")
                         .value()};
    return name;
}

MeasuredLight luminaire_of(const Profile& profile, const std::optional<std::string>& name,
                           const std::optional<std::string>& intensity, const std::string& color, double rotate_deg,
                           Diagnostics& diagnostics) {
    const std::string bytes = write_profile(profile, target_of(profile).value_or(ProfileTarget::lm63));
    ResolvedWeb resolved = value_of(resolve_web(profile));
    const ProfileHeader header = header_of(profile);
    std::vector<Spectrum> spectra;
    if (color.empty()) spectra = value_of(spectra_of(profile));
    MeasuredLightOptions options;
    options.rotation = degrees(rotate_deg);
    options.color = color;
    if (intensity) {
        LightDescription description;
        description.name = profile.source;
        description.shape = ProfileShape{profile.source, std::make_shared<const Web>(resolved.web)};
        description.intensity = value_of(parse_photometric_value(*intensity));
        Diagnostics ignored; // those of the profile are known
        const Light light = value_of(resolve_light(std::move(description), ignored));
        options.flux = Lumens(light.web_scale * flux(resolved.web).value);
    }
    MeasuredLight light =
        value_of(measured_light({profile.source, bytes, resolved.web, header, spectra}, options, diagnostics));
    light.name = name ? checked_name(*name) : asset_name(profile.source);
    return light;
}

std::optional<SkyPicture> picture_of(const LoadedSky& sky, unsigned threads) {
    if (sky.sky.is_dark()) return std::nullopt;
    SkyPicture picture = value_of(interruptible([&] { return sky_picture(sky.sky, threads); }));
    picture.source = sky.text;
    return picture;
}

void require_something(const std::vector<Light>& lights, const std::optional<SkyPicture>& sky) {
    if (lights.empty() && !sky)
        throw Failed{fail("USE0104", "there is nothing to export", "give a light or a sky that is not dark").value()};
}

Export export_lights(const py::object& of, const std::string& target_name, const std::optional<std::string>& name,
                     double unit_m, const std::optional<py::object>& given_sky,
                     const std::optional<std::string>& intensity, const std::string& color, double rotate_deg,
                     unsigned threads) {
    const Target& target = *value_of(find_target(target_name));
    value_of(check_unit(target, Meters(unit_m)));
    Export made;
    if (py::isinstance<Profile>(of)) {
        if (given_sky) throw Failed{fail("USE0107", "a profile has no sky", "make a gonio.Light of it").value()};
        Diagnostics diagnostics;
        const MeasuredLight light =
            luminaire_of(of.cast<const Profile&>(), name, intensity, color, rotate_deg, diagnostics);
        made = encoded(value_of(light_scene(target, light, Meters(unit_m))), target_name, threads);
        made.diagnostics = std::move(diagnostics);
    } else {
        if (intensity || !color.empty() || rotate_deg != 0.0)
            throw Failed{fail("USE0107", "lights have their own amount, colour and rotation",
                              "leave intensity, color and rotate_deg out")
                             .value()};
        std::vector<Light> lights = lights_of(of);
        const std::optional<SkyPicture> sky = picture_of(sky_over(of, given_sky, lights), threads);
        require_something(lights, sky);
        value_of(check_light_count(lights.size()));
        LightSceneOptions options;
        options.name = checked_name(name.value_or("lights"));
        options.description = std::to_string(lights.size()) + " lights" + (sky ? " and a sky" : "");
        options.unit = Meters(unit_m);
        if (sky) options.sky = &*sky;
        made = encoded(value_of(light_scene(target, lights, options)), target_name, threads);
    }
    made.readme = target_readme(target);
    return made;
}

Export export_stage(const py::object& of, const std::string& format_name, const std::optional<std::string>& stage_name,
                    const std::string& name, const std::map<std::string, std::string>& materials,
                    const std::optional<py::object>& given_sky, std::pair<int, int> size, int bounces,
                    std::optional<double> white_nt, unsigned threads) {
    const std::string ending = format_name.starts_with(".") ? format_name : "." + format_name;
    const StageFormat& format = *value_of(stage_format_of(name + ending));
    std::vector<Light> lights = lights_of(of);
    const Stage stage = stage_of(of, stage_name, materials);
    const std::optional<SkyPicture> sky = picture_of(sky_over(of, given_sky, lights), threads);
    require_something(lights, sky);
    StageSceneOptions options;
    options.name = checked_name(name);
    options.description =
        std::to_string(lights.size()) + " lights" + (sky ? " and a sky" : "") + " on the stage " + stage.name;
    options.width = size.first;
    options.height = size.second;
    if (size.first < 1 || size.second < 1) throw Failed{fail("USE0106", "a size is at least 1 by 1").value()};
    if (white_nt) options.white = Nits(*white_nt);
    options.bounces = bounces < 0 ? max_bounces : std::min(bounces, max_bounces);
    if (sky) options.sky = &*sky;
    return encoded(value_of(stage_scene(format, stage, stage.camera, lights, options)), std::string(format.target),
                   threads);
}

void save(const Export& made, const py::object& folder) {
    const std::string path = path_of(folder);
    value_of(make_folder(path));
    FileSet set;
    for (const media::NamedBytes& file : made.files)
        value_of(set.add(path + "/" + file.name, file.bytes));
    value_of(set.commit());
}

} // namespace

void add_exports(py::module_& module) {
    py::class_<Export>(module, "Export", "The files of a target, in memory.")
        .def_readonly("target", &Export::target, "The name of the target.")
        .def_property_readonly(
            "files",
            [](const Export& e) {
                py::dict files;
                for (const media::NamedBytes& file : e.files)
                    files[py::str(file.name)] = py::bytes(file.bytes);
                return files;
            },
            "The bytes of each file by its name.")
        .def_readonly("instead", &Export::instead,
                      "What the target cannot store, and what is written instead: a sentence each.")
        .def_readonly("readme", &Export::readme,
                      "How to use the files, and what was checked in the program itself; empty for a whole stage.")
        .def_readonly("diagnostics", &Export::diagnostics, "Warnings and notes of making them.")
        .def("save", &save, py::arg("folder"), "Writes all files into a folder, which is made, or none of them.")
        .def("__repr__", [](const Export& e) {
            return "<gonio.Export " + e.target + ", " + std::to_string(e.files.size()) + " files>";
        });

    module.def(
        "export_lights", &export_lights, py::arg("lights"), py::arg("target"), py::kw_only(),
        py::arg("name") = py::none(), py::arg("unit_m") = 1.0, py::arg("sky") = py::none(),
        py::arg("intensity") = py::none(), py::arg("color") = "", py::arg("rotate_deg") = 0.0, py::arg("threads") = 0,
        "A profile, lights or a rig as the files of a target of targets(), as `gonio import` writes them. `name` is\n"
        "that of the files, `unit_m` the length of the target's unit [m]. A profile takes another amount, a colour "
        "and\n"
        "a rotation about its axis [°]; lights take a sky.");
    module.def(
        "export_stage", &export_stage, py::arg("lights"), py::arg("format"), py::arg("stage") = py::none(),
        py::kw_only(), py::arg("name") = "stage", py::arg("materials") = std::map<std::string, std::string>(),
        py::arg("sky") = py::none(), py::arg("size") = std::pair(512, 512), py::arg("bounces") = 0,
        py::arg("white_nt") = py::none(), py::arg("threads") = 0,
        "The scene that preview() renders, in a format of stage_formats(), so that another renderer can check the\n"
        "picture: surfaces, camera and lights. `size` is that of the picture, `white_nt` the luminance of its white.");
    module.def(
        "targets", [] { return summaries_of(targets()); },
        "The names of the targets, the programs that lights are written for, each with a summary.");
    module.def(
        "stage_formats",
        [] {
            std::vector<std::pair<std::string, std::string>> rows;
            for (const StageFormat& format : gonio::stage_formats())
                rows.emplace_back(format.extension, format.summary);
            return rows;
        },
        "The formats of whole stages by the ending of their files, each with a summary.");
    module.def(
        "color_temperature_in_text", [](const std::string& text) { return color_temperature_of(text); },
        py::arg("text"), "The colour temperature [K] in a text of a profile, '3000 K' or '830'; None in others.");
}

} // namespace gonio::python
