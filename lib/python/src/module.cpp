#include "binding.hpp"

PYBIND11_MODULE(_gonio, module) {
    module.doc() = "The compiled part of gonio; import gonio instead.";
    gonio::python::add_diagnostics(module);
    gonio::python::add_media(module);
    gonio::python::add_webs(module);
    gonio::python::add_openings(module);
    gonio::python::add_profiles(module);
    gonio::python::add_units(module);
    gonio::python::add_colors(module);
    gonio::python::add_lights(module);
    gonio::python::add_suns(module);
    gonio::python::add_environments(module);
    gonio::python::add_prefiltering(module);
    gonio::python::add_skies(module);
    gonio::python::add_split_sums(module);
    gonio::python::add_materials(module);
    gonio::python::add_textures(module);
    gonio::python::add_rigs(module);
    gonio::python::add_stages(module);
    gonio::python::add_previews(module);
    gonio::python::add_exports(module);
}
