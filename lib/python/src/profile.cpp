// Profiles: photometric files as written; reading, checking, converting and writing them.
#include <gonio/asset/facts_record.hpp>
#include <gonio/asset/figures_record.hpp>
#include <gonio/base/file_set.hpp>
#include <gonio/base/named.hpp>
#include <gonio/figures/luminaire_figures.hpp>
#include <gonio/light/opening.hpp>
#include <gonio/light/profile_facts.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/radiometric.hpp>
#include <gonio/web/repetitions.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/to_profile.hpp>

#include "binding.hpp"

#include <pybind11/stl.h>

namespace gonio::python {

namespace {

constexpr std::array formats{Named{"ies", ProfileFormat::ies}, Named{"ldt", ProfileFormat::ldt},
                             Named{"tm33", ProfileFormat::tm33}};
constexpr std::array conventions{Named{"as-written", AzimuthConvention::as_written},
                                 Named{"ies", AzimuthConvention::lm63}, Named{"eulumdat", AzimuthConvention::eulumdat}};

ReadOptions read_options(const std::optional<std::string>& format, bool strict) {
    ReadOptions options;
    if (format) options.format = value_of(find_value("format", *format, formats));
    options.strict = strict;
    return options;
}

ResolveOptions resolve_options(int lamp_set, double tilt_deg, const std::string& azimuth, bool as_candela) {
    ResolveOptions options;
    options.lamp_set = lamp_set;
    options.tilt_deg = tilt_deg;
    options.azimuth = value_of(find_value("azimuth", azimuth, conventions));
    options.as_candela = as_candela;
    return options;
}

ProfileTarget target_named(const std::string& name) {
    const std::optional<ProfileTarget> target = find_profile_target(name);
    if (!target)
        throw Failed{unknown_name("format", name,
                                  std::array<std::string_view, 7>{"ies", "lm-63-1995", "lm-63-2002", "lm-63-2019",
                                                                  "portable", "ldt", "tm33"})
                         .value()};
    return *target;
}

Web web_of(const Profile& profile, int lamp_set, double tilt_deg, const std::string& azimuth, bool as_candela) {
    if (!as_candela) value_of(require_candela(profile, "as_candela=True takes its numbers as candela"));
    const ResolveOptions options = resolve_options(lamp_set, tilt_deg, azimuth, as_candela);
    const py::gil_scoped_release released;
    return value_of(resolve_web(profile, options)).web;
}

// By the record of the tool, so that there is one list of names.
py::object facts_of(const Profile& profile, int lamp_set, double tilt_deg, const std::string& azimuth,
                    bool as_candela) {
    const ResolveOptions options = resolve_options(lamp_set, tilt_deg, azimuth, as_candela);
    std::string record;
    {
        const py::gil_scoped_release released;
        ResolvedWeb resolved = value_of(resolve_web(profile, options));
        Diagnostics diagnostics = profile.diagnostics;
        diagnostics.insert(diagnostics.end(), resolved.diagnostics.begin(), resolved.diagnostics.end());
        record = facts_record(profile.source, profile_facts(profile, resolved.web, options), diagnostics);
    }
    return py::module_::import("json").attr("loads")(record);
}

py::object figures_of(const Profile& profile, int lamp_set, double tilt_deg, const std::string& azimuth,
                      bool as_candela) {
    const ResolveOptions options = resolve_options(lamp_set, tilt_deg, azimuth, as_candela);
    std::string record;
    {
        const py::gil_scoped_release released;
        const Web web = value_of(resolve_web(profile, options)).web;
        record = detail::figures_json(luminaire_figures(profile, web, options)).dump();
    }
    return py::module_::import("json").attr("loads")(record);
}

Diagnostics checked(const Profile& profile) {
    return report_of(profile.diagnostics, profile, value_of(resolve_web(profile)));
}

Profile made_of(MadeProfile&& made) {
    made.profile.diagnostics = std::move(made.diagnostics);
    return std::move(made.profile);
}

// A portable file needs the dialect's own writer; a profile does not say that it is one, and this reads the same.
py::bytes bytes_of(const Profile& profile) {
    return py::bytes(write_profile(profile, target_of(profile).value_or(ProfileTarget::lm63)));
}

ProfileFormat format_of(const Profile& profile) {
    return static_cast<ProfileFormat>(profile.file.index());
}

py::list keywords_of(const Profile& profile) {
    py::list keywords;
    for (const IesKeyword& keyword : header_of(profile).keywords)
        keywords.append(
            py::make_tuple(py::str(keyword.name), py::bytes(keyword.text).attr("decode")("utf-8", "replace")));
    return keywords;
}

} // namespace

void add_profiles(py::module_& module) {
    py::class_<Profile>(
        module, "Profile",
        "A photometric file as it was written: IES LM-63, EULUMDAT or TM-33. Nothing is applied; `web()`\n"
        "gives the light that it describes.")
        .def_readonly("source", &Profile::source, "The name in messages: a path, or what the bytes were called.")
        .def_property_readonly(
            "format", [](const Profile& p) { return to_text(format_of(p)); }, "'IES', 'LDT' or 'TM-33'.")
        .def_readonly("diagnostics", &Profile::diagnostics,
                      "Warnings and notes: of reading it, or what a conversion could not keep.")
        .def_property_readonly("keywords", &keywords_of,
                               "The texts as (name, text), in the file's order, under LM-63's names in every format.")
        .def_property_readonly(
            "declared_flux_lm", [](const Profile& p) { return declared_flux_lm(p); },
            "Lumens of the lamps that the file declares [lm]; None for absolute photometry.")
        .def_property_readonly(
            "input_watts", [](const Profile& p) { return header_of(p).input_watts; }, "Electrical power [W].")
        .def_property_readonly(
            "opening", [](const Profile& p) { return opening_of(p); },
            "The luminous opening that the file declares; of kind 'point' if it declares none.")
        .def("web", &web_of, py::kw_only(), py::arg("lamp_set") = 1, py::arg("tilt_deg") = 0.0,
             py::arg("azimuth") = "as-written", py::arg("as_candela") = false,
             "The light that the file describes, every factor applied [cd]. `azimuth` 'ies' or 'eulumdat' turns files "
             "of\n"
             "the other convention by 90°; `lamp_set` is one of EULUMDAT's, from 1.")
        .def("facts", &facts_of, py::kw_only(), py::arg("lamp_set") = 1, py::arg("tilt_deg") = 0.0,
             py::arg("azimuth") = "as-written", py::arg("as_candela") = false,
             "What `gonio info --json` says about it, by the same names: flux, peak, angles, lamps, opening, zones.\n"
             "Fluxes of a radiometric profile are in its `flux_unit`, intensities in its `intensity_unit`.")
        .def("figures", &figures_of, py::kw_only(), py::arg("lamp_set") = 1, py::arg("tilt_deg") = 0.0,
             py::arg("azimuth") = "as-written", py::arg("as_candela") = false,
             "The figures by which a luminaire is planned, by the names of `gonio info --json`: UGR tables, "
             "utilisation,\n"
             "luminances, classes. `figure_rules` has the standard of each; one that the profile does not give is "
             "None,\n"
             "and `missing_figures` has the reason.")
        .def("check", &checked,
             "What is wrong with it: its text, its numbers and its physics, as `gonio check` reports them.")
        .def(
            "convert",
            [](const Profile& p, const std::string& target, int lamp_set, double tilt_deg, const std::string& azimuth) {
                return made_of(value_of(
                    convert_profile(p, target_named(target), resolve_options(lamp_set, tilt_deg, azimuth, false))));
            },
            py::arg("target"), py::kw_only(), py::arg("lamp_set") = 1, py::arg("tilt_deg") = 0.0,
            py::arg("azimuth") = "as-written",
            "The same in 'ies', 'lm-63-1995', 'lm-63-2002', 'lm-63-2019', 'portable', 'ldt' or 'tm33'; its\n"
            "`diagnostics` say what was lost.")
        .def("to_bytes", &bytes_of, "The bytes of the file.")
        .def(
            "save",
            [](const Profile& p, const py::object& path) {
                value_of(write_file(path_of(path), std::string_view(bytes_of(p))));
            },
            py::arg("path"), "Writes the file, whole or not at all.")
        .def("_repr_svg_", [](const py::object& self) { return self.attr("web")().attr("_repr_svg_")(); })
        .def("__repr__", [](const Profile& p) {
            return "<gonio.Profile " + std::string(to_text(format_of(p))) + " '" + p.source + "'>";
        });

    module.def(
        "read",
        [](const py::object& path, const std::optional<std::string>& format, bool strict) {
            const std::string file = path_of(path);
            const ReadOptions options = read_options(format, strict);
            const py::gil_scoped_release released;
            return value_of(read_profile_file(file, options));
        },
        py::arg("path"), py::kw_only(), py::arg("format") = py::none(), py::arg("strict") = false,
        "Reads a photometric file, or the first photometry of a GLDF. The format ('ies', 'ldt', 'tm33', 'gldf') is\n"
        "recognised if it is not given; `strict` turns departures from the standard into errors.");
    module.def(
        "parse",
        [](const py::bytes& data, const std::string& source, const std::optional<std::string>& format, bool strict) {
            return value_of(read_profile(std::string_view(data), source, read_options(format, strict)));
        },
        py::arg("data"), py::arg("source") = "-", py::kw_only(), py::arg("format") = py::none(),
        py::arg("strict") = false, "The same from bytes; `source` names them in messages.");
    module.def(
        "to_profile",
        [](const Web& web, const std::string& target, const std::optional<Profile>& like,
           const std::map<std::string, std::string>& keywords, std::optional<double> lamp_flux_lm,
           std::optional<double> input_watts) {
            ProfileHeader header = like ? header_of(*like) : ProfileHeader{};
            for (const auto& [name, text] : keywords)
                set_keyword(header, name, text);
            if (lamp_flux_lm) header.lamp_flux_lm = lamp_flux_lm;
            if (input_watts) header.input_watts = *input_watts;
            return made_of(value_of(to_profile(web, header, target_named(target))));
        },
        py::arg("web"), py::arg("target") = "ies", py::kw_only(), py::arg("like") = py::none(),
        py::arg("keywords") = std::map<std::string, std::string>(), py::arg("lamp_flux_lm") = py::none(),
        py::arg("input_watts") = py::none(),
        "A profile of a web, in any of the formats of `Profile.convert`. Its texts, watts and opening are those of "
        "the\n"
        "profile `like`, then those given here.");
}

} // namespace gonio::python
