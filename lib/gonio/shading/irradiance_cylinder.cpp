#include <gonio/shading/irradiance_cylinder.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace gonio::shading {

namespace {

constexpr int most_bends = 8;

// Of the pieces: both ends of the whole, and two crossings each for the cylinder's ends, the foot and the bends.
using Ends = std::array<double, 2 + 2 * (2 + 1 + 2 * most_bends)>;

using Pose = detail::CylinderPose<double>;

// The integrand over u of irradiance_cylinder.hpp, and where its pieces end.
class Sweep {
public:
    explicit Sweep(const Pose& pose)
        : pose_(pose),
          kappa_(pose.gap / (2.0 * std::sqrt(pose.d * pose.r))),
          most_sinh_(std::sqrt(2.0 * pose.r / pose.gap)),
          most_(std::asinh(most_sinh_)) {}

    double most() const { return most_; }
    double scale() const { return std::sqrt(pose_.r / pose_.d); }

    template<bool clipped>
    double at(double u) const {
        const double sinh = std::sinh(u);
        const double cosh = std::sqrt(1.0 + sinh * sinh);
        const double sine = kappa_ * sinh; // of φ/2
        const double cosine = std::sqrt(1.0 - std::min(sine * sine, 0.5));
        const double rho = pose_.gap * cosh;
        const double towards = (pose_.gap + 2.0 * pose_.r * sine * sine) / rho; // cos α
        const double aside = clipped ? 2.0 * pose_.r * sine * cosine / rho : 0.0;
        const double share = sinh / most_sinh_;
        const double weight = std::max((1.0 - share) * (1.0 + share), 0.0) / (cosh * cosine);
        return weight * detail::cylinder_slice<clipped>(pose_, pose_.n_f * towards + pose_.n_g * aside, rho);
    }

    // Where the circle of an end crosses the horizon: n_f (D − r cos φ) + n_g r sin φ + n_a z = 0.
    void add_crossings(double z, Ends& ends, std::size_t& count) const {
        const double reach = pose_.r * std::hypot(pose_.n_f, pose_.n_g);
        const double level = pose_.n_f * pose_.d + pose_.n_a * z;
        if (!(std::abs(level) < reach)) return;
        const double middle = std::atan2(-pose_.n_g, pose_.n_f);
        const double half = std::atan2(std::sqrt((reach - level) * (reach + level)), level);
        for (const double phi : {middle - half, middle + half}) {
            const double turned = std::remainder(phi, 2.0 * std::numbers::pi);
            const double u = std::asinh(std::sin(0.5 * turned) / kappa_);
            if (std::abs(u) < most_) ends[count++] = u;
        }
    }

private:
    const Pose& pose_;
    double kappa_, most_sinh_, most_;
};

// Gauss and Kronrod's rules of 7 and 15 points: the integral, and how far apart they are.
struct Estimate {
    double value, apart;
};

template<class F>
Estimate gauss_kronrod(double low, double high, const F& f) {
    constexpr double nodes[7] = {0.991455371120812639206854697526329, 0.949107912342758524526189684047851,
                                 0.864864423359769072789712788640926, 0.741531185599394439863864773280788,
                                 0.586087235467691130294144691258,    0.405845151377397166906606412076961,
                                 0.207784955007898467600689403773245};
    constexpr double kronrod[8] = {0.022935322010529224963732008058970, 0.063092092629978553290700663189204,
                                   0.104790010322250183839876322541518, 0.140653259715525918745189590510238,
                                   0.169004726639267902826583426598550, 0.190350578064785409913256402421014,
                                   0.204432940075298892414161999234649, 0.209482141084727828012999174891714};
    constexpr double gauss[4] = {0.129484966168869693270611432679082, 0.279705391489276667901467771423780,
                                 0.381830050505118944950369775488975, 0.417959183673469387755102040816327};
    const double middle = 0.5 * (low + high);
    const double half = 0.5 * (high - low);
    const double center = f(middle);
    double fine = kronrod[7] * center;
    double coarse = gauss[3] * center;
    for (std::size_t i = 0; i < 7; ++i) {
        const double both = f(middle - half * nodes[i]) + f(middle + half * nodes[i]);
        fine += kronrod[i] * both;
        if (i % 2 == 1) coarse += gauss[i / 2] * both;
    }
    return {half * fine, half * std::abs(fine - coarse)};
}

// Halves a piece until both rules agree within `tolerance`. Kronrod's is then far closer to the integral than that.
// `left` bounds the work on input that is no light: there are few halvings else.
template<class F>
double refined(double low, double high, const Estimate& whole, double tolerance, int& left, const F& f) {
    if (!(whole.apart > tolerance) || left <= 0) return whole.value;
    --left;
    const double middle = 0.5 * (low + high);
    const Estimate first = gauss_kronrod(low, middle, f);
    const Estimate second = gauss_kronrod(middle, high, f);
    const double below = refined(low, middle, first, tolerance, left, f);
    return below + refined(middle, high, second, tolerance, left, f);
}

// Pieces of u no longer than this; no singularity is nearer than π/2.
constexpr double longest_piece = 2.0;
constexpr std::size_t most_pieces = 128;

template<class F>
double over_pieces(const double* ends, std::size_t count, const F& f) {
    std::array<double, most_pieces + 1> at{};
    std::array<Estimate, most_pieces> first{};
    std::size_t pieces = 0;
    at[0] = ends[0];
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < count; ++i) {
        const double length = ends[i + 1] - ends[i];
        const auto parts = static_cast<std::size_t>(std::clamp(std::ceil(length / longest_piece), 1.0, 15.0));
        for (std::size_t k = 1; k <= parts; ++k) {
            at[pieces + 1] =
                k == parts ? ends[i + 1] : ends[i] + length * static_cast<double>(k) / static_cast<double>(parts);
            first[pieces] = gauss_kronrod(at[pieces], at[pieces + 1], f);
            sum += first[pieces].value;
            ++pieces;
        }
    }
    constexpr double agreement = 1e-7;
    constexpr int most_halvings = 400;
    int left = most_halvings;
    const double tolerance = agreement * std::abs(sum);
    double total = 0.0;
    for (std::size_t i = 0; i < pieces; ++i)
        total += refined(at[i], at[i + 1], first[i], tolerance, left, f);
    return total;
}

} // namespace

