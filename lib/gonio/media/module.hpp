// The media modules, for picture files (OpenImageIO) and colour configurations (OpenColorIO).
//
// gonio itself links neither, because a program that links OpenImageIO needs a third of a second to start. Each is in
// a module of its own, gonio-image.so and gonio-color.so, which is opened when a function of this room first needs it.
// A module is looked for in the folders set here, beside the running executable, and where gonio's installation puts
// modules as seen from the executable (bin/ and lib/gonio/ under one prefix), in this order.
#pragma once

#include <string>
#include <vector>

namespace gonio::media {

// The folders that are searched before all others; a module that is open already stays. For programs that are not
// installed beside gonio's tool: the CMake package gives the folder as gonio_MODULE_DIR. Safe to call from any thread.
void set_module_folders(std::vector<std::string> folders);

// Every folder that is searched, in order.
std::vector<std::string> module_folders();

} // namespace gonio::media
