// Parameters: the named properties of a light or a material, set from text, so that one of them can be varied.
//
// The text is the same as in the shape, the material or the rig, with the same units and bounds; a light or material
// that has been given a value equals one that was written with it.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/scene/material.hpp>

#include <span>
#include <string_view>
#include <vector>

namespace gonio {

struct ParameterName {
    std::string_view name;
    std::string_view example; // of a value
    std::string_view summary; // what has it and what it means
    bool is_factor = false;   // an amount or a colour, which is a factor on all that the light does
};

std::span<const ParameterName> light_parameters();
std::span<const ParameterName> material_parameters();

// True if it was set, false if the light (a sphere has no cone) or the material has no parameter of that name. Remarks
// are appended to `diagnostics`. Fails (usage) on a value that is not valid for the parameter or out of its bounds.
Result<bool> set_parameter(LightDescription& light, std::string_view name, std::string_view value,
                           Diagnostics& diagnostics);
Result<bool> set_parameter(Material& material, std::string_view name, std::string_view value);

// The names above that the light or material has.
std::vector<std::string_view> parameters_of(const LightDescription& light);
std::vector<std::string_view> parameters_of(const Material& material);

} // namespace gonio
