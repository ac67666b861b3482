// Filling latlong and v180 textures of type C webs: the means of gonio/bake/latlong.hpp, one run after the other.
//
// A mean is linear from column to column as long as the columns lie between two planes of the table, so every row is a
// few straight lines (gonio/bake/texel_store.hpp) and, where a plane crosses a column, single texels. Cost per row:
// O(planes + lines of the table in the row), and about 1 ns a texel.
#pragma once

#include <gonio/bake/texel_store.hpp>
#include <gonio/base/image.hpp>
#include <gonio/web/separable.hpp>
#include <gonio/web/web.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace gonio {

class LatlongFill {
public:
    // `web` is of type C and outlives this. `skip`: columns that a mirror of the web gives are copied, and rows outside
    // its light are left at 0, instead of evaluating them.
    LatlongFill(const Web& web, int width, bool skip);

    // Stores the row that covers γ in [low, high] into texels that are 0; returns its totals.
    StoredTotals row(double low_deg, double high_deg, const Storage& storage, std::span<float> texels) const;

private:
    // Columns between two planes, or outside all planes, or one column with several planes.
    struct Piece {
        std::size_t first = 0;
        std::size_t count = 0;
        std::size_t images = 1; // how often it occurs, counting mirror images
        std::size_t left = 0;   // stored planes
        std::size_t right = 0;
        double weight = 0.0; // of the right plane, at the middle of the first column
        double weight_step = 0.0;
        bool reached = false; // the planes cover it
        Terms mixed;          // for one column: the weight of each plane
    };
    struct Copy { // to[k] = from[count − 1 − k]
        std::size_t from = 0;
        std::size_t count = 0;
        std::size_t to = 0;
    };

    // One number for each stored plane: its value in a row.
    struct PlaneValues {
        std::vector<double> mean;
        std::vector<double> center; // at the row's middle
    };
    PlaneValues plane_values(double low_deg, double high_deg) const;

    void add_pieces(std::size_t from, std::size_t to, std::size_t images);
    void locate(double c_deg, Piece& piece) const;
    Piece mixed_piece(std::size_t column, const std::vector<double>& bends) const;

    const Web& web_;
    std::size_t width_;
    bool skip_;
    double lit_from_deg_ = 0.0; // γ outside which every stored intensity is 0
    double lit_to_deg_ = 0.0;
    std::vector<Piece> pieces_;
    std::vector<Copy> copies_;
};

} // namespace gonio
