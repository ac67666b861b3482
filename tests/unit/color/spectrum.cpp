#include <gonio/color/cct.hpp>
#include <gonio/color/detail/cie_tables.hpp>
#include <gonio/color/planckian.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/profile/profile.hpp>

#include "../temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace gonio {
namespace {

SpectrumColor color_of_illuminant(const char* name) {
    return color_of(find_illuminant(name).value()).value();
}

// Chromaticities as printed in CIE 015 and related publications.
TEST(SpectrumTest, IlluminantsHaveTheirPublishedColours) {
    struct Published {
        const char* name;
        double x, y, slack;
    };
    for (const Published& p :
         {Published{"A", 0.44758, 0.40745, 1e-5}, {"C", 0.31006, 0.31616, 1e-5},     {"D50", 0.34567, 0.35851, 1e-5},
          {"D55", 0.33243, 0.34744, 1e-5},        {"D65", 0.31272, 0.32903, 1e-5},   {"D75", 0.29903, 0.31488, 3e-5},
          {"E", 0.33333, 0.33333, 1e-5},          {"FL2", 0.3721, 0.3751, 5e-5},     {"FL7", 0.3129, 0.3292, 5e-5},
          {"FL11", 0.3805, 0.3769, 5e-5},         {"HP1", 0.5330, 0.4150, 6e-5},     {"LED-B1", 0.4560, 0.4078, 6e-5},
          {"LED-B2", 0.4357, 0.4012, 6e-5},       {"LED-B3", 0.3756, 0.3723, 6e-5},  {"LED-B4", 0.3422, 0.3502, 6e-5},
          {"LED-B5", 0.3118, 0.3236, 6e-5},       {"LED-BH1", 0.4474, 0.4066, 6e-5}, {"LED-RGB1", 0.4557, 0.4211, 6e-5},
          {"LED-V1", 0.4548, 0.4044, 6e-5},       {"LED-V2", 0.3781, 0.3775, 6e-5}}) {
        const Xy xy = to_xy(color_of_illuminant(p.name).uv);
        EXPECT_NEAR(xy.x, p.x, p.slack) << p.name;
        EXPECT_NEAR(xy.y, p.y, p.slack) << p.name;
    }
}

TEST(SpectrumTest, IlluminantsHaveTheirTemperatures) {
    struct Known {
        const char* name;
        double kelvin, duv;
    };
    // From the chromaticities above, which are printed with four or five digits: within the uncertainty of those
    // digits.
    for (const Known& k : {Known{"A", 2855.6, 0.0},
                           {"D50", 5001.75, 0.0032},
                           {"D65", 6502.93, 0.0032},
                           {"E", 5455.4, -0.0044},
                           {"LED-B1", 2732.75, -0.0007},
                           {"LED-B3", 4102.97, -0.0007},
                           {"LED-V1", 2723.1, -0.0019}}) {
        const Cct cct = exact_cct(color_of_illuminant(k.name).uv).value();
        EXPECT_NEAR(cct.temperature.value, k.kelvin, 1.0) << k.name;
        EXPECT_NEAR(cct.duv, k.duv, 6e-5) << k.name;
    }
}

TEST(SpectrumTest, DaylightTablesAreTheirComponents) {
    // M1 and M2 of CIE 015 are rounded to three decimals, as in the tables.
    for (const auto& [name, nominal] : {std::pair{"D50", 5000.0}, {"D65", 6500.0}, {"D75", 7500.0}}) {
        const Xy xy = daylight_xy(Kelvin(nominal * 1.4388 / 1.4380));
        const double m = 0.0241 + 0.2562 * xy.x - 0.7341 * xy.y;
        const double m1 = std::round((-1.3515 - 1.7703 * xy.x + 5.9114 * xy.y) / m * 1e3) / 1e3;
        const double m2 = std::round((0.0300 - 31.4424 * xy.x + 30.0717 * xy.y) / m * 1e3) / 1e3;
        const Spectrum table = find_illuminant(name).value();
        for (std::size_t i = 0; i < table.power.size(); ++i) {
            const auto& s = detail::daylight_components[i];
            EXPECT_NEAR(s[0] + m1 * s[1] + m2 * s[2], table.power[i], 0.0012) << name << ' ' << table.wavelengths_nm[i];
        }
    }
}

TEST(SpectrumTest, EfficaciesNameTheirBand) {
    // Sums at 1 nm with Km = 683.002, computed by another program (numpy).
    EXPECT_NEAR(color_of_illuminant("E").efficacy_lm_per_w, 154.95, 0.01);
    EXPECT_NEAR(color_of_illuminant("FL2").efficacy_lm_per_w, 337.0, 1.0);
    EXPECT_NEAR(color_of_illuminant("HP1").efficacy_lm_per_w, 395.0, 1.0);
    EXPECT_NEAR(color_of_illuminant("LED-BH1").efficacy_lm_per_w, 345.0, 1.0);
    EXPECT_NEAR(color_of_illuminant("LED-V1").efficacy_lm_per_w, 236.0, 1.0);
    const Spectrum d65 = find_illuminant("d65").value();
    EXPECT_NEAR(color_of(d65, Band{380, 780})->efficacy_lm_per_w, 204.8, 0.1);
    EXPECT_NEAR(color_of(d65, Band{400, 700})->efficacy_lm_per_w, 250.6, 0.5);
    EXPECT_EQ(to_text(color_of(d65)->band), "300–780 nm");
    EXPECT_FALSE(color_of(d65, Band{900, 1000}));
    EXPECT_EQ(parse_band("380nm:780nm")->last_nm, 780.0);
    for (const char* bad : {"380:780", "780nm:380nm", "380nm", "380nm:", "nm:nm"})
        EXPECT_FALSE(parse_band(bad)) << bad;
}

TEST(SpectrumTest, ABlackBodyIsThePlanckianSum) {
    for (const double kelvin : {500.0, 2700.0, 6500.0, 1e6}) {
        const SpectrumColor color = color_of(blackbody_spectrum(Kelvin(kelvin)).value()).value();
        EXPECT_LT(delta_uv_prime(color.uv, planckian_sum(1e3 / kelvin).at), 1e-13) << kelvin;
        EXPECT_NEAR(color.efficacy_lm_per_w / blackbody_efficacy(Kelvin(kelvin)).band_lm_per_w, 1.0, 1e-12) << kelvin;
    }
    EXPECT_FALSE(blackbody_spectrum(Kelvin(499)));
}

std::string rows(double first, double last, double step, double kelvin = 3000.0) {
    std::string text;
    for (double nm = first; nm <= last + 1e-6; nm += step)
        text += fmt::format("{},{}\n", nm, std::pow(560.0 / nm, 5) / std::expm1(c2_meter_kelvin * 1e9 / (nm * kelvin)));
    return text;
}

TEST(SpectrumTest, TheGridHardlyMatters) {
    const Uv truth = planckian_sum(1e3 / 3000.0).at;
    struct Grid {
        double first, step, slack;
    };
    // Fine, plain, 5 nm on its own grid points and 10 nm by interpolation; the omitted ends contribute 1e-5.
    for (const Grid& grid : {Grid{360, 0.25, 2e-6}, {360, 1, 1e-9}, {380, 2, 2e-5}, {360, 5, 4e-5}, {360, 10, 2e-4}}) {
        const Result<Spectrum> spectrum = parse_spectrum_csv(rows(grid.first, 830, grid.step), "grid.csv");
        ASSERT_TRUE(spectrum) << grid.step << spectrum.error().diagnostics.back().message;
        EXPECT_LT(delta_uv_prime(color_of(*spectrum)->uv, truth), grid.slack) << grid.step;
    }
}

TEST(SpectrumTest, CsvComesInManyDresses) {
    for (const char* separator : {",", ";", "\t", "  ", " ; "}) {
        std::string text = "\xEF\xBB\xBF# measured\nwavelength" + std::string(separator) + "power\r\n";
        for (int nm = 380; nm <= 780; nm += 5)
            text += fmt::format("{}{}{} # here\r\n", nm, separator, 1.0 + nm * 1e-3);
        const Result<Spectrum> spectrum = parse_spectrum_csv(text, "x.csv");
        ASSERT_TRUE(spectrum) << separator << spectrum.error().diagnostics.back().message;
        EXPECT_EQ(spectrum->power.size(), 81U);
        EXPECT_EQ(spectrum->power.front(), 1.38);
        EXPECT_TRUE(spectrum->diagnostics.empty());
    }
    const Result<Spectrum> shorter = parse_spectrum_csv(rows(400, 700, 5), "x.csv");
    ASSERT_TRUE(shorter);
    ASSERT_EQ(shorter->diagnostics.size(), 1U);
    EXPECT_EQ(shorter->diagnostics[0].severity, Severity::warning);
}

TEST(SpectrumTest, BadCsvSaysWhere) {
    struct Bad {
        std::string text, place, message;
    };
    const std::string good = rows(380, 780, 5);
    const auto replaced = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        const std::size_t at = text.find("\n" + from) + 1;
        text.replace(at, text.find('\n', at) - at, to);
        return text;
    };
    for (const Bad& bad :
         {Bad{replaced("400,", "400,-0.1"), "x.csv:5", "negative power, -0.1 at 400 nm"},
          Bad{replaced("400,", "400,nan"), "x.csv:5:5", "'nan' is not a power"},
          Bad{replaced("400,", "400"), "x.csv:5:4", "no power is given at 400 nm"},
          Bad{replaced("400,", "400,"), "x.csv:5:5", "no power is given at 400 nm"},
          Bad{replaced("400,", "x,1"), "x.csv:5:1", "'x' is not a wavelength"},
          Bad{replaced("400,", "395,1"), "x.csv:5", "wavelengths must ascend, but 395 nm follows 395 nm"},
          Bad{replaced("400,", "400,1,2"), "x.csv:5:7", "more than two columns"},
          Bad{rows(380, 500, 5) + rows(540, 780, 5), "x.csv:26", "a gap: nothing between 500 and 540 nm"},
          Bad{rows(420, 780, 5), "x.csv", "the spectrum reaches from 420 to 780 nm only"},
          Bad{"380,0\n400,0\n420,0\n440,0\n460,0\n480,0\n500,0\n520,0\n540,0\n560,0\n580,0\n600,0\n620,0\n640,0\n660,"
              "0\n"
              "680,0\n700,0\n",
              "x.csv", "no power anywhere in the spectrum"},
          Bad{good + "1e300,1\n", "x.csv:82", "1e+300 is not a wavelength of light in nanometres"},
          Bad{"", "x.csv", "a spectrum of fewer than two points"},
          Bad{"500,1\n", "x.csv", "a spectrum of fewer than two points"},
          Bad{"380,1\n700,1e999\n", "x.csv:2:5", "'1e999' is not a power"}}) {
        const Result<Spectrum> read = parse_spectrum_csv(bad.text, "x.csv");
        ASSERT_FALSE(read) << bad.message;
        EXPECT_EQ(read.error().failure, Failure::malformed);
        const std::string text = to_text(read.error().diagnostics.back());
        EXPECT_EQ(text.substr(0, text.find('\n')), bad.place + ": error[INP0101]: " + bad.message);
    }
}

