// Colours: temperatures and chromaticities, RGB of lights, spectra.
#include <gonio/base/parallel.hpp>
#include <gonio/color/cct.hpp>
#include <gonio/color/kernels.hpp>
#include <gonio/color/light_quality.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/plot/color_vector_graphic.hpp>
#include <gonio/plot/svg.hpp>

#include "binding.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <pybind11/stl.h>

namespace gonio::python {

namespace {

const RgbSpace& space_named(const std::string& name) {
    const RgbSpace* const space = find_rgb_space(name);
    if (space == nullptr) {
        std::string all;
        for (const RgbSpaceName& known : rgb_spaces())
            all += (all.empty() ? "there are: " : ", ") + std::string(known.name);
        throw Failed{fail("USE0103", "unknown space '" + name + "'", all).value()};
    }
    return *space;
}

std::vector<py::ssize_t> with_axis(const py::array& array, py::ssize_t last) {
    std::vector<py::ssize_t> shape(array.shape(), array.shape() + array.ndim());
    shape.push_back(last);
    return shape;
}

// The sum over the spectrum, in double; x and y of each.
Doubles chromaticity(const Doubles& temperature, const Doubles& duv, const std::string& locus) {
    const Locus curve = value_of(parse_locus(locus));
    const auto [kelvin, distance] = broadcast(temperature, duv);
    Doubles result(with_axis(kelvin, 2));
    double* to = result.mutable_data();
    for (py::ssize_t i = 0; i < kelvin.size(); ++i, to += 2) {
        const Xy xy = to_xy(value_of(exact_uv({Kelvin(kelvin.data()[i]), distance.data()[i]}, curve)));
        to[0] = xy.x;
        to[1] = xy.y;
    }
    return result;
}

py::tuple temperature_of(const Doubles& x, const Doubles& y) {
    const auto [xs, ys] = broadcast(x, y);
    Doubles kelvin = like(xs);
    Doubles duv = like(xs);
    for (py::ssize_t i = 0; i < xs.size(); ++i) {
        const Cct cct = fast_cct(to_uv(Xy{xs.data()[i], ys.data()[i]}));
        kelvin.mutable_data()[i] = cct.temperature.value;
        duv.mutable_data()[i] = cct.duv;
    }
    return py::make_tuple(number_or_array(kelvin), number_or_array(duv));
}

// In double by the exact sum or its fit; each fails on its own values, as the tool does.
Doubles rgb_in_double(const Doubles& temperature, const Doubles& duv, const RgbSpace& space) {
    const auto [kelvin, distance] = broadcast(temperature, duv);
    Doubles result(with_axis(kelvin, 3));
    double* to = result.mutable_data();
    for (py::ssize_t i = 0; i < kelvin.size(); ++i, to += 3) {
        const SpaceColor color = to_space(value_of(uv_of({Kelvin(kelvin.data()[i]), distance.data()[i]})), space);
        for (int channel = 0; channel < 3; ++channel)
            to[channel] = color.rgb[channel];
    }
    return result;
}

using FloatsInOrder = py::array_t<float, py::array::c_style>;

// In packs of floats: structures of arrays in pieces that stay in the cache, interleaved on the way out.
FloatsInOrder rgb_in_packs(const FloatsInOrder& temperature, const RgbSpace& space) {
    const color::Kernels& kernels = color::kernels(simd::best_available());
    const color::RgbConstants constants = color::rgb_constants(space);
    FloatsInOrder result(with_axis(temperature, 3));
    const float* const kelvin = temperature.data();
    float* const to = result.mutable_data();
    const auto count = static_cast<std::size_t>(temperature.size());
    constexpr std::size_t piece = 4096;
    const py::gil_scoped_release released;
    std::vector<float> channels(3 * piece);
    for (std::size_t begin = 0; begin < count; begin += piece) {
        const std::size_t size = std::min(piece, count - begin);
        float* const rgb[3] = {channels.data(), channels.data() + piece, channels.data() + 2 * piece};
        kernels.planckian_rgb(kelvin + begin, size, constants, rgb);
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t channel = 0; channel < 3; ++channel)
                to[3 * (begin + i) + channel] = rgb[channel][i];
    }
    return result;
}

// A number of a part that a light may lack.
template<class Part, class Value>
std::optional<double> part_of(const std::optional<Part>& part, Value value) {
    if (!part) return std::nullopt;
    return value(*part);
}

// A number of each hue bin, or None.
py::object of_bins(const LightQuality& quality, double HueBin::*value) {
    if (!quality.fidelity) return py::none();
    Doubles result(static_cast<py::ssize_t>(hue_bin_count));
    for (std::size_t i = 0; i < hue_bin_count; ++i)
        result.mutable_data()[i] = quality.fidelity->bins[i].*value;
    return result;
}

template<std::size_t n>
Doubles array_of(const std::array<double, n>& values) {
    return Doubles(static_cast<py::ssize_t>(n), values.data());
}

// By the names of the receptors.
std::map<std::string, double> of_receptors(const std::array<double, receptor_count>& values) {
    std::map<std::string, double> named;
    for (const ReceptorName& receptor : receptor_names())
        named.emplace(receptor.name, values[static_cast<std::size_t>(receptor.receptor)]);
    return named;
}

void add_light_quality(py::module_& module) {
    py::class_<LightQuality>(
        module, "LightQuality",
        "The quality of light of a spectrum. What needs a reference illuminant is None without one.")
        .def_property_readonly(
            "temperature_k",
            [](const LightQuality& q) { return part_of(q.cct, [](const Cct& c) { return c.temperature.value; }); },
            "Correlated colour temperature [K].")
        .def_property_readonly(
            "duv", [](const LightQuality& q) { return part_of(q.cct, [](const Cct& c) { return c.duv; }); },
            "Distance from the black bodies in u, v of 1960; greener above 0.")
        .def_property_readonly(
            "ra", [](const LightQuality& q) { return part_of(q.rendering, [](const auto& r) { return r.ra; }); },
            "General colour rendering index, CIE 13.3.")
        .def_property_readonly(
            "r",
            [](const LightQuality& q) {
                return q.rendering ? py::object(array_of(q.rendering->r)) : py::object(py::none());
            },
            "Special colour rendering indices R1 to R15 (15).")
        .def_property_readonly(
            "reference_duv",
            [](const LightQuality& q) { return part_of(q.rendering, [](const auto& r) { return r.reference_duv; }); },
            "Distance from the reference illuminant of CIE 13.3 in u, v of 1960, which accepts 0.0054.")
        .def_property_readonly(
            "rf", [](const LightQuality& q) { return part_of(q.fidelity, [](const auto& f) { return f.rf; }); },
            "Colour fidelity index, TM-30 and CIE 224.")
        .def_property_readonly(
            "rg", [](const LightQuality& q) { return part_of(q.fidelity, [](const auto& f) { return f.rg; }); },
            "Gamut index, TM-30.")
        .def_property_readonly(
            "rf_samples",
            [](const LightQuality& q) {
                return q.fidelity ? py::object(array_of(q.fidelity->samples)) : py::object(py::none());
            },
            "Colour fidelity of each of the 99 samples (99).")
        .def_property_readonly(
            "rf_hues", [](const LightQuality& q) { return of_bins(q, &HueBin::fidelity); },
            "Colour fidelity Rf,h by hue bin (16).")
        .def_property_readonly(
            "chroma_shifts", [](const LightQuality& q) { return of_bins(q, &HueBin::chroma_shift); },
            "Shift of chroma Rcs,h by hue bin (16); 0.1 is 10 % more.")
        .def_property_readonly(
            "hue_shifts", [](const LightQuality& q) { return of_bins(q, &HueBin::hue_shift); },
            "Shift of hue Rhs,h by hue bin (16), about radians.")
        .def_property_readonly(
            "alpha_opic_mw_per_lm", [](const LightQuality& q) { return of_receptors(q.alpha_opic.efficacy_mw_per_lm); },
            "Alpha-opic efficacies of luminous radiation [mW/lm] by receptor: s_cone, m_cone, l_cone, rhodopic,\n"
            "melanopic.")
        .def_property_readonly(
            "alpha_opic_der", [](const LightQuality& q) { return of_receptors(q.alpha_opic.der); },
            "Daylight (D65) efficacy ratios by receptor.")
        .def_property_readonly(
            "melanopic_der", [](const LightQuality& q) { return q.alpha_opic.melanopic_der(); },
            "Melanopic daylight efficacy ratio: melanopic EDI per lux.")
        .def_readonly("diagnostics", &LightQuality::diagnostics, "What is to be said about the figures.")
        .def(
            "svg",
            [](const LightQuality& q, int width, int height, const std::string& title) {
                return to_svg(value_of(color_vector_graphic(q, {width, height, title})));
            },
            py::kw_only(), py::arg("width_px") = 480, py::arg("height_px") = 480, py::arg("title") = "",
            "The colour vector graphic of TM-30 as SVG text.");
    module.def(
        "light_quality", [](const Spectrum& spectrum) { return value_of(gonio::light_quality(spectrum)); },
        py::arg("spectrum"),
        "Colour rendering (CIE 13.3, TM-30) and alpha-opic figures (CIE S 026) of a spectrum, some 0.1 ms.");
}

} // namespace

