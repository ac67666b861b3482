#include "bounces.hpp"

#include <gonio/asset/stage_scene.hpp>
#include <gonio/transport/lighting_options.hpp>

#include "values.hpp"

#include <fmt/format.h>

namespace gonio::cli {

Result<int> read_bounces(const Arguments& arguments) {
    const auto text = arguments.value("--indirect");
    if (!text || *text == "all") return all_bounces;
    if (*text == "off") return 0;
    const Result<std::uint64_t> bounces = whole_number(*text, "--indirect");
    if (!bounces)
        return fail("USE0105", fmt::format("--indirect takes all, off or a number of bounces, not '{}'", *text),
                    "for example --indirect 2");
    if (*bounces > max_bounces)
        return fail("USE0106", fmt::format("--indirect {} is above {}", *bounces, max_bounces),
                    "all is until the light is absorbed");
    return static_cast<int>(*bounces);
}

} // namespace gonio::cli
