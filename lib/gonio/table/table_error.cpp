#include <gonio/base/gauss_legendre.hpp>
#include <gonio/base/parallel.hpp>
#include <gonio/shading/brdf_frostbite.hpp>
#include <gonio/shading/ggx.hpp>
#include <gonio/shading/ltc_lobe.hpp>
#include <gonio/table/table_error.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gonio {

namespace {

using shading::vec3;
using std::numbers::pi;
constexpr vec3<double> up{0.0, 0.0, 1.0};

double alpha_of(double roughness) {
    return std::max(roughness * roughness, shading::minimum_alpha);
}

vec3<double> view_of(double mu) {
    return {-std::sqrt((1.0 - mu) * (1.0 + mu)), 0.0, mu};
}

double golden(std::size_t i) {
    return std::fmod(0.5 + static_cast<double>(i) / std::numbers::phi, 1.0);
}

// The share of F = 1 that is reflected, and that of F = (1 − l·h)⁵.
struct Reflected {
    double all = 0.0;
    double grazing = 0.0;
};

Reflected reflected(double mu, double alpha, std::size_t count) {
    const vec3<double> v = view_of(mu);
    Reflected sum;
    for (std::size_t i = 0; i < count; ++i) {
        // Denser towards the steepest normals: few of them turn light below the surface.
        const double left = 1.0 - (static_cast<double>(i) + 0.5) / static_cast<double>(count);
        const vec3<double> l = shading::reflected_direction_ggx(v, alpha, 1.0 - left * left * left, golden(i));
        const double density = shading::pdf_reflected_ggx(up, v, l, alpha);
        if (!(l.z > 0.0 && density > 0.0)) continue;
        const shading::SpecularTerms<double> f = shading::specular_ggx(up, l, v, alpha, alpha);
        const double share = 3.0 * left * left * f.scale * l.z / (density * static_cast<double>(count));
        sum.all += share;
        sum.grazing += share * f.grazing;
    }
    return sum;
}

double mean_reflected(double alpha) {
    static constexpr auto rule = gauss_legendre<16>();
    double sum = 0.0;
    for (const QuadratureNode& node : rule) {
        const double root = 0.5 + 0.5 * node.at; // μ = root²
        sum += 2.0 * node.weight * root * root * root * reflected(root * root, alpha, 1024).all;
    }
    return sum;
}

TableError error_from(std::vector<double> errors) {
    std::sort(errors.begin(), errors.end());
    const auto rank = [&](double share) {
        const auto at = static_cast<std::size_t>(std::ceil(share * static_cast<double>(errors.size())));
        return errors[std::max<std::size_t>(at, 1) - 1];
    };
    return {errors.size(), rank(0.5), rank(0.95), errors.back()};
}

} // namespace

TransformedCosine lobe_of(TableKind kind, const TableValues& values, double n_dot_v, double roughness) {
    if (kind == TableKind::ltc_heitz) // x is towards the eye there
        return {.m00 = values[0],
                .m02 = -values[2],
                .m11 = 1.0,
                .m20 = -values[1],
                .m22 = values[3],
                .scale = values[4],
                .is_clamped = true};
    const double width = kind == TableKind::ltc_disney ? 1.0 : alpha_of(roughness);
    const auto found = shading::detail::lobe_from(values[0], values[1], values[2], values[3], values[4], values[5],
                                                  width, n_dot_v, shading::sine_of_cosine(n_dot_v));
    TransformedCosine lobe;
    lobe.m00 = found.m00;
    lobe.m02 = found.m02;
    lobe.m11 = found.m11;
    lobe.m20 = found.m20;
    lobe.m22 = found.m22;
    lobe.scale = found.albedo / found.horizon_z;
    return lobe;
}

TableTruth::TableTruth(TableKind kind, std::size_t poses, unsigned threads) : kind_(kind), threads_(threads) {
    poses_.resize(std::max<std::size_t>(poses, 1));
    parallel_for(poses_.size(), threads, [&](std::size_t i) {
        Pose& pose = poses_[i];
        pose.n_dot_v = (static_cast<double>(i) + 0.5) / static_cast<double>(poses_.size());
        pose.roughness = golden(i);
        if (info_of(kind_).is_lobe())
            lay_out(pose);
        else
            integrate(pose);
    });
}

