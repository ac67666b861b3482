#include <gonio/base/gauss_legendre.hpp>
#include <gonio/sky/cie_sky.hpp>
#include <gonio/sky/sky_direction.hpp>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace gonio {
namespace {

using std::numbers::pi;

const CieSkyType& type(std::string_view name) {
    return *find_cie_sky(name).value();
}

CieSky sky(std::string_view name, double elevation_deg, double azimuth_deg = 180.0) {
    return {type(name), direction_of({azimuth_deg, elevation_deg})};
}

constexpr glm::dvec3 up{0.0, 0.0, 1.0};

// Eh/Lz at 10°, 30° and 60°, from nested adaptive quadrature with scipy.
struct HorizontalRow {
    const char* name;
    std::array<double, 3> value;
};
constexpr HorizontalRow horizontal[] = {
    {"1", {2.44954087, 2.44954087, 2.44954087}},
    {"2", {2.67874812, 2.55657932, 2.08602321}},
    {"3", {2.76998783, 2.76998783, 2.76998783}},
    {"4", {3.05347968, 2.89014706, 2.31541911}},
    {"5", {pi, pi, pi}},
    {"6", {3.48649027, 3.27782540, 2.58416041}},
    {"7", {3.91013260, 3.67304559, 2.42122526}},
    {"8", {4.40274370, 4.12307659, 2.32837995}},
    {"9", {4.92108350, 4.55275329, 3.45932337}},
    {"10", {5.62328991, 5.14491099, 3.17026047}},
    {"11", {6.45265846, 5.81763147, 2.98906080}},
    {"12", {7.22935067, 6.39410585, 3.19057279}},
    {"13", {8.08353071, 6.99521531, 3.02585307}},
    {"14", {9.19076340, 7.70809713, 3.21695677}},
    {"15", {10.62624241, 8.11602341, 3.01585625}},
    {"overcast", {7 * pi / 9, 7 * pi / 9, 7 * pi / 9}},
};

TEST(CieSky, HorizontalIlluminanceIsThatOfAdaptiveQuadrature) {
    constexpr std::array elevations_deg{10.0, 30.0, 60.0};
    for (const HorizontalRow& row : horizontal)
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_NEAR(sky(row.name, elevations_deg[i]).illuminance(up), row.value[i], 6e-9)
                << row.name << " at " << elevations_deg[i];
}

TEST(CieSky, VerticalIlluminance) {
    const auto wall = [](const CieSky& of, double azimuth_deg) {
        return of.illuminance(direction_of({azimuth_deg, 0.0}));
    };
    EXPECT_NEAR(wall(sky("1", 30.0), 17.0), 0.928823, 6e-7);
    EXPECT_NEAR(wall(sky("overcast", 30.0), 200.0), pi / 6 + 4.0 / 9.0, 1e-9);
    EXPECT_NEAR(wall(sky("5", 30.0), 90.0), pi / 2, 1e-9);
    const CieSky low = sky("12", 30.0);
    EXPECT_NEAR(wall(low, 180.0), 7.893976, 6e-7);
    EXPECT_NEAR(wall(low, 90.0), 3.574549, 6e-7);
    EXPECT_NEAR(wall(low, 270.0), 3.574549, 6e-7);
    EXPECT_NEAR(wall(low, 0.0), 2.535974, 6e-7);
    const CieSky high = sky("12", 60.0);
    EXPECT_NEAR(wall(high, 180.0), 2.367213, 6e-7);
    EXPECT_NEAR(wall(high, 90.0), 1.495388, 6e-7);
    EXPECT_NEAR(wall(high, 0.0), 1.104271, 6e-7);
    EXPECT_EQ(high.illuminance({0.0, 0.0, -1.0}), 0.0);
}

// The literals of colour-science/colour, phenomena/sky/tests/test_cie2003.py: 45° from the zenith, opposite to a sun
// 30° from it.
TEST(CieSky, LuminanceIsThatOfAnotherImplementation) {
    const glm::dvec3 direction = direction_of({0.0, 45.0});
    EXPECT_NEAR(sky("1", 60.0).relative(direction), 0.83258464279644, 1e-13);
    EXPECT_NEAR(sky("12", 60.0).relative(direction), 0.45445243068520, 1e-13);
}

// The formulas of the standard, written out: to 1e-12 in every direction.
TEST(CieSky, LuminanceIsTheFormula) {
    for (const CieSkyType& of : cie_sky_types()) {
        for (const double sun_zenith : {0.1, 0.7, 1.5}) {
            const CieSky made(of, direction_of({70.0, 90.0 - to_degrees(Radians(sun_zenith))}));
            EXPECT_NEAR(made.relative(up), 1.0, 1e-14);
            for (const double zenith : {0.05, 0.6, 1.2, 1.55})
                for (const double azimuth : {0.0, 0.4, 2.0, 3.1}) { // from the sun
                    const double chi = std::acos(std::cos(sun_zenith) * std::cos(zenith) +
                                                 std::sin(sun_zenith) * std::sin(zenith) * std::cos(azimuth));
                    const auto phi = [&](double z) {
                        if (of.number == 16) return (1.0 + 2.0 * std::cos(z)) / 3.0;
                        return 1.0 + of.a * std::exp(of.b / std::cos(z));
                    };
                    const auto f = [&](double x) {
                        return 1.0 + of.c * (std::exp(of.d * x) - std::exp(of.d * pi / 2)) +
                               of.e * std::cos(x) * std::cos(x);
                    };
                    const double expected = f(chi) * phi(zenith) / (f(sun_zenith) * phi(0.0));
                    const glm::dvec3 direction =
                        direction_of({70.0 + to_degrees(Radians(azimuth)), 90.0 - to_degrees(Radians(zenith))});
                    EXPECT_NEAR(made.relative(direction) / expected, 1.0, 1e-12) << of.name;
                }
        }
        EXPECT_EQ(CieSky(of, up).relative({0.6, 0.0, -0.8}), 0.0);
    }
    // f(30°) of the fourth indicatrix.
    const CieSky at_zenith = sky("8", 90.0); // gradation III is 1
    const double f0 = 1.0 + 10.0 * (1.0 - std::exp(-1.5 * pi)) + 0.45;
    EXPECT_NEAR(at_zenith.relative(direction_of({10.0, 60.0})) * f0, 3.32646285329632, 1e-13);
}

// Independent of integrate_above(): rectangles of zenith angle and azimuth, divided until they agree.
class Adaptive {
public:
    explicit Adaptive(const CieSky& of, const glm::dvec3& normal) : sky_(of), normal_(normal) {}

