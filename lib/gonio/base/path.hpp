// The parts of a path, as text.
#pragma once

#include <string>
#include <string_view>

namespace gonio {

// Without its folders: "lamp.ies" of "a/lamp.ies".
std::string file_name(std::string_view path);

// Behind the last dot of the file's name, without that dot: "ies". Empty if there is none, or only one in front.
std::string_view extension_of(std::string_view path);

// Without the dot and the extension: "a/lamp" of "a/lamp.ies".
std::string without_extension(std::string_view path);

} // namespace gonio
