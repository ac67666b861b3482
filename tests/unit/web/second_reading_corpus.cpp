// Every real profile against the second reader: flux, peak and intensities in random directions.
#include <gonio/base/file.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/resolve.hpp>

#include "../folders.hpp"
#include "second_reading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

namespace gonio {
namespace {

namespace fs = std::filesystem;

// The two readers round differently, by about 1e-13. In a steep cell the rounding of the angle matters (acos near a
// pole: 1e-8 rad), so the directions here avoid such places.
constexpr double limit = 1e-9;

void expect_same_light(const std::string& bytes, const std::string& name) {
    const Result<Profile> profile = read_profile(bytes, name);
    ASSERT_TRUE(profile) << name << ": " << to_text(profile.error().diagnostics.back());
    const Result<ResolvedWeb> resolved = resolve_web(*profile);
    ASSERT_TRUE(resolved) << name;
    const Web& web = resolved->web;
    const test::SecondReading second = test::second_reading(bytes);
    EXPECT_EQ(web.photometry() == Photometry::a ? 'A' : web.photometry() == Photometry::b ? 'B' : 'C', second.type);
    const double peak_cd = second.peak_cd();
    EXPECT_NEAR(peak(web).intensity.value, peak_cd, limit * std::abs(peak_cd)) << name;
    const double flux_lm = second.flux_lm();
    EXPECT_NEAR(flux(web).value, flux_lm, limit * std::abs(flux_lm)) << name;
    std::mt19937 random(20261121);
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
    double worst = 0.0;
    for (int i = 0; i < 500; ++i) {
        const double z = 1.998 * uniform() - 0.999;
        const double turn = 2.0 * std::numbers::pi * uniform();
        const double ring = std::sqrt(1.0 - z * z);
        const glm::dvec3 along{ring * std::cos(turn), ring * std::sin(turn), z};
        worst = std::max(worst, std::abs(web.candela(along) - second.candela_along(along.x, along.y, along.z)));
    }
    EXPECT_LE(worst, limit * std::abs(peak_cd)) << name;
}

std::vector<std::string> good_files() {
    std::vector<std::string> paths;
    const fs::path folder = fs::path(test::corpus_folder) / "good";
    if (std::string(test::corpus_folder).empty() || !fs::is_directory(folder)) return paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file()) paths.push_back(entry.path().string());
    return paths;
}

TEST(SecondReading, FindsTheLightOfEveryRealProfile) {
    const std::vector<std::string> paths = good_files();
    if (paths.empty()) GTEST_SKIP() << "no folder of real profiles: set GONIO_CORPUS";
    for (const std::string& path : paths) {
        const Result<std::string> bytes = read_file(path);
        ASSERT_TRUE(bytes) << path;
        ASSERT_NO_FATAL_FAILURE(expect_same_light(*bytes, path));
    }
}

// Replaces number `index` after the TILT line.
std::string with_number(std::string bytes, std::size_t index, const std::string& number) {
    constexpr const char* blanks = " \t\r\n,";
    std::size_t at = bytes.find_first_of("\r\n", bytes.find("TILT="));
    for (;; --index) {
        at = bytes.find_first_not_of(blanks, at);
        const std::size_t end = bytes.find_first_of(blanks, at);
        if (index == 0) return bytes.replace(at, end - at, number);
        at = end;
    }
}

// Few real files are of type B and none of type A, so other tables are read as those types.
TEST(SecondReading, FindsTheLightOfTypesAAndB) {
    int of_type_b = 0;
    for (const std::string& path : good_files()) {
        const Result<std::string> bytes = read_file(path);
        ASSERT_TRUE(bytes) << path;
        if (bytes->find("TILT=NONE") == std::string::npos) continue;
        const Result<Profile> profile = read_profile(*bytes, path);
        ASSERT_TRUE(profile) << path;
        const auto* const file = std::get_if<IesFile>(&profile->file);
        if (file == nullptr || file->photometry != Photometry::b) continue;
        ++of_type_b;
        ASSERT_NO_FATAL_FAILURE(expect_same_light(with_number(*bytes, 5, "3"), path + " as type A"));
    }
    // One of the project's own profiles, as all three types.
    const Result<std::string> flood = read_file(std::string(test::source_folder) + "/profiles/flood.ies");
    ASSERT_TRUE(flood);
    ASSERT_NO_FATAL_FAILURE(expect_same_light(*flood, "flood.ies"));
    ASSERT_NO_FATAL_FAILURE(expect_same_light(with_number(*flood, 5, "3"), "flood.ies as type A"));
    ASSERT_NO_FATAL_FAILURE(expect_same_light(with_number(*flood, 5, "1"), "flood.ies as type C"));
    if (!good_files().empty()) {
        EXPECT_GT(of_type_b, 0);
    }
}

} // namespace
} // namespace gonio
