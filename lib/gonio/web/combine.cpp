#include <gonio/base/sort_unique.hpp>
#include <gonio/web/combine.hpp>
#include <gonio/web/grid.hpp>
#include <gonio/web/resample.hpp>
#include <gonio/web/symmetry.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace gonio {

namespace {

void add_angles(std::vector<double>& to, const std::vector<double>& from) {
    to.insert(to.end(), from.begin(), from.end());
    sort_unique(to);
}

// The web with its mirrors, gaps and table ends written out: linear everywhere within [first, last].
web_detail::Grid whole_grid(const Web& web, double first, double last) {
    if (web.photometry() == Photometry::c) {
        web_detail::Grid grid = web_detail::full_turn(web);
        web_detail::extend_vertical(grid, first, last);
        return grid;
    }
    web_detail::Grid grid = web_detail::stored_grid(expanded(web));
    web_detail::extend_vertical(grid, first, last);
    return grid;
}

struct Ends {
    double low;
    double high;
};

Ends joined(Ends a, std::span<const double> angles) {
    return {std::min(a.low, angles.front()), std::max(a.high, angles.back())};
}

} // namespace

Result<CombinedWeb> combined(std::span<const WeightedWeb> webs) {
    if (webs.empty()) return fail("USE0104", "there is no web to combine");
    const Photometry type = webs.front().web->photometry();
    const bool alike =
        std::all_of(webs.begin(), webs.end(), [&](const WeightedWeb& each) { return each.web->photometry() == type; });
    std::vector<Web> parts;
    double max_error = 0.0;
    for (const WeightedWeb& each : webs) {
        if (alike) {
            parts.push_back(expanded(*each.web));
            continue;
        }
        Result<ResampledWeb> resampled = resampled_to_c(*each.web);
        if (!resampled) return pass_on(resampled);
        max_error += each.weight * resampled->max_error.value;
        parts.push_back(std::move(resampled->web));
    }

    Ends horizontal{parts.front().horizontal_deg().front(), parts.front().horizontal_deg().back()};
    Ends vertical{parts.front().vertical_deg().front(), parts.front().vertical_deg().back()};
    for (const Web& part : parts) {
        horizontal = joined(horizontal, part.horizontal_deg());
        vertical = joined(vertical, part.vertical_deg());
    }
    std::vector<Web> wholes;
    std::vector<double> h;
    std::vector<double> v;
    for (const Web& part : parts) {
        web_detail::Grid grid = whole_grid(part, vertical.low, vertical.high);
        if (part.photometry() != Photometry::c) web_detail::extend_horizontal(grid, horizontal.low, horizontal.high);
        add_angles(h, grid.horizontal_deg);
        add_angles(v, grid.vertical_deg);
        Result<Web> whole = Web::create(part.photometry(), Symmetry::none, std::move(grid.horizontal_deg),
                                        std::move(grid.vertical_deg), std::move(grid.candela));
        if (!whole) return pass_on(whole);
        wholes.push_back(std::move(*whole));
    }
    std::vector<double> candela;
    candela.reserve(h.size() * v.size());
    for (const double at_h : h)
        for (const double at_v : v) {
            double sum = 0.0;
            for (std::size_t i = 0; i < wholes.size(); ++i)
                sum += webs[i].weight * wholes[i].candela_at(at_h, at_v);
            candela.push_back(sum);
        }
    const Photometry result_type = wholes.front().photometry();
    Result<Web> sum = Web::create(result_type, Symmetry::none, std::move(h), std::move(v), std::move(candela));
    if (!sum) return pass_on(sum);
    return CombinedWeb{compacted(*sum, 1e-12), max_error};
}

} // namespace gonio