TEST(SpectrumTest, TextOfAnotherKindIsNotQuoted) {
    for (const char* text : {"root:x:0:0:root:/root:/bin/bash\nmallory:hunter2:1:1\n", "-----BEGIN KEY-----\nhunter2\n",
                             "{\n\"token\": \"hunter2\"}", "name,token\n12345678,hunter2\n", "87654321\nhunter2\n",
                             "hunter2 hunter2\nhunter2 hunter2\n"}) {
        const Result<Spectrum> read = parse_spectrum_csv(text, "x.csv");
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().diagnostics.back().message, "not a spectrum: expected lines WAVELENGTH,POWER") << text;
    }
}

TEST(SpectrumTest, HugePowerDoesNotOverflow) {
    std::string text;
    for (int nm = 380; nm <= 780; nm += 5)
        text += fmt::format("{},{}\n", nm, nm == 555 ? 1e308 : 9e307);
    const SpectrumColor color = color_of(parse_spectrum_csv(text, "x.csv").value()).value();
    EXPECT_NEAR(color.efficacy_lm_per_w, 182.0, 3.0);
    EXPECT_TRUE(std::isfinite(color.uv.u));
}

TEST(SpectrumTest, Tm33DocumentsHaveThem) {
    Tm33File document;
    document.emitters.resize(1);
    Tm33Spectrum in_file;
    in_file.emitter_name = "LED";
    const Spectrum led = find_illuminant("LED-B3").value();
    in_file.wavelengths_nm = led.wavelengths_nm;
    in_file.power = led.power;
    document.emitters[0].spectra = {in_file, in_file};
    const Result<std::vector<Spectrum>> read = spectra_of({"lamp.xml", document, {}});
    ASSERT_TRUE(read);
    ASSERT_EQ(read->size(), 2U);
    EXPECT_EQ((*read)[0].name, "lamp.xml, LED");
    EXPECT_LT(delta_uv_prime(color_of((*read)[0])->uv, color_of(led)->uv), 1e-15);
    document.emitters[0].spectra[1].power[7] = -1.0;
    EXPECT_EQ(spectra_of({"lamp.xml", document, {}}).error().failure, Failure::malformed);
    EXPECT_TRUE(spectra_of({"lamp.ies", IesFile{}, {}})->empty());
}

TEST(SpectrumTest, NamesFilesAndBlackBodiesAreFound) {
    EXPECT_EQ(read_spectrum("led-b3")->name, "LED-B3");
    EXPECT_EQ(read_spectrum("blackbody:2700K")->wavelengths_nm.size(), 471U);
    EXPECT_EQ(read_spectrum("blackbody:2700").error().failure, Failure::usage);
    EXPECT_EQ(read_spectrum("led-b8").error().diagnostics.back().hint, "did you mean 'LED-B1'?");
    const test::TemporaryFolder folder;
    const std::string file = (folder.path() / "lamp.csv").string();
    std::ofstream(file) << rows(380, 780, 1);
    EXPECT_NEAR(exact_cct(color_of(read_spectrum(file).value())->uv)->temperature.value, 3000.0, 1.0);
    EXPECT_EQ(read_spectrum(folder.path().string()).error().failure, Failure::io);
    std::ofstream(file) << "<IESTM33-22>";
    EXPECT_EQ(read_spectrum(file).error().failure, Failure::malformed);
}

} // namespace
} // namespace gonio
