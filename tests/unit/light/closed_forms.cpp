// The closed forms against 50-digit values, in double and in float, and the conversions built from them.
#include <gonio/base/exposure_value.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/light/closed_forms.hpp>
#include <gonio/light/photometric_value.hpp>
#include <gonio/light/photometry.hpp>
#include <gonio/light/shape_traits.hpp>

#include "../folders.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gonio {
namespace {

struct Row {
    std::string form;
    std::vector<std::string> arguments; // exact in float
    std::string value;
};

// "form,argument 1,argument 2,argument 3,value", as reference.py writes it.
std::vector<Row> reference() {
    std::vector<Row> rows;
    std::ifstream file(std::string(test::source_folder) + "/tests/unit/light/reference.csv");
    std::string line;
    std::getline(file, line); // the description
    std::getline(file, line); // the columns' names
    while (std::getline(file, line)) {
        std::vector<std::string> cells;
        for (std::size_t begin = 0; begin <= line.size();) {
            const std::size_t comma = std::min(line.find(',', begin), line.size());
            cells.push_back(line.substr(begin, comma - begin));
            begin = comma + 1;
        }
        rows.push_back({cells.at(0), {cells.at(1), cells.at(2), cells.at(3)}, cells.at(4)});
    }
    return rows;
}

template<class S>
S evaluate(const Row& row) {
    namespace form = closed_form;
    const auto argument = [&](std::size_t i) {
        return static_cast<S>(std::strtod(row.arguments.at(i).c_str(), nullptr));
    };
    const S a = argument(0);
    const S b = argument(1);
    const S c = argument(2);
    for (const Falloff falloff : {Falloff::hard, Falloff::frostbite, Falloff::linear_cos, Falloff::smoothstep_cos,
                                  Falloff::linear_angle, Falloff::smoothstep_angle})
        if (row.form == std::string("spot ") + to_text(falloff))
            return form::spot_solid_angle(a < b ? falloff : Falloff::hard, a, b);
    if (row.form == "frustum") return form::frustum_solid_angle(a, b);
    if (row.form == "disk area") return form::disk_area(a);
    if (row.form == "tube area") return form::tube_area(a, b);
    if (row.form == "tube solid angle") return form::tube_solid_angle(a, b);
    if (row.form == "sun") return form::sun_projected_solid_angle(a);
    if (row.form == "facing sphere") return form::facing_sphere(a, b);
    if (row.form == "facing disk") return form::facing_disk(a, b);
    if (row.form == "facing rect") return form::facing_rectangle(a, b, c);
    if (row.form == "facing tube") return form::facing_tube(a, b, c);
    if (row.form == "cylinder area") return form::cylinder_area(a, b);
    if (row.form == "facing cylinder") return form::facing_cylinder(a, b, c);
    if (row.form == "luminance of ev") return luminance_of_ev(a);
    if (row.form == "ev of luminance") return ev_of_luminance(a);
    if (row.form == "illuminance of ev") return illuminance_of_ev(a);
    if (row.form == "ev of illuminance") return ev_of_illuminance(a);
    ADD_FAILURE() << "no form '" << row.form << "'";
    return S(0);
}

// The distance of `value` from the exact value, in units of the exact value's last place in S. The exact value is read
// to 64 bits: its own error is a thousandth of an ulp of double.
template<class S>
double ulp_error(S value, const std::string& exact_text) {
    const long double exact = std::strtold(exact_text.c_str(), nullptr);
    int exponent = 0;
    static_cast<void>(std::frexp(exact, &exponent));
    const long double ulp = std::ldexp(1.0L, exponent - std::numeric_limits<S>::digits);
    return static_cast<double>(std::abs(static_cast<long double>(value) - exact) / ulp);
}

template<class S>
void expect_within(double most_ulp) {
    std::map<std::string, double> worst;
    const std::vector<Row> rows = reference();
    ASSERT_GT(rows.size(), 1000U);
    for (const Row& row : rows) {
        const S made = evaluate<S>(row);
        const double error = ulp_error(made, row.value);
        EXPECT_LE(error, most_ulp) << row.form << " of " << row.arguments[0] << ", " << row.arguments[1] << ", "
                                   << row.arguments[2];
        worst[row.form] = std::max(worst[row.form], error);
    }
    for (const auto& [form, ulp] : worst)
        std::cout << form << ": " << ulp << " ulp\n";
}

TEST(ClosedForms, DoubleWithinFourUlpOfFiftyDigits) {
    expect_within<double>(4.0);
}

TEST(ClosedForms, FloatWithinEightUlpOfFiftyDigits) {
    expect_within<float>(8.0);
}

// The candela of a spot of 800 lm, and the lux of a tube of 1000 nt, through the conversion itself.
TEST(ClosedForms, ConversionsKeepThem) {
    const PhotometricValue lumens{800.0, {find_unit("lm"), std::nullopt, std::nullopt}};
    const PhotometricValue nits{1000.0, {find_unit("nt"), std::nullopt, std::nullopt}};
    for (const Row& row : reference()) {
        const auto argument = [&](std::size_t i) { return std::strtod(row.arguments.at(i).c_str(), nullptr); };
        const long double exact = std::strtold(row.value.c_str(), nullptr);
        for (const Falloff falloff : {Falloff::hard, Falloff::frostbite, Falloff::linear_cos, Falloff::smoothstep_cos,
                                      Falloff::linear_angle, Falloff::smoothstep_angle}) {
            if (row.form != std::string("spot ") + to_text(falloff)) continue;
            const SpotShape spot{Radians(argument(1)), Radians(argument(0)), falloff, {}, nullptr};
            const Result<Emission> emission = emission_of(spot, lumens);
            ASSERT_TRUE(emission);
            EXPECT_NEAR(static_cast<double>(emission->intensity.value / (800.0L / exact)), 1.0, 4 * 0x1p-53)
                << row.form;
        }
        if (row.form == "facing tube" && argument(2) < 1e9 * argument(0)) {
            const TubeShape tube{Meters(argument(0)), Meters(argument(1))};
            const PhotometricUnit lux{find_unit("lx"), Meters(argument(2)), std::nullopt};
            const Result<Emission> emission = emission_of(tube, nits);
            ASSERT_TRUE(emission);
            const Result<double> made = express(tube, *emission, lux);
            ASSERT_TRUE(made);
            EXPECT_NEAR(static_cast<double>(*made / (1000.0L * exact)), 1.0, 6 * 0x1p-53) << argument(2);
        }
    }
}

// A web is integrated once and gives the same result as without preparation; so do the other shapes.
TEST(ClosedForms, PreparedAndAloneAgree) {
    const std::string web = std::string("ies:") + test::source_folder + "/profiles/street.ies";
    for (const char* text :
         {"point", "spot:outer=40deg,inner=25deg", "frustum:h=60deg,v=40deg", "sphere:r=3cm", "disk:r=3cm",
          "ellipse:w=60cm,h=30cm", "rect:w=60cm,h=30cm", "tube:r=1cm,l=1m", "cylinder:r=1cm,l=1m", web.c_str()}) {
        Result<Shape> shape = parse_shape(text);
        ASSERT_TRUE(shape);
        Diagnostics ignored;
        ASSERT_TRUE(load_profile(*shape, ignored));
        Result<ShapePhotometry> prepared = ShapePhotometry::of(*shape);
        ASSERT_TRUE(prepared);
        for (const char* value_text : {"800lm", "300cd", "20lx@2m", "5evlx@2m"})
            for (const char* unit_text : {"lm", "cd", "lx@3m"}) {
                const Result<PhotometricValue> value = parse_photometric_value(value_text);
                const Result<PhotometricUnit> unit = parse_photometric_unit(unit_text);
                ASSERT_TRUE(value && unit);
                const Result<Emission> one = prepared->emission_of(*value);
                const Result<Emission> other = emission_of(*shape, *value);
                ASSERT_TRUE(one && other) << text << value_text;
                EXPECT_EQ(*prepared->express(*one, *unit), *express(*shape, *other, *unit)) << text;
            }
    }
}

TEST(ClosedForms, SizesBeyondNumbersAreRefused) {
    for (const double radius : {1e-160, 1e-200, 1e200}) {
        const Result<ShapePhotometry> photometry = ShapePhotometry::of(SphereShape{Meters(radius)});
        ASSERT_FALSE(photometry);
        EXPECT_EQ(photometry.error().failure, Failure::usage);
    }
    EXPECT_TRUE(ShapePhotometry::of(SphereShape{Meters(1e-150)}));
}

// A ray has an intensity but no flux.
TEST(ClosedForms, SpotOfNoAngle) {
    const Result<Shape> ray = parse_shape("spot:outer=0deg");
    ASSERT_TRUE(ray);
    const Result<Emission> emission = emission_of(*ray, *parse_photometric_value("1000cd"));
    ASSERT_TRUE(emission);
    EXPECT_EQ(*express(*ray, *emission, *parse_photometric_unit("lm")), 0.0);
    EXPECT_EQ(*express(*ray, *emission, *parse_photometric_unit("lx@2m")), 250.0);
    EXPECT_FALSE(emission_of(*ray, *parse_photometric_value("800lm")));
}

} // namespace
} // namespace gonio
