#include <gonio/bake/latlong_fill.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/symmetry.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr double radians_per_degree = pi / 180.0;

double at_column(std::size_t column, std::size_t width) {
    return static_cast<double>(column) / static_cast<double>(width) * 360.0;
}

} // namespace

LatlongFill::LatlongFill(const Web& web, int width, bool skip)
    : web_(web), width_(static_cast<std::size_t>(width)), skip_(skip) {
    const std::span<const double> gammas = web.gammas_deg();
    std::size_t first_lit = gammas.size();
    std::size_t last_lit = 0;
    for (std::size_t p = 0; p < web.planes_deg().size(); ++p)
        for (std::size_t j = 0; j < gammas.size(); ++j)
            if (web.column(p)[j] != 0.0) {
                first_lit = std::min(first_lit, j);
                last_lit = std::max(last_lit, j);
            }
    if (first_lit < gammas.size()) {
        lit_from_deg_ = gammas[first_lit > 0 ? first_lit - 1 : 0];
        lit_to_deg_ = gammas[std::min(last_lit + 1, gammas.size() - 1)];
    }

    const Symmetry stored = skip ? web.stored_symmetry() : Symmetry::none;
    const std::size_t w = width_;
    switch (stored) {
    case Symmetry::axial:
        add_pieces(0, 1, w);
        break; // and one value for the whole row, see row()
    case Symmetry::bilateral_0_180:
        add_pieces(0, w / 2, 2);
        add_pieces(w / 2, w - w / 2, 1); // an odd width has a column that is its own mirror image
        copies_.push_back({0, w / 2, w - w / 2});
        break;
    case Symmetry::bilateral_90_270:
        if (w % 2 != 0) {
            add_pieces(0, w, 1); // no column is the mirror image of another
        } else {
            // The mirror maps i to w/2 − 1 − i, modulo w: if w/2 is odd, two columns are their own images.
            const std::size_t begin = w / 4;
            const std::size_t own = w / 2 % 2;
            add_pieces(begin, begin + own, 1);
            add_pieces(begin + own, begin + w / 2, 2);
            add_pieces(begin + w / 2, begin + w / 2 + own, 1);
            const std::size_t end = begin + w / 2 + own;
            copies_.push_back({begin + own, begin, 0});             // the first quarter
            copies_.push_back({begin + own + begin, w - end, end}); // the last one
        }
        break;
    case Symmetry::quadrant:
        if (w % 2 != 0) {
            add_pieces(0, w / 2, 2);
            add_pieces(w / 2, w - w / 2, 1);
            copies_.push_back({0, w / 2, w - w / 2});
        } else {
            const std::size_t quarter = w / 4;
            const std::size_t own = w / 2 % 2;
            add_pieces(0, quarter, 4);
            add_pieces(quarter, quarter + own, 2);
            copies_.push_back({0, quarter, quarter + own});
            copies_.push_back({0, w / 2, w / 2});
        }
        break;
    case Symmetry::none:
        add_pieces(0, w, 1);
        break;
    }
}

// The planes on either side of C, which is folded first, and the weight of the right one.
void LatlongFill::locate(double c_deg, Piece& piece) const {
    const std::span<const double> planes = web_.planes_deg();
    piece.reached = web_.stored_symmetry() == Symmetry::axial ||
                    (c_deg >= planes.front() && c_deg <= planes.back() && planes.size() > 1);
    if (!piece.reached || planes.size() < 2) return;
    const auto above = std::upper_bound(planes.begin(), planes.end(), c_deg);
    piece.right = std::min(static_cast<std::size_t>(above - planes.begin()), planes.size() - 1);
    piece.left = piece.right - 1;
    piece.weight = (c_deg - planes[piece.left]) / (planes[piece.right] - planes[piece.left]);
}

LatlongFill::Piece LatlongFill::mixed_piece(std::size_t column, const std::vector<double>& bends) const {
    Piece piece;
    piece.first = column;
    piece.count = 1;
    piece.mixed = plane_terms(web_, bends, at_column(column, width_), at_column(column + 1, width_));
    for (Term& term : piece.mixed)
        term.weight *= static_cast<double>(width_) / (2.0 * pi);
    locate(web_.folded_c_deg((static_cast<double>(column) + 0.5) / static_cast<double>(width_) * 360.0), piece);
    return piece;
}

