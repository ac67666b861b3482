// The luminaires in profiles/: all formats and dialects contain the same light, and as much of it as they declare.
#include <gonio/profile/read.hpp>
#include <gonio/web/compare.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/resolve.hpp>

#include "../folders.hpp"
#include "expect.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace gonio;
using namespace gonio::test;
using std::numbers::pi;

template<class File>
File authored(const std::string& name) {
    std::string path = test::source_folder;
    path += "/profiles/";
    path += name;
    const Result<Profile> read = read_profile_file(path, {{}, true});
    EXPECT_TRUE(read) << said(read);
    if (!read) return {};
    EXPECT_TRUE(read->diagnostics.empty()) << said(read);
    return std::get<File>(read->file);
}

// Flux by the composite midpoint rule on the interpolant, with `parts` by `parts` points per cell: independent of the
// closed form that scaled the table. The planes added by symmetry equal those in the table, so the table represents the
// whole circle.
double flux(const IesFile& file, int parts) {
    const std::size_t rows = file.vertical_deg.size();
    const std::size_t cells = std::max<std::size_t>(file.horizontal_deg.size() - 1, 1);
    double sum = 0.0;
    for (std::size_t p = 0; p < cells; ++p) {
        const std::size_t q = file.horizontal_deg.size() > 1 ? p + 1 : p;
        for (std::size_t g = 0; g + 1 < rows; ++g)
            for (int i = 0; i < parts; ++i) {
                const double t = (i + 0.5) / parts;
                const double step = (file.vertical_deg[g + 1] - file.vertical_deg[g]) * pi / 180.0;
                const double gamma = file.vertical_deg[g] * pi / 180.0 + t * step;
                const auto mean = [&](std::size_t row) {
                    return 0.5 * (file.candela[p * rows + row] + file.candela[q * rows + row]);
                };
                sum += ((1.0 - t) * mean(g) + t * mean(g + 1)) * std::sin(gamma) * step / parts;
            }
    }
    return sum * 2.0 * pi / static_cast<double>(cells);
}

// The zonal rule of the industry: mean candela times the zone's cosine difference.
double zonal_flux(const IesFile& file) {
    const std::size_t rows = file.vertical_deg.size();
    const std::size_t cells = std::max<std::size_t>(file.horizontal_deg.size() - 1, 1);
    double sum = 0.0;
    for (std::size_t p = 0; p < cells; ++p) {
        const std::size_t q = file.horizontal_deg.size() > 1 ? p + 1 : p;
        for (std::size_t g = 0; g + 1 < rows; ++g) {
            const double mean = 0.25 * (file.candela[p * rows + g] + file.candela[p * rows + g + 1] +
                                        file.candela[q * rows + g] + file.candela[q * rows + g + 1]);
            sum +=
                mean * (std::cos(file.vertical_deg[g] * pi / 180.0) - std::cos(file.vertical_deg[g + 1] * pi / 180.0));
        }
    }
    return sum * 2.0 * pi / static_cast<double>(cells);
}

struct Authored {
    const char* name;
    double flux_lm;
    int symmetry;
    IesVersion version;
};

class AuthoredProfiles : public testing::TestWithParam<Authored> {};

TEST_P(AuthoredProfiles, HoldTheLightTheyDeclareInBothFormats) {
    const Authored& p = GetParam();
    const auto ies = authored<IesFile>(std::string(p.name) + ".ies");
    const auto ldt = authored<LdtFile>(std::string(p.name) + ".ldt");
    EXPECT_EQ(ies.version, p.version);
    EXPECT_EQ(ies.lumens_per_lamp, p.flux_lm);
    EXPECT_EQ(ies.candela_multiplier * ies.ballast_factor * ies.lamp_count, 1.0);
    EXPECT_EQ(ldt.symmetry, p.symmetry);
    ASSERT_EQ(ldt.lamp_sets.size(), 1U);
    EXPECT_EQ(ldt.lamp_sets[0].flux_lm, p.flux_lm);
    EXPECT_EQ(ldt.gammas_deg, ies.vertical_deg);
    EXPECT_EQ(static_cast<std::size_t>(stored_plane_count(ldt.symmetry, ldt.plane_count)), ies.horizontal_deg.size());
    ASSERT_EQ(ldt.candela_per_klm.size(), ies.candela.size());
    for (std::size_t i = 0; i < ies.candela.size(); ++i)
        EXPECT_NEAR(ldt.candela_per_klm[i] * p.flux_lm / 1000.0, ies.candela[i], 1e-12 * ies.candela[i]) << i;
    EXPECT_NEAR(flux(ies, 200), p.flux_lm, 1e-6 * p.flux_lm);
    EXPECT_NEAR(zonal_flux(ies), p.flux_lm, 5e-3 * p.flux_lm);
    EXPECT_GT(ldt.direct_ratios.front(), 0.0);
    EXPECT_LT(ldt.direct_ratios.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(ldt.direct_ratios.begin(), ldt.direct_ratios.end()));
}

