// Checks that all rendering methods share.
#pragma once

#include <gonio/preview/render.hpp>

namespace gonio::detail {

// Fails (usage) as render() does.
Result<void> check_rendering(std::span<const Light> lights, const RenderOptions& options);

} // namespace gonio::detail
