// The two ways of reading a rig against each other: where lights are read plainly, the rig is that of its values, to
// the last bit, and where a rig is refused, the message is theirs.
#include <gonio/scene/detail/rig_reader.hpp>
#include <gonio/scene/rig.hpp>
#include <gonio/web/web.hpp>

#include "../folders.hpp"
#include "../scaled.hpp"
#include "../temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace gonio {
namespace {

const std::string profiles = std::string(test::source_folder) + "/profiles";

Result<Rig> by_values(const std::string& text) {
    return detail::read_rig_by_values(text, "rig.json", profiles);
}

Result<Rig> plainly(const std::string& text, unsigned threads = 2) {
    RigReadOptions options;
    options.threads = threads;
    return detail::read_rig_plainly(text, "rig.json", profiles, options);
}

std::string rig_of(std::string_view lights, std::string_view members = {}) {
    return fmt::format(R"({{"schema":"gonio.rig/1",{}"lights":[{}]}})", members, lights);
}

// All bits of a vector.
std::string bits(const glm::dvec3& v) {
    return fmt::format("({:a} {:a} {:a})", v.x, v.y, v.z);
}

std::string state_of(const LightDescription& light) {
    std::string state = fmt::format("'{}' {} ", light.name, kind_of(light.shape));
    struct Number {
        double operator()(Meters length) const { return length.value; }
        double operator()(Radians angle) const { return angle.value; }
        double operator()(bool there) const { return there ? 1.0 : 0.0; }
        double operator()(Falloff falloff) const { return static_cast<double>(falloff); }
    };
    for (const ShapeValue& value : values_of(light.shape))
        state += fmt::format("{}={:a} ", value.key, std::visit(Number(), value.value));
    if (const std::string* const file = file_of(light.shape)) state += *file + ' ';
    state += pattern_of(light.shape) != nullptr ? "pattern " : "bare ";
    if (const auto* const profile = std::get_if<ProfileShape>(&light.shape))
        state += fmt::format("{}x{} {} {} ", profile->web->horizontal_deg().size(), profile->web->vertical_deg().size(),
                             static_cast<int>(profile->size), profile->opening() != nullptr);
    if (light.intensity)
        state += fmt::format("{:a}{}@{:a}@{:a} {} ", light.intensity->number, light.intensity->unit.unit->symbol,
                             light.intensity->unit.distance.value_or(Meters(-1.0)).value,
                             light.intensity->unit.efficacy_lm_per_w.value_or(-1.0), light.intensity->unit.efficacy_of);
    return state + fmt::format("{} {} {} {} {:a} {:a} {:a}", bits(light.color), bits(light.position),
                               bits(light.direction), bits(light.up), light.rotation.value,
                               light.range.value_or(Meters(-1.0)).value, light.level);
}

std::vector<std::string> state_of(const Rig& rig) {
    std::vector<std::string> state;
    for (const LightDescription& light : rig.lights)
        state.push_back(state_of(light));
    for (const LightsPlace& place : rig.places)
        state.push_back(fmt::format("{} from {}", place.path, place.first));
    for (const std::string& file : rig.files)
        state.push_back(file);
    for (const Diagnostic& said : rig.diagnostics)
        state.push_back(to_text(said));
    for (const SurfaceMaterial& material : rig.materials)
        state.push_back(material.surface);
    for (const NamedEmission& emission : rig.emits)
        state.push_back(emission.surface);
    state.push_back(fmt::format("{} {} {}", rig.sky.has_value(), rig.stage ? rig.stage->name : "", rig.source));
    if (rig.camera) state.push_back(bits(rig.camera->position) + bits(rig.camera->target));
    return state;
}

std::string said(const Result<Rig>& rig) {
    return rig ? "no failure" : to_text(rig.error().diagnostics.back());
}

// Whether the plain way takes the rig; then it is that of its values. The one that read_rig() gives, or its refusal, is
// always that.
bool agree(const std::string& text) {
    const Result<Rig> expected = by_values(text);
    const Result<Rig> plain = plainly(text);
    const Result<Rig> got = read_rig(text, "rig.json", profiles);
    EXPECT_EQ(said(got), said(expected)) << text;
    if (plain) {
        EXPECT_TRUE(expected) << said(expected) << '\n' << text;
    }
    if (expected && plain) {
        EXPECT_EQ(state_of(*plain), state_of(*expected)) << text;
    }
    if (expected && got) {
        EXPECT_EQ(state_of(*got), state_of(*expected)) << text;
    }
    return plain.has_value();
}

const std::array<std::string, 30> lights{
    R"({"shape":"point","intensity":"800lm"})",
    R"({ "name": "key" , "shape" :"point","intensity":"1.5 klm","position":[1,-2.5,3e0],"color":"2700K"})",
    R"({"intensity":"900cd","shape":"spot:outer=20deg","position":[0,0,3],"target":[0,1,0],"up":[1,0,0]})",
    R"({"shape":"sphere:r=10cm","intensity":"300lx@2m","direction":[0,1,-1],"color":"#ffd9a0","range":"12m"})",
    R"({"shape":"rect:w=60cm,h=30cm","intensity":"5000nt","rotate":"30deg","dimming":0.5,"maintenance":0.8})",
    R"({"shape":"tube:r=2cm,l=1.2m","intensity":"60W@90lm/W","position":[-0,-0.0,0e5],"dimming":0})",
    R"({"shape":"ies:downlight.ies","position":[0,0,2.8]})",
    R"({"shape":"ies:street.ldt","intensity":"4000lm","color":"d65"})",
    R"({"shape":"disk:r=5cm","intensity":"12ev","position":[0.1000000000000000055511151231257827,1E-3,1e+2]})",
    R"({"luminaire":"A"})",
    R"~({"luminaire":"B","position":[3,4,5],"color":"rgb(1,0.5,0.2)","dimming":0.3,"maintenance":0.7})~",
    R"({"luminaire":"C","intensity":"100lm"})",
    R"~({"shape":"point","intensity":"1lm","color":"rgb(0,1,0)"})~",
    R"({"shape":"point","intensity":"1lm","color":"1200K"})",
    R"({"shape":"sun:angle=0.53deg","intensity":"100klx","direction":[0.3,0,-1]})",
    // Not plain: left to their values.
    R"({"shape":"point","intensity":"800lm","name":"Küche"})",
    R"({"shape":"point","intensity":"800lm","name":"a\u0062c"})",
    R"({"n\u0061me":"x","shape":"point","intensity":"800lm"})",
    R"({"shape":"ies:downlight.ies","smooth":"1deg"})",
    R"({"shape":"point","intensity":"1lm","dimming":"50%"})",
    R"({"shape":"point","intensity":"1lm","positions":[[1,2,3],[4,5,6]]})",
    R"({"shape":"point","intensity":"1lm","array":{"count":[2,3],"spacing":[1,2]},"name":"row"})",
    R"({"name":"group","position":[1,0,0],"rotate":"90deg","lights":[{"luminaire":"A"},{"luminaire":"B"}]})",
    "{\"shape\":\"point\", // with, { remarks } \n \"intensity\":\"1lm\" /* [ \" */ }",
    R"({"name":"}, {","shape":"point","intensity":"1lm"})",
    R"({"name":"ends in \\","shape":"point","intensity":"1lm"})",
    R"({"shape":"point","intensity":"1lm","position":[12345678901234567890,-9223372036854775808,1e-320]})",
    R"({"shape":"point","intensity":"1lm","position":[1e-400,0,0]})",
    R"~({"shape":"point","intensity":"1lm","color":"rgb(0,1,0)"})~",
    R"({"shape":"point","intensity":"1lm","position":[99999999999999999999,18446744073709551616,-1]})",
};
constexpr std::string_view luminaires = R"("luminaires":{"A":{"shape":"ies:wall-washer.ies","dimming":0.9},
    "B":{"shape":"point","intensity":"1klm","maintenance":0.8,"color":"4000K"},
    "C":{"shape":"ies:downlight.ies","smooth":"2deg"}},)";

