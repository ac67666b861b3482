// Help texts, made from the commands' descriptions.
#pragma once

#include "command.hpp"

#include <string>

namespace gonio::cli {

std::string overview();                        // `gonio help`
std::string help_text(const Command& command); // `gonio help CMD`

} // namespace gonio::cli
