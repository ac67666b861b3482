#include <gonio/profile/parse.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace gonio::profile_detail {

Poles look_at_poles(const std::vector<double>& gammas_deg, const std::vector<double>& table, double peak) {
    Poles poles;
    poles.all_zero = peak == 0.0;
    const std::size_t count = gammas_deg.size();
    const auto spread = [&](std::size_t column) {
        double low = table[column];
        double high = table[column];
        for (std::size_t i = column; i < table.size(); i += count) {
            low = std::min(low, table[i]);
            high = std::max(high, table[i]);
        }
        return peak > 0.0 ? (high - low) / peak : 0.0;
    };
    if (gammas_deg.front() == 0.0) poles.at_nadir = spread(0);
    if (gammas_deg.back() == 180.0) poles.at_zenith = spread(count - 1);
    return poles;
}

std::string Poles::difference() const {
    return fmt::format("the planes differ by {:.2g} % of the peak at {}", 100.0 * std::max(at_nadir, at_zenith),
                       at_nadir >= at_zenith ? "nadir" : "zenith");
}

} // namespace gonio::profile_detail
