#include <gonio/media/detail/open_module.hpp>
#include <gonio/media/module.hpp>

#include "../folders.hpp"

#include <gtest/gtest.h>

#include <string>

namespace gonio::media {
namespace {

using detail::color_module_name;
using detail::image_module_name;
using detail::open_module;
using detail::pdf_module_name;

const std::string fakes = test::fakes_folder;

const Diagnostic& reason(const Result<const void*>& result) {
    return result.error().diagnostics.back();
}

TEST(MediaModule, AllOpenFromTheirFolder) {
    for (const auto& name : {image_module_name, detail::writers_module_name, color_module_name, pdf_module_name}) {
        const auto table = open_module(name, {"/nonexistent", test::modules_folder});
        ASSERT_TRUE(table) << reason(table).message;
        EXPECT_NE(*table, nullptr);
    }
}

TEST(MediaModule, AMissingOneIsNamedWithThePlacesThatWereSearched) {
    const auto table = open_module(image_module_name, {"/nonexistent", "/nowhere/lib"});
    ASSERT_FALSE(table);
    EXPECT_EQ(table.error().failure, Failure::unsupported);
    EXPECT_EQ(reason(table).message,
              "the module gonio-image.so (OpenImageIO) is missing; looked in /nonexistent, /nowhere/lib");
    EXPECT_EQ(reason(table).hint,
              "install the package gonio-media, or put the module beside the tool or into lib/gonio");
    EXPECT_FALSE(open_module(color_module_name, {}));
}

TEST(MediaModule, AnotherVersionIsRefused) {
    const auto table = open_module(image_module_name, {fakes + "/other-version"});
    ASSERT_FALSE(table);
    EXPECT_EQ(table.error().failure, Failure::unsupported);
    EXPECT_EQ(reason(table).message,
              "the module gonio-image.so belongs to another version of gonio: its interface has version 4711, not 4");
}

TEST(MediaModule, WhatIsNoModuleIsRefused) {
    // The fake library has only the image module's function.
    const auto other = open_module(color_module_name, {fakes + "/other-version"});
    ASSERT_FALSE(other);
    EXPECT_NE(reason(other).message.find("it has no gonio_color_module"), std::string::npos);

    const auto text = open_module(image_module_name, {fakes + "/no-library"});
    ASSERT_FALSE(text);
    EXPECT_EQ(text.error().failure, Failure::unsupported);
    EXPECT_NE(reason(text).message.find("cannot be loaded"), std::string::npos);
    EXPECT_NE(reason(text).hint.find("libopenimageio"), std::string::npos);
}

TEST(MediaModule, FoldersSetByTheProgramComeFirst) {
    set_module_folders({"/first", "/second"});
    const auto folders = module_folders();
    ASSERT_GE(folders.size(), 4U);
    EXPECT_EQ(folders[0], "/first");
    EXPECT_EQ(folders[1], "/second");
    EXPECT_NE(folders[3].find("lib"), std::string::npos);
    set_module_folders({});
}

} // namespace
} // namespace gonio::media
