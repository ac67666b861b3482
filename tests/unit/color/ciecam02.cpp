#include <gonio/color/detail/ciecam02.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace gonio::detail {
namespace {

// D of CIE 159:2004 in an average surround.
double adaptation(double adapting_nt) {
    return 1.0 - std::exp((-adapting_nt - 42.0) / 92.0) / 3.6;
}

// M. D. Fairchild, "Color Appearance Models", the table of worked examples of CIECAM02.
TEST(Ciecam02Test, HasTheWorkedExamples) {
    struct Example {
        glm::dvec3 xyz, white;
        double adapting_nt, hue_deg, lightness, chroma, colourfulness;
    };
    for (const Example& e : {Example{{19.01, 20.00, 21.78}, {95.05, 100.0, 108.88}, 318.31, 219.0, 41.73, 0.10, 0.11},
                             {{57.06, 43.06, 31.96}, {95.05, 100.0, 108.88}, 31.83, 19.6, 65.96, 48.57, 41.67},
                             {{3.53, 6.56, 2.14}, {109.85, 100.0, 35.58}, 318.31, 177.1, 21.79, 46.94, 48.80},
                             {{19.01, 20.00, 21.78}, {109.85, 100.0, 35.58}, 31.83, 248.9, 42.53, 51.92, 44.54}}) {
        const Ciecam02 model({e.white, e.adapting_nt, 20.0, adaptation(e.adapting_nt)});
        const Appearance seen = model.appearance(e.xyz);
        EXPECT_NEAR(seen.hue_deg, e.hue_deg, 0.051);
        EXPECT_NEAR(seen.lightness, e.lightness, 0.0051);
        EXPECT_NEAR(seen.chroma, e.chroma, 0.0051);
        EXPECT_NEAR(seen.colourfulness, e.colourfulness, 0.0051);
    }
}

TEST(Ciecam02Test, TheWhiteIsWhite) {
    for (const double adaptation : {0.9, 1.0}) {
        const glm::dvec3 white(95.05, 100.0, 108.88);
        const Appearance seen = Ciecam02({white, 100.0, 20.0, adaptation}).appearance(white);
        EXPECT_NEAR(seen.lightness, 100.0, 1e-9);
        // By complete adaptation all cones respond alike, and only the rounding of the matrices leaves a chroma.
        if (adaptation == 1.0) {
            EXPECT_LT(seen.chroma, 0.01);
        }
    }
}

// The model written a second time, as CIE 159 prints it, step by step; only for complete adaptation.
UcsPoint by_steps(const glm::dvec3& xyz, const glm::dvec3& white) {
    const double la = 100.0;
    const double yb = 20.0;
    const auto sharpened = [](const glm::dvec3& c) {
        return glm::dvec3(0.7328 * c.x + 0.4296 * c.y - 0.1624 * c.z, -0.7036 * c.x + 1.6975 * c.y + 0.0061 * c.z,
                          0.0030 * c.x + 0.0136 * c.y + 0.9834 * c.z);
    };
    // The inverse of the above, as it is printed.
    const auto back = [](const glm::dvec3& c) {
        return glm::dvec3(1.096124 * c.x - 0.278869 * c.y + 0.182745 * c.z,
                          0.454369 * c.x + 0.473533 * c.y + 0.072098 * c.z,
                          -0.009628 * c.x - 0.005698 * c.y + 1.015326 * c.z);
    };
    const auto cones = [](const glm::dvec3& c) {
        return glm::dvec3(0.38971 * c.x + 0.68898 * c.y - 0.07868 * c.z, -0.22981 * c.x + 1.18340 * c.y + 0.04641 * c.z,
                          c.z);
    };
    const double k = 1.0 / (5.0 * la + 1.0);
    const double fl = std::pow(k, 4.0) * la + 0.1 * std::pow(1.0 - std::pow(k, 4.0), 2.0) * std::pow(5.0 * la, 1.0 / 3);
    const auto compressed = [&](double x) {
        const double p = std::pow(fl * x / 100.0, 0.42);
        return 400.0 * p / (27.13 + p) + 0.1;
    };
    const double n = yb / white.y;
    const double nbb = 0.725 * std::pow(n, -0.2);
    const glm::dvec3 w = sharpened(white);
    const auto respond = [&](const glm::dvec3& c) {
        const glm::dvec3 s = sharpened(c);
        const glm::dvec3 p = cones(back({white.y * s.x / w.x, white.y * s.y / w.y, white.y * s.z / w.z}));
        return glm::dvec3(compressed(p.x), compressed(p.y), compressed(p.z));
    };
    const auto achromatic = [&](const glm::dvec3& r) { return (2.0 * r.x + r.y + r.z / 20.0 - 0.305) * nbb; };
    const glm::dvec3 r = respond(xyz);
    const double a = r.x - 12.0 * r.y / 11.0 + r.z / 11.0;
    const double b = (r.x + r.y - 2.0 * r.z) / 9.0;
    const double h = std::atan2(b, a);
    const double j = 100.0 * std::pow(achromatic(r) / achromatic(respond(white)), 0.69 * (1.48 + std::sqrt(n)));
    const double t =
        50000.0 / 13.0 * nbb * 0.25 * (std::cos(h + 2.0) + 3.8) * std::sqrt(a * a + b * b) / (r.x + r.y + 1.05 * r.z);
    const double c = std::pow(t, 0.9) * std::sqrt(j / 100.0) * std::pow(1.64 - std::pow(0.29, n), 0.73);
    const double m = std::log(1.0 + 0.0228 * c * std::pow(fl, 0.25)) / 0.0228;
    return {1.7 * j / (1.0 + 0.007 * j), m * std::cos(h), m * std::sin(h)};
}

TEST(Ciecam02Test, TheUniformSpaceIsTheOneInSteps) {
    const glm::dvec3 white(111.1, 100.0, 35.2);
    const Ciecam02 model({white});
    for (double x = 3.0; x < 90.0; x += 11.0)
        for (double y = 3.0; y < 90.0; y += 11.0)
            for (double z = 1.0; z < 30.0; z += 7.0) {
                const glm::dvec3 xyz(x, y, z);
                const Appearance seen = model.appearance(xyz);
                if (!(x < 1.5 * y && x > 0.7 * y)) continue; // colours of surfaces
                const UcsPoint ours = cam02_ucs(seen);
                const UcsPoint steps = by_steps(xyz, white);
                EXPECT_NEAR(ours.j, steps.j, 1e-3);
                EXPECT_NEAR(ours.a, steps.a, 3e-3); // the printed inverse has six digits
                EXPECT_NEAR(ours.b, steps.b, 3e-3);
            }
    // J, M, h of the first of the worked examples, by the code of Colour 0.4.6.
    const UcsPoint known = cam02_ucs({41.73109113, 0.0, 0.10884218, 219.04843266});
    EXPECT_NEAR(known.j, 54.90433134, 1e-8);
    EXPECT_NEAR(known.a, -0.08442362, 1e-8);
    EXPECT_NEAR(known.b, -0.06848314, 1e-8);
}

} // namespace
} // namespace gonio::detail
