// Every diagnostic code with the smallest file that breaks its rule. A code without an entry fails the test.
#include <gonio/base/codes/profile.hpp>
#include <gonio/base/codes/web.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/plausibility.hpp>
#include <gonio/web/to_profile.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace gonio;

using Lines = std::map<std::size_t, std::string>; // by number from 1

std::string text_of(std::vector<std::string> lines, const Lines& changed) {
    std::string text;
    for (const auto& [number, line] : changed)
        lines.at(number - 1) = line;
    for (const std::string& line : lines)
        text += line + "\n";
    return text;
}

// LM-63-1995: 100 cd down, nothing at the horizon; 228 lm of 1000, 10 W.
std::string ies(const Lines& changed = {}) {
    return text_of({"IESNA:LM-63-1995", "TILT=NONE", "1 1000 1 2 1 1 2 0 0 0", "1 1 10", "0 90", "0", "100 0"},
                   changed);
}

// The same light in EULUMDAT. 22: downward flux, 23: light output ratio, 27: lamps, 33: ratios, 43: planes, 44: gammas.
std::string ldt(const Lines& changed = {}) {
    return text_of({"company", "1",   "1",   "1",   "0",    "2",    "90", "report", "name", "number", "file",  "date",
                    "100",     "0",   "0",   "100", "0",    "0",    "0",  "0",      "0",    "100",    "22.83", "1",
                    "0",       "1",   "1",   "LED", "1000", "3000", "80", "10",     "0.1",  "0.2",    "0.3",   "0.4",
                    "0.5",     "0.6", "0.7", "0.8", "0.9",  "1",    "0",  "0",      "90",   "100",    "0"},
                   changed);
}

// EULUMDAT with planes: symmetry, number and step of the planes, and the lines after the ratios.
std::string ldt_planes(const char* symmetry, const char* count, const char* step, const char* table) {
    return ldt({{2, "3"}, {3, symmetry}, {4, count}, {5, step}, {43, table}, {44, ""}, {45, ""}, {46, ""}, {47, ""}});
}

