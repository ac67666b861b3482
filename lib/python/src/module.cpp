#include "binding.hpp"

PYBIND11_MODULE(_gonio, module) {
    module.doc() = "The compiled part of gonio; import gonio instead.";
    gonio::python::add_diagnostics(module);
    gonio::python::add_webs(module);
    gonio::python::add_profiles(module);
    gonio::python::add_units(module);
    gonio::python::add_colors(module);
    gonio::python::add_lights(module);
    gonio::python::add_materials(module);
    gonio::python::add_textures(module);
    gonio::python::add_previews(module);
}
