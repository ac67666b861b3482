#include <gonio/light/photometry.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>

#include "quadrature.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace gonio {
namespace {

using std::numbers::pi;

TEST(Photometry, SphereOf800LumensAnd3Centimetres) {
    // 800/(4π² 0.03²) with 30 digits
    EXPECT_NEAR(test::convert(test::shape("sphere:r=3cm"), "800lm", "nt"), 22515.818587186169,
                22515.818587186169 * 4e-16);
    EXPECT_NEAR(test::convert(test::shape("sphere:r=3cm"), "800lm", "cd"), 200.0 / pi, 1e-13);
}

TEST(Photometry, UnitsOfOneQuantityNeedNoShape) {
    const auto converted = [](const char* value, const char* unit) {
        const PhotometricUnit to = parse_photometric_unit(unit).value();
        EXPECT_TRUE(same_quantity(parse_photometric_value(value)->unit, to)) << value << ' ' << unit;
        return *convert_unit(*parse_photometric_value(value), to);
    };
    EXPECT_EQ(converted("13ev", "nt"), 1024.0);
    EXPECT_EQ(converted("1024nt", "ev"), 13.0);
    EXPECT_EQ(converted("2.5lx", "evlx"), 0.0);
    EXPECT_EQ(converted("1evlx", "lx"), 5.0);
    EXPECT_NEAR(converted("1fL", "nt"), 3.4262590996353905, 1e-15); // 1/(π 0.3048²)
    EXPECT_NEAR(converted("1fc", "lx"), 10.763910416709722, 1e-14); // 1/0.3048²
    for (const char* unit : {"nt", "fL", "ev", "cd/m2", "knt"})
        EXPECT_NEAR(*convert_unit({converted("300nt", unit), parse_photometric_unit(unit).value()},
                                  parse_photometric_unit("nt").value()),
                    300.0, 300.0 * 4e-16)
            << unit;
    const auto same = [](const char* a, const char* b) {
        return same_quantity(*parse_photometric_unit(a), *parse_photometric_unit(b));
    };
    EXPECT_FALSE(same("nt", "lx"));
    EXPECT_FALSE(same("lx", "lx@2m"));
    EXPECT_FALSE(same("fc@6ft", "lx@2m"));
    EXPECT_FALSE(same("lm", "lm")) << "a flux has a shape's light";
    EXPECT_FALSE(convert_unit(*parse_photometric_value("0nt"), *parse_photometric_unit("ev")));
}

// (EU) No 874/2012, Annex VII, and linear in between.
TEST(Photometry, EquivalentWattsAreLumens) {
    const auto lumens = [](const char* text) { return parse_photometric_value(text)->number; };
    EXPECT_EQ(lumens("60Weq"), 806.0);
    EXPECT_EQ(lumens("15Weq"), 136.0);
    EXPECT_EQ(lumens("200 Weq"), 3452.0);
    EXPECT_NEAR(lumens("50Weq"), 638.0, 1e-12);
    EXPECT_EQ(parse_photometric_value("60Weq")->unit.unit->symbol, "lm");
    for (const char* text : {"10Weq", "300Weq", "Weq", "xWeq", "-60Weq"})
        EXPECT_FALSE(parse_photometric_value(text)) << text;
}

TEST(Photometry, MatchesIntegratedEmission) {
    // Flux of a Lambertian sphere: π L times its surface; of a point: I over the whole sphere.
    EXPECT_NEAR(test::convert(test::shape("sphere:r=25cm"), "1000nt", "lm"), pi * 1000.0 * 4.0 * pi * 0.25 * 0.25,
                1e-9);
    EXPECT_NEAR(test::convert(PointShape{}, "100cd", "lm"), 400.0 * pi, 1e-12);
    const Shape shape = test::measured();
    const Web& web = *std::get<ProfileShape>(shape).web;
    const double cd = peak(web).intensity.value;
    EXPECT_NEAR(test::convert(shape, (shortest(cd) + "cd").c_str(), "lm"), flux(web).value, 1e-10 * flux(web).value);
}

TEST(Photometry, InverseSquareIsExactForASphere) {
    // E = πL sin²σ: on contact the whole hemisphere is filled and E = πL.
    EXPECT_NEAR(test::convert(test::shape("sphere:r=50cm"), "1000nt", "lx@0.5m"), 1000.0 * pi, 1e-10);
    EXPECT_NEAR(test::convert(PointShape{}, "100cd", "lx@2m"), 25.0, 1e-14);
    EXPECT_NEAR(test::convert(PointShape{}, "100cd", "fc@10ft"), 1.0, 1e-14);
}

TEST(Photometry, WattsNeedAnEfficacy) {
    EXPECT_NEAR(test::convert(PointShape{}, "60W@90lm/W", "lm"), 5400.0, 1e-11);
    EXPECT_NEAR(test::convert(PointShape{}, "1W@683", "lm"), 683.0, 1e-12);
    EXPECT_FALSE(parse_photometric_value("60W"));
    EXPECT_FALSE(parse_photometric_value("60W@0"));
    EXPECT_FALSE(parse_photometric_value("60W@700"));
}

TEST(Photometry, WhatHasNoMeaningIsRefused) {
    const auto refused = [](const Shape& shape, const char* from, const char* to) {
        return !test::refusal(shape, from, to).empty();
    };
    EXPECT_TRUE(refused(PointShape{}, "800lm", "nt"));
    EXPECT_TRUE(refused(PointShape{}, "5nt", "lm"));
    EXPECT_TRUE(refused(test::measured(), "800lm", "nt"));
    EXPECT_TRUE(refused(test::shape("sphere:r=50cm"), "800lm", "lx@40cm")); // inside
    EXPECT_TRUE(refused(PointShape{}, "800lm", "lx"));
    EXPECT_TRUE(refused(PointShape{}, "800lm", "cd@2m"));
    EXPECT_TRUE(refused(PointShape{}, "800lm", "lx@0m"));
    EXPECT_TRUE(refused(PointShape{}, "-800lm", "cd"));
    EXPECT_TRUE(refused(PointShape{}, "800lm", "K"));
    EXPECT_TRUE(refused(PointShape{}, "3m", "cd"));
    EXPECT_TRUE(refused(test::shape("sphere:r=50cm"), "0lm", "ev"));
    EXPECT_FALSE(refused(test::shape("sphere:r=50cm"), "-3ev", "nt"));
    // Without a distance, or with one inside the shape.
    for (const char* text : {"point", "spot:outer=40deg", "disk:r=1m", "ellipse:w=1m,h=2m", "rect:w=1m,h=1m",
                             "tube:r=1cm,l=1m", "cylinder:r=1cm,l=1m"}) {
        EXPECT_TRUE(refused(test::shape(text), "1lm", "lx")) << text;
        EXPECT_TRUE(refused(test::shape(text), "1lx", "lm")) << text;
        EXPECT_FALSE(refused(test::shape(text), "1lx@1m", "lm")) << text;
    }
    EXPECT_EQ(test::refusal(test::shape("tube:r=5cm,l=1m"), "1lm", "lx@4cm"),
              "a distance of 0.04 m is inside the tube of radius 0.05 m");
    EXPECT_FALSE(refused(test::shape("tube:r=5cm,l=1m"), "1lm", "lx@5cm"));
    EXPECT_FALSE(refused(test::shape("disk:r=1m"), "1lm", "lx@1mm")); // flat: there is no inside
    for (const char* text : {"spot:outer=40deg", "frustum:h=60deg,v=40deg"}) {
        EXPECT_TRUE(refused(test::shape(text), "1nt", "lm")) << text;
        EXPECT_TRUE(refused(test::shape(text), "1lm", "ev")) << text;
    }
    // The sun has no flux, no intensity and no distance.
    const Shape sun = test::shape("sun:angle=0.53deg");
    for (const char* bad : {"1lm", "1cd", "1lx@1m", "1W@100", "1evlx@2m"})
        EXPECT_TRUE(refused(sun, bad, "lx")) << bad;
    for (const char* bad : {"lm", "cd", "lx@1m"})
        EXPECT_TRUE(refused(sun, "1lx", bad)) << bad;
    EXPECT_FALSE(refused(sun, "1lx", "nt"));
    // Results outside the range of double.
    EXPECT_TRUE(refused(test::shape("spot:outer=0.01deg"), "1e305lm", "lm"));
    EXPECT_TRUE(refused(PointShape{}, "1e300cd", "lx@1e-10m"));
}

// Every shape, each with the units that make sense for it.
struct Convertible {
    Shape shape;
    std::vector<std::string> units;
};

std::vector<Convertible> convertibles() {
    const std::vector<std::string> punctual{"lm", "klm", "cd", "lx@1m", "lx@200m", "fc@700ft", "evlx@3m"};
    std::vector<std::string> area = punctual;
    for (const char* unit : {"nt", "fL", "ev"})
        area.emplace_back(unit);
    std::vector<Convertible> all;
    for (const char* text :
         {"point", "spot:outer=40deg,inner=25deg", "spot:outer=25.0001deg,inner=25deg,falloff=linear-cos",
          "spot:outer=1e-4deg,falloff=smoothstep-angle", "spot:cone=180deg,falloff=linear-angle",
          "spot:outer=30deg,inner=30deg", "frustum:h=60deg,v=40deg", "frustum:h=179deg,v=0.001deg"})
        all.push_back({test::shape(text), punctual});
    all.push_back({test::measured(), punctual});
    all.push_back({test::masked(test::shape("spot:outer=40deg"),
                                test::random_web(Symmetry::none, test::steps(0, 360, 13), test::steps(0, 90, 19), 8)),
                   punctual});
    for (const char* text : {"sphere:r=3cm", "sphere:r=1mm", "disk:r=10cm", "disk:r=1m,two-sided",
                             "ellipse:w=60cm,h=10cm", "rect:w=60cm,h=30cm", "rect:w=2mm,h=90cm,two-sided",
                             "tube:r=1.3cm,l=1.2m", "tube:r=50cm,l=1mm", "cylinder:r=10cm,l=30cm"})
        all.push_back({test::shape(text), area});
    for (const char* text : {"sun:angle=0.53deg", "sun:angle=180deg"})
        all.push_back({test::shape(text), {"lx", "fc", "evlx", "nt", "fL", "ev"}});
    return all;
}

TEST(Photometry, EveryPairRoundTrips) {
    for (const auto& [shape, units] : convertibles())
        for (const std::string& from : units)
            for (const std::string& to : units) {
                const PhotometricUnit given = parse_photometric_unit(from).value();
                const PhotometricUnit asked = parse_photometric_unit(to).value();
                const double number = 12.3456;
                const Result<Emission> there = emission_of(shape, {number, given});
                ASSERT_TRUE(there) << kind_of(shape) << " " << from;
                const Result<double> other = express(shape, *there, asked);
                ASSERT_TRUE(other) << kind_of(shape) << " " << to;
                const Result<Emission> back = emission_of(shape, {*other, asked});
                ASSERT_TRUE(back);
                const Result<double> again = express(shape, *back, given);
                ASSERT_TRUE(again);
                // An exponent of 2 amplifies errors in its last digits: EV pairs are checked to 1e-13, others to 4 ulp.
                const bool logarithmic = (from + to).find("ev") != std::string::npos;
                const double ulp = std::nextafter(number, 20.0) - number;
                EXPECT_NEAR(*again, number, logarithmic ? 1e-13 * number : 4.0 * ulp)
                    << kind_of(shape) << " " << from << " to " << to;
            }
}

TEST(Photometry, DarkIsDarkInEveryUnit) {
    for (const auto& [shape, units] : convertibles()) {
        const PhotometricUnit unit = parse_photometric_unit(units.front()).value();
        const Result<Emission> dark = emission_of(shape, {0.0, unit});
        ASSERT_TRUE(dark);
        for (const std::string& to : units) {
            const Result<double> number = express(shape, *dark, parse_photometric_unit(to).value());
            if (to.find("ev") != std::string::npos)
                EXPECT_FALSE(number) << to;
            else
                EXPECT_EQ(number.value(), 0.0) << to;
        }
    }
}

// Values computed by hand, with 20 digits: each shape's flux, intensity and luminance.
TEST(Photometry, AreaShapesByTheirArea) {
    const auto near = [](double value, double expected) { EXPECT_NEAR(value, expected, 4e-15 * expected); };
    near(test::convert(test::shape("disk:r=10cm"), "1000nt", "cd"), 31.415926535897932385);
    near(test::convert(test::shape("disk:r=10cm"), "1000nt", "lm"), 98.696044010893586188);
    near(test::convert(test::shape("disk:r=10cm,two-sided"), "1000nt", "cd"), 31.415926535897932385);
    near(test::convert(test::shape("disk:r=10cm,two-sided"), "1000nt", "lm"), 197.39208802178717238);
    near(test::convert(test::shape("rect:w=60cm,h=30cm"), "1000nt", "cd"), 180.0);
    near(test::convert(test::shape("rect:w=60cm,h=30cm"), "1000nt", "lm"), 565.48667764616278292);
    // A given flux gives half the luminance if both sides emit.
    near(test::convert(test::shape("rect:w=60cm,h=30cm,two-sided"), "565.48667764616278292lm", "nt"), 500.0);
    // π (2π r l + 4π r²) and 2 r l + π r² of r = 1.3 cm, l = 1.2 m
    near(test::convert(test::shape("tube:r=1.3cm,l=1.2m"), "1000nt", "lm"), 314.60350988912440531);
    near(test::convert(test::shape("cylinder:r=10cm,l=30cm"), "1000nt", "lm"), pi * 2.0 * pi * 0.1 * 0.3 * 1000.0);
    near(test::convert(test::shape("cylinder:r=10cm,l=30cm"), "1000nt", "cd"), 60.0);
    near(test::convert(test::shape("cylinder:r=10cm,l=30cm"), "60cd", "lm"), 60.0 * pi * pi);
    near(test::convert(test::shape("tube:r=1.3cm,l=1.2m"), "1000nt", "cd"), 31.730929158456675057);
    // π sin²(0.265°)
    near(test::convert(test::shape("sun:angle=0.53deg"), "1e9nt", "lx"), 67203.711532951917862);
}

TEST(Photometry, SunIsTheCapAtInfinity) {
    for (const double diameter_deg : {1e-4, 0.53, 10.0, 90.0, 180.0}) {
        const double half = 0.5 * diameter_deg * pi / 180.0;
        const double cap = 2.0 * pi * test::integral(0.0, half, 4, [](double t) { return std::cos(t) * std::sin(t); });
        const double lux = test::convert(SunShape{degrees(diameter_deg)}, "1000nt", "lx");
        EXPECT_NEAR(lux, 1000.0 * cap, 1e-12 * lux) << diameter_deg;
    }
}

TEST(Photometry, StepsShowWhatTheInverseSquareWouldGive) {
    const Shape disk = test::shape("disk:r=1m");
    ConversionSteps steps;
    const Emission emission = emission_of(disk, parse_photometric_value("1cd").value(), &steps).value();
    express(disk, emission, parse_photometric_unit("lx@2m").value(), &steps).value();
    ASSERT_EQ(steps.size(), 3U);
    EXPECT_DOUBLE_EQ(steps[0].value, 0.2);  // 1/(d² + r²)
    EXPECT_DOUBLE_EQ(steps[1].value, 0.25); // 1/d²
    EXPECT_DOUBLE_EQ(steps[2].value, 25.0);
    EXPECT_EQ(steps[2].unit, "%");
    ConversionSteps of_point;
    express(PointShape{}, emission, parse_photometric_unit("lx@2m").value(), &of_point).value();
    EXPECT_EQ(of_point.size(), 1U);
}

} // namespace
} // namespace gonio
