// The suites, each in its own file. Internal to this room.
#pragma once

#include <gonio/measure/suite.hpp>

namespace gonio::measure::detail {

std::vector<std::string> irradiance_methods();
std::vector<ContestMaker> irradiance_contests(const SuiteOptions& options);

std::vector<std::string> specular_methods();
std::vector<ContestMaker> specular_contests(const SuiteOptions& options);

std::vector<std::string> brdf_methods();
std::vector<ContestMaker> brdf_contests(const SuiteOptions& options);

std::vector<std::string> color_methods();
std::vector<ContestMaker> color_contests(const SuiteOptions& options);

std::vector<std::string> profile_methods();
std::vector<ContestMaker> profile_contests(const SuiteOptions& options);

std::vector<std::string> bake_methods();
std::vector<ContestMaker> bake_contests(const SuiteOptions& options);

std::vector<std::string> preview_methods();
std::vector<ContestMaker> preview_contests(const SuiteOptions& options);

std::vector<std::string> indirect_methods();
std::vector<ContestMaker> indirect_contests(const SuiteOptions& options);

std::vector<std::string> prefilter_methods();
std::vector<ContestMaker> prefilter_contests(const SuiteOptions& options);

std::vector<std::string> opening_methods();
std::vector<ContestMaker> opening_contests(const SuiteOptions& options);

std::vector<std::string> image_methods();
std::vector<ContestMaker> image_contests(const SuiteOptions& options);

// The names of methods, each once, in the order of their first appearance.
template<class Methods>
void add_names(const Methods& methods, std::vector<std::string>& names) {
    for (const auto& method : methods) {
        bool known = false;
        for (const std::string& name : names)
            known = known || name == method.name;
        if (!known) names.push_back(method.name);
    }
}

// The index of a method in one code; 0 if there is none.
template<class Methods>
std::size_t place_of(const Methods& methods, std::string_view name, std::string_view code) {
    for (std::size_t i = 0; i < methods.size(); ++i)
        if (methods[i].name == name && methods[i].precision == code) return i;
    return 0;
}

} // namespace gonio::measure::detail
