// The conversion matrix: every real profile into every format and dialect, and from there into every other one. The
// result must be the same light as the source.
#include <gonio/profile/read.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/metrics.hpp>
#include <gonio/web/resample.hpp>
#include <gonio/web/to_profile.hpp>

#include "../folders.hpp"
#include "../profile/equal.hpp"
#include "../scaled.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace gonio;
namespace fs = std::filesystem;

constexpr std::array every_target{ProfileTarget::lm63_1995, ProfileTarget::lm63_2002, ProfileTarget::lm63_2019,
                                  ProfileTarget::portable,  ProfileTarget::eulumdat,  ProfileTarget::tm33};

struct Cell {
    int files = 0;
    double worst = 0.0;      // greatest difference relative to the peak
    double worst_flux = 0.0; // relative
    std::string where;
};

struct Written {
    Profile profile;
    Web web;
};

// Converts, writes, reads and resolves; fails the test if any of these steps fails.
void convert_into(const Profile& profile, ProfileTarget target, std::vector<Written>& out) {
    const Result<MadeProfile> made = convert_profile(profile, target);
    ASSERT_TRUE(made) << profile.source << ": " << to_text(made.error().diagnostics.back());
    const Result<Profile> read = read_profile(write_profile(made->profile, target), profile.source);
    ASSERT_TRUE(read) << profile.source << " as " << to_text(target) << ": "
                      << to_text(read.error().diagnostics.back());
    Result<ResolvedWeb> resolved = resolve_web(*read);
    ASSERT_TRUE(resolved) << profile.source << " as " << to_text(target) << ": "
                          << to_text(resolved.error().diagnostics.back());
    out.push_back({*read, std::move(resolved->web)});
}

void note(Cell& cell, const Web& source, const Web& made, const std::string& path) {
    const ConversionError error = conversion_error(source, made);
    const double lm = flux(source).value;
    ++cell.files;
    if (error.relative > cell.worst) cell.where = path;
    cell.worst = std::max(cell.worst, error.relative);
    if (lm > 0.0) cell.worst_flux = std::max(cell.worst_flux, std::abs(flux(made).value / lm - 1.0));
}

// The error of resampling to type C, and the error of what is read back, which also includes directions where the table
// itself has several values, at a pole of its goniometer.
std::string entry_for_other_type(const Web& source, const std::vector<Written>& made, const std::string& path) {
    const ResampledWeb of_type_c = *resampled_to_c(source);
    const double bright = peak(source).intensity.value;
    EXPECT_LE(of_type_c.max_error.value, 2.0 * resampling_tolerance * bright) << path;
    std::array<char, 128> text{};
    std::snprintf(text.data(), text.size(), ", type %c resampled to C %.1e (at its own jumps %.1e):",
                  source.photometry() == Photometry::a ? 'A' : 'B', of_type_c.max_error.value / bright,
                  of_type_c.jump_error.value / bright);
    std::string line = fs::path(path).filename().string() + text.data();
    for (std::size_t i = 0; i < made.size(); ++i) {
        const ConversionError error = conversion_error(source, made[i].web);
        const double lm = flux(source).value;
        const double flux_error = std::abs(flux(made[i].web).value - lm) / lm;
        const bool resampled = made[i].web.photometry() == Photometry::c;
        EXPECT_LE(error.relative,
                  resampled ? 2.0 * resampling_tolerance + 1.3 * of_type_c.jump_error.value / bright : 1e-12)
            << path << " as " << to_text(every_target[i]);
        EXPECT_LE(flux_error, resampled ? 1e-3 : 1e-9) << path << " as " << to_text(every_target[i]);
        std::snprintf(text.data(), text.size(), " %s %.1e (flux %.1e)", to_text(every_target[i]), error.relative,
                      flux_error);
        line += text.data();
    }
    return line + "\n";
}

