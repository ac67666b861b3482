// Sidecars of prefiltered environments, checked against the schema in the tree.
#include <gonio/asset/content_hash.hpp>
#include <gonio/asset/prefilter_sidecar.hpp>
#include <gonio/base/file.hpp>
#include <gonio/sky/sky_direction.hpp>

#include "../folders.hpp"
#include "json_schema.hpp"

#include <gtest/gtest.h>

namespace gonio {
namespace {

TEST(PrefilterSidecar, FitsTheSchema) {
    const std::string path = std::string(test::source_folder) + "/lib/gonio/asset/prefilter.schema.json";
    const test::JsonSchema fits(nlohmann::json::parse(read_file(path).value()));
    for (const PrefilterVariant& variant : prefilter_variants()) {
        const SplitSumTable table = *SplitSumTable::create(4, variant.split_sum);
        PrefilterDescription of;
        of.variant = &variant;
        of.pixel = "float";
        of.levels.push_back(
            {0.0, EnvironmentGrid::create(EnvironmentLayout::cube_strip, 24, 4).value(), {}, file_record("b.exr", "")});
        of.levels.push_back({0.5,
                             EnvironmentGrid::create(EnvironmentLayout::cube_strip, 12, 2).value(),
                             {200.0, 1e-4, 3e-4, 24},
                             file_record("a.exr", "abc")});
        of.irradiance = of.levels.back();
        of.harmonics = IrradianceSh(std::vector<glm::dvec3>(16, glm::dvec3(0.1, 0.2, 0.3)));
        of.table_file = file_record("t.exr", "d");
        of.source = "a \xff.exr";
        auto json = nlohmann::json::parse(prefilter_sidecar(of, table));
        EXPECT_EQ(fits.complaint(json), "") << variant.name;
        EXPECT_TRUE(json["levels"][0]["error"].is_null());
        EXPECT_DOUBLE_EQ(json["levels"][1]["error"]["max_percent"].get<double>(), 0.03);
        EXPECT_EQ(json["roughness_to_level"]["last"], 1);
        EXPECT_EQ(json["spherical_harmonics"]["irradiance"][12][0], 0.0);
        EXPECT_EQ(json["files"].size(), 4U);
        of.sun = SunLight{direction_of({200.0, 30.0}), Lux(90e3), glm::dvec3(1.0), sun_diameter};
        of.source_sha256 = sha256("abc");
        json = nlohmann::json::parse(prefilter_sidecar(of, table));
        EXPECT_EQ(fits.complaint(json), "") << variant.name;
        // Shows that the check can fail.
        json["levels"][1]["roughness"] = 2;
        EXPECT_NE(fits.complaint(json), "");
    }
}

} // namespace
} // namespace gonio
