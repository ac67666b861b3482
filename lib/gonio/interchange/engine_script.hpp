// Scripts that list the lights of a scene inside a program whose files gonio does not read, as the JSON that it does.
#pragma once

#include <gonio/base/result.hpp>

#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// A script for a program.
struct EngineScript {
    std::string_view program; // "unreal"
    std::string_view file;    // what to call it
    std::string_view text;    // Python or C#
};

// By program.
std::span<const EngineScript> engine_scripts();

// Fails (usage) on an unknown program.
Result<const EngineScript*> find_engine_script(std::string_view program);

} // namespace gonio
#pragma GCC visibility pop
