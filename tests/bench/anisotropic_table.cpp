// Prints the table of anisotropic highlights of shading/MEASURED.md: errors against quadrature under lights of each
// shape. Given the file alpha_lambda_theta_phi.npy of A. KT, E. Heitz, J. Dupuy and P. J. Narayanan ("Bringing Linearly
// Transformed Cosines to Anisotropic GGX", I3D 2022), it prints theirs too, with exact albedos, which their table
// lacks.
//
//     gonio-anisotropic-table [COUNT] [alpha_lambda_theta_phi.npy]
#include <gonio/base/parallel.hpp>
#include <gonio/measure/random.hpp>
#include <gonio/measure/specular_cases.hpp>
#include <gonio/measure/specular_truth.hpp>
#include <gonio/shading/anisotropic_lobe.hpp>
#include <gonio/shading/packet.hpp>
#include <gonio/shading/specular_in_double.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

namespace {

using namespace gonio;
using namespace gonio::shading;
using measure::Random;
using measure::SpecularCases;
using Vec = vec3<double>;
using Kind = LightConstants::Kind;

constexpr double pi = std::numbers::pi;

using Matrix = std::array<std::array<double, 3>, 3>;

// 8 × 8 × 8 × 8 matrices over α_x, α_y/α_x, the angle of the view and its azimuth from the rougher axis, in one
// quadrant. They take cosines to lobes.
struct Published {
    float values[8][8][8][8][3][3];

    [[nodiscard]] Matrix at(const Vec& view, AnisotropicAlpha<double> alphas) const {
        const double places[4] = {alphas.x, alphas.y / alphas.x, std::acos(std::min(view.z, 1.0)) / (0.9999 * pi / 2.0),
                                  std::atan2(view.y, view.x) / (pi / 2.0)};
        int first[4];
        double share[4];
        for (int k = 0; k < 4; ++k) {
            const double place = std::clamp(7.0 * places[k], 0.0, 7.0);
            first[k] = std::min(static_cast<int>(place), 6);
            share[k] = place - first[k];
        }
        Matrix m{};
        for (unsigned corner = 0; corner < 16; ++corner) {
            double weight = 1.0;
            int index[4];
            for (unsigned k = 0; k < 4; ++k) {
                const bool next = ((corner >> k) & 1U) != 0;
                index[k] = first[k] + (next ? 1 : 0);
                weight *= next ? share[k] : 1.0 - share[k];
            }
            for (std::size_t r = 0; r < 3; ++r)
                for (std::size_t c = 0; c < 3; ++c)
                    m[r][c] += weight * static_cast<double>(values[index[0]][index[1]][index[2]][index[3]][r][c]);
        }
        return m;
    }
};

// The published lobe towards a view: its density times the albedo, over n·l.
class PublishedLobe {
public:
    PublishedLobe(const Published& table, const AnisotropicGgxLobe<double>& lobe, const Vec& normal, const Vec& view)
        : frame_(lobe.grain.frame(normal)) {
        const Vec v = frame_.to_local(view);
        const bool swapped = lobe.alphas.y > lobe.alphas.x;
        Vec quadrant{std::fabs(v.x), std::fabs(v.y), v.z};
        AnisotropicAlpha<double> alphas = lobe.alphas;
        if (swapped) {
            std::swap(quadrant.x, quadrant.y);
            std::swap(alphas.x, alphas.y);
        }
        Matrix m = table.at(quadrant, alphas);
        if (swapped) std::swap(m[0], m[1]);
        for (std::size_t c = 0; c < 3; ++c) {
            m[0][c] = std::copysign(1.0, v.x) * m[0][c];
            m[1][c] = std::copysign(1.0, v.y) * m[1][c];
        }
        const auto minor = [&](std::size_t r, std::size_t c) {
            const std::size_t r1 = (r + 1) % 3;
            const std::size_t r2 = (r + 2) % 3;
            const std::size_t c1 = (c + 1) % 3;
            const std::size_t c2 = (c + 2) % 3;
            return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
        };
        const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
        for (std::size_t r = 0; r < 3; ++r)
            for (std::size_t c = 0; c < 3; ++c)
                inverse_[r][c] = minor(c, r) / determinant;
        factor_ = albedo(v, lobe.alphas) / (pi * std::fabs(determinant));
    }

