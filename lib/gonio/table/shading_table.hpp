// Tables that renderers look up while they shade: the split sum, the energy that GGX loses, and lobes as linearly
// transformed cosines.
//
// Columns are n·v from the left and rows are linear roughness r from the top, α = r²; with the axes heitz the other way
// round. Where a texel is depends on the axes:
//
//     linear   n·v = (column + ½)/width,       r = (row + ½)/height: u = n·v, v = r
//     root     n·v = (column/(width − 1))²,    r = row/(height − 1): the outermost texels hold 0 and 1
//     heitz    r = column/(width − 1),         n·v = 1 − (row/(height − 1))²: the same
//
// Lookups are bilinear and held at the outermost texels, as a texture unit clamps. As a polynomial a table holds the
// coefficients of Chebyshev's polynomials of the root axes instead. Deterministic; the same for any number of threads.
#pragma once

#include <gonio/base/result.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace gonio {

enum class TableKind : std::uint8_t {
    dfg,         // scale A and bias B of the split sum: A F0 + B F90 (split_sum.hpp)
    kulla_conty, // E(n·v) for F = 1, scattered once, and its mean Ē = ∫ 2μ E dμ of the row
    ltc_ggx,     // GGX as a linearly transformed cosine (shading/ltc_lobe.hpp), with its albedos
    ltc_disney,  // the renormalised Disney diffuse of Frostbite in the same form
    ltc_heitz    // the lobe of ltc_ggx as E. Heitz and others (2016) and three.js look it up: LTC_1 and LTC_2
};

enum class TableAxes : std::uint8_t { linear, root, heitz };

// Texels between which a lookup interpolates, or Σᵢⱼ c Tᵢ(2√(n·v) − 1) Tⱼ(2r − 1): column i, row j.
enum class TableForm : std::uint8_t { bilinear, chebyshev };

inline constexpr std::size_t most_table_channels = 8;
inline constexpr int least_table_size = 2;
inline constexpr int most_table_size = 256;

struct TableChannel {
    std::string_view name; // as in EXR files and in code
    std::string_view says;
    // Integers store the square root: for numbers not below 0 of which small ones need a fine step.
    bool root_in_integers = false;
    bool is_of_pose = true; // of n·v and roughness: a part of the lookup; else of other coordinates
};

// A row of the list of tables.
struct TableInfo {
    std::string_view name; // "ltc-ggx"
    TableKind kind;
    std::string_view summary;
    std::span<const TableChannel> channels;
    std::span<const TableAxes> axes; // those that it has; the first are the usual ones
    int size;                        // usual texels a side
    std::string_view error;          // what the error of a lookup is

    [[nodiscard]] bool is_lobe() const { return channels.size() > 2; }
    // GGX's lobe has none: polynomials of it are farther off than as many bytes of texels, and oscillate where it is
    // narrow.
    [[nodiscard]] bool has_polynomials() const { return kind != TableKind::ltc_ggx && kind != TableKind::ltc_heitz; }
};

// All of them, and the one of a kind.
std::span<const TableInfo> table_infos();
const TableInfo& info_of(TableKind kind);

std::string_view to_text(TableAxes axes); // "linear"
std::string_view to_text(TableForm form); // "bilinear"

// One number for each channel; those that a table does not have are 0.
using TableValues = std::array<double, most_table_channels>;

// What a table approximates, n·v in [0, 1] and linear roughness in [0, 1]: by quadrature (dfg, kulla-conty and the
// albedos of ltc), and the fitted entries of the shading core, with cubic interpolation between them (ltc).
TableValues table_values(TableKind kind, double n_dot_v, double roughness);

struct ShadingTable {
    TableKind kind = TableKind::dfg;
    TableAxes axes = TableAxes::linear;
    TableForm form = TableForm::bilinear;
    int width = 0;             // texels of n·v, or terms; of roughness with the axes heitz
    int height = 0;            // of the other
    std::vector<float> values; // rows from the top, channels interleaved
    bool has_roots = false;    // channels with root_in_integers hold square roots; a lookup squares them

    [[nodiscard]] std::size_t channels() const { return info_of(kind).channels.size(); }
    [[nodiscard]] bool holds_root(std::size_t channel) const {
        return has_roots && info_of(kind).channels[channel].root_in_integers;
    }
    // n·v and roughness in [0, 1].
    [[nodiscard]] TableValues lookup(double n_dot_v, double roughness) const;
};

// Texels of dfg and kulla-conty are those whose lookups are nearest in the mean square (texel_fit.hpp), in some 0.3 ms
// each; those of lobes hold table_values(), in 0.1 ms. Fails (usage) on a width or height outside 2 … 256, on
// linear axes of a lobe or of a polynomial, and on a polynomial of ltc-ggx. `threads` 0: all.
Result<ShadingTable> make_shading_table(TableKind kind, TableForm form, TableAxes axes, int width, int height,
                                        unsigned threads = 0);

} // namespace gonio
