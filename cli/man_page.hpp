// Manual pages in the roff macros of man(7), made from the commands' descriptions as the help texts are.
#pragma once

#include "command.hpp"

#include <string>

namespace gonio::cli {

// The name of a command's page without its section: "gonio-bake"; of the tool's: "gonio".
std::string man_page_name(const Command& command);

std::string man_page();                       // gonio(1): every command, the environment, the exit status
std::string man_page(const Command& command); // gonio-bake(1)

} // namespace gonio::cli