    double operator()(const Vec& l) const {
        const Vec p = frame_.to_local(l);
        const auto row = [&](std::size_t r) {
            return inverse_[r][0] * p.x + inverse_[r][1] * p.y + inverse_[r][2] * p.z;
        };
        const Vec q{row(0), row(1), row(2)};
        const double square = dot(q, q);
        return factor_ * std::fmax(q.z, 0.0) / (square * square * p.z);
    }

private:
    static double albedo(const Vec& v, AnisotropicAlpha<double> alphas) {
        constexpr int steps = 64;
        double sum = 0.0;
        for (int i = 0; i < steps; ++i)
            for (int k = 0; k < steps; ++k) {
                const Vec l = reflected_direction_ggx(v, alphas, (i + 0.5) / steps, (k + 0.5) / steps);
                const FacetPose<double> pose(l, v);
                const double pdf = pdf_reflected_ggx(pose, alphas);
                if (l.z > 0.0 && pdf > 0.0) sum += specular_ggx(pose, alphas, alphas).scale * l.z / pdf;
            }
        return sum / (steps * steps);
    }

    TangentFrame<double> frame_;
    Matrix inverse_{};
    double factor_ = 0.0;
};

double by_ltc(const LightConstants& constants, const Vec& center, const Vec& normal, const Vec& view,
              const AnisotropicGgxLobe<double>& lobe) {
    double found = 0.0;
    shading::detail::with_light<double>(constants, [&](const auto& light) {
        if constexpr (requires { light.center; })
            found = specular_in_double(SpecularMethod::ltc, light, center, normal, view, lobe).scale;
    });
    return found;
}

// Relative to the truth, or to a thousandth of the light's luminance; of what is not dark by both.
void print(const char* shape, double least, const char* method, const std::vector<double>& truth,
           const std::vector<double>& found) {
    std::vector<double> errors;
    double square = 0.0;
    double all = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (truth[i] > 1e-3 || found[i] > 1e-3)
            errors.push_back(std::fabs(found[i] - truth[i]) / std::fmax(truth[i], 1e-3));
        square += (found[i] - truth[i]) * (found[i] - truth[i]);
        all += truth[i] * truth[i];
    }
    std::sort(errors.begin(), errors.end());
    if (errors.empty()) return;
    fmt::print("| {} | {} | {} | {:.2f} % | {:.1f} % | {:.1f} % |\n", shape, least, method,
               100.0 * errors[errors.size() / 2], 100.0 * errors[errors.size() * 19 / 20],
               100.0 * std::sqrt(square / all));
}

} // namespace

int main(int argc, char** argv) {
    const std::size_t count = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 2048;
    std::unique_ptr<Published> published;
    if (argc > 2) {
        published = std::make_unique<Published>();
        std::ifstream file(argv[2], std::ios::binary);
        file.seekg(128); // behind the header
        file.read(reinterpret_cast<char*>(published->values), sizeof published->values);
        if (!file) {
            fmt::print(stderr, "{}: not a table of 8^4 matrices\n", argv[2]);
            return 1;
        }
    }
    const auto at = [](const std::array<std::vector<float>, 3>& v, std::size_t i) {
        return Vec{static_cast<double>(v[0][i]), static_cast<double>(v[1][i]), static_cast<double>(v[2][i])};
    };
    fmt::print("| shape | least α | method | median | 95 % below | RMS |\n|---|---|---|---|---|---|\n");
    for (const auto& [shape, kind] : {std::pair{"sphere", Kind::sphere}, std::pair{"disk", Kind::disk},
                                      std::pair{"rectangle", Kind::rectangle}, std::pair{"tube", Kind::tube}})
        for (const double least : {0.1, 0.01}) {
            const SpecularCases cases = measure::specular_cases(kind, count, 7);
            Random random(5);
            std::vector<AnisotropicGgxLobe<double>> lobes;
            for (std::size_t i = 0; i < count; ++i) {
                const auto draw = [&] { return std::exp(random.uniform(std::log(least), 0.0)); };
                const double along = draw();
                const AnisotropicAlpha<double> alphas{along, draw()};
                const double turn = random.uniform(0.0, 2.0 * pi);
                lobes.push_back({alphas, {{0.0, 0.0, 1.0}, std::cos(turn), std::sin(turn)}, alphas.mean()});
            }
            std::vector<double> truth(count);
            std::vector<double> ltc(count);
            std::vector<double> theirs(count);
            parallel_for(count, 0, [&](std::size_t i) {
                const LightConstants& light = cases.area.lights[i / SpecularCases::group_size];
                const Vec center = at(cases.area.position, i) * -1.0;
                const Vec n = normalized(at(cases.area.normal, i));
                const Vec v = normalized(at(cases.view, i));
                truth[i] = measure::specular_by_quadrature(
                    light, center, n, v, [&](Vec l) { return lobes[i](n, l, v, lobes[i].alpha).scale; });
                ltc[i] = by_ltc(light, center, n, v, lobes[i]);
                if (published)
                    theirs[i] =
                        measure::specular_by_quadrature(light, center, n, v, PublishedLobe(*published, lobes[i], n, v));
            });
            print(shape, least, "`ltc`", truth, ltc);
            if (published) print(shape, least, "published", truth, theirs);
        }
}
