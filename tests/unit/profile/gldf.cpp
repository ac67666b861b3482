// GLDF: what is read, chosen, written, and refused.
#include <gonio/profile/gldf.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/resolve.hpp>

#include "../archives.hpp"
#include "../luminaires.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

namespace gonio {

namespace {

using std::numbers::pi;
using test::code_of;
using test::gldf_of;
using test::product;
using test::replaced;

// The code of the only remark; "none" or "several".
std::string remark_of(const std::string& xml) {
    const Result<Gldf> gldf = read_gldf(gldf_of(xml), "a.gldf");
    if (!gldf) return gldf.error().diagnostics.back().code;
    if (gldf->diagnostics.empty()) return "none";
    return gldf->diagnostics.size() == 1 ? gldf->diagnostics[0].code : "several";
}

double flux_of(const Result<Profile>& profile) {
    EXPECT_TRUE(profile.has_value()) << (profile ? "" : profile.error().diagnostics.back().message);
    return profile ? flux(resolve_web(*profile)->web).value : 0.0;
}

TEST(Gldf, ReadsWhatALuminaireIs) {
    const std::string bytes = gldf_of(product());
    EXPECT_TRUE(is_gldf(bytes));
    const Result<Gldf> gldf = read_gldf(bytes, "a.gldf", true);
    ASSERT_TRUE(gldf.has_value()) << gldf.error().diagnostics.back().message;
    EXPECT_TRUE(gldf->diagnostics.empty());
    EXPECT_EQ(gldf->version, "1.0-rc.3");
    EXPECT_EQ(gldf->manufacturer, "Works");
    EXPECT_EQ(gldf->name, "Lamp");
    EXPECT_EQ(gldf->number, "W1");
    EXPECT_EQ(gldf->files[0].entry, "ldc/a.ies");
    ASSERT_EQ(gldf->emitters.size(), 3U);
    const GldfLight& down = gldf->emitters[0].lights[0];
    EXPECT_EQ(down.name, "below");
    EXPECT_EQ(down.flux_lm, 500.0);
    EXPECT_EQ(down.cct_k, 3000.0);
    EXPECT_EQ(down.cri, 90.0);
    EXPECT_EQ(down.input_w, 5.0);
    EXPECT_EQ(gldf->spectra[*down.spectrum].intensities, (std::vector<double>{0.5, 1.0}));
    const GldfEmitter& up = gldf->emitters[1];
    ASSERT_EQ(up.lights.size(), 2U);
    EXPECT_EQ(up.lights[0].flux_lm, 800.0); // of two lamps
    EXPECT_EQ(up.lights[0].input_w, 40.0);
    EXPECT_EQ(up.lights[0].rotation_deg.x, 180.0);
    EXPECT_EQ(up.lights[1].emergency, "EmergencyOnly");
    EXPECT_FALSE(gldf->photometries[2].file);
    EXPECT_EQ(gldf->variants[1].emitters, (std::vector<std::size_t>{1}));
}

TEST(Gldf, ReadersOfProfilesTakeAPhotometryOfIt) {
    const std::string bytes = gldf_of(product());
    const Result<Profile> first = read_profile(bytes, "a.gldf");
    EXPECT_NEAR(flux_of(first), 200.0 * pi, 1e-9);
    EXPECT_EQ(first->source, "a.gldf/ldc/a.ies");
    ASSERT_FALSE(first->diagnostics.empty());
    EXPECT_EQ(first->diagnostics[0].code, "GLD0209"); // one of several
    ReadOptions options;
    options.choice.variant = "v2";
    const Result<Profile> second = read_profile(bytes, "a.gldf", options);
    EXPECT_NEAR(flux_of(second), 100.0 * pi, 1e-9);
    for (const Diagnostic& said : second->diagnostics)
        EXPECT_NE(said.code, "GLD0209");
    options.choice = {"one", ""}; // by its name
    EXPECT_NEAR(flux_of(read_profile(bytes, "a.gldf", options)), 200.0 * pi, 1e-9);
    options.choice = {"", "up"};
    EXPECT_NEAR(flux_of(read_profile(bytes, "a.gldf", options)), 100.0 * pi, 1e-9);
    options.choice = {"v1", "up"};
    EXPECT_EQ(code_of(read_profile(bytes, "a.gldf", options)), "USE0103");
    options.choice = {"v3", ""};
    EXPECT_EQ(code_of(read_profile(bytes, "a.gldf", options)), "USE0103");
    options.choice = {"", "told"};
    EXPECT_EQ(code_of(read_profile(bytes, "a.gldf", options)), "GLD0101");
    EXPECT_EQ(code_of(read_profile(gldf_of(product(), "neither of them"), "a.gldf")), "IES0108");
    EXPECT_EQ(code_of(read_profile(gldf_of(product(), bytes), "a.gldf")), "GLD0101"); // an archive in it
}

TEST(Gldf, DeparturesFromTheSchemaAreRemarks) {
    EXPECT_EQ(remark_of(product()), "none");
    EXPECT_EQ(remark_of(replaced(product(), "<Manufacturer>Works</Manufacturer>", "")), "GLD0201");
    EXPECT_EQ(remark_of(replaced(product(), "<PhotometryReference photometryId=\"p1\"/>", "")), "GLD0201");
    EXPECT_EQ(remark_of(replaced(product(), "photometryId=\"p1\"", "photometryId=\"p9\"")), "GLD0202");
    EXPECT_EQ(remark_of(replaced(product(), "emitterId=\"down\"", "emitterId=\"downs\"")), "GLD0202");
    EXPECT_EQ(remark_of(replaced(product(), "<EmitterReference emitterId=\"down\"/>", "<ModelGeometryReference/>")),
              "GLD0201");
    EXPECT_EQ(remark_of(replaced(replaced(product(), "<GldfCreationTimeCode>", "<CreationTimeCode>"),
                                 "</GldfCreationTimeCode>", "</CreationTimeCode>")),
              "none"); // as the first release candidate has it
    EXPECT_EQ(remark_of(replaced(product(), "<Spectrum id=\"s\">",
                                 "<Spectrum id=\"s\"><SpectrumFileReference fileId=\"f1\"/>")),
              "none"); // where its intensities come from
    EXPECT_EQ(remark_of(replaced(product(), "Variant id=\"v2\"", "Variant id=\"v1\"")), "GLD0203");
    EXPECT_EQ(remark_of(replaced(product(), "<RatedLuminousFlux>500", "<RatedLuminousFlux>-500")), "GLD0204");
    EXPECT_EQ(remark_of(replaced(product(), "contentType=\"ldc/ies\" type=\"localFileName\">a.ies",
                                 "contentType=\"ldc/ies\" type=\"url\">https://a.invalid/a.ies")),
              "several"); // the note, and a file that is not named
    EXPECT_EQ(remark_of(replaced(product(), "major=\"1\"", "major=\"2\"")), "GLD0210");
    const Result<Gldf> missing = read_gldf(gldf_of(replaced(product(), ">a.ies<", ">../../etc/passwd<")), "a.gldf");
    ASSERT_TRUE(missing.has_value());
    EXPECT_EQ(missing->diagnostics[0].code, "GLD0205");
    EXPECT_GT(missing->diagnostics[0].location.line, 1U);
    EXPECT_EQ(missing->diagnostics[0].location.file, "a.gldf/product.xml");
    const std::string broken = replaced(product(), "photometryId=\"p1\"", "photometryId=\"p9\"");
    EXPECT_EQ(code_of(read_gldf(gldf_of(broken), "a.gldf", true)), "GLD0202");
    // A million faults are a few sentences.
    std::string many;
    for (int i = 0; i < 1000; ++i)
        many += "<Photometry id=\"x\"/>";
    const Result<Gldf> gldf = read_gldf(gldf_of(replaced(product(), "</Photometries>", many + "</Photometries>")), "a");
    ASSERT_TRUE(gldf.has_value());
    EXPECT_LT(gldf->diagnostics.size(), 20U);
}

TEST(Gldf, AVariantWithoutEmittersHasThemAll) {
    const Result<Gldf> gldf =
        read_gldf(gldf_of(replaced(product(), "<EmitterReference emitterId=\"down\"/>", "")), "a.gldf");
    ASSERT_TRUE(gldf.has_value());
    EXPECT_EQ(gldf->variants.at(0).emitters.size(), gldf->emitters.size());
    EXPECT_EQ(gldf->variants.at(1).emitters.size(), 1U);
}

// Each may be repeated for every light.
TEST(Gldf, LongTextsAreCutOrRefused) {
    const auto with_id = [](std::size_t size) {
        const std::string id(size, 'x');
        return replaced(replaced(product(), "emitterId=\"down\"", "emitterId=\"" + id + "\""), "Emitter id=\"down\"",
                        "Emitter id=\"" + id + "\"");
    };
    EXPECT_EQ(remark_of(with_id(256)), "none");
    const Result<Gldf> refused = read_gldf(gldf_of(with_id(257)), "a.gldf");
    ASSERT_TRUE(refused.has_value());
    EXPECT_EQ(refused->diagnostics[0].code, "GLD0204");
    EXPECT_LT(refused->diagnostics[0].message.size(), 200U);
    EXPECT_EQ(refused->emitters[0].id, "");
    std::string name = "a"; // 256 bytes end in the middle of a character
    for (int i = 0; i < 200; ++i)
        name += "é";
    const Result<Gldf> cut = read_gldf(
        gldf_of(replaced(replaced(product(), ">below<", ">" + name + "<"), ">Works<", ">" + name + "<")), "a.gldf");
    ASSERT_TRUE(cut.has_value());
    EXPECT_EQ(cut->emitters[0].lights[0].name, name.substr(0, 255));
    EXPECT_EQ(cut->manufacturer, name.substr(0, 255));
    const Result<Gldf> file =
        read_gldf(gldf_of(replaced(product(), ">a.ies<", ">" + std::string(1000, 'f') + "<")), "a.gldf");
    ASSERT_TRUE(file.has_value());
    EXPECT_EQ(file->diagnostics[0].code, "GLD0204");
    EXPECT_EQ(file->files[0].written.size(), 256U);
    EXPECT_FALSE(file->photometries[0].file);
}

TEST(Gldf, VariantsWithoutEmittersStayAsLargeAsTheDocument) {
    std::string emitters;
    std::string variants;
    for (int i = 0; i < 2000; ++i) {
        emitters += "<Emitter id=\"e" + std::to_string(i) + "\"><Sensor/></Emitter>";
        variants += "<Variant id=\"w" + std::to_string(i) + "\"/>";
    }
    const Result<Gldf> gldf = read_gldf(gldf_of(replaced(replaced(product(), "</Emitters>", emitters + "</Emitters>"),
                                                         "</Variants>", variants + "</Variants>")),
                                        "a.gldf");
    ASSERT_TRUE(gldf.has_value());
    std::size_t all = 0;
    for (const GldfVariant& variant : gldf->variants)
        all += variant.emitters.size();
    EXPECT_LE(all, (std::size_t{1} << 20U) + 10);
    EXPECT_EQ(gldf->variants[2].emitters.size(), gldf->emitters.size());
}

TEST(Gldf, CountsOfLightSources) {
    EXPECT_EQ(remark_of(replaced(product(), "lightSourceCount=\"2\"", "lightSourceCount=\"two\"")), "GLD0204");
    EXPECT_EQ(remark_of(replaced(product(), "lightSourceCount=\"2\"", "lightSourceCount=\"0\"")), "GLD0204");
    const Result<Gldf> gldf =
        read_gldf(gldf_of(replaced(product(), "<EquipmentReference equipmentId=\"two\"/>",
                                   "<LightSourceReference changeableLightSourceId=\"lamp\" lightSourceCount=\"3\"/>")),
                  "a.gldf");
    ASSERT_TRUE(gldf.has_value());
    EXPECT_EQ(gldf->emitters[1].lights[0].flux_lm, 1200.0);
    EXPECT_EQ(gldf->emitters[1].lights[0].input_w, 60.0);
}

TEST(Gldf, AVariantIsChosenByIdentifierBeforeName) {
    const Result<Gldf> gldf = read_gldf(gldf_of(replaced(product(), ">one<", ">v2<")), "a.gldf");
    ASSERT_TRUE(gldf.has_value());
    EXPECT_EQ((*choose_variant(*gldf, "v2"))->id, "v2");
    EXPECT_EQ((*choose_variant(*gldf, ""))->id, "v1");
    EXPECT_EQ(code_of(choose_variant(*gldf, "v3")), "USE0103");
    EXPECT_EQ(*choose_variant(Gldf{}, ""), nullptr);
    // Without options the first variant, not the first emitter of the document.
    const std::string bytes = gldf_of(replaced(replaced(product(), "emitterId=\"up\"", "emitterId=\"told\""),
                                               "emitterId=\"down\"", "emitterId=\"up\""));
    EXPECT_NEAR(flux_of(read_profile(bytes, "a.gldf")), 100.0 * pi, 1e-9);
}

TEST(Gldf, WhatIsMissingIsNotReplacedSilently) {
    const std::string bytes = gldf_of(replaced(product(), ">a.ies<", ">gone.ies<"));
    const Result<Profile> other = read_profile(bytes, "a.gldf");
    EXPECT_NEAR(flux_of(other), 100.0 * pi, 1e-9);
    std::string codes;
    for (const Diagnostic& said : other->diagnostics)
        codes += said.code + " ";
    EXPECT_NE(codes.find("GLD0205"), std::string::npos); // of the document
    EXPECT_NE(codes.find("GLD0209"), std::string::npos); // an emitter is passed over
    ReadOptions options;
    options.choice = {"v1", ""};
    EXPECT_EQ(code_of(read_profile(bytes, "a.gldf", options)), "GLD0101");
    options.choice = {"", "down"};
    EXPECT_EQ(code_of(read_profile(bytes, "a.gldf", options)), "GLD0101");
    options.choice = {};
    options.strict = true;
    EXPECT_EQ(code_of(read_profile(bytes, "a.gldf", options)), "GLD0205");
}

TEST(Gldf, FactorsOfTiltAreReadFromTheArchive) {
    const std::string tilted = replaced(test::half_sphere(), "TILT=NONE", "TILT=t.tlt");
    const std::string bytes = write_archive(
        std::array{ArchiveFile{"product.xml", product()}, ArchiveFile{"ldc/a.ies", tilted},
                   ArchiveFile{"ldc/b.ies", test::half_sphere()}, ArchiveFile{"ldc/t.tlt", "1\n2\n0 90\n1 0.5\n"}});
    const Result<Profile> profile = read_profile(bytes, "a.gldf");
    ASSERT_TRUE(profile.has_value());
    EXPECT_EQ(std::get<IesFile>(profile->file).tilt.factors.size(), 2U);
}

TEST(Gldf, ProfilesBeyondTheirLimitAreRefusedWhereverTheyComeFrom) {
    const std::string large(16 * mebibyte + 1, ' ');
    EXPECT_EQ(code_of(read_profile(large, "a.ies")), "FIL0104");
    EXPECT_EQ(code_of(read_profile(gldf_of(product(), large), "a.gldf")), "FIL0104");
}

TEST(Gldf, HostileDocumentsAreRefused) {
    const std::string bomb =
        "<?xml version=\"1.0\"?>\n<!DOCTYPE Root [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;&a;\">]>\n";
    EXPECT_EQ(code_of(read_gldf(gldf_of(bomb + "<Root>&b;</Root>"), "a.gldf")), "ARC0202");
    EXPECT_EQ(code_of(read_gldf(gldf_of(bomb + "<Root>&b;"), "a.gldf")), "ARC0202");
    EXPECT_EQ(code_of(read_gldf(gldf_of("<Root>"), "a.gldf")), "ARC0201");
    EXPECT_EQ(code_of(read_gldf(gldf_of("<Roots/>"), "a.gldf")), "ARC0201");
    EXPECT_EQ(code_of(read_gldf(gldf_of(""), "a.gldf")), "ARC0201");
    std::string deep;
    for (int i = 0; i < 100; ++i)
        deep += "<a>";
    for (int i = 0; i < 100; ++i)
        deep += "</a>";
    EXPECT_EQ(code_of(read_gldf(gldf_of("<Root>" + deep + "</Root>"), "a.gldf")), "ARC0203");
    EXPECT_EQ(code_of(read_gldf(write_archive({}), "a.gldf")), "ARC0107");
    EXPECT_EQ(code_of(read_profile(write_archive({}), "a.gldf")), "ARC0107");
    const Result<Gldf> other = read_gldf(gldf_of("<Root>\n\n<a b=c/></Root>"), "a.gldf");
    ASSERT_FALSE(other.has_value());
    EXPECT_EQ(other.error().diagnostics.back().location.line, 3U);
    for (std::size_t cut = 0; cut < gldf_of(product()).size(); cut += 7)
        EXPECT_FALSE(read_gldf(gldf_of(product()).substr(0, cut), "a.gldf").has_value());
}

TEST(Gldf, WhatIsWrittenReadsBack) {
    GldfProduct made;
    made.manufacturer = "Müller & <Söhne>";
    made.file = "../lamp one.ies";
    made.flux_lm = 628.3;
    made.cct_k = 2700.0;
    made.cri = 80.0;
    made.input_w = 7.5;
    const std::string bytes = write_gldf(test::half_sphere(), made);
    EXPECT_EQ(bytes, write_gldf(test::half_sphere(), made));
    const Result<Gldf> gldf = read_gldf(bytes, "a.gldf", true);
    ASSERT_TRUE(gldf.has_value()) << gldf.error().diagnostics.back().message;
    EXPECT_TRUE(gldf->diagnostics.empty());
    EXPECT_EQ(gldf->manufacturer, made.manufacturer);
    EXPECT_EQ(gldf->name, "-");
    EXPECT_EQ(gldf->files[0].entry, "ldc/lamp_one.ies");
    const GldfLight& light = gldf->emitters[0].lights[0];
    EXPECT_EQ(light.flux_lm, 628.0);
    EXPECT_EQ(light.cct_k, 2700.0);
    EXPECT_EQ(light.cri, 80.0);
    EXPECT_EQ(light.input_w, 7.5);
    EXPECT_NEAR(flux_of(read_profile(bytes, "a.gldf")), 200.0 * pi, 1e-9);
}

} // namespace

} // namespace gonio
