// Webs and headers written into files and read again, with the diagnostics.
#pragma once

#include <gonio/profile/read.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/to_profile.hpp>

#include "../said.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace gonio::test {

inline constexpr ProfileTarget every_target[] = {ProfileTarget::lm63_1995, ProfileTarget::lm63_2002,
                                                 ProfileTarget::lm63_2019, ProfileTarget::portable,
                                                 ProfileTarget::eulumdat,  ProfileTarget::tm33};

inline bool says(const Diagnostics& diagnostics, std::string_view code, std::string_view part = {}) {
    return std::any_of(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& diagnostic) {
        return diagnostic.code == code && diagnostic.message.find(part) != std::string::npos;
    });
}

// Made, written, read and resolved again.
struct RoundTrip {
    MadeProfile made;
    Profile read;
    Web web;
};

inline RoundTrip round_trip(const Web& web, const ProfileHeader& header, ProfileTarget target) {
    Result<MadeProfile> made = to_profile(web, header, target);
    EXPECT_TRUE(made);
    Result<Profile> read = read_profile(write_profile(made->profile, target), "written");
    EXPECT_TRUE(read) << said(read.error().diagnostics);
    Result<ResolvedWeb> resolved = resolve_web(*read);
    EXPECT_TRUE(resolved) << said(resolved.error().diagnostics);
    return {*made, *read, resolved->web};
}

} // namespace gonio::test