// The same light in TM-33, with `from` replaced by `to`.
std::string tm33(const std::string& from = {}, const std::string& to = {}) {
    std::string text =
        "<IESTM33-22><Version>1.1</Version><Header><Description>d</Description><Laboratory>l</Laboratory>"
        "<ReportNumber>1</ReportNumber><ReportDate>2024-01-01</ReportDate></Header>"
        "<Emitter><Quantity>1</Quantity><Description>e</Description><RatedLumens>1000</RatedLumens>"
        "<InputWattage>10</InputWattage><LuminousData><LuminousIntensity>"
        "<AbsolutePhotometry>false</AbsolutePhotometry><Symm>Symm_Full</Symm>"
        "<IntData h=\"0\" v=\"0\">100</IntData><IntData h=\"0\" v=\"90\">0</IntData>"
        "</LuminousIntensity></LuminousData></Emitter></IESTM33-22>";
    if (from.empty()) return text;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::string tm33_spectrum(const std::string& inside) {
    return tm33("</Emitter>",
                "<SpectralData><EmitterSpectral>" + inside + "</EmitterSpectral></SpectralData></Emitter>");
}

constexpr const char* last_point = "<IntData h=\"0\" v=\"90\">0</IntData>";

struct Rule {
    std::string bytes;
    bool strict = false;
    std::optional<ProfileTarget> target = {}; // converted into
    std::string name = "lamp";
};

std::string nested(int depth) {
    std::string text;
    for (int i = 0; i < depth; ++i)
        text += "<a>";
    for (int i = 0; i < depth; ++i)
        text += "</a>";
    return text;
}

const std::map<std::string, Rule>& smallest_files() {
    using T = ProfileTarget;
    static const std::map<std::string, Rule> rules{
        {"PRF0101", {" \r\n"}},
        {"PRF0102", {std::string("\0PNG", 4)}},
        {"PRF0103", {"x"}},
        {"PRF0104", {"\xEF\xBB\xBF" + ies()}},
        {"PRF0105",
         {ies() + "\x1A"
                  "x"}},
        {"PRF0106",
         {std::string("\xFF\xFE"
                      "x\0",
                      4)}},
        {"PRF0108", {tm33("<Description>d", "<Description>\xE4")}},

        {"IES0101", {ies({{1, "IESNA95"}})}},
        {"IES0102", {ies({{1, "IESNA:"}})}},
        {"IES0103", {ies({{1, ""}})}},
        {"IES0104", {ies({{2, "x\nTILT=NONE"}})}},
        {"IES0105", {ies({{2, "[MORE] x\nTILT=NONE"}})}},
        {"IES0106", {ies({{1, "IESNA:LM-63-2002"}})}},
        {"IES0107", {ies({{2, "[OTHER] " + std::string(123, 'x') + "\nTILT=NONE"}}), true}},
        {"IES0108", {"IESNA:LM-63-1995\n"}},
        {"IES0109", {ies({{2, "TILT= NONE"}})}},
        {"IES0110", {ies({{2, "TILT=none"}})}},
        {"IES0111", {ies({{2, "TILT=a.tlt"}})}},
        {"IES0112", {ies({{1, "IES:LM-63-2019"}, {2, "TILT=a.tlt"}})}},
        {"IES0113", {ies({{2, "TILT=INCLUDE\n4"}})}},
        {"IES0114", {ies({{2, "TILT=INCLUDE\n1\n0"}})}},
        {"IES0115", {ies({{1, "IESNA:LM-63-2002"}, {2, "[x]\nTILT=NONE"}}), true}},
        {"IES0201", {ies({{7, "100 x"}})}},
        {"IES0202", {ies({{7, "100 1e999"}})}},
        {"IES0203", {ies({{3, "1 1000 1 2.5 1 1 2 0 0 0"}})}},
        {"IES0204", {ies({{3, "1 1000 1 3 1 1 2 0 0 0"}})}},
        {"IES0205", {ies({{3, "1 1000 1 2 9 1 2 0 0 0"}, {6, "0 1 2"}, {7, ""}})}},
        {"IES0206", {ies({{7, "100"}})}},
        {"IES0207", {ies({{4, "1"}, {5, ""}, {6, ""}, {7, ""}})}},
        {"IES0208", {ies({{3, "1 1000 1 2 1 4 2 0 0 0"}})}},
        {"IES0209", {ies({{3, "1 1000 1 2 1 1 3 0 0 0"}})}},
        {"IES0210", {ies({{3, "1 0 1 2 1 1 2 0 0 0"}})}},
        {"IES0211", {ies({{3, "1 1000 0 2 1 1 2 0 0 0"}})}},
        {"IES0212", {ies({{4, "0 1 10"}})}},
        {"IES0213", {ies({{4, "1 2 10"}})}},
        {"IES0214", {ies({{7, "100 0 0"}})}},
        {"IES0215", {ies({{3, "0 1000 1 2 1 1 2 0 0 0"}})}},
        {"IES0216", {ies({{7, "1e2 0"}}), true}},
        {"IES0217", {ies({{3, "1. 1000 1 2 1 1 2 0 0 0"}}), true}},
        {"IES0218", {ies({{4, "1 1 -1"}})}},
        {"IES0219", {ies({{3, "1 1000 1 2 1 1 2 -1 -1 0"}})}},
        {"IES0220",
         {ies({{3, "1 1000 1 6 1 1 2 0 0 0"}, {4, "0 15 30 45 60 90"}, {5, "0"}, {6, "100 90 80 60 30 0"}, {7, ""}})}},
        {"IES0301", {ies({{5, "90 0"}})}},
        {"IES0302", {ies({{3, "1 1000 1 2 2 1 2 0 0 0"}, {6, "90 0"}, {7, "100 0 100 0"}})}},
        {"IES0303", {ies({{3, "1 1000 1 3 1 1 2 0 0 0"}, {5, "0 90 90"}, {7, "100 0 0"}})}},
        {"IES0304", {ies({{3, "1 1000 1 2 2 1 2 0 0 0"}, {6, "0 0"}, {7, "100 0 100 0"}})}},
        {"IES0305", {ies({{5, "0 80"}})}},
        {"IES0306", {ies({{3, "1 1000 1 2 2 1 2 0 0 0"}, {6, "0 100"}, {7, "100 0 100 0"}})}},
        {"IES0307", {ies({{5, "0 190"}})}},
        {"IES0308", {ies({{6, "5"}})}},
        {"IES0309", {ies({{3, "1 1000 1 2 3 1 2 0 0 0"}, {6, "0 120 240"}, {7, "100 0 100 0 100 0"}})}},
        {"IES0310", {ies({{1, "IESNA:LM-63-2002"}, {3, "1 1000 1 2 2 1 2 0 0 0"}, {6, "90 270"}, {7, "9 0 9 0"}})}},
        {"IES0311", {ies({{5, "0 90 180"}, {6, "0"}, {7, "100 0 0"}})}},
        {"IES0401", {ies({{7, "100 -1"}})}},
        {"IES0402", {ies({{7, "0 0"}})}},
        {"IES0403", {ies({{3, "1 1000 1 2 2 1 2 0 0 0"}, {6, "0 90"}, {7, "100 0 98 0"}})}},
        {"IES0404", {ies({{3, "1 1000 1 2 3 1 2 0 0 0"}, {6, "0 180 360"}, {7, "9 1 9 1 9 2"}})}},

        {"LDT0101", {"c\n1\n1\n1\n0\n2\n90\n"}},
        {"LDT0102", {ldt({{47, "x"}})}},
        {"LDT0103", {ldt({{47, "1e999"}})}},
        {"LDT0104", {ldt({{14, ""}})}},
        {"LDT0105", {ldt({{23, "22,83"}})}},
        {"LDT0106", {ldt({{9, std::string(79, 'x')}})}},
        {"LDT0107", {ldt({{11, "123456789.ldt"}}), true}},
        {"LDT0201", {ldt({{4, "0"}})}},
        {"LDT0202", {ldt({{3, "5"}})}},
        {"LDT0203", {ldt({{2, "4"}})}},
        {"LDT0204", {ldt({{4, "2"}})}},
        {"LDT0205", {ldt({{6, "3"}, {46, "50"}})}},
        {"LDT0206", {ldt({{47, ""}})}},
        {"LDT0207", {ldt() + "x\n"}},
        {"LDT0208", {ldt_planes("2", "4", "90", "0\n90\n180\n270\n0\n90\n1\n0\n1\n0\n1\n0\n1\n0")}},
        {"LDT0209", {ldt_planes("2", "3", "120", "0\n120\n240\n0\n90\n100\n0\n100\n0")}},
        {"LDT0210", {ldt({{27, "0"}})}},
        {"LDT0301", {ldt_planes("0", "2", "0", "180\n10\n0\n90\n1\n0\n1\n0")}},
        {"LDT0302", {ldt({{6, "3"}, {45, "30"}, {46, "20"}, {47, "1\n2\n3"}})}},
        {"LDT0303", {ldt_planes("0", "3", "0", "0\n180\n180\n0\n90\n1\n0\n1\n0\n1\n0")}},
        {"LDT0304", {ldt({{6, "3"}, {45, "90\n90"}, {47, "0\n0"}})}},
        {"LDT0305", {ldt_planes("0", "2", "90", "0\n180\n0\n90\n1\n0\n1\n0")}},
        {"LDT0306", {ldt({{7, "5"}})}},
        {"LDT0307", {ldt({{43, "400"}})}},
        {"LDT0308", {ldt({{45, "80"}, {7, "80"}})}},
        {"LDT0401", {ldt({{47, "-1"}})}},
        {"LDT0402", {ldt({{46, "0"}})}},
        {"LDT0403", {ldt_planes("4", "4", "90", "0\n90\n180\n270\n0\n90\n100\n0\n98\n0")}},
        {"LDT0404",
         {ldt({{33, "0"},
               {34, "0"},
               {35, "0"},
               {36, "0"},
               {37, "0"},
               {38, "0"},
               {39, "0"},
               {40, "0"},
               {41, "0"},
               {42, "0"}})}},
        {"LDT0405", {ldt({{23, "0"}})}},
        {"LDT0406", {ldt({{24, "2"}})}},
        {"LDT0407", {ldt({{25, "5"}})}},
        {"LDT0408", {ldt({{27, "-1"}})}},

        {"TM30101", {tm33("</Emitter>", "")}},
        {"TM30102", {"<svg/>", false, {}, "lamp.xml"}},
        {"TM30103", {tm33("<Laboratory>l</Laboratory>", "")}},
        {"TM30104", {tm33("1.1", "9")}},
        {"TM30105", {"<IESTM33-22/>"}},
        {"TM30106", {"<LuminaireOpticalData><Emitter/></LuminaireOpticalData>"}},
        {"TM30107", {tm33("</Header>", "</Header>" + nested(65))}},
        {"TM30201", {tm33("1000", "x")}},
        {"TM30202", {tm33("false", "x")}},
        {"TM30203", {tm33("<IntData", "<NumberVert>3</NumberVert><IntData")}},
        {"TM30204", {tm33(last_point, "<IntData h=\"90\" v=\"90\">0</IntData>")}},
        {"TM30205", {tm33("v=\"90\"", "v=\"0\"")}},
        {"TM30206", {tm33("v=\"90\"", "")}},
        {"TM30207", {tm33(">0</IntData>", ">x</IntData>")}},
        {"TM30208", {tm33("<IntData", "<Multiplier>0</Multiplier><IntData")}},
        {"TM30209", {tm33("<Quantity>1", "<Quantity>0")}},
        {"TM30210", {tm33("Symm_Full", "x")}},
        {"TM30211", {tm33(">0</IntData>", ">1e999</IntData>")}},
        {"TM30212", {tm33("<LuminousData>", "<TiltAngles><Tilt>1</Tilt></TiltAngles><LuminousData>")}},
        {"TM30213",
         {tm33("</Emitter>", "<SpectralDistribution><Wavelengths>400 500</Wavelengths><Values>1</Values>"
                             "</SpectralDistribution></Emitter>")}},
        {"TM30301", {tm33("Symm_Full", "Symm_Quad")}},
        {"TM30302", {tm33("v=\"90\"", "v=\"190\"")}},
        {"TM30303", {tm33_spectrum("<PwrData w=\"5\">1</PwrData><PwrData w=\"4\">1</PwrData>")}},
        {"TM30304",
         {tm33(last_point, std::string(last_point) + "<IntData h=\"190\" v=\"0\">1</IntData>"
                                                     "<IntData h=\"190\" v=\"90\">1</IntData>")}},
        {"TM30401", {tm33(">0</IntData>", ">-1</IntData>")}},
        {"TM30402", {tm33(">100<", ">0<")}},
        {"TM30403",
         {tm33(last_point, std::string(last_point) + "<IntData h=\"90\" v=\"0\">1</IntData>"
                                                     "<IntData h=\"90\" v=\"90\">0</IntData>")}},
        {"TM30404", {"<IESTM33-22><Emitter/></IESTM33-22>"}},
        {"TM30405", {"<IESTM33-22><Emitter><LuminousData><LuminousIntensity/></LuminousData></Emitter></IESTM33-22>"}},

        {"WEB0101", {ies({{3, "1 1000 1 2 3 1 2 0 0 0"}, {6, "0 120 240"}, {7, "100 0 100 0 100 0"}})}},
        {"WEB0102", {ies({{3, "1 1000 1 2 2 1 2 0 0 0"}, {6, "0 100"}, {7, "100 0 100 0"}})}},
        {"WEB0103", {ies({{6, "5"}})}},
        {"WEB0104", {ies({{4, "1 2 10"}})}},
        {"WEB0105", {ies({{7, "100 -1"}})}},
        {"WEB0106", {ies({{7, "0 0"}})}},
        {"WEB0107", {ies({{3, "1 1000 1 2 1 2 2 0 0 0"}})}},
        {"WEB0108", {ies({{3, "1 1000 1e20 2 1 1 2 0 0 0"}, {7, "1e11 0"}})}},

        {"WEB0109", {ldt({{3, "0"}})}},
        {"WEB0110", {ies({{2, "[_INTENSITYUNITS] mW/sr\nTILT=NONE"}})}},

        {"WEB0201", {ies({{2, "[OTHER] x\nTILT=NONE"}}), false, T::eulumdat}},
        {"WEB0202", {ies({{2, "TILT=INCLUDE\n1\n1\n0\n1"}}), false, T::eulumdat}},
        {"WEB0203", {ldt({{26, "2"}, {32, "10\n1\nLED\n1\n\n\n1"}}), false, T::lm63}},
        {"WEB0204", {tm33_spectrum("<PwrData w=\"5\">1</PwrData>"), false, T::lm63}},
        {"WEB0205",
         {ies({{3, "1 1000 1 2 2 2 2 0 0 0"}, {5, "-90 90"}, {6, "-90 90"}, {7, "1 1 1 1"}}), false, T::eulumdat}},
        {"WEB0206", {ies({{5, "0 80"}}), false, T::eulumdat}},
        {"WEB0207", {ies({{3, "1 1000 1 2 2 1 2 0 0 0"}, {6, "0 100"}, {7, "100 0 100 0"}}), false, T::lm63_2002}},
        {"WEB0208", {ies({{3, "1 1000 1 2 2 1 2 0 0 0"}, {6, "90 270"}, {7, "100 0 100 0"}}), false, T::lm63_2002}},
        {"WEB0209", {ies({{3, "1 1000 1 2 1 1 2 -1 0 -1"}}), false, T::eulumdat}},
        {"WEB0210", {ldt(), false, T::lm63}},
        {"WEB0211", {ies({{1, "IES:LM-63-2019"}, {4, "1 1.1 10"}}), false, T::eulumdat}},
        {"WEB0212", {ies({{2, "[OTHER] \xE4\nTILT=NONE"}}), false, T::portable}},
        {"WEB0213", {ies({{3, "1 -1 1 2 1 1 2 0 0 0"}}), false, T::portable}},
        {"WEB0214", {ies({{3, "1 1000 1 2 3 1 2 0 0 0"}, {6, "0 180 360"}, {7, "9 1 9 1 9 2"}}), false, T::eulumdat}},
        {"WEB0215", {ies(), false, T::lm63_2002}},
        {"WEB0217", {ies({{2, "TILT=a.tlt"}}), false, T::lm63, "beside"}},
        {"WEB0218", {"<IESTM33-22><Emitter/>" + tm33("<IESTM33-22><Version>1.1</Version>", ""), false, T::lm63}},
        {"WEB0219", {ies({{3, "1 1000 1 2 2 1 2 0 0 0"}, {6, "0 90"}, {7, "9 1 9 1"}}), false, T::lm63, "compact"}},
        {"WEB0220", {ies({{3, "1 1000 1 2 2 1 2 0 0 0"}, {6, "0 90"}, {7, "9 1 9 5"}}), false, T::eulumdat}},
        {"WEB0221", {ies({{2, "[OTHER] x\x02y\nTILT=NONE"}}), false, T::tm33}},

        {"WEB0301", {ies({{3, "1 1 1 2 1 1 2 0 0 0"}})}},
        {"WEB0302", {ies({{3, "1 9999 1 2 1 1 2 0 0 0"}})}},
        {"WEB0303", {ies({{4, "1 1 .1"}})}},
        {"WEB0304", {ies({{4, "1 1 .5"}})}},
        {"WEB0305", {ies({{4, "1 1 0"}})}},
        {"WEB0306", {ies({{3, "1 1000 1 2 1 1 2 99 0 0"}})}},
        {"WEB0307", {ies({{3, "1 1000 1 2 1 1 2 .0005 .0005 0"}, {7, "999 0"}})}},
        {"WEB0308", {ies({{3, "1 1000 1 4 1 1 2 0 0 0"}, {5, "0 30 60 90"}, {7, "1 99 1 1"}})}},
        {"WEB0309", {ies({{7, "100 11"}})}},
        {"WEB0311", {ies({{3, "1 1000 1 2 2 1 2 0 0 0"}, {6, "0 90"}, {7, "100 0 100 0"}})}},
        {"WEB0312", {ldt({{22, "97"}})}},
        {"WEB0313", {ldt({{23, "40"}})}},
        {"WEB0314", {ldt({{33, "0.3"}})}},
        {"WEB0315", {ldt({{29, "0"}})}},
        {"WEB0316", {ldt({{13, "99"}})}},
        {"WEB0317", {ldt({{31, "101"}})}},
        {"WEB0318", {ies({{4, "1 1 1"}, {7, "200 0"}})}},
        {"WEB0319", {ies({{3, "1 1000 1 2 1 1 2 5 0 0"}})}},
    };
    return rules;
}

// All diagnostics of reading, resolving, the plausibility check and, if requested, converting.
Diagnostics all_said(const Rule& rule) {
    ReadOptions options;
    options.strict = rule.strict;
    if (rule.name == "beside") options.read_beside = [](const std::string&) { return Result<std::string>("1 1 0 1"); };
    Result<Profile> profile = read_profile(rule.bytes, rule.name, options);
    if (!profile) return profile.error().diagnostics;
    Diagnostics said = profile->diagnostics;
    const auto add = [&](const Diagnostics& more) { said.insert(said.end(), more.begin(), more.end()); };
    const Result<ResolvedWeb> resolved = resolve_web(*profile);
    if (!resolved) {
        add(resolved.error().diagnostics);
        return said;
    }
    add(resolved->diagnostics);
    add(check_plausibility(*profile, resolved->web));
    if (!rule.target) return said;
    const Result<MadeProfile> made = rule.name == "compact" ? convert_compacted(*profile, *rule.target, 0.0)
                                                            : convert_profile(*profile, *rule.target);
    EXPECT_TRUE(made);
    if (made) add(made->diagnostics);
    return said;
}

std::string text_of(const Diagnostics& said) {
    std::string text;
    for (const Diagnostic& diagnostic : said)
        text += to_text(diagnostic) + "\n";
    return text;
}

const Diagnostic* find_code(const Diagnostics& said, std::string_view code) {
    const auto found =
        std::find_if(said.begin(), said.end(), [&](const Diagnostic& diagnostic) { return diagnostic.code == code; });
    return found == said.end() ? nullptr : &*found;
}

void expect_broken(std::string_view code, Severity severity) {
    const auto rule = smallest_files().find(std::string(code));
    ASSERT_NE(rule, smallest_files().end()) << code << " has no file that breaks its rule";
    const Diagnostics said = all_said(rule->second);
    const Diagnostic* const diagnostic = find_code(said, code);
    ASSERT_NE(diagnostic, nullptr) << code << " is not said, but\n" << text_of(said);
    EXPECT_EQ(diagnostic->severity, severity) << to_text(*diagnostic);
    EXPECT_FALSE(diagnostic->message.empty()) << code;
    EXPECT_EQ(diagnostic->message.find('\n'), std::string::npos) << to_text(*diagnostic);
    EXPECT_NE(diagnostic->message.back(), '.') << to_text(*diagnostic);
    EXPECT_EQ(diagnostic->location.file, rule->second.name);
    // Diagnostics about reading and about the light have a place; losses in writing concern the whole file.
    const bool of_writing = code.substr(0, 5) == "WEB02";
    EXPECT_EQ(diagnostic->location.line == 0, of_writing) << to_text(*diagnostic);
}

TEST(Rules, EveryCodeHasTheSmallestFileThatBreaksIt) {
    for (const DiagnosticCode& entry : profile_codes) {
        SCOPED_TRACE(entry.code);
        const auto rule = smallest_files().find(std::string(entry.code));
        const bool strict = rule != smallest_files().end() && rule->second.strict;
        expect_broken(entry.code, strict ? entry.strict_severity() : entry.severity);
        EXPECT_FALSE(entry.explanation.empty());
    }
    for (const DiagnosticCode& entry : web_codes) {
        SCOPED_TRACE(entry.code);
        expect_broken(entry.code, entry.severity);
        EXPECT_FALSE(entry.explanation.empty());
    }
    EXPECT_EQ(smallest_files().size(), std::size(profile_codes) + std::size(web_codes));
}

std::string place_of(const Diagnostics& said, std::string_view code) {
    const Diagnostic* const diagnostic = find_code(said, code);
    if (diagnostic == nullptr) return "not said";
    return std::to_string(diagnostic->location.line) + ":" + std::to_string(diagnostic->location.column);
}

TEST(Rules, AboutTheLightNameTheField) {
    const std::map<std::string, std::string> places{
        {"WEB0101", "6:7"},  {"WEB0102", "6:1"},  {"WEB0103", "6:1"},  {"WEB0104", "4:3"},  {"WEB0105", "7:5"},
        {"WEB0106", "7:1"},  {"WEB0107", "6:1"},  {"WEB0108", "3:8"},  {"WEB0301", "3:3"},  {"WEB0302", "3:3"},
        {"WEB0303", "4:5"},  {"WEB0304", "4:5"},  {"WEB0305", "4:5"},  {"WEB0306", "3:18"}, {"WEB0307", "3:18"},
        {"WEB0308", "7:1"},  {"WEB0309", "5:3"},  {"WEB0311", "6:1"},  {"WEB0312", "22:1"}, {"WEB0313", "23:1"},
        {"WEB0314", "34:0"}, {"WEB0315", "29:1"}, {"WEB0316", "16:1"}, {"WEB0317", "31:1"}, {"WEB0318", "4:5"},
        {"WEB0319", "3:18"}, {"WEB0109", "43:1"}, {"WEB0110", "8:1"}};
    for (const DiagnosticCode& entry : web_codes) {
        if (entry.code.substr(0, 5) == "WEB02") continue;
        const std::string code(entry.code);
        EXPECT_EQ(place_of(all_said(smallest_files().at(code)), code), places.at(code)) << code;
    }
    // The same rules where another format has the field.
    EXPECT_EQ(place_of(all_said({ldt({{46, " -1"}})}), "WEB0105"), "46:2");
    EXPECT_EQ(place_of(all_said({ldt({{32, "0"}})}), "WEB0305"), "32:1");
    EXPECT_EQ(place_of(all_said({ies({{2, "[_CCT] 99\nTILT=NONE"}})}), "WEB0317"), "2:1");
    // If a factor takes the values out of range, the place is that of the largest factor.
    EXPECT_EQ(place_of(all_said({ies({{4, "1e30 1 10"}})}), "WEB0108"), "4:1");
    EXPECT_EQ(place_of(all_said({ies({{1, "IESNA91"}, {4, "1 1e30 10"}})}), "WEB0108"), "4:3");
    EXPECT_EQ(place_of(all_said({ldt({{24, "1e30"}})}), "WEB0108"), "24:1");
    EXPECT_EQ(place_of(all_said({ldt({{24, "100"}, {29, "1e30"}})}), "WEB0108"), "29:1");
    EXPECT_EQ(place_of(all_said({tm33("<IntData h=\"0\" v=\"0\">", "\n <Multiplier>1e30</Multiplier>"
                                                                   "<IntData h=\"0\" v=\"0\">")}),
                       "WEB0108"),
              "2:2");
    const std::string lines = tm33("<InputWattage>10", "\n <InputWattage>0");
    EXPECT_EQ(place_of(all_said({lines}), "WEB0305"), "2:2");
}

TEST(Rules, NameTheLampSetThatIsLookedAt) {
    const auto profile = read_profile(ldt({{26, "2"}, {32, "10\n1\nLED\n0\n\n\n1"}}), "lamp");
    ASSERT_TRUE(profile);
    ResolveOptions options;
    EXPECT_EQ(place_of(check_plausibility(*profile, resolve_web(*profile, options)->web, options), "WEB0315"),
              "not said");
    options.lamp_set = 2;
    EXPECT_EQ(place_of(check_plausibility(*profile, resolve_web(*profile, options)->web, options), "WEB0315"), "35:0");
}

// A profile that was made has no text: its diagnostics concern the whole profile.
TEST(Rules, OfAMadeProfileNameNoPlace) {
    Profile made;
    made.source = "made";
    made.file = std::get<IesFile>(read_profile(ies({{7, "0 0"}}), "lamp")->file);
    EXPECT_EQ(place_of(resolve_web(made)->diagnostics, "WEB0106"), "0:0");
}

// Otherwise the files above would prove nothing.
TEST(Rules, TheFilesTheyAreMadeFromBreakNone) {
    for (const std::string& bytes : {ies(), ldt(), tm33()})
        EXPECT_EQ(text_of(all_said({bytes})), "");
}

// Tolerant reading accepts what strict reading refuses.
TEST(Rules, StrictSeveritiesAreThoseOfTheTable) {
    for (const DiagnosticCode& entry : profile_codes) {
        Rule rule = smallest_files().at(std::string(entry.code));
        rule.strict = true;
        const Diagnostics said = all_said(rule);
        const Diagnostic* const diagnostic = find_code(said, entry.code);
        ASSERT_NE(diagnostic, nullptr) << entry.code << "\n" << text_of(said);
        EXPECT_EQ(diagnostic->severity, entry.strict_severity()) << to_text(*diagnostic);
        rule.strict = false;
        EXPECT_EQ(find_code(all_said(rule), entry.code) == nullptr, entry.strict == Strict::only) << entry.code;
    }
}

// Plausible files must pass without warnings, otherwise users would ignore the check.
TEST(Rules, PlausibleLightsPass) {
    const auto said = [](const std::string& bytes) { return text_of(all_said({bytes})); };
    // Losses of the luminaire, and a flux 2 % above that of the lamps.
    EXPECT_EQ(said(ies({{3, "1 224 1 2 1 1 2 0 0 0"}})), "");
    // A narrow beam: the pole is one direction, whatever the values next to it are.
    EXPECT_EQ(said(ies({{3, "1 -1 1 3 1 1 2 0 0 0"}, {5, "0 5 90"}, {7, "10000 10 0"}})), "");
    // A short code for 3000 K, Ra 80 to 89; no number at all.
    EXPECT_EQ(said(ldt({{30, "830"}})), "");
    EXPECT_EQ(said(ldt({{30, "nw"}, {31, "1A/>90"}})), "");
}

} // namespace
