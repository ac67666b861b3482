#include <gonio/base/nearest.hpp>
#include <gonio/base/unit_text.hpp>

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <numbers>

namespace gonio {
namespace {

TEST(UnitText, ReadsNumbersWithUnits) {
    EXPECT_DOUBLE_EQ(parse_amount("800lm")->in_base_units(), 800.0);
    EXPECT_DOUBLE_EQ(parse_amount("+2.5klm")->in_base_units(), 2500.0);
    EXPECT_DOUBLE_EQ(parse_amount("1e3lm")->in_base_units(), 1000.0);
    EXPECT_DOUBLE_EQ(parse_amount("5ev")->number, 5.0); // not an exponent
    EXPECT_DOUBLE_EQ(parse_amount("6ft")->in_base_units(), 1.8288);
    EXPECT_DOUBLE_EQ(parse_amount("180deg")->in_base_units(), std::numbers::pi);
    EXPECT_DOUBLE_EQ(parse_amount("1cd/m2")->in_base_units(), 1.0);
    EXPECT_NEAR(parse_amount("1fc")->in_base_units(), 10.763910416709722, 1e-14);
    EXPECT_NEAR(parse_amount("1fL")->in_base_units(), 3.4262590996353905, 1e-14);
}

TEST(UnitText, DecimalMultiplesRoundOnce) {
    EXPECT_EQ(parse_amount("1.3cm")->in_base_units(), 0.013);
    EXPECT_EQ(parse_amount("7mm")->in_base_units(), 0.007);
    EXPECT_EQ(parse_amount("2.3km")->in_base_units(), 2300.0);
}

TEST(UnitText, RefusesWhatIsNoAmount) {
    for (const char* text : {"", "lm", "800", "800 ", "nanlm", "inflm", "0x10lm", "1e999lm", "8..0lm", "--5lm", "+-5lm",
                             "1e308km", "-1e306klm"})
        EXPECT_FALSE(parse_amount(text)) << text;
    EXPECT_TRUE(parse_amount("1e308m") && parse_amount("1e308mm"));
    const auto error = parse_amount("800luu");
    ASSERT_FALSE(error);
    EXPECT_EQ(error.error().failure, Failure::usage);
    EXPECT_EQ(parse_amount("800lM").error().diagnostics.back().hint, "did you mean 'lm'?");
}

TEST(UnitText, ChecksTheDimension) {
    const auto radius = parse_amount("3lm", Dimension::length, "the radius");
    ASSERT_FALSE(radius);
    EXPECT_NE(radius.error().diagnostics.back().message.find("is a luminous flux"), std::string::npos);
    EXPECT_DOUBLE_EQ(*parse_amount("3cm", Dimension::length, "the radius"), 0.03);
}

TEST(UnitText, ShortestTextReadsBack) {
    for (const double value : {0.1, 1.0 / 3.0, 22515.81858718617, 1e300, 5e-324, -0.0, 123456789.0})
        EXPECT_EQ(*parse_number(shortest(value)), value);
}

TEST(UnitText, EveryUnitReadsBackFromItsSymbol) {
    for (const Unit& unit : all_units()) {
        const auto amount = parse_amount("2" + std::string(unit.symbol));
        ASSERT_TRUE(amount) << unit.symbol;
        EXPECT_EQ(amount->unit, &unit);
    }
}

TEST(Nearest, FindsTyposAndKeepsQuietOtherwise) {
    constexpr std::array<std::string_view, 4> names{"units", "info", "sample", "preview"};
    EXPECT_EQ(nearest("untis", names), "units");
    EXPECT_EQ(nearest("prevew", names), "preview");
    EXPECT_EQ(nearest("INFO", names), "info");
    EXPECT_EQ(nearest("frobnicate", names), "");
    EXPECT_EQ(nearest("", names), "");
}

TEST(UnitText, UnitsMayBeWords) {
    const auto base = [](const char* text) { return parse_amount(text)->in_base_units(); };
    for (const char* text : {"800lm", "800 lm", "800  lm", "800lumens", "800 Lumens", "800lumen"})
        EXPECT_EQ(base(text), 800.0) << text;
    EXPECT_EQ(base("6 feet"), 6.0 * 0.3048);
    EXPECT_EQ(base("300 nits"), 300.0);
    EXPECT_EQ(find_unit("metres"), find_unit("m"));
    for (const char* text : {"800 ", "800 lm ", "800l m", "800LM", "8 00lm"}) // a symbol is case-sensitive
        EXPECT_FALSE(parse_amount(text)) << text;
}

} // namespace
} // namespace gonio
