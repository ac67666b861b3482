// TM-33: every rule with the smallest document that triggers it, and what survives reading and writing.
#include <gonio/profile/luminous_opening.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/profile/tm33_light.hpp>
#include <gonio/profile/write.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/resolve.hpp>

#include "equal.hpp"
#include "expect.hpp"

#include <gtest/gtest.h>

namespace {

using namespace gonio;
using namespace gonio::test;

// 33 lines; the points are lines 25 to 30.
const TextLines lamp = {"<?xml version=\"1.0\" encoding=\"UTF-8\"?>",
                        "<IESTM33-22>",
                        "<Version>1.1</Version>",
                        "<Header>",
                        "<Manufacturer>Lamp Works</Manufacturer>",
                        "<Description>Lamp &amp; shade</Description>",
                        "<Laboratory>bench</Laboratory>",
                        "<ReportNumber>7</ReportNumber>",
                        "<ReportDate>2024-01-01</ReportDate>",
                        "</Header>",
                        "<Equipment><Gonioradiometer><Type>IES_C</Type></Gonioradiometer></Equipment>",
                        "<Emitter>",
                        "<Quantity>2</Quantity>",
                        "<Description>LED</Description>",
                        "<RatedLumens>500</RatedLumens>",
                        "<InputWattage>10.5</InputWattage>",
                        "<LuminousData>",
                        "<LuminousIntensity>",
                        "<AbsolutePhotometry>false</AbsolutePhotometry>",
                        "<Symm>Symm_Quad</Symm>",
                        "<Multiplier>2</Multiplier>",
                        "<NumberMeasured>6</NumberMeasured>",
                        "<NumberHorz>2</NumberHorz>",
                        "<NumberVert>3</NumberVert>",
                        "<IntData h=\"0\" v=\"0\">100</IntData>",
                        "<IntData h=\"0\" v=\"45\">80.5</IntData>",
                        "<IntData h=\"0\" v=\"90\">0</IntData>",
                        "<IntData h=\"90\" v=\"0\">100</IntData>",
                        "<IntData h=\"90\" v=\"45\">70</IntData>",
                        "<IntData h=\"90\" v=\"90\">0</IntData>",
                        "</LuminousIntensity>",
                        "<LuminousFlux>930</LuminousFlux>",
                        "</LuminousData></Emitter></IESTM33-22>"};

Result<Profile> read(const std::string& text, bool strict = false) {
    return read_profile(text, "lamp", {{}, strict});
}
Result<Profile> read(const TextLines& lines, bool strict = false) {
    return read(joined(lines), strict);
}
Tm33File file_of(const Result<Profile>& profile) {
    EXPECT_TRUE(profile) << said(profile);
    return profile && std::holds_alternative<Tm33File>(profile->file) ? std::get<Tm33File>(profile->file) : Tm33File{};
}
Tm33File file_of(const TextLines& lines) {
    return file_of(read(lines));
}

TEST(Tm33Read, ReadsItsFields) {
    expect_silent(read(lamp));
    expect_silent(read(lamp, true));
    const Tm33File file = file_of(lamp);
    EXPECT_EQ(file.root, "IESTM33-22");
    EXPECT_STREQ(edition(file), "TM-33-23");
    EXPECT_EQ(file.version, "1.1");
    ASSERT_EQ(file.header.size(), 5U);
    EXPECT_EQ(file.header[0], (Tm33Text{"Manufacturer", "Lamp Works"}));
    EXPECT_EQ(file.header[1], (Tm33Text{"Description", "Lamp & shade"}));
    EXPECT_EQ(file.goniometer, "IES_C");
    ASSERT_EQ(file.emitters.size(), 1U);
    const Tm33Emitter& emitter = file.emitters[0];
    EXPECT_EQ(emitter.quantity, 2.0);
    EXPECT_EQ(emitter.description, "LED");
    EXPECT_EQ(emitter.rated_lumens, 500.0);
    EXPECT_EQ(emitter.input_watts, 10.5);
    EXPECT_EQ(emitter.luminous_flux_lm, 930.0);
    EXPECT_FALSE(emitter.cct_k);
    ASSERT_TRUE(emitter.intensity);
    EXPECT_EQ(emitter.intensity->absolute, false);
    EXPECT_EQ(emitter.intensity->symmetry, Tm33Symmetry::quadrant);
    EXPECT_EQ(emitter.intensity->multiplier, 2.0);
    EXPECT_EQ(emitter.intensity->horizontal_deg, (std::vector<double>{0, 90}));
    EXPECT_EQ(emitter.intensity->vertical_deg, (std::vector<double>{0, 45, 90}));
    EXPECT_EQ(emitter.intensity->candela, (std::vector<double>{100, 80.5, 0, 100, 70, 0}));
    // The table is stored once: in the numbers.
    EXPECT_EQ(file.document.find("80.5"), std::string::npos) << file.document;
}

TEST(Tm33Read, ReadsColourTiltSpectraAndAreas) {
    const std::string more = "<TiltAngles><NumberAngles>2</NumberAngles><Tilt angle=\"0\">1</Tilt>"
                             "<Tilt angle=\"90\">0.9</Tilt></TiltAngles>"
                             "<ColorTemperature><FixedCCT>3000</FixedCCT><MinCCT>2700</MinCCT></ColorTemperature>"
                             "<ColorRendering><CIE_CRI><Ra>92</Ra><R9>85</R9></CIE_CRI>"
                             "<IES_TM30><Rf>90</Rf><Rg>101</Rg></IES_TM30></ColorRendering><Duv>-0.002</Duv>"
                             "<SpectralData><EmitterSpectral><EmitterName>warm</EmitterName>"
                             "<NumberWavelength>3</NumberWavelength><Normalized>true</Normalized>"
                             "<PwrData w=\"400\">0.1</PwrData><PwrData w=\"500\">0.5</PwrData>"
                             "<PwrData w=\"600\">1</PwrData></EmitterSpectral></SpectralData>"
                             "<EmissionAreas><BottomFace><NumberBottom>1</NumberBottom><BottomArea><Length>0.6</Length>"
                             "<Width>0.6</Width><LengthOffset>0</LengthOffset><WidthOffset>0</WidthOffset>"
                             "<Circular>true</Circular></BottomArea></BottomFace></EmissionAreas>";
    const Result<Profile> profile = read(with(lamp, 16, "<InputWattage>10.5</InputWattage>" + more), true);
    expect_silent(profile);
    const Tm33Emitter emitter = file_of(profile).emitters.at(0);
    EXPECT_EQ(emitter.tilt.angles_deg, (std::vector<double>{0, 90}));
    EXPECT_EQ(emitter.tilt.factors, (std::vector<double>{1, 0.9}));
    EXPECT_EQ(emitter.cct_k, 3000.0);
    EXPECT_EQ(emitter.min_cct_k, 2700.0);
    EXPECT_FALSE(emitter.max_cct_k);
    EXPECT_EQ(emitter.cri_ra, 92.0);
    EXPECT_EQ(emitter.cri_r9, 85.0);
    EXPECT_EQ(emitter.tm30_rf, 90.0);
    EXPECT_EQ(emitter.tm30_rg, 101.0);
    EXPECT_EQ(emitter.duv, -0.002);
    ASSERT_EQ(emitter.spectra.size(), 1U);
    EXPECT_EQ(emitter.spectra[0].emitter_name, "warm");
    EXPECT_EQ(emitter.spectra[0].normalized, true);
    EXPECT_EQ(emitter.spectra[0].wavelengths_nm, (std::vector<double>{400, 500, 600}));
    EXPECT_EQ(emitter.spectra[0].power, (std::vector<double>{0.1, 0.5, 1}));
    EXPECT_EQ(emitter.bottom_areas, (std::vector<Tm33Area>{{0.6, 0.6, true}}));
    EXPECT_EQ(luminous_opening(*profile).shape, OpeningShape::disk);
    EXPECT_EQ(luminous_opening(*profile).width_m, 0.6);
}

TEST(Tm33Read, RootsOfAllEditions) {
    for (const std::string root : {"IESTM33", "IESTM33-18", "ATLA_S001", "ATLA_S001_A"}) {
        TextLines lines = with(with(lamp, 2, "<" + root + ">"), 33, "</LuminousData></Emitter></" + root + ">");
        expect_silent(read(lines));
        EXPECT_EQ(file_of(lines).root, root);
        EXPECT_STREQ(edition(file_of(lines)), "TM-33-18");
        // The prefix of a namespace does not matter.
        std::string prefixed = joined(lines);
        for (std::size_t at = 0; (at = prefixed.find('<', at)) != std::string::npos; ++at)
            if (prefixed[at + 1] != '?') prefixed.insert(prefixed[at + 1] == '/' ? at + 2 : at + 1, "t:");
        EXPECT_EQ(file_of(read(prefixed)).emitters, file_of(lines).emitters) << prefixed;
    }
    expect_error(read_profile("<svg><IESTM33/></svg>", "lamp"),
                 "lamp:1:1: error[TM30102]: the root element is 'svg', which is not from TM-33");
    expect_error(read_profile("<svg/>", "lamp.xml"),
                 "lamp.xml:1:1: error[TM30102]: the root element is 'svg', which is not from TM-33");
    expect_error(read_profile("<svg/>", "lamp"), "lamp:1:1: error[PRF0103]: neither IES, EULUMDAT nor TM-33");
    expect_says(read(with(lamp, 3, "<Version>2.0</Version>")),
                "lamp:3:1: warning[TM30104]: version '2.0', known are 1.0 and 1.1");
    expect_says(read(without(lamp, 3)), "lamp:2:1: warning[TM30104]: no version is given");
}

TEST(Tm33Read, TheDialectOfPrograms) {
    const std::string text =
        "<LuminaireOpticalData version=\"1.0\"><Header/><Emitter><Quantity>1</Quantity><InputWatts>100</InputWatts>"
        "<CCT>2700</CCT><ColorRendering><Ra>99</Ra></ColorRendering>"
        "<SpectralDistribution><Wavelengths>400 500,600</Wavelengths><Values>1 2 3</Values></SpectralDistribution>"
        "<IntensityDistribution><PhotometryType>C</PhotometryType><Metric>Luminous</Metric>"
        "<IntensityData horz=\"0\" vert=\"0\">80</IntensityData><IntensityData horz=\"0\" "
        "vert=\"90\">70</IntensityData>"
        "</IntensityDistribution></Emitter></LuminaireOpticalData>";
    const Result<Profile> profile = read(text);
    expect_says(profile, "lamp:1:1: warning[TM30106]: the root element is not that of an edition of TM-33");
    EXPECT_EQ(profile->diagnostics.size(), 1U) << said(profile);
    const Tm33File file = file_of(profile);
    EXPECT_EQ(file.version, "1.0");
    const Tm33Emitter& emitter = file.emitters.at(0);
    EXPECT_EQ(emitter.input_watts, 100.0);
    EXPECT_EQ(emitter.cct_k, 2700.0);
    EXPECT_EQ(emitter.cri_ra, 99.0);
    ASSERT_TRUE(emitter.intensity);
    EXPECT_EQ(emitter.intensity->candela, (std::vector<double>{80, 70}));
    ASSERT_EQ(emitter.spectra.size(), 1U);
    EXPECT_EQ(emitter.spectra[0].wavelengths_nm, (std::vector<double>{400, 500, 600}));
    EXPECT_EQ(emitter.spectra[0].power, (std::vector<double>{1, 2, 3}));
    EXPECT_TRUE(equal(file_of(read(write_tm33(file))), file)) << write_tm33(file);

    // Other metrics do not measure visible light.
    std::string radiant = text;
    radiant.replace(radiant.find("Luminous<"), 8, "Radiant");
    EXPECT_FALSE(file_of(read(radiant)).emitters.at(0).intensity);
}

TEST(Tm33Read, PointsInAnyOrder) {
    TextLines mixed = lamp;
    std::swap(mixed[24], mixed[29]);
    std::swap(mixed[25], mixed[27]);
    expect_silent(read(mixed));
    EXPECT_EQ(file_of(mixed).emitters[0].intensity->candela, file_of(lamp).emitters[0].intensity->candela);
}

TEST(Tm33Read, BrokenXmlIsSaidWhere) {
    expect_error(read(with(lamp, 14, "<Description>LED</Describtion>")),
                 "lamp:14:19: error[TM30101]: this is not well-formed XML: Start-end tags mismatch");
    expect_error(read(TextLines{"<IESTM33-22>"}),
                 "lamp:1:13: error[TM30101]: this is not well-formed XML: Start-end tags mismatch");
    EXPECT_FALSE(read(joined(lamp).substr(0, 700)));
    expect_error(read(TextLines{"<IESTM33-22><Version>1.1</Version>", "</IESTM33-22>"}),
                 "lamp:1:1: error[TM30105]: the document describes no emitter");
}

TEST(Tm33Read, NoBombs) {
    std::string deep = "<IESTM33-22>";
    for (int i = 0; i < 200000; ++i)
        deep += "<a>";
    const std::string open = deep;
    for (int i = 0; i < 200000; ++i)
        deep += "</a>";
    expect_error(read(deep + "</IESTM33-22>"),
                 "lamp:1:205: error[TM30107]: elements nested deeper than 64 levels, the limit 'xml-depth'");
    EXPECT_FALSE(read(open));
    // Entities are never expanded.
    const std::string laughs = "<!DOCTYPE x [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]>";
    const Result<Profile> profile = read(with(with(lamp, 1, laughs), 14, "<Description>&b;</Description>"));
    EXPECT_EQ(file_of(profile).emitters.at(0).description, "&b;");
}

TEST(Tm33Read, NumbersThatAreNone) {
    expect_says(read(with(lamp, 15, "<RatedLumens>many</RatedLumens>")),
                "lamp:15:14: warning[TM30201]: 'many' is not a number for RatedLumens");
    EXPECT_FALSE(file_of(with(lamp, 15, "<RatedLumens>many</RatedLumens>")).emitters[0].rated_lumens);
    expect_says(read(with(lamp, 15, "<RatedLumens/>")), "lamp:15:1: warning[TM30201]: RatedLumens is empty");
    expect_error(read(with(lamp, 15, "<RatedLumens>many</RatedLumens>"), true),
                 "lamp:15:14: error[TM30201]: 'many' is not a number for RatedLumens");
    expect_says(read(with(lamp, 19, "<AbsolutePhotometry>perhaps</AbsolutePhotometry>")),
                "lamp:19:21: warning[TM30202]: 'perhaps' is neither true nor false");
    EXPECT_EQ(
        file_of(with(lamp, 19, "<AbsolutePhotometry> True </AbsolutePhotometry>")).emitters[0].intensity->absolute,
        true);
    expect_error(read(with(lamp, 26, "<IntData h=\"0\" v=\"45\">8O</IntData>")),
                 "lamp:26:23: error[TM30207]: expected a number, found '8O'");
    expect_error(read(with(lamp, 26, "<IntData h=\"0\" v=\"4x\">80</IntData>")),
                 "lamp:26:19: error[TM30207]: expected a number, found '4x'");
    expect_error(read(with(lamp, 26, "<IntData h=\"0\" v=\"45\"/>")),
                 "lamp:26:1: error[TM30207]: a point of the table is empty");
    expect_error(read(with(lamp, 26, "<IntData h=\"0\" v=\"45\">1e999</IntData>")),
                 "lamp:26:23: error[TM30211]: '1e999' is not a finite number up to 1e30");
    expect_error(read(with(lamp, 26, "<IntData h=\"0\">80</IntData>")),
                 "lamp:26:1: error[TM30206]: a point without its two angles");
    expect_error(read(with(lamp, 21, "<Multiplier>0</Multiplier>")), "lamp:21:1: error[TM30208]: multiplier 0");
    expect_says(read(with(lamp, 13, "<Quantity>4294967295</Quantity>")),
                "lamp:13:1: warning[TM30209]: a quantity of 4294967295");
    expect_says(read(with(lamp, 20, "<Symm>Symm_Half</Symm>")),
                "lamp:20:1: warning[TM30210]: 'Symm_Half' is not a symmetry");
    EXPECT_EQ(file_of(with(lamp, 20, "<Symm>Symm _ Bi _90</Symm>")).emitters[0].intensity->symmetry,
              Tm33Symmetry::bilateral_90);
}

TEST(Tm33Read, Tables) {
    expect_error(read(without(lamp, 26)),
                 "lamp:25:1: error[TM30204]: 5 points, 2 horizontal and 3 vertical angles need 6");
    TextLines twice = lamp;
    twice.insert(twice.begin() + 25, lamp[24]);
    expect_error(read(twice), "lamp:26:1: error[TM30205]: a second point at the same angles");
    expect_says(read(with(lamp, 24, "<NumberVert>37</NumberVert>")),
                "lamp:24:1: warning[TM30203]: NumberVert 37 announced, 3 found");
    expect_error(read(with(lamp, 24, "<NumberVert>37</NumberVert>"), true),
                 "lamp:24:1: error[TM30203]: NumberVert 37 announced, 3 found");
    expect_says(read(with(lamp, 22, "<NumberMeasured>2147483647</NumberMeasured>")),
                "lamp:22:1: warning[TM30203]: NumberMeasured 2147483647 announced, 6 found");
    TextLines empty = lamp;
    empty.erase(empty.begin() + 24, empty.begin() + 30);
    expect_says(read(empty), "lamp:18:1: warning[TM30405]: the luminous intensity has no points");
    expect_says(read(empty), "lamp:2:1: warning[TM30404]: no emitter has a luminous intensity");
    expect_says(read(with(lamp, 20, "<Symm>Symm_None</Symm>")),
                "lamp:20:1: warning[TM30301]: the stated symmetry does not match planes from 0 to 90");
    expect_silent(read(with(lamp, 20, "<Symm>Symm_Arbitrary</Symm>")));
    TextLines out =
        with(with(lamp, 27, "<IntData h=\"0\" v=\"190\">0</IntData>"), 30, "<IntData h=\"90\" v=\"190\">0</IntData>");
    expect_error(read(out), "lamp:18:1: error[TM30302]: horizontal angles from 0 to 90, vertical from 0 to 190");
    expect_says(read(with(lamp, 26, "<IntData h=\"0\" v=\"45\">-1</IntData>")),
                "lamp:18:1: warning[TM30401]: a negative intensity");
    expect_says(read(with(lamp, 25, "<IntData h=\"0\" v=\"0\">90</IntData>")),
                "lamp:18:1: warning[TM30403]: the planes differ by 10 % of the peak at nadir");
    expect_says(read(without(without(lamp, 9), 16 - 1)),
                "lamp:2:1: warning[TM30103]: required by TM-33-23: Header/ReportDate, InputWattage");
    expect_error(read(without(lamp, 9), true), "lamp:2:1: error[TM30103]: required by TM-33-23: Header/ReportDate");
}

TEST(Tm33Read, Spectra) {
    const auto spectrum = [](const std::string& inside) {
        return with(lamp, 16,
                    "<InputWattage>1</InputWattage><SpectralDistribution>" + inside + "</SpectralDistribution>");
    };
    expect_error(read(spectrum("<Wavelengths>400 500</Wavelengths><Values>1</Values>")),
                 "lamp:16:87: error[TM30213]: 2 wavelengths, 1 values");
    expect_error(read(spectrum("<Wavelengths>400 5OO</Wavelengths><Values>1</Values>")),
                 "lamp:16:70: error[TM30207]: expected a number, found '5OO'");
    expect_says(read(spectrum("<Wavelengths>500 400</Wavelengths><Values>1 2</Values>")),
                "lamp:16:31: warning[TM30303]: the wavelengths do not ascend");
    expect_error(read(spectrum("<SpectralData w=\"x\">1</SpectralData>")),
                 "lamp:16:53: error[TM30207]: a point of the spectrum is not a pair of numbers");
}

TEST(Tm33Read, TextThatIsNotUtf8) {
    const Result<Profile> profile = read(with(lamp, 5, "<Manufacturer>L\xE4mp</Manufacturer>"));
    expect_says(profile, "lamp:1:1: warning[PRF0108]: the XML is not UTF-8, read as Windows-1252");
    EXPECT_EQ(file_of(profile).header[0].text, "L\xC3\xA4mp");
    expect_says(read("\xEF\xBB\xBF" + joined(lamp)),
                "lamp:1:1: warning[PRF0104]: the file begins with a byte order mark");
    expect_error(read("\xEF\xBB\xBF" + joined(with(lamp, 21, "<Multiplier>-1</Multiplier>"))),
                 "lamp:21:1: error[TM30208]: multiplier -1");
}

const std::string foreign = "<!-- ours --><Own kind=\"a &lt; b\"><Deep x='1'>text</Deep></Own>";

TEST(Tm33Write, WhatIsUnknownSurvives) {
    TextLines lines = with(lamp, 16, "<InputWattage uncertainty=\"0.1\"> 10.50 </InputWattage>" + foreign);
    lines[1] = "<IESTM33-22 xmlns:x=\"urn:x\" made=\"by hand\">";
    lines[4] = "<Manufacturer lang=\"de\">Lamp Works</Manufacturer>";
    lines[30] = "</LuminousIntensity><After/>";
    lines[32] = "</LuminousData><RadiantData><RadiantFlux>3</RadiantFlux></RadiantData></Emitter>"
                "<CustomData><Name>n</Name><x:any>1</x:any></CustomData></IESTM33-22>";
    const Tm33File file = file_of(lines);
    const std::string written = write_tm33(file);
    for (const std::string kept :
         {"xmlns:x=\"urn:x\" made=\"by hand\"", "<Manufacturer lang=\"de\">Lamp Works<", "uncertainty=\"0.1\"> 10.50 <",
          "<!-- ours -->", "<Own kind=\"a &lt; b\">", "<Deep x=\"1\">text</Deep>", "<RadiantFlux>3</RadiantFlux>",
          "<x:any>1</x:any>", "<IntData h=\"0\" v=\"45\">80.5</IntData>"})
        EXPECT_NE(written.find(kept), std::string::npos) << kept << "\n" << written;
    // Each in its place: the points after NumberVert, then the elements that followed the points.
    EXPECT_LT(written.find("<NumberVert>"), written.find("<IntData"));
    EXPECT_LT(written.find("v=\"90\">0<"), written.find("</LuminousIntensity>"));
    EXPECT_LT(written.find("<InputWattage"), written.find("<Own"));
    const Result<Profile> again = read(written);
    expect_silent(again);
    EXPECT_TRUE(equal(file_of(again), file)) << written;
    EXPECT_EQ(write_tm33(file_of(again)), written);
}

TEST(Tm33Write, PointsWithMoreThanNumbersStayAsTheyAre) {
    const TextLines lines = with(lamp, 26, "<IntData h=\"0\" v=\"45\" quality=\"low\">80.5</IntData>");
    const Tm33File file = file_of(lines);
    const std::string written = write_tm33(file);
    EXPECT_NE(written.find("quality=\"low\">80.5<"), std::string::npos) << written;
    EXPECT_TRUE(equal(file_of(read(written)), file)) << written;
    Tm33File changed = file;
    changed.emitters[0].intensity->candela[1] = 81;
    EXPECT_EQ(file_of(read(write_tm33(changed))).emitters, changed.emitters);
}

TEST(Tm33Write, FieldsWin) {
    Tm33File file = file_of(lamp);
    file.header[0].text = "Other <Works>";
    file.header.push_back({"Comment", "new"});
    file.length_m = 1.2;
    file.goniometer = "CIE_C";
    Tm33Emitter& emitter = file.emitters[0];
    emitter.rated_lumens.reset();
    emitter.cct_k = 2700;
    emitter.tilt = {1, {0, 45}, {1, 0.5}};
    emitter.bottom_areas = {{0.5, 0.25, false}};
    emitter.spectra.push_back({"s", 2.0, false, {400, 500}, {1, 0.25}});
    emitter.intensity->vertical_deg = {0, 90};
    emitter.intensity->candela = {1, 2, 3, 4};
    file.emitters.push_back(emitter);
    file.emitters.back().intensity.reset();
    const std::string written = write_tm33(file);
    const Tm33File again = file_of(read(written));
    EXPECT_EQ(again.header, file.header) << written;
    EXPECT_EQ(again.length_m, 1.2);
    EXPECT_EQ(again.goniometer, "CIE_C");
    EXPECT_EQ(again.emitters, file.emitters) << written;
    EXPECT_EQ(written.find("RatedLumens"), std::string::npos) << written;
    EXPECT_NE(written.find("<NumberMeasured>4</NumberMeasured>"), std::string::npos) << written;
    EXPECT_LT(written.find("<TiltAngles>"), written.find("<ColorTemperature>"));
    EXPECT_LT(written.find("<ColorTemperature>"), written.find("<LuminousData>"));
    EXPECT_LT(written.find("<Luminaire>"), written.find("<Equipment>"));
    // And removes them again.
    EXPECT_EQ(file_of(read(write_tm33([&] {
                  Tm33File less = again;
                  less.emitters.resize(1);
                  less.emitters[0].spectra.clear();
                  less.emitters[0].tilt = {};
                  less.emitters[0].bottom_areas.clear();
                  return less;
              }())))
                  .emitters.at(0)
                  .spectra.size(),
              0U);
}

TEST(Tm33Write, FromFieldsAlone) {
    Tm33File file = file_of(lamp);
    file.document.clear();
    file.emitters[0].spectra.push_back({{}, {}, {}, {380, 780}, {1, 2}});
    const std::string written = write_tm33(file);
    EXPECT_TRUE(
        written.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<IESTM33-22>\n  <Version>1.1</Version>\n"
                            "  <Header>\n"))
        << written;
    const Result<Profile> again = read(written, true);
    expect_silent(again);
    Tm33File expected = file;
    expected.document = file_of(again).document;
    EXPECT_TRUE(equal(file_of(again), expected)) << written;
}

