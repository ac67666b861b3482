// Prints the table in MEASURED.md of shading/ for ltc by the light's size relative to the lobe: its relative error next
// to those of the transformed cosine alone, of its share corrected by points and of a single direction, in Markdown.
//
//   gonio-specular-size-table [CASES_PER_SHAPE [SEED]]
//
// Size is the light's radius over its distance in the space where the lobe is a cosine (LtcLobe); 1 is as large as the
// lobe itself. Each cell: median / 95 % of the relative errors where the luminance is above 1e-6 of the light's / mean
// error over mean truth.
#include <gonio/measure/error_statistics.hpp>
#include <gonio/measure/specular_methods.hpp>
#include <gonio/shading/packet.hpp>
#include <gonio/shading/specular_by_share.hpp>
#include <gonio/shading/specular_named.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace gonio;
using namespace gonio::shading;
using Kind = LightConstants::Kind;

constexpr std::size_t ways = 4;
constexpr const char* names[ways] = {"transformed cosine alone", "ltc-share", "ltc", "representative-point"};

struct Case {
    double size;
    bool cut; // by the horizon
    double truth;
    double value[ways];
};

Case evaluated(const LightConstants& light, vec3<double> to_center, vec3<double> n, vec3<double> v, double alpha,
               double truth) {
    Case found{};
    found.truth = truth;
    const GgxLobe<double> lobe{alpha};
    const LtcFrame<double> frame = ltc_frame(n, v);
    const double mu = dot(n, v);
    const LtcLobe<double> cosine = ltc_ggx(alpha, mu, frame.sine);
    shading::detail::with_light<double>(light, [&](const auto& typed) {
        const auto points = shading::detail::points_of(typed, frame, to_center);
        const vec3<double> c = cosine(points.patch.center);
        found.size = std::sqrt(points.transformed_size2(cosine) / dot(c, c));
        found.cut = points.patch.center.z <= points.rise();
        const auto seen = seen_from(typed, to_center);
        found.value[0] = shading::detail::ltc_share(cosine, frame, seen.light, seen.to_center) * cosine.albedo;
        found.value[1] = specular_by_share(seen.light, seen.to_center, n, v, lobe).scale;
        found.value[2] = specular_ltc(typed, to_center, n, v, lobe).scale;
        found.value[3] = specular_by<SpecularMethod::representative_point>(typed, to_center, n, v, lobe).scale;
    });
    return found;
}

void print_row(const std::string& label, const std::vector<Case>& cases, bool cut, double from, double to) {
    std::vector<double> truth;
    std::vector<double> values[ways];
    double off[ways] = {};
    double sum = 0.0;
    for (const Case& each : cases) {
        if (each.cut != cut || each.size < from || each.size >= to) continue;
        truth.push_back(each.truth);
        sum += each.truth;
        for (std::size_t w = 0; w < ways; ++w) {
            values[w].push_back(each.value[w]);
            off[w] += std::fabs(each.value[w] - each.truth);
        }
    }
    if (truth.empty() || !(sum > 0.0)) return;
    (void)std::printf("| %s | %zu |", label.c_str(), truth.size());
    for (std::size_t w = 0; w < ways; ++w) {
        const auto errors = measure::compare(values[w], truth, 1e-6).relative;
        (void)std::printf(" %.1e / %.1e / %.1e |", errors.median, errors.p95, off[w] / sum);
    }
    (void)std::printf("\n");
}

} // namespace

int main(int argc, char** argv) {
    const std::size_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 4096;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    std::vector<Case> all;
    for (const Kind kind : {Kind::sphere, Kind::disk, Kind::ellipse, Kind::rectangle, Kind::tube}) {
        const measure::SpecularCases cases = measure::specular_cases(kind, count, seed);
        const std::vector<double> truth = measure::specular_truth(cases);
        for (std::size_t i = 0; i < cases.size(); ++i) {
            const auto at = [i](const auto& v) {
                return vec3<double>{static_cast<double>(v[0][i]), static_cast<double>(v[1][i]),
                                    static_cast<double>(v[2][i])};
            };
            const std::size_t group = i / measure::SpecularCases::group_size;
            all.push_back(evaluated(cases.area.lights[group], at(cases.area.position) * -1.0, at(cases.area.normal),
                                    at(cases.view), static_cast<double>(cases.alpha[group]), truth[i]));
        }
    }
    (void)std::printf("| size | cases |");
    for (const char* name : names)
        (void)std::printf(" %s |", name);
    (void)std::printf("\n|---|---|---|---|---|---|\n");
    constexpr double edges[] = {0.0, 0.05, 0.15, 0.25, 0.5, 0.8, 1.6, 5.0, 1e300};
    constexpr const char* labels[] = {"< 0.05", "< 0.15", "< 0.25", "< 0.5", "< 0.8", "< 1.6", "< 5", "larger"};
    for (const bool cut : {false, true})
        for (std::size_t i = 0; i < std::size(labels); ++i)
            print_row(std::string(labels[i]) + (cut ? ", cut" : ""), all, cut, edges[i], edges[i + 1]);
    return 0;
}
