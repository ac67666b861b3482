#include <gonio/base/gauss_legendre.hpp>
#include <gonio/table/texel_fit.hpp>

#include <algorithm>
#include <cmath>

namespace gonio {

namespace {

constexpr double held_weight = 0.1;

template<std::size_t nodes>
void add_places(std::vector<FitPlace>& places, double begin, double end, double weight) {
    static constexpr auto rule = gauss_legendre<nodes>();
    const double half = 0.5 * (end - begin);
    for (const QuadratureNode& node : rule)
        places.push_back({begin + half * (1.0 + node.at), half * node.weight * weight});
}

} // namespace

Between between(TableAxes axes, double at, int count) {
    const double last = count - 1.0;
    const double place = std::clamp(axes == TableAxes::linear ? at * count - 0.5 : at * last, 0.0, last);
    const auto first = static_cast<std::size_t>(place);
    return {first, std::min(first + 1, static_cast<std::size_t>(count - 1)), place - static_cast<double>(first)};
}

std::vector<FitPlace> fit_places(TableAxes axes, int count) {
    std::vector<FitPlace> places;
    const bool linear = axes == TableAxes::linear;
    const auto texel = [&](int index) { return linear ? (index + 0.5) / count : index / (count - 1.0); };
    if (linear) add_places<4>(places, 0.0, texel(0), held_weight);
    for (int index = 0; index + 1 < count; ++index)
        if (index == 0)
            add_places<4>(places, texel(index), texel(index + 1), 1.0);
        else
            add_places<2>(places, texel(index), texel(index + 1), 1.0);
    if (linear) add_places<2>(places, texel(count - 1), 1.0, held_weight);
    return places;
}

std::vector<double> fitted_texels(TableAxes axes, int count, std::span<const FitPlace> places,
                                  std::span<const double> values) {
    const auto size = static_cast<std::size_t>(count);
    // The equations: `middle` and, symmetric, `beside` of the matrix; `texels` first holds their right side.
    std::vector<double> middle(size);
    std::vector<double> beside(size);
    std::vector<double> texels(size);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto [at, weight] = places[i];
        const auto [first, second, share] = between(axes, at, count);
        middle[first] += weight * (1.0 - share) * (1.0 - share);
        texels[first] += weight * (1.0 - share) * values[i];
        if (second == first) continue;
        middle[second] += weight * share * share;
        beside[first] += weight * share * (1.0 - share);
        texels[second] += weight * share * values[i];
    }
    // Elimination without a pivot: the matrix is positive definite.
    for (std::size_t k = 1; k < size; ++k) {
        const double factor = beside[k - 1] / middle[k - 1];
        middle[k] -= factor * beside[k - 1];
        texels[k] -= factor * texels[k - 1];
    }
    texels[size - 1] /= middle[size - 1];
    for (std::size_t k = size - 1; k-- > 0;)
        texels[k] = (texels[k] - beside[k] * texels[k + 1]) / middle[k];
    return texels;
}

} // namespace gonio
