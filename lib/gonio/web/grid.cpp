#include <gonio/web/grid.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

namespace gonio::web_detail {

namespace {

constexpr double same_deg = 1e-9;

struct Plane {
    double c_deg = 0.0;
    std::vector<double> candela;
};

bool is_dark(std::span<const double> candela) {
    return std::all_of(candela.begin(), candela.end(), [](double cd) { return cd == 0.0; });
}

std::vector<double> between(const Plane& low, const Plane& high, double c_deg) {
    const double weight = (c_deg - low.c_deg) / (high.c_deg - low.c_deg);
    std::vector<double> candela(low.candela.size());
    for (std::size_t j = 0; j < candela.size(); ++j)
        candela[j] = low.candela[j] + weight * (high.candela[j] - low.candela[j]);
    return candela;
}

// A sequence of planes without a gap: the stored ones or a mirror image of them.
std::vector<Plane> image(const Web& web, double mirror_deg, bool mirrored, double turn_deg) {
    std::vector<Plane> run;
    const std::span<const double> planes = web.planes_deg();
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const std::span<const double> column = web.column(i);
        run.push_back({turn_deg + (mirrored ? mirror_deg - planes[i] : planes[i]), {column.begin(), column.end()}});
    }
    if (mirrored) std::reverse(run.begin(), run.end());
    return run;
}

std::vector<std::vector<Plane>> images(const Web& web) {
    switch (web.stored_symmetry()) {
    case Symmetry::quadrant:
        return {image(web, 0.0, false, 0.0), image(web, 180.0, true, 0.0), image(web, 0.0, false, 180.0),
                image(web, 360.0, true, 0.0)};
    case Symmetry::bilateral_0_180:
        return {image(web, 0.0, false, 0.0), image(web, 360.0, true, 0.0)};
    case Symmetry::bilateral_90_270:
        return {image(web, 0.0, false, 0.0), image(web, 540.0, true, 0.0)};
    case Symmetry::axial:
    case Symmetry::none:
        break;
    }
    return {image(web, 0.0, false, 0.0)};
}

// Adds zeros in the dark sector between `low_deg` and `high_deg`; none beside planes that are already zero.
void add_dark(std::vector<Plane>& to, double low_deg, double high_deg, bool low_is_dark, bool high_is_dark,
              std::size_t rows) {
    const std::vector<double> zeros(rows, 0.0);
    if (high_deg - low_deg < 3.0 * dark_step_deg) {
        to.push_back({0.5 * (low_deg + high_deg), zeros});
        return;
    }
    if (!low_is_dark) to.push_back({low_deg + dark_step_deg, zeros});
    if (!high_is_dark) to.push_back({high_deg - dark_step_deg, zeros});
}

// The images in sequence once around from the first plane; the last plane is 360° after the first.
std::vector<Plane> ring(const Web& web, Grid& says) {
    std::vector<Plane> planes;
    const std::size_t rows = web.gammas_deg().size();
    const auto gap = [&](double next_deg, const std::vector<double>& next) {
        says.dark_sector = true;
        const double low = planes.back().c_deg;
        const bool low_is_dark = is_dark(planes.back().candela);
        add_dark(planes, low, next_deg, low_is_dark, is_dark(next), rows);
    };
    for (std::vector<Plane>& run : images(web)) {
        auto from = run.begin();
        if (!planes.empty()) {
            if (from->c_deg - planes.back().c_deg <= same_deg)
                ++from;
            else
                gap(from->c_deg, from->candela);
        }
        planes.insert(planes.end(), std::make_move_iterator(from), std::make_move_iterator(run.end()));
    }
    const double closing = planes.front().c_deg + 360.0;
    const Plane last{closing, planes.front().candela};
    if (web.stored_symmetry() == Symmetry::axial) {
        planes.push_back(last);
    } else if (closing - planes.back().c_deg <= same_deg) {
        planes.back().c_deg = closing;
    } else {
        gap(closing, last.candela);
        planes.push_back(last);
    }
    return planes;
}

bool differ(const Plane& a, const Plane& b) {
    double peak = 0.0;
    double difference = 0.0;
    for (std::size_t j = 0; j < a.candela.size(); ++j) {
        peak = std::max({peak, std::abs(a.candela[j]), std::abs(b.candela[j])});
        difference = std::max(difference, std::abs(a.candela[j] - b.candela[j]));
    }
    return difference > 1e-9 * peak;
}

// Rotates the ring so that it begins at a multiple of 360°, and counts angles from there.
std::vector<Plane> begun_at_zero(std::vector<Plane> planes) {
    const double zero = 360.0 * std::ceil((planes.front().c_deg - same_deg) / 360.0);
    std::size_t at = 0;
    while (planes[at].c_deg < zero - same_deg)
        ++at;
    if (planes[at].c_deg > zero + same_deg) {
        Plane inserted{zero, between(planes[at - 1], planes[at], zero)};
        planes.insert(planes.begin() + static_cast<std::ptrdiff_t>(at), std::move(inserted));
    }
    std::vector<Plane> turned;
    const auto add = [&](Plane plane, double turn_deg) {
        plane.c_deg += turn_deg;
        turned.push_back(std::move(plane));
    };
    const std::size_t last = planes.size() - 1;
    for (std::size_t i = at; i < last; ++i)
        add(planes[i], -zero);
    if (at == 0) {
        add(planes[last], -zero);
    } else {
        // If the first and last planes of the ring differ, both are kept, slightly apart.
        if (differ(planes[last], planes.front())) {
            const double before = planes[last].c_deg - dark_step_deg;
            add({before, between(planes[last - 1], planes[last], before)}, -zero);
        }
        for (std::size_t i = 0; i <= at; ++i)
            add(planes[i], 360.0 - zero);
    }
    turned.front().c_deg = 0.0;
    turned.back().c_deg = 360.0;
    return turned;
}

Grid to_grid(const std::vector<Plane>& planes, std::span<const double> gammas, Grid grid) {
    grid.vertical_deg.assign(gammas.begin(), gammas.end());
    for (const Plane& plane : planes) {
        grid.horizontal_deg.push_back(plane.c_deg);
        grid.candela.insert(grid.candela.end(), plane.candela.begin(), plane.candela.end());
    }
    return grid;
}

// Angles to add before and after a list so that it runs from `first` to `last`; the value at them is 0.
struct Extension {
    std::vector<double> before;
    std::vector<double> behind;
};

Extension extension(const std::vector<double>& angles, double first, double last, bool first_is_dark,
                    bool last_is_dark) {
    Extension more;
    if (angles.front() > first) {
        more.before.push_back(first);
        if (!first_is_dark && angles.front() - dark_step_deg > first)
            more.before.push_back(angles.front() - dark_step_deg);
    }
    if (angles.back() < last) {
        if (!last_is_dark && angles.back() + dark_step_deg < last) more.behind.push_back(angles.back() + dark_step_deg);
        more.behind.push_back(last);
    }
    return more;
}

std::vector<double> joined(const Extension& more, const std::vector<double>& angles) {
    std::vector<double> all = more.before;
    all.insert(all.end(), angles.begin(), angles.end());
    all.insert(all.end(), more.behind.begin(), more.behind.end());
    return all;
}

} // namespace

