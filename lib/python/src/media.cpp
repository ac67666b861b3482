// Picture modules: found where gonio is installed, or in folders that are named here.
#include <gonio/media/light_image_file.hpp>
#include <gonio/media/module.hpp>

#include "binding.hpp"

#include <pybind11/stl.h>

namespace gonio::python {

void add_media(py::module_& module) {
    media::enable_light_images(); // nothing is loaded before an image is read
    module.def(
        "set_module_folders",
        [](const std::vector<py::object>& folders) {
            std::vector<std::string> paths;
            for (const py::object& folder : folders)
                paths.push_back(path_of(folder));
            media::set_module_folders(std::move(paths));
        },
        py::arg("folders"),
        "Folders in which the modules for picture files are looked for first: gonio-image.so and gonio-color.so of "
        "the\n"
        "package gonio-media. They are loaded when a picture file is first read or written.");
    module.def("module_folders", &media::module_folders, "The folders in which the modules are looked for, in order.");
}

} // namespace gonio::python
