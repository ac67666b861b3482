// The split sum as a table, as engines look it up.
//
// Columns are n·v and rows are linear roughness, at the middles of texels: column i holds n·v = (i + ½)/size, row j
// roughness (j + ½)/size. Lookups are bilinear and held at the outermost middles, as a texture unit clamps.
#pragma once

#include <gonio/base/image.hpp>
#include <gonio/base/result.hpp>
#include <gonio/ibl/split_sum.hpp>

#include <vector>

#pragma GCC visibility push(default)
namespace gonio {

// The split sum as the texture that renderers look up.
class SplitSumTable {
public:
    // size² texels, in about 0.1 ms each. Fails (usage) on a size that is not in 2 … 1024. The same for any number of
    // threads; 0: all.
    static Result<SplitSumTable> create(int size, SplitSumModel model = SplitSumModel::ggx, unsigned threads = 0);

    static constexpr int most_size = 1024;

    [[nodiscard]] int size() const { return image_.width; }
    [[nodiscard]] SplitSumModel model() const { return model_; }

    // Three channels: A, B, and the diffuse part of frostbite or 0.
    [[nodiscard]] const Image& image() const { return image_; }

    // n·v and roughness in [0, 1].
    [[nodiscard]] SplitSum lookup(double n_dot_v, double roughness) const;

    // mean_albedo() of a roughness in [0, 1], linear between the rows.
    [[nodiscard]] double mean_albedo(double roughness) const;

    // The greatest error of A and B of a lookup, at the middles between texels, where it is greatest: at every
    // `stride`-th of them in both directions, the first included; beyond the outermost middles it is greater.
    [[nodiscard]] double lookup_error(int stride = 1, unsigned threads = 0) const;

private:
    SplitSumTable(Image image, SplitSumModel model, std::vector<double> means);

    Image image_;
    SplitSumModel model_;
    std::vector<double> means_; // of each row
};

} // namespace gonio
#pragma GCC visibility pop