TEST(Tm33Light, IsThatOfTheSameTableInLm63) {
    const Result<IesFile> light = lm63_of(file_of(lamp));
    ASSERT_TRUE(light);
    EXPECT_EQ(light->candela_multiplier, 2.0);
    EXPECT_EQ(light->lumens_per_lamp, 500.0);
    EXPECT_EQ(light->lamp_count, 2);
    EXPECT_EQ(light->input_watts, 10.5);
    EXPECT_EQ(declared_flux_lm(file_of(lamp)), 1000.0);
    const Result<ResolvedWeb> web = resolve_web(*read(lamp));
    ASSERT_TRUE(web);
    EXPECT_EQ(web->web.stored_symmetry(), Symmetry::quadrant);
    Profile same{"same", *light, {}};
    EXPECT_DOUBLE_EQ(flux(web->web).value, flux(resolve_web(same)->web).value);
    EXPECT_EQ(declared_flux_lm(*read(lamp)), 1000.0);
    EXPECT_FALSE(declared_flux_lm(*read(with(lamp, 19, "<AbsolutePhotometry>true</AbsolutePhotometry>"))));
    EXPECT_FALSE(declared_flux_lm(*read(without(lamp, 15))));
}

TEST(Tm33Light, EmittersShineTogether) {
    Tm33File file = file_of(lamp);
    file.emitters.push_back(file.emitters[0]);
    file.emitters[1].intensity->multiplier.reset();
    file.emitters[1].ballast_factor = 0.5;
    const Result<IesFile> light = lm63_of(file);
    ASSERT_TRUE(light);
    EXPECT_EQ(light->candela_multiplier * light->ballast_factor, 1.0);
    EXPECT_EQ(light->candela, (std::vector<double>{250, 80.5 * 2.5, 0, 250, 175, 0}));
    EXPECT_EQ(light->input_watts, 21.0);
    file.emitters[1].intensity->vertical_deg[1] = 40;
    EXPECT_EQ(lm63_of(file).error().failure, Failure::unsupported);
    file.emitters[1].intensity.reset();
    EXPECT_TRUE(lm63_of(file));
    file.emitters[0].intensity.reset();
    EXPECT_EQ(lm63_of(file).error().failure, Failure::unsupported);
}

TEST(Tm33Light, Goniometers) {
    Tm33File file = file_of(lamp);
    const auto type = [&](const std::string& name) {
        file.goniometer = name;
        return photometry_of(file);
    };
    EXPECT_EQ(type(""), Photometry::c);
    EXPECT_EQ(type("CIE _ C"), Photometry::c);
    EXPECT_EQ(type("IES_B"), Photometry::b);
    EXPECT_EQ(type("Type B"), Photometry::b);
    EXPECT_EQ(type("IES_A"), Photometry::a);
    EXPECT_FALSE(type("CIE_A"));
    EXPECT_FALSE(type("CUSTOM"));
    EXPECT_EQ(lm63_of(file).error().failure, Failure::unsupported);
}

} // namespace
