// Filling the textures of every other layout: line integrals around those texels (gonio/bake/texel_flux.hpp) that are
// not a mirror image of another and not dark.
#pragma once

#include <gonio/bake/layout.hpp>
#include <gonio/bake/texel_store.hpp>
#include <gonio/base/image.hpp>
#include <gonio/web/web.hpp>

#include <span>

namespace gonio {

// `image` is all 0; `skip` and `threads` as in BakeOptions.
StoredTotals fill_charts(Image& image, const Web& web, std::span<const PlacedChart> charts, const Storage& storage,
                         bool skip, unsigned threads);

} // namespace gonio