void TableTruth::integrate(Pose& pose) const {
    const double alpha = alpha_of(pose.roughness);
    const Reflected found = reflected(pose.n_dot_v, alpha, std::size_t{1} << 13U);
    if (kind_ == TableKind::kulla_conty)
        pose.values = {found.all, mean_reflected(alpha)};
    else
        pose.values = {found.all - found.grazing, found.grazing};
}

// Directions by visible normals of α and of 3α and by cosine, weighted by the balance heuristic (E. Veach, 1997).
void TableTruth::lay_out(Pose& pose) const {
    constexpr std::size_t count = 1024;
    const vec3<double> v = view_of(pose.n_dot_v);
    const double alpha = alpha_of(pose.roughness);
    const bool specular = kind_ != TableKind::ltc_disney;
    const std::vector<double> widths =
        specular ? std::vector<double>{alpha, std::min(1.0, 3.0 * alpha)} : std::vector<double>{};
    const std::size_t of_cosine = specular ? count : 3 * count;
    const auto add = [&](vec3<double> l) {
        if (!(l.z > 1e-9)) return;
        double density = static_cast<double>(of_cosine) * l.z / pi;
        for (const double width : widths)
            density += static_cast<double>(count) * shading::pdf_reflected_ggx(up, v, l, width);
        const double value = l.z * (specular ? shading::specular_ggx(up, l, v, alpha, alpha).scale
                                             : shading::diffuse_frostbite(l.z, v.z, dot(l, v), pose.roughness));
        pose.directions.push_back({l.x, l.y, l.z, 1.0 / density, value});
        pose.values[0] += value / density;
    };
    for (const double width : widths)
        for (std::size_t i = 0; i < count; ++i)
            add(shading::reflected_direction_ggx(v, width, (static_cast<double>(i) + 0.5) / count, golden(i)));
    for (std::size_t i = 0; i < of_cosine; ++i) {
        const double square = (static_cast<double>(i) + 0.5) / static_cast<double>(of_cosine); // of the sine
        const double phi = 2.0 * pi * golden(i);
        add({std::sqrt(square) * std::cos(phi), std::sqrt(square) * std::sin(phi), std::sqrt(1.0 - square)});
    }
}

TableError TableTruth::error_of(const ShadingTable& table) const {
    if (!info_of(kind_).is_lobe())
        return error_of_values([&](double mu, double roughness) { return table.lookup(mu, roughness); });
    return error_of_lobes(
        [&](double mu, double roughness) { return lobe_of(kind_, table.lookup(mu, roughness), mu, roughness); });
}

TableError TableTruth::error_of_values(const Values& values) const {
    std::vector<double> errors(poses_.size());
    parallel_for(poses_.size(), threads_, [&](std::size_t i) {
        const Pose& pose = poses_[i];
        const TableValues found = values(pose.n_dot_v, pose.roughness);
        errors[i] = std::max(std::fabs(found[0] - pose.values[0]), std::fabs(found[1] - pose.values[1]));
    });
    return error_from(std::move(errors));
}

TableError TableTruth::error_of_lobes(const Lobes& lobes) const {
    std::vector<double> errors(poses_.size());
    parallel_for(poses_.size(), threads_, [&](std::size_t i) {
        const Pose& pose = poses_[i];
        const TransformedCosine lobe = lobes(pose.n_dot_v, pose.roughness);
        const double determinant = lobe.m11 * (lobe.m00 * lobe.m22 - lobe.m02 * lobe.m20);
        double more = 0.0;
        double less = 0.0;
        for (const Direction& d : pose.directions) {
            const double x = lobe.m00 * d.x + lobe.m02 * d.z;
            const double y = lobe.m11 * d.y;
            double z = lobe.m20 * d.x + lobe.m22 * d.z;
            if (lobe.is_clamped) z = std::max(z, 0.0);
            const double square = x * x + y * y + z * z;
            const double off = lobe.scale * determinant * z / (pi * square * square) - d.value;
            (off > 0.0 ? more : less) += std::fabs(off) * d.weight;
        }
        errors[i] = std::max(more, less) / pose.values[0];
    });
    return error_from(std::move(errors));
}

} // namespace gonio
