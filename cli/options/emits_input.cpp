#include "emits_input.hpp"

#include <gonio/base/file_scope.hpp>
#include <gonio/scene/emissive_lights.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace gonio::cli {

namespace {

Result<NamedEmission> read_one(const std::string& text, const Stage& stage, FileScope& files,
                               Diagnostics& diagnostics) {
    const std::size_t equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const auto names = surface_names(stage);
    if (std::find(names.begin(), names.end(), name) != names.end() &&
        (equals == std::string::npos || equals + 1 == text.size()))
        return fail("USE0104", fmt::format("--emits {} has no amount", name), fmt::format("write {}=500nt", name));
    if (equals == std::string::npos || equals == 0)
        return fail("USE0104", fmt::format("--emits '{}' names no surface", text),
                    fmt::format("write SURFACE=AMOUNT, for example {}=500nt; there are: {}", names.back(),
                                fmt::join(names, ", ")));
    Result<SurfaceEmission> emission =
        parse_surface_emission(std::string_view(text).substr(equals + 1), &diagnostics, &files);
    if (!emission) return pass_on(emission);
    return NamedEmission{text.substr(0, equals), *emission};
}

} // namespace

Result<void> read_emits(const Arguments& arguments, Stage& stage, LightsInput& input, Diagnostics& diagnostics) {
    for (const NamedEmission& named : input.rig.emits)
        if (Result<void> set = let_emit(stage, named); !set) return set;
    FileScope files = FileScope::anywhere();
    std::vector<std::string> given;
    for (const std::string& text : arguments.values("--emits")) {
        Result<NamedEmission> named = read_one(text, stage, files, diagnostics);
        if (!named) return pass_on(named);
        if (std::find(given.begin(), given.end(), named->surface) != given.end())
            return fail("USE0107", fmt::format("--emits {} is given twice", named->surface));
        given.push_back(named->surface);
        if (Result<void> set = let_emit(stage, *named); !set) return set;
    }
    input.files.insert(input.files.end(), files.named().begin(), files.named().end());
    Result<std::vector<LightDescription>> lights = emissive_lights(stage);
    if (!lights) return pass_on(lights);
    input.others.insert(input.others.begin(), std::make_move_iterator(lights->begin()),
                        std::make_move_iterator(lights->end()));
    return {};
}

Result<void> require_any_light(const LightsInput& input, const Stage& stage, bool has_sky) {
    if (has_sky || !input.others.empty() || !input.rig.lights.empty()) return {};
    if (Result<void> own = require_lights(input.rig); !own) return own;
    return fail("USE0104", fmt::format("nothing lights the stage '{}'", stage.name),
                "the rig's surfaces that emit are those of its own stage: leave --stage out, or add a light",
                input.rig_file);
}

} // namespace gonio::cli