void add_colors(py::module_& module) {
    module.def("chromaticity", &chromaticity, py::arg("temperature_k"), py::arg("duv") = 0.0, py::kw_only(),
               py::arg("locus") = "planckian",
               "CIE 1931 x, y (…, 2) of colour temperatures [K], from the sum over the spectrum. `locus`: planckian,\n"
               "daylight or blend.");
    module.def(
        "temperature", &temperature_of, py::arg("x"), py::arg("y"),
        "Correlated colour temperature [K] and Duv of CIE 1931 x and y, which are broadcast; NaN where a colour\n"
        "has none. Within 1e-5 K of the exact one over 1500–40000 K.");
    module.def(
        "rgb",
        [](const py::object& temperature, const Doubles& duv, const std::string& name) -> py::object {
            const RgbSpace& space = space_named(name);
            const bool plain = duv.size() == 1 && *duv.data() == 0.0;
            if (plain && py::isinstance<FloatsInOrder>(temperature)) return rgb_in_packs(temperature, space);
            const auto kelvin = Doubles::ensure(temperature);
            if (!kelvin) throw py::error_already_set();
            return rgb_in_double(kelvin, duv, space);
        },
        py::arg("temperature_k"), py::arg("duv") = 0.0, py::kw_only(), py::arg("space") = "rec709",
        "Linear RGB of luminance 1 (…, 3) of colour temperatures [K]; negative outside the gamut. Arrays of float32 "
        "run\n"
        "on the vector units, within 4e-7 in u'v', and give NaN outside 800 K to 1e6 K; others are computed in "
        "double.");
    module.def(
        "light_color",
        [](const std::string& text) {
            Diagnostics diagnostics;
            const glm::dvec3 color = value_of(parse_light_color(text, &diagnostics));
            warn(diagnostics);
            return to_array(color);
        },
        py::arg("text"),
        "Linear Rec.709 of luminance 1 (3) of a light's colour: '2700K', '2700K/0.003', 'd65', 'spectrum:FILE',\n"
        "'rgb(r,g,b)' or '#ffd9a0'.");
    module.def(
        "loci",
        [] {
            std::vector<std::pair<std::string, std::string>> rows;
            for (const LocusName& row : locus_names())
                rows.emplace_back(row.name, row.says);
            return rows;
        },
        "The curves of chromaticities over temperature: their names, each with a summary.");
    module.def(
        "duv_of_tint", [](const std::string& text) { return value_of(parse_tint(text)); }, py::arg("text"),
        "The Duv of a tint of a program of tints(): '10@dng'.");
    module.def(
        "tints",
        [] {
            std::vector<std::pair<std::string, std::string>> rows;
            for (const TintConvention& row : tint_conventions())
                rows.emplace_back(row.name, row.says);
            return rows;
        },
        "How programs express the distance from the locus: their names, each with a summary.");
    module.def(
        "is_real",
        [](const Doubles& x, const Doubles& y) {
            const auto [xs, ys] = broadcast(x, y);
            py::array_t<bool> result(std::vector<py::ssize_t>(xs.shape(), xs.shape() + xs.ndim()));
            for (py::ssize_t i = 0; i < xs.size(); ++i)
                result.mutable_data()[i] = is_real(Xy{xs.data()[i], ys.data()[i]});
            return xs.ndim() == 0 ? py::object(py::bool_(*result.data())) : py::object(result);
        },
        py::arg("x"), py::arg("y"),
        "Whether CIE 1931 x and y, which are broadcast, are a mixture of wavelengths, bool (…).");
    module.def(
        "rgb_to_xyz",
        [](const std::string& name) {
            const RgbSpace& space = space_named(name);
            Doubles matrix(std::vector<py::ssize_t>{3, 3});
            for (int row = 0; row < 3; ++row)
                for (int column = 0; column < 3; ++column)
                    matrix.mutable_at(row, column) = space.to_xyz[column][row];
            return matrix;
        },
        py::arg("space"), "The matrix (3, 3) from linear RGB of a space to XYZ relative to D65.");
    module.def(
        "srgb_encoded",
        [](const Doubles& linear) {
            Doubles result = like(linear);
            std::transform(linear.data(), linear.data() + linear.size(), result.mutable_data(), encode_srgb);
            return number_or_array(result);
        },
        py::arg("linear"), "The curve of sRGB (IEC 61966-2-1) on linear values (…).");
    module.def(
        "srgb_decoded",
        [](const Doubles& encoded) {
            Doubles result = like(encoded);
            std::transform(encoded.data(), encoded.data() + encoded.size(), result.mutable_data(), decode_srgb);
            return number_or_array(result);
        },
        py::arg("encoded"), "Its inverse: linear values (…).");
    module.def(
        "rgb_spaces",
        [] {
            std::vector<std::string> names;
            for (const RgbSpaceName& space : rgb_spaces())
                names.emplace_back(space.name);
            return names;
        },
        "The names of the RGB spaces.");
    module.def(
        "illuminants",
        [] {
            std::vector<std::string> names;
            for (const std::string_view name : illuminant_names())
                names.emplace_back(name);
            return names;
        },
        "The names of the CIE illuminants.");

    py::class_<SpectrumColor>(module, "SpectrumColor", "The colour of a spectrum.")
        .def_property_readonly(
            "xyz", [](const SpectrumColor& c) { return to_array(c.xyz); }, "CIE 1931 XYZ with Y = 1 (3).")
        .def_property_readonly(
            "xy",
            [](const SpectrumColor& c) {
                const Xy xy = to_xy(c.uv);
                return std::pair(xy.x, xy.y);
            },
            "CIE 1931 x and y.")
        .def_readonly("efficacy_lm_per_w", &SpectrumColor::efficacy_lm_per_w,
                      "Luminous flux over the radiant flux in the band [lm/W].")
        .def_property_readonly(
            "temperature_k", [](const SpectrumColor& c) { return value_of(exact_cct(c.uv)).temperature.value; },
            "Correlated colour temperature [K].")
        .def_property_readonly(
            "duv", [](const SpectrumColor& c) { return value_of(exact_cct(c.uv)).duv; },
            "Distance from the black bodies in u, v of 1960; greener above 0.");

    py::class_<Spectrum>(module, "Spectrum", "Spectral power over wavelength, relative or absolute.")
        .def(py::init([](const Doubles& wavelengths, const Doubles& power, const std::string& name) {
                 std::string text;
                 if (wavelengths.ndim() != 1 || power.ndim() != 1 || wavelengths.size() != power.size())
                     throw Failed{
                         fail("USE0105", "a spectrum needs as many wavelengths as powers, in one row").value()};
                 // By the reader, which checks what a table must have.
                 for (py::ssize_t i = 0; i < power.size(); ++i)
                     text += py::repr(py::float_(wavelengths.data()[i])).cast<std::string>() + "," +
                             py::repr(py::float_(power.data()[i])).cast<std::string>() + "\n";
                 return value_of(parse_spectrum_csv(text, name));
             }),
             py::arg("wavelengths_nm"), py::arg("power"), py::kw_only(), py::arg("name") = "spectrum",
             "A spectrum of ascending wavelengths [nm] (n) and powers (n), from 400 to 700 nm at least.")
        .def_readonly("name", &Spectrum::name, "Its name.")
        .def_readonly("diagnostics", &Spectrum::diagnostics, "Warnings of reading it.")
        .def_property_readonly(
            "wavelengths_nm",
            [](const py::object& self) {
                const std::vector<double>& list = self.cast<const Spectrum&>().wavelengths_nm;
                return py::array_t<double>(static_cast<py::ssize_t>(list.size()), list.data(), self);
            },
            "Wavelengths [nm] (n), a view.")
        .def_property_readonly(
            "power",
            [](const py::object& self) {
                const std::vector<double>& list = self.cast<const Spectrum&>().power;
                return py::array_t<double>(static_cast<py::ssize_t>(list.size()), list.data(), self);
            },
            "Spectral power (n), a view.")
        .def(
            "color",
            [](const Spectrum& s, std::optional<std::pair<double, double>> band) {
                std::optional<Band> within;
                if (band) within = Band{band->first, band->second};
                return value_of(color_of(s, within));
            },
            py::arg("band_nm") = py::none(), "Its colour; the radiant flux is counted within `band_nm`.")
        .def("__repr__", [](const Spectrum& s) {
            return "<gonio.Spectrum '" + s.name + "', " + std::to_string(s.power.size()) + " wavelengths>";
        });
    module.def(
        "read_spectra", [](const std::string& text) { return value_of(gonio::read_spectra(text)); }, py::arg("text"),
        "All spectra of a CSV or TM-33 file.");
    module.def(
        "read_spectrum", [](const std::string& text) { return value_of(read_spectrum(text)); }, py::arg("text"),
        "The spectrum of a CIE illuminant ('d65', 'LED-B3'), of 'blackbody:2700K', or of a CSV or TM-33 file.");
    add_light_quality(module);
}

} // namespace gonio::python
