#include <gonio/bake/bake.hpp>
#include <gonio/base/limits.hpp>

#include <fmt/format.h>

#include <utility>

namespace gonio {

namespace {

constexpr int least_side = 4;
constexpr int greatest_side = static_cast<int>(limit("auto-texture-side").value);

} // namespace

Result<Texture> bake_smallest(const Web& web, const BakeOptions& options, Candelas max_error) {
    const auto bake = [&](int side) {
        BakeOptions sized = options;
        const TextureSize size = size_of_side(info_of(options.layout), side, options.chart.border);
        sized.width = size.width;
        sized.height = size.height;
        return bake_texture(web, sized);
    };
    int too_small = 0;
    int side = least_side;
    Result<Texture> best = bake(side);
    while (best && best->max_error.value > max_error.value) {
        too_small = side;
        if (side == greatest_side)
            return fail("USE0106",
                        fmt::format("no size up to {}x{} stays within {:.6g} cd: the error there is {:.6g} cd",
                                    best->image.width, best->image.height, max_error.value, best->max_error.value),
                        "allow a larger error, or choose another layout");
        side *= 2;
        best = bake(side);
    }
    while (best && side - too_small > 1 && too_small > 0) {
        const int middle = (side + too_small) / 2;
        Result<Texture> smaller = bake(middle);
        if (!smaller) return smaller;
        if (smaller->max_error.value <= max_error.value) {
            side = middle;
            best = std::move(smaller);
        } else {
            too_small = middle;
        }
    }
    return best;
}

} // namespace gonio