Grid stored_grid(const Web& web) {
    Grid grid;
    grid.horizontal_deg.assign(web.horizontal_deg().begin(), web.horizontal_deg().end());
    grid.vertical_deg.assign(web.vertical_deg().begin(), web.vertical_deg().end());
    for (std::size_t i = 0; i < grid.horizontal_deg.size(); ++i)
        grid.candela.insert(grid.candela.end(), web.column(i).begin(), web.column(i).end());
    return grid;
}

Grid full_turn(const Web& web) {
    Grid says;
    const std::vector<Plane> planes = begun_at_zero(ring(web, says));
    says.jump_at_zero = differ(planes.front(), planes.back());
    return to_grid(planes, web.gammas_deg(), std::move(says));
}

bool reaches_its_ends(const Web& web) {
    const double first = web.planes_deg().front();
    const double last = web.planes_deg().back();
    switch (web.stored_symmetry()) {
    case Symmetry::axial:
        return true;
    case Symmetry::quadrant:
        return first == 0.0 && last == 90.0;
    case Symmetry::bilateral_0_180:
        return first == 0.0 && last == 180.0;
    case Symmetry::bilateral_90_270:
        return first == 90.0 && last == 270.0;
    case Symmetry::none:
        break;
    }
    return false;
}

bool extend_vertical(Grid& grid, double first, double last) {
    const std::size_t rows = grid.rows();
    const auto row_is_dark = [&](std::size_t row) {
        for (std::size_t i = row; i < grid.candela.size(); i += rows)
            if (grid.candela[i] != 0.0) return false;
        return true;
    };
    const Extension more = extension(grid.vertical_deg, first, last, row_is_dark(0), row_is_dark(rows - 1));
    if (more.before.empty() && more.behind.empty()) return false;
    std::vector<double> table;
    for (std::size_t i = 0; i < grid.candela.size(); i += rows) {
        table.insert(table.end(), more.before.size(), 0.0);
        const auto begin = grid.candela.begin() + static_cast<std::ptrdiff_t>(i);
        table.insert(table.end(), begin, begin + static_cast<std::ptrdiff_t>(rows));
        table.insert(table.end(), more.behind.size(), 0.0);
    }
    grid.candela = std::move(table);
    grid.vertical_deg = joined(more, grid.vertical_deg);
    return true;
}

