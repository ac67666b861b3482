#include <gonio/base/parallel.hpp>
#include <gonio/ibl/split_sum_table.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace gonio {

namespace {

// Between which texels a value in [0, 1] lies.
struct Between {
    int first;
    int second;
    double share; // of the second
};

Between between(double value, int size) {
    const double at = std::clamp(value * size - 0.5, 0.0, size - 1.0);
    const int first = static_cast<int>(at);
    return {first, std::min(first + 1, size - 1), at - first};
}

} // namespace

SplitSumTable::SplitSumTable(Image image, SplitSumModel model, std::vector<double> means)
    : image_(std::move(image)), model_(model), means_(std::move(means)) {}

Result<SplitSumTable> SplitSumTable::create(int size, SplitSumModel model, unsigned threads) {
    if (size < 2 || size > most_size)
        return fail("USE0106", fmt::format("a split-sum table has 2 to {} texels a side, not {}", most_size, size),
                    "for example 128");
    Image image(size, size, 3);
    std::vector<double> means(static_cast<std::size_t>(size));
    parallel_for(means.size(), threads, [&](std::size_t at) {
        const int row = static_cast<int>(at);
        const double roughness = (row + 0.5) / size;
        for (int column = 0; column < size; ++column) {
            const SplitSum sum = split_sum((column + 0.5) / size, roughness, model);
            float* const texel = image.at(column, row);
            texel[0] = static_cast<float>(sum.scale);
            texel[1] = static_cast<float>(sum.bias);
            texel[2] = static_cast<float>(sum.diffuse);
        }
        means[at] = gonio::mean_albedo(roughness, model);
    });
    return SplitSumTable(std::move(image), model, std::move(means));
}

SplitSum SplitSumTable::lookup(double n_dot_v, double roughness) const {
    const Between x = between(n_dot_v, size());
    const Between y = between(roughness, size());
    const auto channel = [&](int c) {
        const auto texel = [&](int column, int row) { return static_cast<double>(image_.at(column, row)[c]); };
        return (1.0 - y.share) * ((1.0 - x.share) * texel(x.first, y.first) + x.share * texel(x.second, y.first)) +
               y.share * ((1.0 - x.share) * texel(x.first, y.second) + x.share * texel(x.second, y.second));
    };
    return {channel(0), channel(1), channel(2)};
}

double SplitSumTable::mean_albedo(double roughness) const {
    const Between y = between(roughness, size());
    return (1.0 - y.share) * means_[static_cast<std::size_t>(y.first)] +
           y.share * means_[static_cast<std::size_t>(y.second)];
}

double SplitSumTable::lookup_error(int stride, unsigned threads) const {
    const int count = (size() - 2) / stride + 1;
    std::vector<double> most(static_cast<std::size_t>(count), 0.0);
    parallel_for(most.size(), threads, [&](std::size_t at) {
        const double roughness = (static_cast<double>(at) * stride + 1.0) / size();
        for (int i = 0; i < count; ++i) {
            const double n_dot_v = (static_cast<double>(i) * stride + 1.0) / size();
            const SplitSum exact = split_sum(n_dot_v, roughness, model_);
            const SplitSum found = lookup(n_dot_v, roughness);
            most[at] = std::max({most[at], std::abs(found.scale - exact.scale), std::abs(found.bias - exact.bias)});
        }
    });
    return *std::max_element(most.begin(), most.end());
}

} // namespace gonio
