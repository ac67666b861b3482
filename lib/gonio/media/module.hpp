// The media modules, for picture files (OpenImageIO), colour configurations (OpenColorIO) and PDF (cairo).
//
// gonio itself links none of them, because a program that links OpenImageIO takes a third of a second to start. Each
// library is in a separate module, gonio-image.so, gonio-color.so and gonio-pdf.so, which is opened when a function of
// this room first needs it; gonio-writers.so writes PNG and OpenEXR by the libraries of these formats alone. A module
// is searched in the folders set here, beside the running executable, where gonio's installation puts modules relative
// to the executable (bin/ and lib/gonio/ under one prefix), and in gonio/ beside the shared library if the program uses
// that, in this order.
#pragma once

#include <string>
#include <vector>

#pragma GCC visibility push(default)
namespace gonio::media {

// The folders that are searched before all others; a module that is already open stays open. For programs that are not
// installed beside gonio's tool and contain the library: the CMake package provides the folder as gonio_MODULE_DIR,
// pkg-config as the variable `modules`. Safe to call from any thread.
void set_module_folders(std::vector<std::string> folders);

// Every folder that is searched, in order.
std::vector<std::string> module_folders();

// The files of the modules that are open in this process: "gonio-writers.so". Safe to call from any thread.
std::vector<std::string> opened_modules();

} // namespace gonio::media
#pragma GCC visibility pop
