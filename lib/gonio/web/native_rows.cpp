#include <gonio/web/goniometer.hpp>
#include <gonio/web/native_rows.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace gonio::web_detail {

namespace {

// The cosine and the sine of C, as direction_of() multiplies them: the sine of 90° is 1.
glm::dvec3 azimuth(double c_deg) {
    return direction_of(Photometry::c, {c_deg, 90.0});
}

} // namespace

NativeRows::NativeRows(const Web& web, std::span<const double> gammas_deg)
    : web_(web), quick_(web), x_(gammas_deg.size()), y_(gammas_deg.size()) {
    assert(web.photometry() != Photometry::c);
    for (const double gamma : gammas_deg) {
        const glm::dvec3 direction = direction_of(Photometry::c, {0.0, gamma}); // the cosine of 0° is 1
        sines_.push_back(direction.x);
        z_.push_back(direction.z);
    }
}

double NativeRows::exact(double c_deg, std::size_t gamma) const {
    const glm::dvec3 at = azimuth(c_deg);
    return web_.candela(glm::dvec3(sines_[gamma] * at.x, sines_[gamma] * at.y, z_[gamma]));
}

void NativeRows::exact(double c_deg, std::span<double> to) const {
    const glm::dvec3 at = azimuth(c_deg);
    for (std::size_t j = 0; j < sines_.size(); ++j)
        to[j] = web_.candela(glm::dvec3(sines_[j] * at.x, sines_[j] * at.y, z_[j]));
}

void NativeRows::quick(double c_deg, std::span<double> to) {
    const glm::dvec3 at = azimuth(c_deg);
    for (std::size_t j = 0; j < sines_.size(); ++j) {
        x_[j] = sines_[j] * at.x;
        y_[j] = sines_[j] * at.y;
    }
    quick_.candela(x_, y_, z_, to);
}

bool is_lit_at(const Web& web, const QuickWeb& quick, double gamma_deg) {
    constexpr std::size_t chunk = 40;
    std::array<glm::dvec3, chunk> directions{};
    std::array<double, chunk> candela{};
    std::array<char, chunk> is_exact{};
    if (web.candela(0.0, gamma_deg) != 0.0) return true;
    for (int begin = 0; begin < 360; begin += static_cast<int>(chunk)) {
        for (std::size_t i = 0; i < chunk; ++i)
            directions[i] =
                direction_of(Photometry::c, {static_cast<double>(begin) + static_cast<double>(i), gamma_deg});
        quick.candela(directions, candela, is_exact);
        for (std::size_t i = 0; i < chunk; ++i) {
            const double least = is_exact[i] != 0 ? 0.0 : quick.margin_cd();
            if (std::abs(candela[i]) > least) return true;
            if (is_exact[i] == 0 && web.candela(directions[i]) != 0.0) return true;
        }
    }
    return false;
}

} // namespace gonio::web_detail
