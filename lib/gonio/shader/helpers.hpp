// The functions that a shader gets beside the one asked for.
#pragma once

#include <gonio/shader/function.hpp>

#include <span>
#include <string_view>
#include <vector>

namespace gonio::shader {

struct HelperInfo {
    Helper helper;
    std::string_view name;
    Type result;
    std::string_view comment; // one line: value and domain
};

const HelperInfo& info(Helper helper);
// Its body, recorded once.
const Function& function_of(Helper helper);
// All that `functions` call, directly or not; each comes after those that it calls.
std::vector<Helper> helpers_of(std::span<const Function> functions);

} // namespace gonio::shader