TEST(RigPlain, EachLightIsThatOfItsValues) {
    for (const std::string& light : lights)
        EXPECT_TRUE(agree(rig_of(light, luminaires))) << light << '\n' << said(by_values(rig_of(light, luminaires)));
}

TEST(RigPlain, LightsInAnyOrderAreThoseOfTheirValues) {
    std::mt19937 random(7);
    for (int round = 0; round < 40; ++round) {
        std::string all;
        const std::size_t count = 1 + random() % 40;
        for (std::size_t i = 0; i < count; ++i) {
            constexpr std::array<std::string_view, 5> between{",", " ,\n", ",\t// }, {\n", "\r\n,/* }, { */ ", ","};
            if (i > 0) all += between[random() % between.size()];
            all += lights[random() % lights.size()];
        }
        constexpr std::array<std::string_view, 3> members{
            "", R"("sky":"cie:12,sun=180/40,horizontal=20klx","stage":"floor",)",
            R"("maintenance":"90%","camera":{"position":[0,-5,1.5],"target":[0,0,1]},)"};
        const std::string text = rig_of(all, std::string(luminaires) + std::string(members[random() % members.size()]));
        EXPECT_TRUE(agree(text));
    }
}

TEST(RigPlain, MembersMayFollowTheLights) {
    const std::string head = R"({"schema":"gonio.rig/1","lights":[{"shape":"point","intensity":"1lm","dimming":0.3}])";
    EXPECT_TRUE(agree(head + R"(,"maintenance":0.7,"stage":"room","emits":{"ceiling":"5nt"}})"));
    EXPECT_TRUE(agree(head + R"(,"sky":"cie:12,sun=180/40,horizontal=20klx"})"));
    EXPECT_TRUE(agree(R"({"lights":[{"shape":"point","intensity":"1lm"}],"schema":"gonio.rig/1"})"));
    // Luminaires behind the lights are read by their values.
    EXPECT_FALSE(agree(R"({"schema":"gonio.rig/1","lights":[{"luminaire":"A"}],"luminaires":{"A":{"shape":"point",)"
                       R"("intensity":"1lm"}}})"));
    EXPECT_FALSE(agree(R"({"schema":"gonio.rig/1","lights":[],"sky":"cie:12,sun=180/40,horizontal=20klx"})"));
}

