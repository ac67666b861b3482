// Pieces of text of scenes against the library that writes JSON.
#include <gonio/asset/detail/scene_text.hpp>
#include <gonio/base/json.hpp>

#include <gtest/gtest.h>

#include <string>

namespace gonio {
namespace {

TEST(SceneText, QuotesAsJsonDoes) {
    std::string all;
    for (int c = 1; c < 128; ++c)
        all += static_cast<char>(c);
    for (const std::string& text :
         {all, all.substr(0x1f, 0x5f), std::string("0 12.5 90\n"), std::string("\"a\\b\"\n"), std::string(),
          std::string("\u00e9clairage \u4e2d\n"), std::string("a\0b", 3), std::string("\t\x7f")})
        EXPECT_EQ(asset_detail::quoted(text), detail::Json(text).dump(-1, true)) << text;
}

} // namespace
} // namespace gonio
