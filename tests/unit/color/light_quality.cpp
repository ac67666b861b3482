#include <gonio/color/light_quality.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace gonio {
namespace {

LightQuality quality_of(const char* name) {
    return light_quality(read_spectrum(name).value()).value();
}

bool warns(const LightQuality& quality, const char* code) {
    return std::any_of(quality.diagnostics.begin(), quality.diagnostics.end(),
                       [&](const Diagnostic& said) { return said.code == code; });
}

// Peaks of a full width at half maximum, in steps of `step_nm`.
struct Peak {
    double nm, width_nm, power;
};
Spectrum peaks(const std::vector<Peak>& list, double step_nm = 1.0, double first_nm = 380.0, double last_nm = 780.0) {
    Spectrum spectrum;
    spectrum.name = "peaks";
    for (double nm = first_nm; nm <= last_nm + 1e-9; nm += step_nm) {
        double power = 0.0;
        for (const Peak& peak : list)
            power += peak.power * std::exp2(-4.0 * std::pow((nm - peak.nm) / peak.width_nm, 2.0));
        spectrum.wavelengths_nm.push_back(nm);
        spectrum.power.push_back(power);
    }
    return spectrum;
}

// By the code of Colour 0.4.6 (commit 9d743142ed97) on the same tables: Ra and R1 to R14 to a tenth, Rf and Rg. Colour
// interpolates tables of 5 nm to 1 nm for the CRI, which moves lines: hence its slack.
TEST(LightQualityTest, IlluminantsHaveTheFiguresOfAnotherProgram) {
    struct Known {
        const char* name;
        double r[15]; // Ra, R1, …
        double rf, rg;
    };
    for (const Known& k :
         {Known{"A", {100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100}, 100.0003, 100.0},
          {"E",
           {95.3, 94.6, 96.8, 98.2, 92.6, 94.2, 96.4, 96.5, 93.0, 82.2, 94.2, 92.3, 88.7, 94.7, 98.7},
           94.7075,
           103.6577},
          {"FL2",
           {64.2, 55.9, 76.7, 90.3, 57.0, 58.9, 67.2, 74.1, 33.1, -83.9, 45.3, 45.9, 53.7, 60.3, 94.0},
           70.1208,
           86.4163},
          {"FL11",
           {82.8, 98.3, 92.9, 50.4, 88.4, 87.3, 77.3, 88.5, 79.4, 25.2, 46.8, 72.3, 53.0, 96.9, 66.7},
           80.0404,
           101.0567},
          {"HP1",
           {8.1, -3.1, 61.4, 39.9, -26.8, -3.9, 51.9, 21.0, -75.8, -260.8, 42.8, -52.3, 26.6, 7.2, 60.4},
           34.1921,
           53.9669},
          {"LED-B3",
           {84.8, 83.6, 89.3, 93.2, 84.8, 83.7, 84.8, 88.2, 71.1, 23.8, 74.3, 83.8, 66.5, 84.7, 96.2},
           85.3243,
           97.8632},
          {"LED-RGB1",
           {57.1, 48.6, 79.9, 83.1, 36.0, 47.7, 62.5, 70.7, 28.3, -34.2, 53.4, 13.9, 52.1, 54.7, 87.9},
           71.0007,
           107.0082}}) {
        const LightQuality quality = quality_of(k.name);
        EXPECT_NEAR(quality.rendering->ra, k.r[0], 0.07) << k.name;
        for (std::size_t i = 1; i < 15; ++i)
            EXPECT_NEAR(quality.rendering->r[i - 1], k.r[i], 0.2) << k.name << " R" << i;
        EXPECT_NEAR(quality.fidelity->rf, k.rf, 0.003) << k.name;
        EXPECT_NEAR(quality.fidelity->rg, k.rg, 0.003) << k.name;
    }
}

// FL2 is the example of IES TM-30: 4225 K, Duv 0.0019 and Rf 70, Rg 86. CIE 15 prints its R1 to R14 as whole numbers.
TEST(LightQualityTest, Fl2IsThePublishedExample) {
    const LightQuality quality = quality_of("FL2");
    EXPECT_NEAR(quality.cct->temperature.value, 4225.0, 1.0);
    EXPECT_NEAR(quality.cct->duv, 0.0019, 1.5e-4);
    EXPECT_EQ(std::lround(quality.fidelity->rf), 70);
    EXPECT_EQ(std::lround(quality.fidelity->rg), 86);
    EXPECT_EQ(quality.fidelity->reference, ReferenceIlluminant::blend);
    EXPECT_EQ(quality.rendering->reference, ReferenceIlluminant::planckian);
    const long printed[] = {56, 77, 90, 57, 59, 67, 74, 33, -84, 45, 46, 54, 60, 94};
    for (std::size_t i = 0; i < std::size(printed); ++i)
        EXPECT_EQ(std::lround(quality.rendering->r[i]), printed[i]) << "R" << i + 1;
    // By Colour's code, as above.
    const double rf[] = {60.20, 61.28, 52.54, 68.33, 79.55, 87.53, 76.77, 72.73,
                         76.16, 62.29, 69.61, 76.54, 81.34, 71.37, 63.59, 65.26};
    const double rcs[] = {-0.2493, -0.1766, -0.0889, 0.0541, 0.1110, 0.0445, -0.0773, -0.1464,
                          -0.1724, -0.1543, -0.0364, 0.0505, 0.1100, 0.0668, -0.0645, -0.1637};
    const double rhs[] = {-0.0220, 0.1401, 0.2443, 0.1962, 0.0914,  -0.0673, -0.1224, -0.0847,
                          0.0063,  0.1658, 0.1904, 0.1143, -0.0808, -0.1467, -0.2635, -0.1700};
    int samples = 0;
    for (std::size_t i = 0; i < hue_bin_count; ++i) {
        const HueBin& bin = quality.fidelity->bins[i];
        EXPECT_NEAR(bin.fidelity, rf[i], 0.02) << i;
        EXPECT_NEAR(bin.chroma_shift, rcs[i], 2e-4) << i;
        EXPECT_NEAR(bin.hue_shift, rhs[i], 2e-4) << i;
        samples += bin.samples;
    }
    EXPECT_EQ(samples, static_cast<int>(fidelity_sample_count));
}

// JIS Z 8726's sample by Colour's code with that sample put into it.
TEST(LightQualityTest, TheFifteenthSampleIsSkin) {
    EXPECT_NEAR(quality_of("FL2").rendering->r[14], 46.878, 0.1);
    EXPECT_NEAR(quality_of("FL11").rendering->r[14], 95.947, 0.2);
    EXPECT_NEAR(quality_of("LED-B3").rendering->r[14], 79.014, 0.1);
}

// In steps of 1 nm the samples are interpolated. By Colour's code, which takes the tables of CIE 224 at 1 nm.
TEST(LightQualityTest, FinerStepsAgreeToo) {
    const LightQuality narrow = light_quality(peaks({{460, 20, 1.0}, {530, 30, 0.9}, {625, 18, 1.3}})).value();
    EXPECT_NEAR(narrow.fidelity->rf, 66.1311, 0.01);
    EXPECT_NEAR(narrow.fidelity->rg, 116.7299, 0.01);
    EXPECT_NEAR(narrow.rendering->ra, 51.385, 0.05);
    EXPECT_NEAR(narrow.rendering->r[8], -138.349, 0.2);
    const LightQuality white = light_quality(peaks({{450, 20, 1.0}, {560, 115, 0.62}})).value();
    EXPECT_NEAR(white.fidelity->rf, 70.7958, 0.01);
    EXPECT_NEAR(white.fidelity->rg, 86.6289, 0.01);
    // A smooth light is the same in steps of 5 nm.
    const LightQuality coarse = light_quality(peaks({{450, 20, 1.0}, {560, 115, 0.62}}, 5.0)).value();
    EXPECT_NEAR(coarse.fidelity->rf, white.fidelity->rf, 0.02);
    EXPECT_NEAR(coarse.rendering->ra, white.rendering->ra, 0.02);
    EXPECT_NEAR(coarse.alpha_opic.melanopic_der(), white.alpha_opic.melanopic_der(), 1e-4);
}

TEST(LightQualityTest, BlackBodiesAndDaylightAreTheirOwnReference) {
    for (const double kelvin : {1000.0, 1900.0, 2700.0, 3500.0, 3999.0}) {
        const LightQuality quality = light_quality(blackbody_spectrum(Kelvin(kelvin)).value()).value();
        for (const double r : quality.rendering->r)
            EXPECT_NEAR(r, 100.0, 1e-4) << kelvin;
        EXPECT_NEAR(quality.rendering->ra, 100.0, 1e-4) << kelvin;
        EXPECT_NEAR(quality.fidelity->rf, 100.0, 1e-3) << kelvin;
        EXPECT_NEAR(quality.fidelity->rg, 100.0, 1e-4) << kelvin;
        EXPECT_LT(quality.rendering->reference_duv, 1e-8);
        EXPECT_TRUE(quality.diagnostics.empty());
    }
    for (const char* const name : {"D50", "D55", "D65", "D75"}) {
        const LightQuality quality = quality_of(name);
        EXPECT_EQ(quality.rendering->reference, ReferenceIlluminant::daylight);
        EXPECT_NEAR(quality.rendering->ra, 100.0, 0.03) << name;
        EXPECT_NEAR(quality.fidelity->rf, 100.0, 0.01) << name;
        EXPECT_NEAR(quality.fidelity->rg, 100.0, 0.03) << name;
    }
}

TEST(LightQualityTest, FiguresDoNotDependOnTheScale) {
    for (const std::string_view name : illuminant_names()) {
        Spectrum spectrum = find_illuminant(name).value();
        const LightQuality once = light_quality(spectrum).value();
        for (const double factor : {1e-200, 0.125, 1e200}) {
            Spectrum scaled = spectrum;
            for (double& power : scaled.power)
                power *= factor;
            const LightQuality again = light_quality(scaled).value();
            EXPECT_NEAR(again.rendering->ra, once.rendering->ra, 1e-9) << name;
            EXPECT_NEAR(again.fidelity->rf, once.fidelity->rf, 1e-9) << name;
            EXPECT_NEAR(again.fidelity->rg, once.fidelity->rg, 1e-9) << name;
            EXPECT_NEAR(again.alpha_opic.melanopic_der(), once.alpha_opic.melanopic_der(), 1e-12) << name;
        }
        EXPECT_LE(once.rendering->ra, 100.0 + 1e-9) << name;
        EXPECT_GE(once.fidelity->rf, 0.0) << name;
    }
}

// Of D65, as CIE S 026 prints them; the melanopic DER of the others by this text's formula in another program.
TEST(LightQualityTest, AlphaOpicEfficaciesAreThePrintedOnes) {
    const AlphaOpic daylight = alpha_opic(find_illuminant("D65").value()).value();
    for (const ReceptorName& receptor : receptor_names()) {
        const auto i = static_cast<std::size_t>(receptor.receptor);
        EXPECT_NEAR(daylight.efficacy_mw_per_lm[i], receptor.d65_mw_per_lm, 3e-4) << receptor.name;
        EXPECT_NEAR(daylight.der[i], 1.0, 4e-4) << receptor.name;
    }
    struct Known {
        const char* name;
        double der;
    };
    for (const Known& k :
         {Known{"A", 0.4958}, {"E", 0.9058}, {"FL2", 0.570}, {"FL11", 0.564}, {"HP1", 0.154}, {"LED-B3", 0.633}})
        EXPECT_NEAR(quality_of(k.name).alpha_opic.melanopic_der(), k.der, 1.1e-3) << k.name;
    // A line at the maximum of the action spectrum: 1 W of it over its lumens.
    Spectrum line;
    line.name = "line";
    line.wavelengths_nm = {490.0};
    line.power = {3.0};
    EXPECT_NEAR(alpha_opic(line)->efficacy_mw_per_lm[4], 1e3 / (683.0 * 0.20802), 1e-2);
}

TEST(LightQualityTest, ItSaysWhatStandardsDoNotAccept) {
    EXPECT_TRUE(quality_of("FL2").diagnostics.empty());
    // Too far from the reference for CIE 13.3.
    const LightQuality green = light_quality(peaks({{450, 20, 0.5}, {550, 90, 1.0}})).value();
    EXPECT_GT(green.rendering->reference_duv, greatest_reference_duv);
    EXPECT_TRUE(warns(green, "RES0109"));
    EXPECT_TRUE(warns(light_quality(peaks({{450, 20, 1.0}, {560, 115, 0.62}}, 10.0)).value(), "RES0110"));
    EXPECT_TRUE(warns(light_quality(peaks({{450, 20, 1.0}, {560, 115, 0.62}}, 5.0, 400.0, 700.0)).value(), "RES0103"));
    // The reader has said it already.
    const Spectrum read =
        parse_spectrum_csv("400,1\n500,1\n", "short.csv")
            .value_or(parse_spectrum_csv(
                          "390,1\n400,1\n410,1\n420,1\n430,1\n440,1\n450,1\n460,1\n470,1\n480,1\n490,1\n500,1\n510,1\n"
                          "520,1\n530,1\n540,1\n550,1\n560,1\n570,1\n580,1\n590,1\n600,1\n610,1\n620,1\n630,1\n640,1\n"
                          "650,1\n660,1\n670,1\n680,1\n690,1\n700,1\n",
                          "short.csv")
                          .value());
    EXPECT_FALSE(read.diagnostics.empty());
    EXPECT_FALSE(warns(light_quality(read).value(), "RES0103"));
}

TEST(LightQualityTest, LightsWithoutAReferenceKeepWhatTheyHave) {
    const Spectrum blue = peaks({{450, 20, 1.0}});
    const LightQuality quality = light_quality(blue).value();
    EXPECT_FALSE(quality.cct || quality.rendering || quality.fidelity);
    EXPECT_TRUE(warns(quality, "RES0111"));
    EXPECT_GT(quality.alpha_opic.melanopic_der(), 1.0);
    EXPECT_FALSE(color_rendering(blue));
    EXPECT_FALSE(color_fidelity(blue));
    EXPECT_TRUE(warns(light_quality(blackbody_spectrum(Kelvin(30000.0)).value()).value(), "RES0111"));
    // Visible for the observer, but outside of the range of the figures.
    EXPECT_FALSE(light_quality(peaks({{365, 2, 1.0}}, 1.0, 360.0, 370.0)));
    EXPECT_FALSE(alpha_opic(peaks({{365, 2, 1.0}}, 1.0, 360.0, 370.0)));
    EXPECT_FALSE(light_quality(peaks({{900, 10, 1.0}}, 1.0, 850.0, 950.0)));
}

// Lights of odd tables: each gives numbers, or says why not.
TEST(LightQualityTest, OddTablesGiveNumbersOrFail) {
    for (const double step : {0.3, 1.0, 2.5, 3.7, 5.0, 7.0, 20.0})
        for (const double first : {300.0, 379.9, 382.5, 400.0})
            for (const double last : {700.0, 781.0, 1100.0}) {
                const LightQuality quality =
                    light_quality(peaks({{450, 30, 1.0}, {580, 150, 1.0}}, step, first, last)).value();
                ASSERT_TRUE(quality.rendering);
                EXPECT_TRUE(std::isfinite(quality.rendering->ra));
                EXPECT_NEAR(quality.rendering->ra, 83.0, 8.0) << step << ' ' << first << ' ' << last;
                EXPECT_TRUE(std::isfinite(quality.fidelity->rf));
                EXPECT_TRUE(std::isfinite(quality.fidelity->rg));
            }
    // Two lines, a single sample of both.
    for (const double nm : {480.0, 530.0, 590.0}) {
        Spectrum line;
        line.name = "line";
        line.wavelengths_nm = {nm};
        line.power = {1.0};
        if (const Result<LightQuality> quality = light_quality(line); quality && quality->fidelity) {
            EXPECT_TRUE(std::isfinite(quality->fidelity->rf));
            EXPECT_LT(quality->rendering->ra, 0.0);
        }
    }
}

} // namespace
} // namespace gonio
