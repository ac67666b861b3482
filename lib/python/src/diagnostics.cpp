// Diagnostics, errors and warnings. The classes of errors are Python's, in gonio/_errors.py.
#include <gonio/base/diagnostic_codes.hpp>
#include <gonio/base/version.hpp>

#include "binding.hpp"

#include <pybind11/stl.h>

namespace gonio::python {

namespace {

py::object error_of(const Error& error) {
    const char* name = "Error";
    if (error.failure == Failure::io) name = "FileError";
    if (error.failure == Failure::unsupported) name = "UnsupportedError";
    return py::module_::import("gonio._errors").attr(name)(error.diagnostics);
}

} // namespace

void warn(const Diagnostics& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics) {
        if (diagnostic.severity == Severity::note) continue;
        const py::object category = py::module_::import("gonio._errors").attr("DiagnosticWarning");
        if (PyErr_WarnEx(category.ptr(), to_text(diagnostic).c_str(), 1) != 0) throw py::error_already_set();
    }
}

void add_diagnostics(py::module_& module) {
    module.attr("__version__") = GONIO_VERSION_STRING;

    py::class_<Diagnostic>(module, "Diagnostic",
                           "A message about an input: a stable code, a severity, a place, one sentence and a hint.")
        .def_readonly("code", &Diagnostic::code, "Of the registry, as `gonio explain` takes it: 'IES0204'.")
        .def_property_readonly(
            "severity", [](const Diagnostic& d) { return to_text(d.severity); }, "'note', 'warning' or 'error'.")
        .def_readonly("message", &Diagnostic::message, "One sentence without a full stop.")
        .def_readonly("hint", &Diagnostic::hint, "What to do about it; may be empty.")
        .def_property_readonly(
            "file", [](const Diagnostic& d) { return d.location.file; }, "The input's name; may be empty.")
        .def_property_readonly(
            "line", [](const Diagnostic& d) { return d.location.line; }, "From 1; 0 for the whole file.")
        .def_property_readonly(
            "column", [](const Diagnostic& d) { return d.location.column; }, "In bytes, from 1; 0 for the whole line.")
        .def("__str__", [](const Diagnostic& d) { return to_text(d); })
        .def("__repr__", [](const Diagnostic& d) { return "<gonio.Diagnostic " + to_text(d) + ">"; });

    module.def(
        "diagnostic_codes",
        [] {
            std::vector<std::pair<std::string, std::string>> rows;
            for (const DiagnosticCode& row : gonio::diagnostic_codes())
                rows.emplace_back(row.code, row.title);
            return rows;
        },
        "All codes of diagnostics, each with its title.");
    module.def(
        "explain",
        [](const std::string& code) {
            const DiagnosticCode* const row = find_diagnostic_code(code);
            if (row == nullptr)
                throw Failed{fail("USE0103", "there is no code '" + code + "'", "for example WEB0301").value()};
            return std::string(row->title) + "\n\n" + std::string(row->explanation);
        },
        py::arg("code"), "What the code of a diagnostic means: its title and its explanation.");

    py::register_exception_translator([](std::exception_ptr pointer) {
        try {
            if (pointer) std::rethrow_exception(pointer);
        } catch (const Failed& failed) {
            const py::object error = error_of(failed.error);
            PyErr_SetObject(py::type::of(error).ptr(), error.ptr());
        }
    });
}

} // namespace gonio::python
