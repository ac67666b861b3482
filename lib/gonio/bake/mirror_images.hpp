// Which texels of a layout are mirror images of each other, for a web that is symmetric under its mirrors.
//
// A mirror of the light maps each chart onto a chart and, if the layout allows it, texels onto whole texels: s and t
// are kept or swapped, and may run backwards. Mirrors for which this does not hold are left out.
#pragma once

#include <gonio/bake/layout.hpp>
#include <gonio/web/web.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace gonio {

struct TexelPlace {
    std::size_t chart = 0;
    int column = 0; // within the chart
    int row = 0;

    bool operator==(const TexelPlace&) const = default;
};

class MirrorImages {
public:
    // `charts` must outlive this. For an axial web the diagonal mirrors count too.
    MirrorImages(std::span<const PlacedChart> charts, const Web& web);

    // Whether there are any.
    [[nodiscard]] bool any() const { return !mirrors_.empty(); }

    // The first of a texel's images, in the order of charts, rows and columns; often itself.
    [[nodiscard]] TexelPlace first_of(const TexelPlace& texel) const;

    // How many different images it has, including itself.
    [[nodiscard]] std::size_t count_of(const TexelPlace& texel) const;

private:
    struct ChartMap {
        std::size_t chart = 0; // the target chart
        bool swapped = false;  // s is the other chart's t
        bool s_backwards = false;
        bool t_backwards = false;
    };
    using Mirror = std::vector<ChartMap>; // one for each chart

    [[nodiscard]] TexelPlace image(const Mirror& mirror, const TexelPlace& texel) const;

    std::span<const PlacedChart> charts_;
    std::vector<Mirror> mirrors_;
};

} // namespace gonio
