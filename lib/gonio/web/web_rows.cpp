#include <gonio/web/web_rows.hpp>

namespace gonio::web_detail {

WebRows::WebRows(const Web& web, std::span<const double> gammas_deg) : row_(gammas_deg.size()) {
    if (web.photometry() == Photometry::c)
        planes_.emplace(web, gammas_deg);
    else
        native_.emplace(web, gammas_deg);
}

std::span<const double> WebRows::exact(double c_deg) {
    if (native_) {
        native_->exact(c_deg, row_);
        return row_;
    }
    row_.clear();
    planes_->append(c_deg, row_);
    return row_;
}

std::span<const double> WebRows::quick(double c_deg) {
    if (!native_) return exact(c_deg);
    native_->quick(c_deg, row_);
    return row_;
}

} // namespace gonio::web_detail