INSTANTIATE_TEST_SUITE_P(All, AuthoredProfiles,
                         testing::Values(Authored{"downlight", 1200, 1, IesVersion::lm63_2002},
                                         Authored{"wall-washer", 2500, 2, IesVersion::lm63_2002},
                                         Authored{"bare-tube", 3350, 4, IesVersion::lm63_2019}));

TEST(AuthoredProfilesDialects, OfOneNameAreOneLight) {
    int files = 0;
    for (const char* const name :
         {"accent", "bare-tube", "batwing", "downlight", "flood", "pendant", "street", "wall-washer"}) {
        const std::string folder = std::string(test::source_folder) + "/profiles/";
        const auto web_of = [&](const std::string& path) {
            const Result<Profile> read = read_profile_file(path);
            EXPECT_TRUE(read) << said(read);
            EXPECT_TRUE(read->diagnostics.empty()) << said(read);
            return resolve_web(*read)->web;
        };
        const Web own = web_of(folder + name + ".ies");
        for (const std::string& other :
             {folder + name + ".ldt", folder + name + ".xml", folder + "lm-63-1995/" + name + ".ies",
              folder + "lm-63-2002/" + name + ".ies", folder + "lm-63-2019/" + name + ".ies",
              folder + "portable/" + name + ".ies"}) {
            const Web web = web_of(other);
            // Seven digits of cd/klm, nine in the portable dialect; the flood is resampled for formats that store only
            // type C.
            const bool resampled = web.photometry() != own.photometry();
            EXPECT_EQ(resampled, std::string_view(name) == "flood" && other.find(".xml") == std::string::npos &&
                                     other.find("lm-63-") == std::string::npos);
            EXPECT_LE(difference(own, web).relative, resampled ? 0.035 : 1e-7) << other;
            EXPECT_NEAR(gonio::flux(web).value, gonio::flux(own).value,
                        (resampled ? 1e-3 : 1e-7) * gonio::flux(own).value)
                << other;
            ++files;
        }
    }
    EXPECT_EQ(files, 48);
}

TEST(AuthoredProfilesShape, AreWhatTheirNamesSay) {
    const auto down = authored<IesFile>("downlight.ies");
    EXPECT_NEAR(down.candela[15] / down.candela[0], 0.5, 0.01); // 30° between the halves of the peak
    EXPECT_EQ(down.candela.back(), 0.0);

    const auto wash = authored<IesFile>("wall-washer.ies");
    const auto peak = std::max_element(wash.candela.begin(), wash.candela.end()) - wash.candela.begin();
    EXPECT_LT(peak, 37); // in the first plane, C0
    EXPECT_NEAR(wash.vertical_deg[static_cast<std::size_t>(peak)], 32.5, 2.6);
    EXPECT_GT(wash.candela[14], 20.0 * wash.candela[36 * 37 + 14]); // at 35°: C0 against C180

    const auto tube = authored<IesFile>("bare-tube.ies");
    const double end_on = tube.candela[45];            // C0, γ = 90°: along the axis
    const double side_on = tube.candela[18 * 91 + 45]; // C90
    EXPECT_NEAR(side_on / end_on, (2 * 0.013 * 1.2 + pi * 0.013 * 0.013) / (pi * 0.013 * 0.013), 1e-4);
    // The luminance implied by the table's intensity and the one implied by the flux, Φ = π (2π r l + 4π r²) L.
    const double luminance = 3350.0 / (pi * (2 * pi * 0.013 * 1.2 + 4 * pi * 0.013 * 0.013));
    EXPECT_NEAR(side_on / (2 * 0.013 * 1.2 + pi * 0.013 * 0.013), luminance, 2e-3 * luminance);
}

} // namespace