// Columns [from, to), cut at the bends of the web.
void LatlongFill::add_pieces(std::size_t from, std::size_t to, std::size_t images) {
    const std::vector<double> bends = plane_bends_deg(web_);
    const std::span<const double> planes = web_.planes_deg();
    const auto width = static_cast<double>(width_);
    for (std::size_t i = from; i < to;) {
        // The columns from i on that end before the next bend.
        const auto next = std::upper_bound(bends.begin(), bends.end(), at_column(i, width_));
        const double end_deg = next == bends.end() ? 360.0 : *next;
        auto end = static_cast<std::size_t>(std::max(0.0, end_deg / 360.0 * width + 1.0));
        end = std::min(end, to);
        while (end > i && at_column(end, width_) > end_deg)
            --end;
        if (end <= i + 1) {
            pieces_.push_back(mixed_piece(i, bends));
            pieces_.back().images = images;
            ++i;
            continue;
        }
        Piece piece;
        piece.first = i;
        piece.count = end - i;
        piece.images = images;
        const double first_c = web_.folded_c_deg((static_cast<double>(i) + 0.5) / width * 360.0);
        const double last_c = web_.folded_c_deg((static_cast<double>(end) - 0.5) / width * 360.0);
        i = end;
        locate(0.5 * (first_c + last_c), piece);
        if (!piece.reached) continue; // dark
        if (piece.right > piece.left) {
            const double cell = planes[piece.right] - planes[piece.left];
            piece.weight = (first_c - planes[piece.left]) / cell;
            piece.weight_step = (last_c - first_c) / cell / static_cast<double>(piece.count - 1);
        }
        pieces_.push_back(std::move(piece));
    }
}

LatlongFill::PlaneValues LatlongFill::plane_values(double low_deg, double high_deg) const {
    const std::span<const double> gammas = web_.gammas_deg();
    const Terms terms = gamma_terms(web_, low_deg, high_deg);
    const double measure = integrate_linear_sin(low_deg * radians_per_degree, high_deg * radians_per_degree, 1.0, 1.0);
    const double middle = 0.5 * (low_deg + high_deg);
    const auto above = std::upper_bound(gammas.begin(), gammas.end(), middle);
    const auto upper = std::min(static_cast<std::size_t>(above - gammas.begin()), gammas.size() - 1);
    const bool inside = middle >= gammas.front() && middle <= gammas.back();
    const std::size_t lower = upper > 0 ? upper - 1 : 0;
    const double weight = upper > lower ? (middle - gammas[lower]) / (gammas[upper] - gammas[lower]) : 0.0;
    PlaneValues values{std::vector<double>(web_.planes_deg().size(), 0.0),
                       std::vector<double>(web_.planes_deg().size())};
    for (std::size_t p = 0; p < values.mean.size(); ++p) {
        const std::span<const double> column = web_.column(p);
        for (const Term& term : terms)
            values.mean[p] += term.weight / measure * column[term.index];
        values.center[p] = inside ? column[lower] + weight * (column[upper] - column[lower]) : 0.0;
    }
    return values;
}

StoredTotals LatlongFill::row(double low_deg, double high_deg, const Storage& storage, std::span<float> texels) const {
    StoredTotals totals;
    const double texel_sr =
        integrate_linear_sin(low_deg * radians_per_degree, high_deg * radians_per_degree, 1.0, 1.0) * 2.0 * pi /
        static_cast<double>(width_);
    totals.steradians = texel_sr * static_cast<double>(width_);
    if (skip_ && (high_deg <= lit_from_deg_ || low_deg >= lit_to_deg_)) return totals;
    const PlaneValues values = plane_values(low_deg, high_deg);
    double sum = 0.0;
    for (const Piece& piece : pieces_) {
        const std::span<float> out = texels.subspan(piece.first, piece.count);
        const double center = values.center[piece.left];
        const double center_rise = values.center[piece.right] - center;
        const double center_first = piece.reached ? center + piece.weight * center_rise : 0.0;
        double stored = 0.0;
        if (piece.count == 1) {
            double mean = 0.0;
            for (const Term& term : piece.mixed)
                mean += term.weight * values.mean[term.index];
            stored = store_texel(mean, center_first, storage, out[0], totals);
        } else {
            const double mean = values.mean[piece.left];
            const double mean_rise = values.mean[piece.right] - mean;
            stored = store_run({mean + piece.weight * mean_rise, piece.weight_step * mean_rise, center_first,
                                piece.weight_step * center_rise},
                               storage, out, totals);
        }
        sum += stored * static_cast<double>(piece.images);
    }
    totals.lumens = sum * texel_sr;
    for (const Copy& copy : copies_)
        std::reverse_copy(texels.begin() + static_cast<std::ptrdiff_t>(copy.from),
                          texels.begin() + static_cast<std::ptrdiff_t>(copy.from + copy.count),
                          texels.begin() + static_cast<std::ptrdiff_t>(copy.to));
    if (skip_ && web_.stored_symmetry() == Symmetry::axial) std::fill(texels.begin() + 1, texels.end(), texels[0]);
    return totals;
}

} // namespace gonio
