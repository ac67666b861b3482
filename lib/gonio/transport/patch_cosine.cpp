#include <gonio/transport/patch_cosine.hpp>

#include <numbers>

namespace gonio::detail {

double PatchCosine::of_lit_part(double a, double m, double b) const {
    constexpr double turn = 2.0 * std::numbers::pi;
    // From the direction to where A cos + B ends to be positive.
    const double lit = a > std::abs(b) ? std::acos(-b / a) : b > 0.0 ? std::numbers::pi : 0.0;
    double sum = 0.0;
    for (const double about : {-turn, 0.0, turn}) {
        const double low = std::max(m - half_turn_, about - lit);
        const double high = std::min(m + half_turn_, about + lit);
        if (low < high) sum += a * (std::sin(high) - std::sin(low)) + b * (high - low);
    }
    return std::max(sum / (2.0 * half_turn_), 0.0);
}

} // namespace gonio::detail
