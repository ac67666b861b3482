// Filling the textures of every other layout: line integrals around texels (gonio/bake/texel_flux.hpp), of those that
// are no mirror image of another and not dark.
#pragma once

#include <gonio/bake/layout.hpp>
#include <gonio/bake/texel_store.hpp>
#include <gonio/base/image.hpp>
#include <gonio/web/web.hpp>

#include <span>

namespace gonio {

// `image` is 0 all over; `skip` and `threads` as BakeOptions have them.
StoredTotals fill_charts(Image& image, const Web& web, std::span<const PlacedChart> charts, const Storage& storage,
                         bool skip, unsigned threads);

} // namespace gonio