    double integral() const {
        double sum = 0.0;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 16; ++j)
                sum += refined(i * pi / 8, (i + 1) * pi / 8, j * pi / 8, (j + 1) * pi / 8, 0);
        return sum;
    }

private:
    double refined(double z0, double z1, double p0, double p1, int depth) const {
        const double zm = 0.5 * (z0 + z1);
        const double pm = 0.5 * (p0 + p1);
        const double whole = gauss(z0, z1, p0, p1);
        const double parts =
            gauss(z0, zm, p0, pm) + gauss(zm, z1, p0, pm) + gauss(z0, zm, pm, p1) + gauss(zm, z1, pm, p1);
        if (depth == 14 || std::abs(whole - parts) < 1e-11) return parts;
        return refined(z0, zm, p0, pm, depth + 1) + refined(zm, z1, p0, pm, depth + 1) +
               refined(z0, zm, pm, p1, depth + 1) + refined(zm, z1, pm, p1, depth + 1);
    }
    double gauss(double z0, double z1, double p0, double p1) const {
        static constexpr auto rule = gauss_legendre<6>();
        double sum = 0.0;
        for (const QuadratureNode& u : rule)
            for (const QuadratureNode& v : rule) {
                const double z = 0.5 * (z0 + z1) + 0.5 * (z1 - z0) * u.at;
                const double p = 0.5 * (p0 + p1) + 0.5 * (p1 - p0) * v.at;
                const glm::dvec3 direction{std::sin(z) * std::cos(p), std::sin(z) * std::sin(p), std::cos(z)};
                sum += u.weight * v.weight * sky_.relative(direction) * std::sin(z) *
                       std::fmax(glm::dot(direction, normal_), 0.0);
            }
        return 0.25 * (z1 - z0) * (p1 - p0) * sum;
    }