double irradiance_cylinder(vec3<double> center, vec3<double> axis, double radius, double length_m,
                           vec3<double> normal) {
    Pose p = detail::cylinder_pose(center, axis, radius, length_m, normal);
    if (!(p.r > 0.0) || !(p.length > 0.0)) return 0.0;
    if (!(p.gap > 0.0)) {
        const bool touches = p.gap == 0.0 && p.z0 < 0.0 && p.z1 > 0.0;
        return touches ? detail::clamp_irradiance(0.5 * std::numbers::pi * (1.0 + p.n_f)) : 0.0;
    }
    p.gap = std::max(p.gap, 1e-24 * p.r); // the asinh of the widest azimuth stays below 60
    p.r = std::max(p.r, 1e-150);
    const double across = std::hypot(p.n_f, p.n_g);
    const double reach = 0.5 * p.length * p.n_a + p.r * across;
    if (p.up <= -reach) return 0.0;
    const Sweep sweep(p);
    const double factor = sweep.scale();
    if (p.up >= reach) {
        const double ends[2] = {0.0, sweep.most()};
        const double half = over_pieces(&ends[0], 2, [&](double u) { return sweep.at<false>(u); });
        return detail::clamp_irradiance(2.0 * factor * half);
    }
    Ends ends{};
    std::size_t count = 0;
    ends[count++] = -sweep.most();
    sweep.add_crossings(p.z0, ends, count);
    sweep.add_crossings(p.z1, ends, count);
    // A horizon that runs almost along the axis sweeps over the receiver's foot on it, where the integrand bends within
    // the distance from the surface: pieces that grow from there.
    if (p.z0 < 0.0 && p.z1 > 0.0) sweep.add_crossings(0.0, ends, count);
    double out = 2.0 * p.gap;
    for (int i = 0; i < most_bends; ++i, out *= 6.0) {
        if (out < p.z1) sweep.add_crossings(out, ends, count);
        if (-out > p.z0) sweep.add_crossings(-out, ends, count);
    }
    ends[count++] = sweep.most();
    for (std::size_t i = 1; i < count; ++i)
        for (std::size_t k = i; k > 0 && ends[k] < ends[k - 1]; --k)
            std::swap(ends[k], ends[k - 1]);
    const double all = over_pieces(ends.data(), count, [&](double u) { return sweep.at<true>(u); });
    return detail::clamp_irradiance(factor * all);
}

} // namespace gonio::shading
