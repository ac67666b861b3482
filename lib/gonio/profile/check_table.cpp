#include <gonio/profile/parse.hpp>

#include <algorithm>

namespace gonio::profile_detail {

Poles look_at_poles(const std::vector<double>& gammas_deg, const std::vector<double>& table, double peak) {
    Poles poles;
    poles.all_zero = peak == 0.0;
    const std::size_t count = gammas_deg.size();
    const auto differs = [&](std::size_t column) {
        double low = table[column];
        double high = table[column];
        for (std::size_t i = column; i < table.size(); i += count) {
            low = std::min(low, table[i]);
            high = std::max(high, table[i]);
        }
        return high - low > peak * 1e-3;
    };
    poles.nadir_differs = gammas_deg.front() == 0.0 && differs(0);
    poles.zenith_differs = gammas_deg.back() == 180.0 && differs(count - 1);
    return poles;
}

} // namespace gonio::profile_detail
