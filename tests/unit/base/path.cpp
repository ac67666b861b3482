#include <gonio/base/path.hpp>

#include <gtest/gtest.h>

namespace gonio {
namespace {

struct Parts {
    const char* path;
    const char* name;
    const char* extension;
    const char* without;
};

TEST(Path, HasANameAndAnExtension) {
    for (const Parts& parts : {Parts{"lamp.ies", "lamp.ies", "ies", "lamp"},
                               {"a.b/lamp", "lamp", "", "a.b/lamp"},
                               {"/a/lamp.v2.LDT", "lamp.v2.LDT", "LDT", "/a/lamp.v2"},
                               {"a/.ies", ".ies", "", "a/.ies"},
                               {"a/lamp.", "lamp.", "", "a/lamp"},
                               {"a/", "", "", "a/"},
                               {"", "", "", ""}}) {
        EXPECT_EQ(file_name(parts.path), parts.name);
        EXPECT_EQ(extension_of(parts.path), parts.extension) << parts.path;
        EXPECT_EQ(without_extension(parts.path), parts.without) << parts.path;
    }
}

} // namespace
} // namespace gonio
