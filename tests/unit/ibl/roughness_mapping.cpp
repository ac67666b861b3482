#include <gonio/ibl/roughness_mapping.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace gonio {
namespace {

TEST(RoughnessMapping, GoesThereAndBack) {
    constexpr int last = 7;
    for (const RoughnessMappingInfo& info : roughness_mappings())
        for (int level = 0; level <= last; ++level) {
            const double roughness = roughness_of(info.mapping, level, last);
            if (roughness < 1.0) {
                EXPECT_NEAR(level_of(info.mapping, roughness, last), level, 1e-12) << info.name;
            }
        }
}

TEST(RoughnessMapping, IsThatOfTheEngines) {
    EXPECT_DOUBLE_EQ(level_of(RoughnessMapping::linear, 0.25, 4), 1.0);
    EXPECT_DOUBLE_EQ(level_of(RoughnessMapping::filament, 0.5, 4), 3.0);
    EXPECT_DOUBLE_EQ(level_of(RoughnessMapping::frostbite, 0.25, 4), 2.0);
    // Eight levels of a cube of 128: roughness 1 is the level of 4×4 texels.
    EXPECT_DOUBLE_EQ(level_of(RoughnessMapping::ue4, 1.0, 7), 5.0);
    EXPECT_DOUBLE_EQ(level_of(RoughnessMapping::ue4, 0.5, 7), 3.8);
    EXPECT_DOUBLE_EQ(roughness_of(RoughnessMapping::ue4, 0.0, 7), std::exp2(-5.0 / 1.2));
    EXPECT_DOUBLE_EQ(roughness_of(RoughnessMapping::ue4, 7.0, 7), 1.0);
}

TEST(RoughnessMapping, HasOneLevelAtLeast) {
    for (const RoughnessMappingInfo& info : roughness_mappings()) {
        EXPECT_EQ(level_of(info.mapping, 0.7, 0), 0.0) << info.name;
        EXPECT_GE(roughness_of(info.mapping, 0.0, 0), 0.0) << info.name;
    }
}

TEST(RoughnessMapping, IsFoundByItsName) {
    for (const RoughnessMappingInfo& info : roughness_mappings())
        EXPECT_EQ(*parse_roughness_mapping(info.name), info.mapping);
    EXPECT_FALSE(parse_roughness_mapping("unreal"));
}

} // namespace
} // namespace gonio
