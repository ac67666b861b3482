#include <gonio/base/json_text.hpp>
#include <gonio/base/limits.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace gonio {
namespace {

std::string refusal(const std::string& text) {
    const Result<detail::Json> json = detail::parse_json(text, "x.json");
    if (json) return "no failure";
    EXPECT_EQ(json.error().failure, Failure::malformed);
    return to_text(json.error().diagnostics.back());
}

std::string repeated(const std::string& text, std::size_t times) {
    std::string all;
    for (std::size_t i = 0; i < times; ++i)
        all += text;
    return all;
}

TEST(JsonText, ReadsEveryKindOfValueInItsOrder) {
    const std::string text = R"({"z":[1,-2,0.5,true,false,null,"é",[],{}],"a":{"b":{"c":18446744073709551615}}})";
    EXPECT_EQ(detail::parse_json(text)->dump(), text);
    EXPECT_EQ(*detail::parse_json(" 7\n"), 7);
    EXPECT_EQ(detail::parse_json(R"({"a":1,"a":2})")->dump(), R"({"a":2})");
    EXPECT_EQ(detail::parse_json("\xef\xbb\xbf[1]")->dump(), "[1]");
}

TEST(JsonText, BrokenTextIsPlacedAndNotQuoted) {
    EXPECT_EQ(refusal(""),
              "x.json:1:1: error[INP0101]: the JSON ends too early\nhint: expected '[', '{', or a literal");
    EXPECT_EQ(refusal("{\n \"a\": secret }"), "x.json:2:7: error[INP0101]: broken JSON: invalid literal");
    EXPECT_EQ(refusal("root:x:0:0"), "x.json:1:1: error[INP0101]: broken JSON: invalid literal");
    EXPECT_EQ(refusal("[1e999]"), "x.json:1:2: error[INP0101]: the number 1e999 is too large");
}

TEST(JsonText, DepthIsLimitedWithItsPlace) {
    const std::size_t most = limit("json-depth").value;
    EXPECT_TRUE(detail::parse_json(repeated("[", most) + repeated("]", most)));
    EXPECT_EQ(refusal("\n" + repeated("[", most + 1) + repeated("]", most + 1)),
              "x.json:2:65: error[INP0101]: nested deeper than 64 levels, the limit 'json-depth'\n"
              "hint: 'gonio list limits' describes each limit");
    EXPECT_EQ(refusal(repeated("{\"a\":", 100000)).substr(0, 42), "x.json:1:321: error[INP0101]: nested deepe");
    EXPECT_EQ(refusal(repeated("[", 1000000)).substr(0, 28), "x.json:1:65: error[INP0101]:");
}

TEST(JsonText, KeysAndValuesAreLimited) {
    std::string many = "{";
    for (std::size_t i = 0; i <= limit("json-keys").value; ++i)
        many += (i > 0 ? ",\n\"k" : "\"k") + std::to_string(i) + "\":0";
    EXPECT_EQ(refusal(many + "}").substr(0, 88),
              "x.json:1025:7: error[INP0101]: an object has more than 1024 keys, the limit 'json-keys'\n");
    const std::size_t most = limit("json-values").value;
    EXPECT_TRUE(detail::parse_json("[" + repeated("0,", most - 2) + "0]"));
    EXPECT_NE(refusal("[" + repeated("0,", most - 1) + "0]").find("the limit 'json-values'"), std::string::npos);
}

} // namespace
} // namespace gonio