TEST(RigPlain, MistakesAreThoseOfTheValues) {
    const std::array<std::string_view, 36> wrong{
        "",
        "5",
        "null",
        "[]",
        "{}",
        R"({"intensity":"1lm"})",
        R"({"shape":"point","intensity":"800"})",
        R"({"shape":"point","intensity":800})",
        R"({"shape":"poin","intensity":"800lm"})",
        R"({"shape":"point","intensity":"1lm","intensity":"1lm"})",
        R"({"shape":"point","intensity":"1lm","shape":"point"})",
        R"({"shape":"point","luminaire":"B","intensity":"1lm"})",
        R"({"luminaire":"D"})",
        R"({"shape":"point","intensity":"1lm","position":[1,2]})",
        R"({"shape":"point","intensity":"1lm","position":[1,2,3,4]})",
        R"({"shape":"point","intensity":"1lm","position":[1,2,"3"]})",
        R"({"shape":"point","intensity":"1lm","position":[1,2,3,]})",
        R"({"shape":"point","intensity":"1lm","position":[01,2,3]})",
        R"({"shape":"point","intensity":"1lm","position":[+1,2,3]})",
        R"({"shape":"point","intensity":"1lm","position":[1.,2,3]})",
        R"({"shape":"point","intensity":"1lm","position":[1e,2,3]})",
        R"({"shape":"point","intensity":"1lm","position":[1e101,2,3]})",
        R"({"shape":"point","intensity":"1lm","position":[1e999,2,3]})",
        R"({"shape":"point","intensity":"1lm","position":[nan,2,3]})",
        R"({"shape":"point","intensity":"1lm","direction":[0,0,-0.0]})",
        R"({"shape":"point","intensity":"1lm","direction":[0,0,1],"target":[1,1,1]})",
        R"({"shape":"point","intensity":"1lm","target":[0,0,0]})",
        R"({"shape":"point","intensity":"1lm","dimming":1.5})",
        R"({"shape":"point","intensity":"1lm","maintenance":0})",
        R"({"shape":"point","intensity":"1lm","range":"0m"})",
        R"~({"shape":"point","intensity":"1lm","color":"rgb(0,0,0)"})~",
        R"({"shape":"ies:no-such-file.ies"})",
        R"({"shape":"ies:../README.md"})",
        R"({"shape":"point","intensity":"1lm",})",
        R"({"shape":"point" "intensity":"1lm"})",
        "{\"shape\":\"point\",\"intensity\":\"1lm\",\"name\":\"a\x7f\"}",
    };
    const std::string sound = R"({"shape":"point","intensity":"1lm"})";
    for (const std::string_view light : wrong)
        for (const std::string& around :
             {std::string(light), sound + ",\n" + std::string(light), std::string(light) + "," + sound})
            EXPECT_FALSE(agree(rig_of(around, luminaires))) << around;
    for (const std::string_view text : {"", "{", "[]", R"({"lights":)", R"({"lights":[)", R"({"lights":[]} x)",
                                        R"({"schema":"gonio.rig/1","lights":[{]})",
                                        R"({"schema":"gonio.rig/1","lights":[{"shape":"point","intensity":"1lm"}})",
                                        R"({"schema":"gonio.rig/1","lights":[{"shape":"point","intensity":"1lm"}],})",
                                        R"({"schema":"gonio.rig/2","lights":[{"shape":"point","intensity":"1lm"}]})",
                                        R"({"lights":[{"shape":"point","intensity":"1lm"}]})"})
        EXPECT_FALSE(agree(std::string(text))) << text;
    EXPECT_FALSE(agree(rig_of(sound) + "x"));
    EXPECT_FALSE(agree(R"({"schema":"gonio.rig/1","lights":[)" + sound + R"(],"lights":[]})"));
    // A null character ends a comment early.
    EXPECT_FALSE(agree("{\"schema\":\"gonio.rig/1\",\"lights\":[// " + std::string(1, '\0') + " x\n" + sound + "]}"));
}

