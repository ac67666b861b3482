// Filling textures with the web's values at points, as some engines read them: at left edges, or from edge to edge.
// Cost: about 100 ns a texel; a mean over C takes an integral.
#pragma once

#include <gonio/bake/layout.hpp>
#include <gonio/bake/texel_store.hpp>
#include <gonio/base/image.hpp>
#include <gonio/web/web.hpp>

#include <span>

namespace gonio {

// `sampling` is not mean. For the totals' flux, each value counts as the mean over its texel. A v180 texture of one row
// stores means over C at the texels' left edges.
StoredTotals fill_points(Image& image, const Web& web, std::span<const PlacedChart> charts, const Storage& storage,
                         Sampling sampling, unsigned threads);

} // namespace gonio
