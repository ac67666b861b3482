// Intensities of a web of type A or B on many planes of type C at the same γ: the sines of each angle are found once.
// Internal to the web room.
#pragma once

#include <gonio/web/quick_web.hpp>
#include <gonio/web/web.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace gonio::web_detail {

class NativeRows {
public:
    // The web must be of type A or B and outlive this; γ from 0° to 180°.
    NativeRows(const Web& web, std::span<const double> gammas_deg);

    // web.candela(C, γ) at each γ: the same to the last bit. C must be finite.
    void exact(double c_deg, std::span<double> to) const;
    // At one of them.
    [[nodiscard]] double exact(double c_deg, std::size_t gamma) const;

    // The same within margin_cd(), in a third of the time.
    void quick(double c_deg, std::span<double> to);
    [[nodiscard]] double margin_cd() const { return quick_.margin_cd(); }

private:
    const Web& web_;
    QuickWeb quick_;
    std::vector<double> sines_; // of γ
    std::vector<double> z_;
    std::vector<double> x_;
    std::vector<double> y_;
};

// Whether the web has light at γ in a direction of whole degrees of C.
bool is_lit_at(const Web& web, const QuickWeb& quick, double gamma_deg);

} // namespace gonio::web_detail
