#include <gonio/base/kind_text.hpp>

#include <gtest/gtest.h>

#include <array>

namespace gonio {
namespace {

TEST(KindText, KeepsParenthesesTogether) {
    const auto parsed = parse_kind_text("frostbite:base=rgb(0.1,0.2,0.3),metal=1,two-sided");
    ASSERT_TRUE(parsed);
    EXPECT_EQ(parsed->kind, "frostbite");
    ASSERT_EQ(parsed->entries.size(), 3U);
    EXPECT_EQ(*parsed->value("base"), "rgb(0.1,0.2,0.3)");
    EXPECT_EQ(*parsed->value("metal"), "1");
    EXPECT_EQ(parsed->value("two-sided"), nullptr);
    EXPECT_EQ(parsed->entries[2].key, "two-sided");
}

TEST(KindText, HasNoEntriesWhenNothingFollowsTheColon) {
    for (const char* text : {"frostbite", "frostbite:"}) {
        const auto parsed = parse_kind_text(text);
        ASSERT_TRUE(parsed) << text;
        EXPECT_EQ(parsed->kind, "frostbite");
        EXPECT_TRUE(parsed->entries.empty());
    }
}

TEST(KindText, RefusesEmptyAndRepeatedKeys) {
    for (const char* text : {"", ":", ":r=1", "sphere:r=1,r=2", "sphere:,r=1", "sphere:r=1,", "sphere:,", "sphere:=1"})
        EXPECT_FALSE(parse_kind_text(text)) << text;
}

TEST(KindText, NamesTheNearestKey) {
    constexpr std::array<std::string_view, 2> keys{"smoothness", "metal"};
    const auto checked = only_keys(*parse_kind_text("frostbite:smoothnes=1"), keys);
    ASSERT_FALSE(checked);
    EXPECT_NE(checked.error().diagnostics.back().hint.find("'smoothness'"), std::string::npos);
}

} // namespace
} // namespace gonio