TEST(RigPlain, ChangedBytesGiveTheSameAnswerBothWays) {
    std::string all;
    for (const std::string& light : lights) {
        if (light.find("smooth") != std::string::npos) continue; // slow to read
        all += (all.empty() ? "" : ",\n") + light;
    }
    std::mt19937 random(11);
    constexpr std::string_view bytes = "{}[]\",:\\/*0123456789.eE+-aklmspt \n\t";
    std::size_t taken = 0;
    for (int round = 0; round < 6000; ++round) {
        // One light or all, without the luminaires, whose profiles would be read each time.
        std::string text = rig_of(round % 10 == 0 ? all : lights[random() % lights.size()]);
        for (std::size_t changes = 1 + random() % 2; changes > 0; --changes) {
            const std::size_t at = random() % text.size();
            const char byte = random() % 50 == 0 ? static_cast<char>(random()) : bytes[random() % bytes.size()];
            switch (random() % 3) {
            case 0:
                text[at] = byte;
                break;
            case 1:
                text.insert(at, 1, byte);
                break;
            default:
                text.erase(at, 1);
            }
        }
        if (agree(text)) ++taken;
    }
    EXPECT_GT(taken, 150U); // not only refusals are compared
}

// Some megabytes, in which every piece of the text begins somewhere else.
TEST(RigPlain, ManyLightsAreThoseOfTheirValuesAtAnyNumberOfThreads) {
    std::mt19937 random(3);
    std::string all;
    for (int i = 0; i < 40000; ++i) {
        if (i > 0) all += i % 7 == 0 ? "," : ",\n  ";
        if (i % 97 == 5)
            all += lights[15 + random() % 15];
        else if (i == 20000)
            all += fmt::format(R"({{"name":"{}","shape":"point","intensity":"1lm"}})", std::string(600'000, '}'));
        else
            all += fmt::format(R"({{{}"shape":"point","intensity":"{}lm","color":"{}K","position":[{}.{},-{},{}e-2]}})",
                               i % 3 == 0 ? fmt::format(R"("name":"lamp }}, {{ {} {}",)", i, i % 2 == 0 ? "[[[" : "/*")
                                          : "",
                               random() % 4000, random() % 40 * 100 + 2500, random() % 1000, random() % 1000,
                               random() % 500, random() % 9);
    }
    const std::string text = rig_of(all, luminaires);
    const Result<Rig> expected = by_values(text);
    ASSERT_TRUE(expected) << said(expected);
    const std::vector<std::string> state = state_of(*expected);
    for (const unsigned threads : {1U, 2U, 5U}) {
        const Result<Rig> plain = plainly(text, threads);
        ASSERT_TRUE(plain) << said(plain);
        EXPECT_EQ(state_of(*plain), state);
    }
    // A mistake in the last light.
    std::string broken = text;
    broken.replace(broken.rfind("\"shape\""), 7, "\"shame\"");
    EXPECT_FALSE(plainly(broken));
    EXPECT_EQ(said(read_rig(broken, "rig.json", profiles)), said(by_values(broken)));
}

// Keeps what a stream passes on.
class Keeper final : public LightsSink {
public:
    void add(std::vector<Light> more) override {
        ++parts;
        for (Light& light : more)
            lights.push_back(std::move(light));
    }
    void restart() override {
        lights.clear();
        parts = 0;
    }

    std::vector<Light> lights;
    std::size_t parts = 0;
};

std::string state_of(const Light& light) {
    return fmt::format("'{}' {} {} {} {} {} {} {:a} {:a} {:a} {:a} {:a} {}", light.name, kind_of(light.shape),
                       bits(light.frame.origin), bits(light.frame.x), bits(light.frame.y), bits(light.frame.z),
                       bits(light.color), light.intensity.value, light.luminance.value, light.illuminance.value,
                       light.web_scale, light.range.value_or(Meters(-1.0)).value, pattern_of(light.shape) != nullptr);
}

std::vector<std::string> state_of(const std::vector<Light>& all) {
    std::vector<std::string> state;
    for (const Light& light : all)
        state.push_back(state_of(light));
    return state;
}

// The text as a file beside copies of the profiles that it names.
class RigFile {
public:
    explicit RigFile(const std::string& text) {
        for (const char* const name : {"downlight.ies", "wall-washer.ies", "street.ldt"})
            std::filesystem::copy_file(std::filesystem::path(profiles) / name, folder_.path() / name);
        std::ofstream(path()) << text;
    }
    std::string path() const { return (folder_.path() / "rig.json").string(); }

private:
    test::TemporaryFolder folder_;
};

// How many parts the lights came in; 0: the rig was refused.
std::size_t parts_of_stream(const std::string& text) {
    const RigFile file(text);
    Diagnostics kept;
    Result<std::vector<Light>> expected;
    if (Result<Rig> rig = read_rig_file(file.path()))
        expected = resolve_lights(std::move(*rig), kept);
    else
        expected = Unexpected(rig.error());
    Keeper keeper;
    Diagnostics passed;
    const Result<Rig> rest = stream_rig_file(file.path(), {}, keeper, passed);
    EXPECT_EQ(rest.has_value(), expected.has_value());
    if (!rest || !expected) {
        if (!rest && !expected) {
            EXPECT_EQ(to_text(rest.error().diagnostics.back()), to_text(expected.error().diagnostics.back()));
        }
        return 0;
    }
    EXPECT_TRUE(rest->lights.empty());
    EXPECT_EQ(state_of(keeper.lights), state_of(*expected));
    EXPECT_EQ(passed.size(), kept.size());
    for (std::size_t i = 0; i < std::min(passed.size(), kept.size()); ++i)
        EXPECT_EQ(to_text(passed[i]), to_text(kept[i]));
    return keeper.parts;
}

TEST(RigPlain, LightsThatArePassedOnAreThoseThatAreKept) {
    std::mt19937 random(5);
    std::string all;
    // Under a sanitizer they come in the short first piece and one more.
    constexpr int count = test::is_sanitized ? 20'000 : 120'000;
    constexpr std::size_t least_parts = test::is_sanitized ? 2 : 3;
    for (int i = 0; i < count; ++i) {
        if (i > 0) all += ",\n";
        if (i % 501 == 7 && random() % 2 == 0)
            all += lights[random() % lights.size()];
        else
            all += fmt::format(R"({{"shape":"point","intensity":"{}lm","position":[{},-{},9],"dimming":0.{}}})",
                               random() % 4000, random() % 1000, random() % 1000, random() % 10);
    }
    const std::string first(luminaires);
    EXPECT_GE(parts_of_stream(rig_of(all, first)), least_parts);
    EXPECT_GE(parts_of_stream(rig_of(all, first + R"("maintenance":0.7,)")), least_parts);
    // The factor comes too late for lights that were passed on: they come again, all at once.
    std::string late = rig_of(all, first);
    late.insert(late.size() - 1, R"(,"maintenance":0.7)");
    EXPECT_EQ(parts_of_stream(late), 1U);
    // A light without an intensity is refused when it is resolved, and a key that is wrong when it is read.
    EXPECT_EQ(parts_of_stream(rig_of(all + R"(,{"shape":"point"})", first)), 0U);
    EXPECT_EQ(parts_of_stream(rig_of(R"({"shape":"point"},)" + all + R"(,{"shame":"point"})", first)), 0U);
}

} // namespace
} // namespace gonio
