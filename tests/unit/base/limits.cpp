#include <gonio/base/kind_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/picture_size.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>

namespace gonio {
namespace {

std::string refusal(const Result<void>& checked) {
    return checked ? "no failure" : checked.error().diagnostics.back().message;
}

TEST(Limits, EachHasItsNameAndSaysWhatItIs) {
    std::set<std::string_view> names;
    for (const Limit& known : limits) {
        EXPECT_TRUE(names.insert(known.name).second) << known.name;
        EXPECT_GT(known.value, 0U) << known.name;
        EXPECT_FALSE(known.says.empty()) << known.name;
    }
    EXPECT_EQ(to_text(limit("kind-bytes")), "16 KiB, the limit 'kind-bytes'");
    EXPECT_EQ(to_text(limit("profile-bytes")), "16 MiB, the limit 'profile-bytes'");
    EXPECT_EQ(to_text(limit("kind-keys")), "64 keys, the limit 'kind-keys'");
}

TEST(Limits, PicturesHaveOneForTheirPixelsAndOneForTheirSides) {
    EXPECT_TRUE(check_picture_size(1, 1));
    EXPECT_TRUE(check_picture_size(16384, 16384));
    EXPECT_EQ(refusal(check_picture_size(32768, 8193, limit("texture-side"))),
              "a picture of 32768x8193 pixels is out of range: it may have up to 268435456 pixels, the limit "
              "'picture-pixels'");
    EXPECT_EQ(refusal(check_picture_size(16385, 1)),
              "a picture of 16385x1 pixels is out of range: a side may have 1 to "
              "16384 pixels, the limit 'picture-side'");
    EXPECT_FALSE(check_picture_size(0, 5));
    EXPECT_FALSE(check_picture_size(5, -1));
    EXPECT_TRUE(check_picture_size(32768, 8192, limit("texture-side")));
    EXPECT_FALSE(check_picture_size(2147483647, 2147483647));
}

// A text with so many keys that it would take long is refused before the work starts.
TEST(Limits, KindTextsHaveOneForTheirLengthAndOneForTheirKeys) {
    const auto keys = [](int count) {
        std::string text = "sphere:";
        for (int i = 0; i < count; ++i)
            text += fmt::format("{}k{}=1", i > 0 ? "," : "", i);
        return text;
    };
    EXPECT_TRUE(parse_kind_text(keys(64)));
    const Result<KindText> many = parse_kind_text(keys(65));
    ASSERT_FALSE(many);
    EXPECT_EQ(many.error().diagnostics.back().message, "'sphere' has more than 64 keys, the limit 'kind-keys'");
    EXPECT_TRUE(parse_kind_text("sphere:a=" + std::string(16000, '(')));
    const Result<KindText> longer = parse_kind_text("sphere:a=" + std::string(2000000, '('));
    ASSERT_FALSE(longer);
    EXPECT_EQ(longer.error().diagnostics.back().message, "the text is longer than 16 KiB, the limit 'kind-bytes'");
}

} // namespace
} // namespace gonio
