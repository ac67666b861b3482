// Environments: images of the light from all around, as arrays.
#include <gonio/base/codes/result.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/file_set.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/named.hpp>
#include <gonio/media/environment_file.hpp>
#include <gonio/preview/exposure.hpp>
#include <gonio/sky/environment_resample.hpp>
#include <gonio/sky/sky_direction.hpp>
#include <gonio/sky/sky_measures.hpp>
#include <gonio/sky/sun_extraction.hpp>

#include "sky_types.hpp"

#include <pybind11/stl.h>

namespace gonio::python {

namespace {

constexpr std::array bad_pixels_names{Named{"error", BadPixels::error}, Named{"black", BadPixels::black}};

EnvironmentLayout layout_named_or_of(const std::optional<std::string>& name, const Image& image) {
    return value_of(name ? parse_environment_layout(*name) : environment_layout_of(image.width, image.height));
}

Environment make_environment(const py::object& pixels, const std::optional<std::string>& layout, double nits_per_unit,
                             const std::string& bad_pixels) {
    Image image = image_of(pixels, "pixels");
    if (image.channels == 1) {
        Image colored(image.width, image.height, 3);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            std::fill_n(colored.pixels.begin() + static_cast<std::ptrdiff_t>(3 * i), 3, image.pixels[i]);
        image = std::move(colored);
    }
    if (image.channels != 3) throw Failed{fail("USE0105", "the pixels of an environment have 1 or 3 channels").value()};
    if (!(nits_per_unit > 0.0) || !std::isfinite(nits_per_unit))
        throw Failed{fail("USE0106", "nits_per_unit must be greater than 0").value()};
    Environment environment;
    const EnvironmentLayout as = layout_named_or_of(layout, image);
    const BadPixels bad = value_of(find_value("bad_pixels", bad_pixels, bad_pixels_names));
    environment.map = std::make_shared<const EnvironmentMap>(
        value_of(EnvironmentMap::create(as, std::move(image), nits_per_unit, bad, environment.diagnostics)));
    return environment;
}

// For each texel: `work(grid, texel)` gives the numbers of one; NaN where the picture has no direction.
template<class Work>
Doubles for_each_texel(const EnvironmentGrid& grid, py::ssize_t numbers, const Work& work) {
    std::vector<py::ssize_t> shape{grid.height(), grid.width()};
    if (numbers > 1) shape.push_back(numbers);
    Doubles result(shape);
    double* to = result.mutable_data();
    const py::gil_scoped_release released;
    for (int row = 0; row < grid.height(); ++row)
        for (int column = 0; column < grid.width(); ++column, to += numbers)
            if (grid.covers({column, row}))
                work(TexelIndex{column, row}, to);
            else
                std::fill_n(to, numbers, std::numeric_limits<double>::quiet_NaN());
    return result;
}

Doubles directions_of(const EnvironmentGrid& grid) {
    return for_each_texel(grid, 3, [&](TexelIndex texel, double* to) {
        const glm::dvec3 direction = grid.direction({texel.column + 0.5, texel.row + 0.5});
        for (int i = 0; i < 3; ++i)
            to[i] = direction[i];
    });
}

Environment calibrated(const Environment& environment, std::optional<double> illuminance, std::optional<double> mean,
                       std::optional<double> zenith, const py::object& facing, unsigned threads) {
    if ((illuminance ? 1 : 0) + (mean ? 1 : 0) + (zenith ? 1 : 0) != 1)
        throw Failed{
            fail("USE0104", "an environment is calibrated to one amount", "illuminance_lx, mean_nt or zenith_nt")
                .value()};
    Calibration to;
    to.of = illuminance ? Calibration::Of::illuminance
            : mean      ? Calibration::Of::mean_luminance
                        : Calibration::Of::zenith_luminance;
    to.value = illuminance ? *illuminance : mean ? *mean : *zenith;
    to.normal = direction_of_length(vector_of(facing, "facing"), "facing");
    EnvironmentMap map = *environment.map;
    value_of(interruptible([&] { return calibrate(map, to, threads); }));
    return {std::make_shared<const EnvironmentMap>(std::move(map)), environment.diagnostics};
}

py::object read_file_as_environment(const py::object& path, const std::optional<std::string>& layout,
                                    const std::string& space, const std::string& bad_pixels) {
    ImageSkyKind kind;
    kind.file = path_of(path);
    if (layout) kind.layout = value_of(parse_environment_layout(*layout));
    kind.space = space;
    kind.bad_pixels = value_of(find_value("bad_pixels", bad_pixels, bad_pixels_names));
    return py::cast(read_environment(kind));
}

void save(const Environment& environment, const py::object& path, const std::string& pixel) {
    constexpr std::array kinds{Named{"float", media::Pixel::float32}, Named{"half", media::Pixel::half}};
    const std::string file = path_of(path);
    const media::ImageFormat* const format = media::find_image_format(file);
    if (format == nullptr ||
        std::find(format->pixels.begin(), format->pixels.end(), media::Pixel::float32) == format->pixels.end())
        throw Failed{fail("USE0107", "the name of a file for light ends in .exr, .hdr or .tif", "", file).value()};
    value_of(write_file(file, value_of(media::encode_environment(
                                  *environment.map, *format, value_of(find_value("pixel type", pixel, kinds)), {}))));
}

} // namespace

Environment environment_of(EnvironmentMap&& map) {
    return {std::make_shared<const EnvironmentMap>(std::move(map)), {}};
}

EnvironmentGrid grid_of(const std::string& layout, std::optional<std::pair<int, int>> size) {
    constexpr int usual_side = 512; // of a lat-long: 1024 × 512
    const EnvironmentLayout as = value_of(parse_environment_layout(layout));
    const int side = size ? value_of(EnvironmentGrid::create(as, size->first, size->second)).side()
                          : side_like(EnvironmentLayout::latlong, usual_side, as);
    return value_of(environment_grid(as, side));
}

Environment read_environment(const ImageSkyKind& kind) {
    Environment environment;
    media::EnvironmentReadOptions options;
    options.layout = kind.layout;
    options.space = kind.space;
    options.bad_pixels = kind.bad_pixels;
    const std::string bytes = value_of(read_file(kind.file, limit("environment-bytes")));
    Result<media::EnvironmentImage> image = [&] {
        const py::gil_scoped_release released;
        return media::decode_environment(bytes, options, environment.diagnostics);
    }();
    for (Diagnostic& one : image ? environment.diagnostics : image.error().diagnostics)
        if (one.location.file.empty() && one.code.rfind("USE", 0) != 0) one.location.file = kind.file;
    environment.map = std::make_shared<const EnvironmentMap>(value_of(std::move(image)).map);
    return environment;
}

void add_environments(py::module_& module) {
    py::class_<BrightestSpot>(module, "BrightestSpot", "Where a sky or an environment is brightest.")
        .def_property_readonly(
            "direction", [](const BrightestSpot& s) { return to_array(s.direction); }, "Unit, towards it (3).")
        .def_property_readonly(
            "luminance_nt", [](const BrightestSpot& s) { return s.luminance.value; }, "Its luminance [cd/m²].")
        .def_readonly("share", &BrightestSpot::share, "Of all light from within 3° of it, 0 to 1.");

    struct Cut {
        Environment sky;
        SunLight sun;
        std::size_t texels;
        double region_sr;
    };
    py::class_<Cut>(module, "ExtractedSun", "An image without its sun, and the sun as a light.")
        .def_readonly("sky", &Cut::sky, "The environment without it.")
        .def_readonly("sun", &Cut::sun, "The sun.")
        .def_readonly("texels", &Cut::texels, "How many texels it was cut out of.")
        .def_readonly("region_sr", &Cut::region_sr, "Their solid angle [sr].");

    py::class_<Environment>(
        module, "Environment",
        "An image of the light from all around: linear Rec.709 × nits_per_unit is the luminance [cd/m²].\n\n"
        "z is up, +Y is north and +X is east. The layouts are latlong, cube-cross, cube-cross-vertical, cube-strip "
        "and\n"
        "octahedral. As an array it is its pixels; a notebook shows it exposed.")
        .def(py::init(&make_environment), py::arg("pixels"), py::kw_only(), py::arg("layout") = py::none(),
             py::arg("nits_per_unit") = 1.0, py::arg("bad_pixels") = "error",
             "An environment of pixels (height, width) or (height, width, 3), which are copied. The layout is that of\n"
             "the ratio of the sides if it is not given. `bad_pixels` 'black' makes those that cannot be light 0.")
        .def_property_readonly(
            "pixels",
            [](const py::object& self) { return view_of(self, self.cast<const Environment&>().map->image()); },
            "Linear Rec.709 (height, width, 3), float32, a view.")
        .def(
            "__array__",
            [](const py::object& self, const py::object& type) {
                return type.is_none() ? self.attr("pixels") : self.attr("pixels").attr("astype")(type);
            },
            py::arg("dtype") = py::none())
        .def_property_readonly(
            "layout", [](const Environment& e) { return info_of(e.map->grid().layout()).name; }, "Its layout's name.")
        .def_property_readonly(
            "nits_per_unit", [](const Environment& e) { return e.map->nits_per_unit(); }, "cd/m² of a pixel of Y = 1.")
        .def_readonly("diagnostics", &Environment::diagnostics, "Warnings of making or reading it.")
        .def(
            "directions", [](const Environment& e) { return directions_of(e.map->grid()); },
            "The unit direction of the middle of each texel (height, width, 3); NaN where a cross is empty.")
        .def(
            "solid_angles",
            [](const Environment& e) {
                return for_each_texel(e.map->grid(), 1,
                                      [&](TexelIndex texel, double* to) { *to = e.map->grid().solid_angle(texel); });
            },
            "The solid angle of each texel [sr] (height, width); NaN where a cross is empty.")
        .def(
            "texel_of",
            [](const Environment& e, const Doubles& directions) {
                require_vectors(directions, "directions");
                std::vector<py::ssize_t> shape = shape_of_vectors(directions);
                shape.push_back(2);
                py::array_t<int> texels(shape);
                const double* from = directions.data();
                int* to = texels.mutable_data();
                for (py::ssize_t i = 0; i < directions.size() / 3; ++i, from += 3, to += 2) {
                    const TexelIndex at =
                        e.map->grid().texel_at(direction_of_length({from[0], from[1], from[2]}, "a direction"));
                    to[0] = at.row;
                    to[1] = at.column;
                }
                return texels;
            },
            py::arg("directions"), "Row and column (…, 2) of the texels in which directions (…, 3) lie, int.")
        .def(
            "radiance",
            [](const Environment& e, const Doubles& directions) {
                return for_each_vector_rgb(directions, "directions",
                                           [&](const glm::dvec3& at) { return e.map->radiance(at); });
            },
            py::arg("directions"),
            "Luminance of the three channels [cd/m²] (…, 3) towards directions (…, 3), bilinear between texels.")
        .def(
            "luminance",
            [](const Environment& e, const Doubles& directions) {
                return for_each_vector(directions, "directions",
                                       [&](const glm::dvec3& at) { return luminance_of(e.map->radiance(at)); });
            },
            py::arg("directions"), "Luminance [cd/m²] (…) towards directions (…, 3).")
        .def(
            "illuminance",
            [](const Environment& e, const Doubles& normals, unsigned threads) {
                return illuminance_under(*e.map, normals, threads);
            },
            py::arg("normals"), py::kw_only(), py::arg("threads") = 0,
            "Illuminance [lx] (…) of open planes with normals (…, 3); all in one pass over the texels.")
        .def(
            "scalar_illuminance_lx",
            [](const Environment& e, unsigned threads) { return luminance_of(e.map->light(threads)); }, py::kw_only(),
            py::arg("threads") = 0, "∫ L dω over all directions [lx]: four times the mean over a sphere's surface.")
        .def(
            "brightest",
            [](const Environment& e) {
                const TexelIndex at = e.map->brightest();
                const double light = luminance_of(e.map->light());
                BrightestSpot spot;
                spot.direction = e.map->grid().direction({at.column + 0.5, at.row + 0.5});
                spot.luminance = Nits(luminance_of(e.map->texel(at)));
                const double within = luminance_of(e.map->light_within(spot.direction, degrees(spot_radius_deg)));
                spot.share = light > 0.0 ? within / light : 0.0;
                return spot;
            },
            "The brightest texel, and the share of the light from around it.")
        .def(
            "resampled",
            [](const Environment& e, const std::string& layout, std::optional<std::pair<int, int>> size,
               double rotate_deg, unsigned threads) {
                const EnvironmentGrid to = grid_of(layout, size);
                return environment_of(
                    interruptible([&] { return resampled(*e.map, to, degrees(rotate_deg), threads); }));
            },
            py::arg("layout"), py::arg("size") = py::none(), py::kw_only(), py::arg("rotate_deg") = 0.0,
            py::arg("threads") = 0,
            "In another layout and size (width, height): exact means over the new texels, so the light is kept.\n"
            "Azimuths grow by `rotate_deg`.")
        .def("calibrated", &calibrated, py::kw_only(), py::arg("illuminance_lx") = py::none(),
             py::arg("mean_nt") = py::none(), py::arg("zenith_nt") = py::none(),
             py::arg("facing") = py::make_tuple(0.0, 0.0, 1.0), py::arg("threads") = 0,
             "With another nits_per_unit, so that it gives this illuminance [lx] to an open plane that faces\n"
             "`facing` (3), or has this luminance [cd/m²] on average or at the zenith.")
        .def(
            "with_sun", [](const Environment& e, const SunLight& sun) { return environment_of(with_sun(*e.map, sun)); },
            py::arg("sun"), "With the disc of a sun in its texels.")
        .def(
            "extract_sun",
            [](const Environment& e) {
                ExtractedSun found = value_of(interruptible([&] { return extract_sun(*e.map); }));
                return Cut{environment_of(std::move(found.sky)), found.sun, found.texels, found.region.value};
            },
            "The sun in a photograph of the sky, cut out of its pixels. Fails if nothing is bright enough.")
        .def("save", &save, py::arg("path"), py::kw_only(), py::arg("pixel") = "float",
             "Writes .exr, .hdr or .tif, with its layout and nits_per_unit in an .exr. Needs gonio's picture module.")
        .def("_repr_png_",
             [](const py::object& self) { return exposed_png(self, self.cast<const Environment&>().map->image()); })
        .def("__repr__", [](const Environment& e) {
            return "<gonio.Environment " + std::string(info_of(e.map->grid().layout()).name) + ", " +
                   std::to_string(e.map->grid().width()) + " × " + std::to_string(e.map->grid().height()) + ">";
        });

    module.def("read_environment", &read_file_as_environment, py::arg("path"), py::kw_only(),
               py::arg("layout") = py::none(), py::arg("space") = "", py::arg("bad_pixels") = "error",
               "Reads .exr, .hdr or a .tif of floats as an environment; `space` is that of its pixels. Needs gonio's\n"
               "picture module.");
    module.def(
        "environment_layouts", [] { return summaries_of(environment_layouts()); },
        "The names of the layouts of environments, each with a summary.");
}

} // namespace gonio::python
