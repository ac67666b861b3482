#include <gonio/base/frame.hpp>
#include <gonio/base/gauss_legendre.hpp>
#include <gonio/base/sort_unique.hpp>
#include <gonio/light/lobe.hpp>
#include <gonio/light/masked_flux.hpp>
#include <gonio/light/shape_traits.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/rings.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

namespace gonio {

namespace {

using std::numbers::pi;

constexpr double radians_per_degree = pi / 180.0;

constexpr auto rule = gauss_legendre<16>();

template<class F>
double gauss(double low, double high, F&& f) {
    const double middle = 0.5 * (low + high);
    const double half = 0.5 * (high - low);
    double sum = 0.0;
    for (const QuadratureNode& node : rule)
        sum += node.weight * f(middle + half * node.at);
    return half * sum;
}

// Halves the interval until the sum of both halves agrees with the whole.
template<class F>
double halved_gauss(double low, double high, double whole, double tolerance, int depth, F&& f) {
    const double middle = 0.5 * (low + high);
    const double left = gauss(low, middle, f);
    const double right = gauss(middle, high, f);
    if (depth == 0 || std::abs(left + right - whole) <= tolerance) return left + right;
    return halved_gauss(low, middle, left, tolerance, depth - 1, f) +
           halved_gauss(middle, high, right, tolerance, depth - 1, f);
}

std::vector<double> in_radians(std::span<const double> angles_deg) {
    std::vector<double> angles(angles_deg.size());
    std::transform(angles_deg.begin(), angles_deg.end(), angles.begin(),
                   [](double deg) { return deg * radians_per_degree; });
    return angles;
}

// ∫ mask dC over the whole circle at each γ of the web.
std::vector<double> around_circle(const Web& mask) {
    const std::span<const double> planes = mask.planes_deg();
    std::vector<double> sum(mask.gammas_deg().size(), 0.0);
    if (mask.stored_symmetry() == Symmetry::axial) {
        for (std::size_t j = 0; j < sum.size(); ++j)
            sum[j] = 2.0 * pi * mask.column(0)[j];
        return sum;
    }
    const double images = image_count(mask.stored_symmetry());
    for (std::size_t p = 1; p < planes.size(); ++p) {
        const double half_width = 0.5 * (planes[p] - planes[p - 1]) * radians_per_degree * images;
        for (std::size_t j = 0; j < sum.size(); ++j)
            sum[j] += half_width * (mask.column(p - 1)[j] + mask.column(p)[j]);
    }
    return sum;
}

double masked(const SpotShape& spot, const Web& mask) {
    const std::vector<double> gammas = in_radians(mask.gammas_deg());
    const std::vector<double> ring = around_circle(mask);
    const double a = spot.inner.value;
    const double b = spot.outer.value;
    double sum = 0.0;
    for (std::size_t j = 1; j < gammas.size(); ++j) {
        const double low = gammas[j - 1];
        const double high = gammas[j];
        const auto ring_at = [&](double gamma) {
            return ring[j - 1] + (gamma - low) / (high - low) * (ring[j] - ring[j - 1]);
        };
        const double even_until = std::min(high, spot.falloff == Falloff::hard ? b : a);
        if (low < even_until) sum += integrate_linear_sin(low, even_until, ring[j - 1], ring_at(even_until));
        const double from = std::max(low, a);
        const double to = std::min(high, b);
        if (spot.falloff == Falloff::hard || !(from < to)) continue;
        // The integrand is an entire function; over a quarter turn the rule is exact to rounding.
        const int pieces = 1 + static_cast<int>((to - from) / (0.25 * pi));
        const double step = (to - from) / pieces;
        for (int piece = 0; piece < pieces; ++piece)
            sum += gauss(from + piece * step, piece + 1 == pieces ? to : from + (piece + 1) * step,
                         [&](double gamma) { return lobe(spot, Radians(gamma)) * ring_at(gamma) * std::sin(gamma); });
    }
    return sum;
}

// The integral over γ of each stored plane from 0 up to any γ.
class PlaneIntegrals {
public:
    explicit PlaneIntegrals(const Web& mask) : mask_(mask), gammas_(in_radians(mask.gammas_deg())) {
        sums_.reserve(mask.planes_deg().size() * gammas_.size());
        for (std::size_t p = 0; p < mask.planes_deg().size(); ++p) {
            double sum = 0.0;
            sums_.push_back(sum);
            for (std::size_t j = 1; j < gammas_.size(); ++j) {
                sum += integrate_linear_sin(gammas_[j - 1], gammas_[j], mask.column(p)[j - 1], mask.column(p)[j]);
                sums_.push_back(sum);
            }
        }
    }

