// Sidecars of environment images, checked against the schema in the tree.
#include <gonio/asset/content_hash.hpp>
#include <gonio/asset/environment_sidecar.hpp>
#include <gonio/base/file.hpp>

#include "../folders.hpp"
#include "json_schema.hpp"

#include <gtest/gtest.h>

namespace gonio {
namespace {

TEST(EnvironmentSidecar, FitsTheSchema) {
    const std::string path = std::string(test::source_folder) + "/lib/gonio/asset/environment.schema.json";
    const test::JsonSchema fits(nlohmann::json::parse(read_file(path).value()));
    for (const EnvironmentLayoutInfo& layout : environment_layouts()) {
        EnvironmentDescription of;
        of.grid = EnvironmentGrid::create(layout.layout, 8 * layout.across, 8 * layout.down).value();
        of.nits_per_unit = 2.5;
        of.pixel = "half";
        of.source = "a \xff.exr";
        auto json = nlohmann::json::parse(environment_sidecar(of));
        EXPECT_EQ(fits.complaint(json), "") << layout.name;
        EXPECT_EQ(json["nits_per_unit"], 2.5);
        EXPECT_TRUE(json["sun"].is_null());
        of.sun = SunLight{direction_of({200.0, 30.0}), Lux(90e3), glm::dvec3(1.0), sun_diameter};
        of.source_sha256 = sha256("abc");
        of.file = file_record("sky.exr", "abc");
        of.measures.horizontal = Lux(123.0);
        json = nlohmann::json::parse(environment_sidecar(of));
        EXPECT_EQ(fits.complaint(json), "") << layout.name;
        EXPECT_EQ(json["horizontal_lx"], 123.0);
        EXPECT_NEAR(json["sun"]["azimuth_deg"].get<double>(), 200.0, 1e-12);
        // Shows that the check can fail.
        json["nits_per_unit"] = -1;
        EXPECT_NE(fits.complaint(json), "");
    }
}

} // namespace
} // namespace gonio
