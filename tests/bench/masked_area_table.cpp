// The error of the fast method for a light with a size behind a mask (the mask towards the receiver from the light's
// centre, times the closed form of the unmasked light), against quadrature. Argument: a profile for the mask.
#include <gonio/scene/probe.hpp>

#include "../unit/scene/reference_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

int main(int argc, char** argv) {
    using namespace gonio;
    if (argc < 2) {
        std::fputs("usage: gonio-masked-area-table PROFILE\n", stderr);
        return 2;
    }
    constexpr std::array shapes{"sphere:r=0.5m", "disk:r=0.5m", "rect:w=1m,h=1m", "tube:r=5cm,l=0.9m"};
    constexpr std::array<double, 7> distances{0.75, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0}; // in sizes, 1 m each
    std::printf("| distance over size |");
    for (const char* shape : shapes)
        std::printf(" %.*s |", static_cast<int>(std::string_view(shape).find(':')), shape);
    std::printf("\n|---|---|---|---|---|\n");
    for (const double distance : distances) {
        std::printf("| %g |", distance);
        for (const char* text : shapes) {
            LightDescription description;
            description.shape = parse_shape(std::string(text) + ",mask=" + argv[1]).value();
            description.intensity = parse_photometric_value("1000nt").value();
            Diagnostics diagnostics;
            Result<Light> made = resolve_light(description, diagnostics);
            if (!made) {
                std::fprintf(stderr, "%s\n", made.error().diagnostics.back().message.c_str());
                return 1;
            }
            measure::Random random(5);
            std::vector<double> errors;
            std::vector<Receiver> receivers;
            // Below the light, within 60° of its direction, tilted from facing it by up to 60°.
            while (receivers.size() < 300) {
                const glm::dvec3 away = test::random_direction(random);
                const glm::dvec3 normal = test::random_direction(random);
                if (away.z < -0.5 && -glm::dot(normal, away) > 0.5) receivers.push_back({away * distance, normal});
            }
            ProbeOptions options;
            const auto lux = [&](IrradianceMethod method) {
                options.method = method;
                options.goal.relative_error = 1e-4;
                return probe({&*made, 1}, receivers, options).value().illuminance_lx;
            };
            const std::vector<double> truth = lux(IrradianceMethod::reference);
            const std::vector<double> fast = lux(IrradianceMethod::ltc);
            double brightest = 0.0;
            for (const double e : truth)
                brightest = std::max(brightest, e);
            for (std::size_t i = 0; i < truth.size(); ++i)
                if (truth[i] > 1e-3 * brightest) errors.push_back(std::abs(fast[i] / truth[i] - 1.0));
            std::sort(errors.begin(), errors.end());
            std::printf(" %.2g / %.2g |", errors[errors.size() / 2], errors[errors.size() * 95 / 100]);
        }
        std::printf("\n");
    }
    return 0;
}