TEST(ConvertCorpus, EveryPairOfFormatsKeepsTheLight) {
    const fs::path folder = fs::path(test::corpus_folder) / "good";
    if (std::string(test::corpus_folder).empty() || !fs::is_directory(folder))
        GTEST_SKIP() << "no folder of real profiles: set GONIO_CORPUS";
    std::vector<std::string> paths;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.is_regular_file()) paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());

    std::array<Cell, every_target.size()> direct;
    std::array<std::array<Cell, every_target.size()>, every_target.size()> matrix;
    std::string other_types;
    int of_type_c = 0;
    for (const std::string& path : paths) {
        const Result<Profile> read = read_profile_file(path);
        ASSERT_TRUE(read) << path;
        const Result<ResolvedWeb> source = resolve_web(*read);
        ASSERT_TRUE(source) << path;
        std::vector<Written> first;
        for (const ProfileTarget target : every_target)
            ASSERT_NO_FATAL_FAILURE(convert_into(*read, target, first));
        if (source->web.photometry() != Photometry::c) {
            // Exact between the editions of one format; EULUMDAT and the portable dialect are resampled.
            other_types += entry_for_other_type(source->web, first, path);
            continue;
        }
        ++of_type_c;
        const bool has_pairs = !test::is_sanitized || of_type_c % 4 == 1;
        for (std::size_t i = 0; i < first.size(); ++i) {
            note(direct[i], source->web, first[i].web, path);
            if (!has_pairs) continue;
            std::vector<Written> second;
            for (const ProfileTarget target : every_target)
                ASSERT_NO_FATAL_FAILURE(convert_into(first[i].profile, target, second));
            for (std::size_t j = 0; j < second.size(); ++j)
                note(matrix[i][j], source->web, second[j].web, path);
        }
    }

    std::printf("greatest difference by the peak, %d files of type C\n", of_type_c);
    std::printf("%12s %12s", "from \\ to", "");
    for (const ProfileTarget target : every_target)
        std::printf(" %11s", to_text(target));
    std::printf("\n%12s %12s", "the file", "");
    for (const Cell& cell : direct)
        std::printf(" %11.1e", cell.worst);
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        std::printf("\n%12s %12s", to_text(every_target[i]), "");
        for (const Cell& cell : matrix[i])
            std::printf(" %11.1e", cell.worst);
    }
    std::printf("\n%s", other_types.c_str());
    for (std::size_t j = 0; j < every_target.size(); ++j) {
        EXPECT_LE(direct[j].worst, 1e-6) << to_text(every_target[j]) << ": " << direct[j].where;
        EXPECT_LE(direct[j].worst_flux, 1e-4) << to_text(every_target[j]);
        for (std::size_t i = 0; i < every_target.size(); ++i) {
            EXPECT_LE(matrix[i][j].worst, 1e-6)
                << to_text(every_target[i]) << " to " << to_text(every_target[j]) << ": " << matrix[i][j].where;
            EXPECT_LE(matrix[i][j].worst_flux, 1e-4) << to_text(every_target[i]) << " to " << to_text(every_target[j]);
        }
    }
}

// Conversion into a file's own format keeps every field.
TEST(ConvertCorpus, TheOwnFormatKeepsEveryField) {
    const fs::path folder = fs::path(test::corpus_folder) / "good";
    if (std::string(test::corpus_folder).empty() || !fs::is_directory(folder))
        GTEST_SKIP() << "no folder of real profiles: set GONIO_CORPUS";
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        Result<Profile> read = read_profile_file(entry.path().string());
        ASSERT_TRUE(read) << entry.path();
        const bool ies = std::holds_alternative<IesFile>(read->file);
        const ProfileTarget target = ies ? ProfileTarget::lm63 : *target_of(*read);
        const Result<MadeProfile> made = convert_profile(*read, target);
        ASSERT_TRUE(made) << entry.path();
        const Result<Profile> again = read_profile(write_profile(made->profile, target), "again");
        ASSERT_TRUE(again) << entry.path();
        // A round light whose file does not state it is written as one.
        if (auto* const ldt = std::get_if<LdtFile>(&read->file); ldt != nullptr && ldt->planes_deg.size() == 1)
            ldt->symmetry = 1;
        EXPECT_TRUE(test::equal(read->file, again->file)) << entry.path();
    }
}

} // namespace
