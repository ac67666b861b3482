// A web's intensities on many planes of C at the same γ: each γ is found once. Internal to the library.
#pragma once

#include <gonio/web/native_rows.hpp>
#include <gonio/web/plane_rows.hpp>
#include <gonio/web/web.hpp>

#include <optional>
#include <span>
#include <vector>

namespace gonio::web_detail {

// A web of any type. What its functions return lasts until the next call.
class WebRows {
public:
    // The web must outlive this; γ from 0° to 180°.
    WebRows(const Web& web, std::span<const double> gammas_deg);

    // web.candela(C, γ) at each γ: the same to the last bit. C must be finite.
    std::span<const double> exact(double c_deg);
    // The same within margin_cd(), in less time for types A and B.
    std::span<const double> quick(double c_deg);
    [[nodiscard]] double margin_cd() const { return native_ ? native_->margin_cd() : 0.0; }

private:
    std::optional<PlaneRows> planes_; // type C
    std::optional<NativeRows> native_;
    std::vector<double> row_;
};

} // namespace gonio::web_detail