    double up_to(std::size_t plane, double gamma) const {
        if (!(gamma > gammas_.front())) return 0.0;
        const double* const sums = sums_.data() + plane * gammas_.size();
        if (gamma >= gammas_.back()) return sums[gammas_.size() - 1];
        const auto above = std::upper_bound(gammas_.begin(), gammas_.end(), gamma);
        const auto j = static_cast<std::size_t>(above - gammas_.begin()) - 1;
        const std::span<const double> values = mask_.column(plane);
        const double share = (gamma - gammas_[j]) / (gammas_[j + 1] - gammas_[j]);
        return sums[j] +
               integrate_linear_sin(gammas_[j], gamma, values[j], values[j] + share * (values[j + 1] - values[j]));
    }

    const std::vector<double>& gammas() const { return gammas_; }

private:
    const Web& mask_;
    std::vector<double> gammas_;
    std::vector<double> sums_; // [plane][gamma]
};

// The outline of a pyramid in polar angles.
class PyramidOutline {
public:
    explicit PyramidOutline(const FrustumShape& frustum)
        : tan_x_(std::tan(0.5 * frustum.horizontal.value)), tan_y_(std::tan(0.5 * frustum.vertical.value)) {}

    double gamma(double c) const {
        const double across_x = std::abs(std::cos(c));
        const double across_y = std::abs(std::sin(c));
        // The nearer of two faces, as tangents: t_x/|cos c| and t_y/|sin c|.
        return tan_x_ * across_y <= tan_y_ * across_x ? std::atan2(tan_x_, across_x) : std::atan2(tan_y_, across_y);
    }