    const CieSky& sky_;
    glm::dvec3 normal_;
};

// The rectangles end at the wall's own horizon; that of the tilted plane cuts them, and costs them digits.
TEST(CieSky, IlluminanceIsThatOfIndependentQuadrature) {
    for (const char* name : {"4", "12", "15"})
        for (const double elevation_deg : {0.3, 47.0, 90.0}) {
            const CieSky of = sky(name, elevation_deg, 137.0);
            const glm::dvec3 wall = direction_of({112.5, 0.0});
            const glm::dvec3 tilted = direction_of({60.0, -50.0});
            EXPECT_NEAR(of.illuminance(up), Adaptive(of, up).integral(), 1e-8) << name << " " << elevation_deg;
            EXPECT_NEAR(of.illuminance(wall), Adaptive(of, wall).integral(), 1e-8) << name << " " << elevation_deg;
            EXPECT_NEAR(of.illuminance(tilted), Adaptive(of, tilted).integral(), 2e-7) << name << " " << elevation_deg;
        }
}

// A uniform hemisphere has E/L = π (1 + cos tilt)/2.
TEST(CieSky, IlluminanceOfTheUniformSkyIsItsClosedForm) {
    for (const double elevation_deg : {-89.0, -50.0, -1.0, 0.0, 20.0, 89.9, 90.0}) {
        const glm::dvec3 normal = direction_of({77.0, elevation_deg});
        EXPECT_NEAR(sky("5", 30.0).illuminance(normal), 0.5 * pi * (1.0 + normal.z), 1e-9) << elevation_deg;
    }
}

// Turning sun and plane together changes nothing, and neither do all planes of nearly the same normal.
TEST(CieSky, TurnsWithItsSun) {
    const glm::dvec3 normal = direction_of({200.0, 20.0});
    const double before = sky("11", 35.0, 120.0).illuminance(normal);
    for (const double turn_deg : {13.0, 90.0, 180.0, 271.0})
        EXPECT_NEAR(sky("11", 35.0, 120.0 + turn_deg).illuminance(turned(normal, degrees(turn_deg))), before, 1e-9);
    for (const double tilt : {1e-16, 1e-12, 1e-8, 1e-5})
        EXPECT_NEAR(sky("11", 35.0).illuminance(glm::normalize(glm::dvec3(tilt, 0.0, 1.0))),
                    sky("11", 35.0).illuminance(up), 6.0 * tilt + 1e-9)
            << tilt;
}

// E of opposite planes about the horizontal: their vectors add up to that of the whole sky.
TEST(CieSky, IlluminancesAreConsistent) {
    const CieSky of = sky("13", 25.0, 90.0);
    const glm::dvec3 tilted = direction_of({90.0, 45.0});
    const double net = of.illuminance(tilted) - of.illuminance(-tilted);
    const double net_up = of.illuminance(up);
    const double net_east = of.illuminance({1.0, 0.0, 0.0}) - of.illuminance({-1.0, 0.0, 0.0});
    EXPECT_NEAR(net, std::sqrt(0.5) * (net_up + net_east), 1e-8);
}

TEST(CieSky, MeanOfSkiesWithClosedForms) {
    EXPECT_NEAR(sky("5", 30.0).mean(), 1.0, 1e-12);
    EXPECT_NEAR(sky("overcast", 30.0).mean(), 2.0 / 3.0, 1e-12);
}

TEST(CieSky, IsFoundByNumberOrName) {
    EXPECT_EQ(cie_sky_types().size(), 16U);
    for (int i = 1; i <= 16; ++i)
        EXPECT_EQ(find_cie_sky(std::to_string(i)).value()->number, i);
    EXPECT_EQ(type("overcast").number, 16);
    for (const char* bad : {"0", "17", "1.5", "", "clear", "012"})
        EXPECT_FALSE(find_cie_sky(bad)) << bad;
    EXPECT_EQ(find_cie_sky("overcst").error().diagnostics.back().hint.substr(0, 23), "did you mean 'overcast'");
}

} // namespace
} // namespace gonio