bool extend_horizontal(Grid& grid, double first, double last) {
    const std::size_t rows = grid.rows();
    const std::span<const double> table = grid.candela;
    const Extension more =
        extension(grid.horizontal_deg, first, last, is_dark(table.first(rows)), is_dark(table.last(rows)));
    if (more.before.empty() && more.behind.empty()) return false;
    grid.candela.insert(grid.candela.begin(), more.before.size() * rows, 0.0);
    grid.candela.insert(grid.candela.end(), more.behind.size() * rows, 0.0);
    grid.horizontal_deg = joined(more, grid.horizontal_deg);
    return true;
}

void halve_last_cell(Grid& grid) {
    const std::size_t rows = grid.rows();
    const std::size_t last = grid.horizontal_deg.size() - 1;
    const double middle = 0.5 * (grid.horizontal_deg[last - 1] + grid.horizontal_deg[last]);
    std::vector<double> mean(rows);
    for (std::size_t j = 0; j < rows; ++j)
        mean[j] = 0.5 * (grid.candela[(last - 1) * rows + j] + grid.candela[last * rows + j]);
    grid.candela.insert(grid.candela.begin() + static_cast<std::ptrdiff_t>(last * rows), mean.begin(), mean.end());
    grid.horizontal_deg.insert(grid.horizontal_deg.begin() + static_cast<std::ptrdiff_t>(last), middle);
}

void step_before_the_turn(Grid& grid) {
    const std::size_t rows = grid.rows();
    const std::size_t last = grid.horizontal_deg.size() - 1;
    const double low = grid.horizontal_deg[last - 1];
    const double weight = (360.0 - dark_step_deg - low) / (360.0 - low);
    grid.horizontal_deg[last] = 360.0 - dark_step_deg;
    for (std::size_t j = 0; j < rows; ++j) {
        const double before = grid.candela[(last - 1) * rows + j];
        grid.candela[last * rows + j] = before + weight * (grid.candela[last * rows + j] - before);
    }
    grid.horizontal_deg.push_back(360.0);
    const std::vector<double> first(grid.candela.begin(), grid.candela.begin() + static_cast<std::ptrdiff_t>(rows));
    grid.candela.insert(grid.candela.end(), first.begin(), first.end());
}

double even_step(const std::vector<double>& angles_deg, double tolerance_deg) {
    if (angles_deg.size() < 2) return 0.0;
    const double step = angles_deg[1] - angles_deg[0];
    for (std::size_t i = 1; i < angles_deg.size(); ++i)
        if (std::abs(angles_deg[i] - angles_deg[i - 1] - step) >= tolerance_deg) return 0.0;
    return step;
}

} // namespace gonio::web_detail
