// Textures: webs baked to arrays.
#include <gonio/bake/bake.hpp>
#include <gonio/base/named.hpp>

#include "binding.hpp"

#include <pybind11/stl.h>

namespace gonio::python {

namespace {

constexpr std::array texel_types{Named{"float32", TexelType::float32}, Named{"half", TexelType::half},
                                 Named{"uint16", TexelType::uint16}, Named{"uint8", TexelType::uint8}};

Texture bake(const Web& web, const std::string& layout, std::optional<std::pair<int, int>> size,
             const std::string& normalization, const std::string& texel_type, double cone_deg, unsigned threads,
             std::optional<double> max_error_cd) {
    BakeOptions options;
    options.layout = value_of(parse_layout(layout));
    const TextureSize usual = usual_size(options.layout);
    options.width = size ? size->first : usual.width;
    options.height = size ? size->second : usual.height;
    options.normalization = value_of(parse_normalization(normalization));
    options.texel_type = value_of(find_value("texel type", texel_type, texel_types));
    options.chart.cone = degrees(cone_deg);
    options.threads = threads;
    return value_of(interruptible([&] {
        return max_error_cd ? bake_smallest(web, options, Candelas(*max_error_cd)) : bake_texture(web, options);
    }));
}

} // namespace

void add_textures(py::module_& module) {
    py::class_<Texture>(module, "Texture", "A web as a picture: each texel is the exact mean over its solid angle.")
        .def_readonly("layout", &Texture::layout, "The layout's name.")
        .def_readonly("texel_convention", &Texture::texel_convention, "Which directions a texel covers, in a sentence.")
        .def_property_readonly(
            "image",
            [](const py::object& self) {
                const Image& image = self.cast<const Texture&>().image;
                return py::array_t<float>({image.height, image.width}, image.pixels.data(), self);
            },
            "The texels (height, width), float32, a view. Candela are texel × cd_per_unit.")
        .def(
            "__array__",
            [](const py::object& self, const py::object& type) {
                return type.is_none() ? self.attr("image") : self.attr("image").attr("astype")(type);
            },
            py::arg("dtype") = py::none())
        .def_readonly("cd_per_unit", &Texture::cd_per_unit, "Candela of a texel of 1 [cd].")
        .def_property_readonly(
            "peak_cd", [](const Texture& t) { return t.peak.value; }, "The web's greatest intensity [cd].")
        .def_property_readonly(
            "flux_lm", [](const Texture& t) { return t.flux.value; }, "The web's flux [lm].")
        .def_property_readonly(
            "texture_flux_lm", [](const Texture& t) { return t.texture_flux.value; },
            "The flux of the texels as stored [lm].")
        .def_property_readonly(
            "max_error_cd", [](const Texture& t) { return t.max_error.value; },
            "Greatest difference between the filtered texture and the web [cd].")
        .def_property_readonly(
            "solid_angle_sr", [](const Texture& t) { return t.solid_angle.value; },
            "Of all texels: 4π unless the layout leaves directions out [sr].")
        .def("_repr_png_",
             [](const py::object& self) {
                 return py::module_::import("gonio._png").attr("grey_png")(self.attr("image"));
             })
        .def("__repr__", [](const Texture& t) {
            return "<gonio.Texture " + t.layout + ", " + std::to_string(t.image.width) + " × " +
                   std::to_string(t.image.height) + ">";
        });

    module.def(
        "bake", &bake, py::arg("web"), py::arg("layout") = "latlong", py::kw_only(), py::arg("size") = py::none(),
        py::arg("normalization") = "none", py::arg("texel_type") = "float32", py::arg("cone_deg") = 90.0,
        py::arg("threads") = 0, py::arg("max_error_cd") = py::none(),
        "A web as a texture of `size` (width, height), or the smallest one within `max_error_cd` [cd]. A texel of 1\n"
        "is 1 cd, or the 'peak', 'mean' or 'flux' of `normalization`; values are rounded to `texel_type` 'float32',\n"
        "'half', 'uint16' or 'uint8'. `cone_deg` is the full angle of a gnomonic texture.");
    module.def(
        "layouts",
        [] {
            std::vector<std::pair<std::string, std::string>> names;
            for (const LayoutInfo& layout : layouts())
                names.emplace_back(layout.name, layout.summary);
            return names;
        },
        "The names of the layouts, each with a summary.");
}

} // namespace gonio::python
