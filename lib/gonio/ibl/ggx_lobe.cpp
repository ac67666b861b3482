#include <gonio/base/gauss_legendre.hpp>
#include <gonio/ibl/ggx_lobe.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {

using std::numbers::pi;

GgxLobe::GgxLobe(double roughness)
    : alpha_(std::pow(std::max(roughness, least_roughness), 2.0)),
      peak_(4.0 * alpha_ * alpha_ / pi),
      offset_(2.0 * alpha_ * alpha_),
      falloff_((1.0 - alpha_) * (1.0 + alpha_)) {
    whole_ = 2.0 * pi * integral(1.0);
}

double GgxLobe::integral(double u) const {
    u = std::clamp(u, 0.0, 1.0);
    // The closed form cancels in falloff² where the lobe is nearly Lambert's; there Gauss nodes have all digits.
    constexpr double nearly_flat = 0.3;
    if (falloff_ == 0.0) return peak_ * u * (1.0 - 0.5 * u) / (offset_ * offset_);
    if (falloff_ < nearly_flat) {
        double sum = 0.0;
        for (const QuadratureNode& node : gauss_legendre<16>()) {
            const double at = 0.5 * u * (1.0 + node.at);
            sum += node.weight * weight(at);
        }
        return 0.5 * u * sum;
    }
    // ∫ c/x² dc = (ln x + (offset + falloff)/x)/falloff², taken as a difference.
    const double step = falloff_ * u;
    const double x = offset_ + step;
    return peak_ / (falloff_ * falloff_) * ((offset_ + falloff_) * step / (offset_ * x) - std::log1p(step / offset_));
}

} // namespace gonio