    // The azimuths from −360° to 720° at which the outline turns or crosses one of `gammas`, in ascending order.
    std::vector<double> breaks(const std::vector<double>& gammas) const {
        std::vector<double> quarter{0.0, std::atan2(tan_y_, tan_x_), 0.5 * pi};
        for (const double gamma : gammas) {
            if (!(gamma > 0.0 && gamma < 0.5 * pi)) continue;
            const double t = std::tan(gamma);
            if (t >= tan_x_) quarter.push_back(std::acos(tan_x_ / t));
            if (t >= tan_y_) quarter.push_back(std::asin(tan_y_ / t));
        }
        std::vector<double> all;
        for (const double c : quarter)
            for (int turn = -1; turn <= 1; ++turn)
                for (const double image : {c, pi - c, pi + c, 2.0 * pi - c})
                    all.push_back(image + turn * 2.0 * pi);
        sort_unique(all);
        return all;
    }

private:
    double tan_x_;
    double tan_y_;
};

// One smooth stretch of azimuths between two stored planes (the same plane twice for an axial web).
struct Stretch {
    double from;
    double to;
    std::size_t plane;
};

double masked(const FrustumShape& frustum, const Web& mask) {
    const PlaneIntegrals integrals(mask);
    const PyramidOutline outline(frustum);
    const bool axial = mask.stored_symmetry() == Symmetry::axial;
    const std::vector<double> planes = axial ? std::vector<double>{0.0, 0.5 * pi} : in_radians(mask.planes_deg());
    // The pyramid has the mirror planes of every stored symmetry, so the stored planes represent the circle.
    const double images = axial ? 4.0 : image_count(mask.stored_symmetry());

    const std::vector<double> breaks = outline.breaks(integrals.gammas());
    std::vector<Stretch> stretches;
    for (std::size_t p = 0; p + 1 < planes.size(); ++p) {
        double from = planes[p];
        auto next = std::upper_bound(breaks.begin(), breaks.end(), from);
        while (from < planes[p + 1]) {
            const double to = next == breaks.end() ? planes[p + 1] : std::min(*next++, planes[p + 1]);
            stretches.push_back({from, to, p});
            from = to;
        }
    }
    const auto integrand = [&](const Stretch& stretch, double c) {
        const double gamma = outline.gamma(c);
        if (axial) return integrals.up_to(0, gamma);
        const std::size_t p = stretch.plane;
        const double share = (c - planes[p]) / (planes[p + 1] - planes[p]);
        return (1.0 - share) * integrals.up_to(p, gamma) + share * integrals.up_to(p + 1, gamma);
    };
    std::vector<double> first;
    double size = 0.0;
    for (const Stretch& stretch : stretches) {
        first.push_back(gauss(stretch.from, stretch.to, [&](double c) { return integrand(stretch, c); }));
        size += std::abs(first.back());
    }
    const double tolerance = 1e-14 * size;
    double sum = 0.0;
    for (std::size_t i = 0; i < stretches.size(); ++i)
        sum += halved_gauss(stretches[i].from, stretches[i].to, first[i], tolerance, 40,
                            [&](double c) { return integrand(stretches[i], c); });
    return sum * images;
}

// Masks of types A and B are not summed over planes: the shape is a weight on the web's rings.
double masked_rings(const SpotShape& spot, const Web& mask) {
    Rings rings(mask);
    rings.cut_at_gamma(to_degrees(spot.inner));
    return rings.zone(0.0, to_degrees(spot.outer),
                      [&](const glm::dvec3& direction) { return ShapeTraits<SpotShape>::shown(spot, direction); });
}
double masked_rings(const FrustumShape& frustum, const Web& mask) {
    Rings rings(mask);
    rings.cut_at_pyramid(0.5 * to_degrees(frustum.horizontal), 0.5 * to_degrees(frustum.vertical));
    return rings.zone(0.0, 90.0, [&](const glm::dvec3& direction) { return lobe(frustum, direction); });
}

// ∬ mask · (projected area over projected area along the direction) dω.
template<class Kind>
double masked_area(const Kind& shape, const Web& mask) {
    std::vector<double> gammas_deg;
    for (int deg = 0; deg <= 180; ++deg)
        gammas_deg.push_back(deg);
    if (mask.photometry() == Photometry::c)
        gammas_deg.insert(gammas_deg.end(), mask.gammas_deg().begin(), mask.gammas_deg().end());
    sort_unique(gammas_deg);
    constexpr auto three = gauss_legendre<3>();
    double sum = 0.0;
    for (std::size_t j = 1; j < gammas_deg.size(); ++j)
        for (const QuadratureNode& of_gamma : three) {
            const double half = 0.5 * (gammas_deg[j] - gammas_deg[j - 1]) * radians_per_degree;
            const double gamma = 0.5 * (gammas_deg[j] + gammas_deg[j - 1]) * radians_per_degree + half * of_gamma.at;
            double ring = 0.0;
            for (int plane = 0; plane < 360; ++plane)
                for (const QuadratureNode& of_c : three) {
                    const double c = (plane + 0.5 + 0.5 * of_c.at) * radians_per_degree;
                    const glm::dvec3 toward = direction_of({Radians(c), Radians(gamma)});
                    const double shown = ShapeTraits<Kind>::shown(shape, toward);
                    if (shown > 0.0) ring += of_c.weight * shown * mask.candela(toward);
                }
            sum += of_gamma.weight * half * std::sin(gamma) * ring;
        }
    return sum * 0.5 * radians_per_degree;
}

} // namespace

Steradians masked_solid_angle(const Shape& shape, const Web& mask) {
    const double top = peak(mask).intensity.value;
    return with_traits(shape, [&]<class Kind>(const Kind& kind, ShapeTraits<Kind>) {
        if constexpr (!MaskedShape<Kind>)
            return Steradians(0.0);
        else if constexpr (ShapeTraits<Kind>::masked_by == MaskedBy::mask)
            return Steradians(flux(mask).value / top);
        else if constexpr (ShapeTraits<Kind>::masked_by == MaskedBy::lobe)
            return Steradians((mask.photometry() != Photometry::c ? masked_rings(kind, mask) : masked(kind, mask)) /
                              top);
        else
            return Steradians(masked_area(kind, mask) / top);
    });
}

} // namespace gonio
