// Textures: webs baked to arrays.
#include <gonio/bake/bake_choice.hpp>
#include <gonio/bake/engine.hpp>

#include "binding.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <pybind11/stl.h>
#include <tuple>

namespace gonio::python {

namespace {

// What is baked: a layout with its own options, or that of an engine.
struct Baking {
    std::optional<std::string> layout, normalization, texel_type, engine;
    std::optional<std::pair<int, int>> size;
    double cone_deg;
    int border;
    std::optional<double> max_error_cd;
    unsigned threads;
};

BakeOptions options_of(const Baking& baking) {
    BakeChoice choice{baking.layout,     baking.engine,   {}, {}, baking.normalization,
                      baking.texel_type, baking.cone_deg, {}};
    if (baking.size) std::tie(choice.width, choice.height) = *baking.size;
    if (baking.border > 0) choice.border = baking.border;
    BakeOptions options = value_of(bake_options(choice));
    options.threads = baking.threads;
    return options;
}

// A texture, and how the file of an engine holds it.
struct Baked {
    Texture texture;
    int channels = 1;
    std::string rule;
};

Baked bake(const Web& web, const Baking& baking) {
    const BakeOptions options = options_of(baking);
    Baked baked{value_of(interruptible([&] {
                    return baking.max_error_cd ? bake_smallest(web, options, Candelas(*baking.max_error_cd))
                                               : bake_texture(web, options);
                })),
                1,
                {}};
    if (!baking.engine) return baked;
    const Engine& engine = *value_of(find_engine(*baking.engine));
    baked.channels = engine.channels;
    baked.rule = engine.rule;
    return baked;
}

// As the engine's file holds it: (height, width, channels), encoded.
py::array file_pixels(const Baked& baked) {
    const Image picture = picture_of(baked.texture, 0, baked.texture.image.width, baked.channels);
    py::array_t<float> array(std::vector<py::ssize_t>{picture.height, picture.width, picture.channels});
    std::copy(picture.pixels.begin(), picture.pixels.end(), array.mutable_data());
    return array;
}

// The unit direction of the middle of each texel; NaN in borders and empty corners.
Doubles layout_directions(const std::string& name, std::optional<std::pair<int, int>> size, double cone_deg,
                          int border) {
    Baking baking{name, {}, {}, {}, size, cone_deg, border, {}, 1};
    const BakeOptions options = options_of(baking);
    const std::vector<PlacedChart> charts =
        value_of(charts_of(options.layout, options.width, options.height, options.chart));
    Doubles result(std::vector<py::ssize_t>{options.height, options.width, 3});
    std::fill_n(result.mutable_data(), result.size(), std::numeric_limits<double>::quiet_NaN());
    for (const PlacedChart& placed : charts)
        for (int row = 0; row < placed.height; ++row)
            for (int column = 0; column < placed.width; ++column) {
                const glm::dvec3 direction =
                    placed.chart->at((column + 0.5) / placed.width, (row + 0.5) / placed.height).direction;
                double* const to = result.mutable_data(placed.y + row, placed.x + column, 0);
                for (int k = 0; k < 3; ++k)
                    to[k] = direction[k] / glm::length(direction);
            }
    return result;
}

} // namespace

void add_textures(py::module_& module) {
    py::class_<Baked>(module, "Texture", "A web as a picture: each texel is the exact mean over its solid angle.")
        .def_property_readonly(
            "layout", [](const Baked& b) { return b.texture.layout; }, "The layout's name.")
        .def_property_readonly(
            "texel_convention", [](const Baked& b) { return b.texture.texel_convention; },
            "Which directions a texel covers, in a sentence.")
        .def_readonly("rule", &Baked::rule, "How the engine reads it, in a sentence; empty without an engine.")
        .def_property_readonly(
            "image", [](const py::object& self) { return view_of(self, self.cast<const Baked&>().texture.image); },
            "The texels (height, width), float32, a view. Candela are texel × cd_per_unit.")
        .def(
            "__array__",
            [](const py::object& self, const py::object& type) {
                return type.is_none() ? self.attr("image") : self.attr("image").attr("astype")(type);
            },
            py::arg("dtype") = py::none())
        .def(
            "file_pixels", &file_pixels,
            "The texels as the engine's file holds them (height, width, channels), float32: encoded as in sRGB if the\n"
            "engine expects that.")
        .def_property_readonly(
            "cd_per_unit", [](const Baked& b) { return b.texture.cd_per_unit; }, "Candela of a texel of 1 [cd].")
        .def_property_readonly(
            "peak_cd", [](const Baked& b) { return b.texture.peak.value; }, "The web's greatest intensity [cd].")
        .def_property_readonly(
            "flux_lm", [](const Baked& b) { return b.texture.flux.value; }, "The web's flux [lm].")
        .def_property_readonly(
            "texture_flux_lm", [](const Baked& b) { return b.texture.texture_flux.value; },
            "The flux of the texels as stored [lm].")
        .def_property_readonly(
            "max_error_cd", [](const Baked& b) { return b.texture.max_error.value; },
            "Greatest difference between the filtered texture and the web [cd].")
        .def_property_readonly(
            "solid_angle_sr", [](const Baked& b) { return b.texture.solid_angle.value; },
            "Of all texels: 4π unless the layout leaves directions out [sr].")
        .def("_repr_png_",
             [](const py::object& self) {
                 return py::module_::import("gonio._png").attr("grey_png")(self.attr("image"));
             })
        .def("__repr__", [](const Baked& b) {
            return "<gonio.Texture " + b.texture.layout + ", " + std::to_string(b.texture.image.width) + " × " +
                   std::to_string(b.texture.image.height) + ">";
        });

    module.def(
        "bake",
        [](const Web& web, std::optional<std::string> layout, std::optional<std::string> engine,
           std::optional<std::pair<int, int>> size, std::optional<std::string> normalization,
           std::optional<std::string> texel_type, double cone_deg, int border, unsigned threads,
           std::optional<double> max_error_cd) {
            return bake(web, {std::move(layout), std::move(normalization), std::move(texel_type), std::move(engine),
                              size, cone_deg, border, max_error_cd, threads});
        },
        py::arg("web"), py::arg("layout") = py::none(), py::kw_only(), py::arg("engine") = py::none(),
        py::arg("size") = py::none(), py::arg("normalization") = py::none(), py::arg("texel_type") = py::none(),
        py::arg("cone_deg") = 90.0, py::arg("border") = 0, py::arg("threads") = 0, py::arg("max_error_cd") = py::none(),
        "A web as a texture of a layout (latlong) or for an engine of engines(), of `size` (width, height), or the\n"
        "smallest one within `max_error_cd` [cd]. A texel of 1 is 1 cd, or the 'peak', 'mean' or 'flux' of\n"
        "`normalization`; values are rounded to `texel_type` 'float32', 'half', 'uint16' or 'uint8'. `cone_deg` is "
        "the\n"
        "full angle of a gnomonic texture, `border` the width of its dark border.");
    module.def("layout_directions", &layout_directions, py::arg("layout"), py::arg("size") = py::none(), py::kw_only(),
               py::arg("cone_deg") = 90.0, py::arg("border") = 0,
               "The unit direction of the middle of each texel of a layout (height, width, 3), in the light's frame;\n"
               "NaN in borders and empty corners.");
    module.def(
        "layouts", [] { return summaries_of(gonio::layouts()); }, "The names of the layouts, each with a summary.");
    module.def(
        "normalizations",
        [] { return std::vector<std::string>(normalization_names().begin(), normalization_names().end()); },
        "The names of the normalizations.");
    module.def(
        "engines", [] { return summaries_of(gonio::engines()); },
        "The names of the engines whose textures are known, each with a summary.");
}

} // namespace gonio::python
