// --profile-size: whether measured luminaires emit from their luminous openings or from points.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>

#include "../arguments.hpp"
#include "../command.hpp"

#include <span>

namespace gonio::cli {

inline constexpr Option profile_size_option{
    "--profile-size", "SIZE",
    "where the light of a profile leaves it: opening, as its file declares (usual in preview); off, a point (usual in "
    "probe); or another opening, rect:w=1.2m,h=0.3m"};

// Sets what the shapes of profiles leave unsaid to `usual`, and all of them to --profile-size if it is given. Fails
// (usage) as parse_opening() does.
Result<void> set_profile_sizes(const Arguments& arguments, ProfileSize usual, std::span<LightDescription> lights);

} // namespace gonio::cli
