#include <gonio/profile/read.hpp>
#include <gonio/web/integrate.hpp>
#include <gonio/web/resolve.hpp>
#include <gonio/web/to_profile.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

namespace gonio {
namespace {

Profile ies(IesVersion version, std::vector<double> planes, std::vector<double> candela) {
    IesFile file;
    file.version = version;
    file.vertical_deg = {0, 90};
    file.horizontal_deg = std::move(planes);
    file.candela = std::move(candela);
    return {"test.ies", file, {}};
}

bool has_code(const Diagnostics& diagnostics, std::string_view code) {
    for (const Diagnostic& diagnostic : diagnostics)
        if (diagnostic.code == code) return true;
    return false;
}

TEST(Resolve, AppliesEveryFactorOnce) {
    Profile profile = ies(IesVersion::lm63_1991, {0}, {100, 50});
    auto& file = std::get<IesFile>(profile.file);
    file.candela_multiplier = 2.0;
    file.ballast_factor = 0.9;
    file.field_12 = 0.95;
    EXPECT_DOUBLE_EQ(resolve_web(profile)->web.candela(0, 0), 100 * 2.0 * 0.9 * 0.95);
}

TEST(Resolve, TheTwelfthFieldIsAFactorOnlyInItsEditions) {
    for (const IesVersion version : {IesVersion::lm63_1986, IesVersion::lm63_1991}) {
        Profile profile = ies(version, {0}, {100, 50});
        std::get<IesFile>(profile.file).field_12 = 1.1;
        EXPECT_DOUBLE_EQ(resolve_web(profile)->web.candela(0, 0), 110.00000000000001);
    }
    for (const IesVersion version : {IesVersion::lm63_1995, IesVersion::lm63_2002, IesVersion::lm63_2019}) {
        Profile profile = ies(version, {0}, {100, 50});
        std::get<IesFile>(profile.file).field_12 = 1.1;
        const auto resolved = resolve_web(profile);
        EXPECT_DOUBLE_EQ(resolved->web.candela(0, 0), 100.0);
        EXPECT_EQ(has_code(resolved->diagnostics, "WEB0104"), version != IesVersion::lm63_2019);
    }
}

TEST(Resolve, TiltAppliesAtTheAskedAngle) {
    Profile profile = ies(IesVersion::lm63_2002, {0}, {100, 50});
    auto& file = std::get<IesFile>(profile.file);
    file.tilt_keyword = "INCLUDE";
    file.tilt = {1, {0, 90}, {1.0, 0.8}};
    EXPECT_DOUBLE_EQ(resolve_web(profile)->web.candela(0, 0), 100.0);
    EXPECT_DOUBLE_EQ(resolve_web(profile, {1, 45.0})->web.candela(0, 0), 90.0);
    EXPECT_DOUBLE_EQ(resolve_web(profile, {1, 120.0})->web.candela(0, 0), 80.0);
}

TEST(Resolve, ReadsSymmetryFromTheAngles) {
    EXPECT_EQ(resolve_web(ies(IesVersion::lm63_2002, {0}, {1, 1}))->web.stored_symmetry(), Symmetry::axial);
    EXPECT_EQ(resolve_web(ies(IesVersion::lm63_2002, {0, 90}, {1, 1, 1, 1}))->web.stored_symmetry(),
              Symmetry::quadrant);
    EXPECT_EQ(resolve_web(ies(IesVersion::lm63_2002, {0, 90, 180}, {1, 1, 1, 1, 1, 1}))->web.stored_symmetry(),
              Symmetry::bilateral_0_180);
    EXPECT_EQ(resolve_web(ies(IesVersion::lm63_2002, {90, 180, 270}, {1, 1, 1, 1, 1, 1}))->web.stored_symmetry(),
              Symmetry::bilateral_90_270);
    EXPECT_EQ(resolve_web(ies(IesVersion::lm63_2002, {0, 180, 360}, {1, 1, 1, 1, 1, 1}))->web.stored_symmetry(),
              Symmetry::none);
    EXPECT_TRUE(has_code(resolve_web(ies(IesVersion::lm63_2002, {205}, {1, 1}))->diagnostics, "WEB0103"));
    // 90° after rounding to float.
    EXPECT_EQ(resolve_web(ies(IesVersion::lm63_2002, {0, 90.0000001}, {1, 1, 1, 1}))->web.stored_symmetry(),
              Symmetry::quadrant);
}

TEST(Resolve, PlanesNextToEachOtherStayApart) {
    for (const std::vector<double>& planes :
         {std::vector<double>{0, 1e-8}, {-1e-8, 1e-8}, {-1e-7, 0}, {359.9999999, 360}}) {
        const auto resolved = resolve_web(ies(IesVersion::lm63_2002, planes, {1, 1, 2, 2}));
        ASSERT_TRUE(resolved);
        EXPECT_EQ(resolved->web.planes_deg().size(), 2u) << planes.back();
        EXPECT_EQ(resolved->web.stored_symmetry(), Symmetry::none);
    }
    for (const Photometry photometry : {Photometry::a, Photometry::b}) {
        Profile profile = ies(IesVersion::lm63_2002, {0, 1e-8}, {1, 1, 2, 2});
        std::get<IesFile>(profile.file).photometry = photometry;
        EXPECT_EQ(resolve_web(profile)->web.horizontal_deg().size(), 2u);
    }
}

TEST(Resolve, ClosesAMissingLastPlaneAndNoWiderGap) {
    const auto closed = resolve_web(ies(IesVersion::lm63_2002, {0, 90, 180, 270}, {1, 1, 2, 2, 3, 3, 4, 4}));
    EXPECT_TRUE(has_code(closed->diagnostics, "WEB0101"));
    EXPECT_DOUBLE_EQ(closed->web.candela(315, 45), 2.5);
    const auto open = resolve_web(ies(IesVersion::lm63_2002, {0, 30, 60, 120}, {1, 1, 2, 2, 3, 3, 4, 4}));
    EXPECT_TRUE(has_code(open->diagnostics, "WEB0102"));
    EXPECT_EQ(open->web.candela(200, 45), 0.0);
}

TEST(Resolve, KeepsNegativeIntensitiesAndSaysSo) {
    const auto resolved = resolve_web(ies(IesVersion::lm63_2002, {0}, {100, -1}));
    EXPECT_TRUE(has_code(resolved->diagnostics, "WEB0105"));
    EXPECT_DOUBLE_EQ(resolved->web.candela(0, 90), -1.0);
    EXPECT_TRUE(has_code(resolve_web(ies(IesVersion::lm63_2002, {0}, {0, 0}))->diagnostics, "WEB0106"));
}

TEST(Resolve, AbsolutePhotometryDeclaresNoFlux) {
    Profile profile = ies(IesVersion::lm63_2002, {0}, {100, 50});
    EXPECT_FALSE(declared_flux_lm(profile));
    std::get<IesFile>(profile.file).lumens_per_lamp = 500;
    std::get<IesFile>(profile.file).lamp_count = 2;
    EXPECT_DOUBLE_EQ(*declared_flux_lm(profile), 1000.0);
}

// An EULUMDAT table of 24 planes for a light with the given symmetry, stored in each way that Isym allows.
Profile ldt(int symmetry) {
    LdtFile file;
    file.symmetry = symmetry;
    file.plane_count = 24;
    for (int i = 0; i < 24; ++i)
        file.planes_deg.push_back(15.0 * i);
    file.gammas_deg = {0, 45, 90};
    file.lamp_sets = {{1, "LED", 2000.0, "", "", 20.0}, {-1, "LED", 500.0, "", "", 5.0}};
    const auto add = [&](double c) {
        const double r = c * 3.14159265358979323846 / 180.0;
        // Symmetric in C0–C180 for Isym 2, in C90–C270 for 3, in both for 4, in none for 0.
        const double value = symmetry == 2   ? 100 + 20 * std::cos(r)
                             : symmetry == 3 ? 100 + 20 * std::sin(r)
                             : symmetry == 4 ? 100 + 20 * std::cos(2 * r)
                             : symmetry == 1 ? 100
                                             : 100 + 20 * std::cos(r) + 10 * std::sin(r);
        for (const double share : {1.0, 0.5, 0.0})
            file.candela_per_klm.push_back(share * value);
    };
    const int first = symmetry == 3 ? 18 : 0; // C270 over C0 to C90
    const int count = symmetry == 0 ? 24 : symmetry == 1 ? 1 : symmetry == 4 ? 7 : 13;
    for (int i = 0; i < count; ++i)
        add(15.0 * (first + i));
    return {"test.ldt", file, {}};
}

TEST(Resolve, EveryIsymMeansTheSameAsItsFullTable) {
    for (const int symmetry : {0, 1, 2, 3, 4}) {
        const auto resolved = resolve_web(ldt(symmetry));
        ASSERT_TRUE(resolved) << symmetry;
        for (int i = 0; i < 24; ++i) {
            const double c = 15.0 * i;
            const double r = c * 3.14159265358979323846 / 180.0;
            const double value = symmetry == 2   ? 100 + 20 * std::cos(r)
                                 : symmetry == 3 ? 100 + 20 * std::sin(r)
                                 : symmetry == 4 ? 100 + 20 * std::cos(2 * r)
                                 : symmetry == 1 ? 100
                                                 : 100 + 20 * std::cos(r) + 10 * std::sin(r);
            // cd/klm × 2000 lm of lamp set 1
            EXPECT_NEAR(resolved->web.candela(c, 0), 2.0 * value, 1e-9) << symmetry << " at " << c;
        }
    }
}

// Five files of the corpus are written like this, and their IES twins are round.
TEST(Resolve, ASinglePlaneWithoutSymmetryIsForEveryC) {
    Profile single = ldt(1);
    auto& file = std::get<LdtFile>(single.file);
    file.symmetry = 0;
    file.plane_count = 1;
    file.planes_deg = {0.0};
    const auto resolved = resolve_web(single);
    ASSERT_TRUE(resolved);
    EXPECT_TRUE(has_code(resolved->diagnostics, "WEB0109"));
    EXPECT_EQ(resolved->web.stored_symmetry(), Symmetry::axial);
    EXPECT_DOUBLE_EQ(flux(resolved->web).value, flux(resolve_web(ldt(1))->web).value);
    EXPECT_FALSE(has_code(resolve_web(ldt(1))->diagnostics, "WEB0109"));
    const auto written = convert_profile(single, ProfileTarget::eulumdat);
    ASSERT_TRUE(written);
    EXPECT_EQ(std::get<LdtFile>(written->profile.file).symmetry, 1);
}

TEST(Resolve, LampSetsAreAlternatives) {
    EXPECT_NEAR(resolve_web(ldt(1), {2, 0.0})->web.candela(0, 0), 50.0, 1e-12);
    EXPECT_DOUBLE_EQ(*declared_flux_lm(ldt(1)), 2000.0);
    EXPECT_FALSE(declared_flux_lm(ldt(1), {2, 0.0})); // a negative lamp count: absolute
    const auto missing = resolve_web(ldt(1), {3, 0.0});
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().failure, Failure::usage);
}

TEST(Resolve, AzimuthTurnsTheOtherTraditionByAQuarterTurn) {
    const Profile file = ies(IesVersion::lm63_2002, {0, 90, 180}, {1, 0, 2, 0, 3, 0});
    ResolveOptions eulumdat;
    eulumdat.azimuth = AzimuthConvention::eulumdat;
    ResolveOptions lm63;
    lm63.azimuth = AzimuthConvention::lm63;
    const Web plain = resolve_web(file)->web;
    const Web turned = resolve_web(file, eulumdat)->web;
    EXPECT_EQ(turned.stored_symmetry(), Symmetry::bilateral_90_270);
    for (double c = 0.0; c < 360.0; c += 7.5)
        EXPECT_NEAR(turned.candela(c + 90.0, 30.0), plain.candela(c, 30.0), 1e-12);
    EXPECT_EQ(resolve_web(file, lm63)->web.stored_symmetry(), Symmetry::bilateral_0_180);
    for (const int symmetry : {0, 1, 2, 3, 4}) {
        const Web own = resolve_web(ldt(symmetry))->web;
        const Web back = resolve_web(ldt(symmetry), lm63)->web;
        for (double c = 0.0; c < 360.0; c += 7.5) {
            EXPECT_NEAR(back.candela(c - 90.0, 30.0), own.candela(c, 30.0), 1e-10) << symmetry;
            EXPECT_EQ(resolve_web(ldt(symmetry), eulumdat)->web.candela(c, 30.0), own.candela(c, 30.0));
        }
    }
}

TEST(Resolve, ATiltFactorScalesWhateverTheGoniometer) {
    for (const Photometry type : {Photometry::a, Photometry::b, Photometry::c}) {
        IesFile table;
        table.photometry = type;
        table.vertical_deg = {0, 30, 60};
        table.horizontal_deg = {0, 45, 90};
        table.candela = {8, 4, 2, 8, 4, 2, 8, 4, 2};
        table.tilt_keyword = "INCLUDE";
        table.tilt = {1, {0, 30, 90}, {1.0, 0.9, 0.5}};
        const Profile file{"test.ies", table, {}};
        EXPECT_DOUBLE_EQ(resolve_web(file)->web.candela_at(45, 30), 4.0);
        EXPECT_DOUBLE_EQ(resolve_web(file, {1, 15.0})->web.candela_at(45, 30), 4.0 * 0.95);
        EXPECT_DOUBLE_EQ(resolve_web(file, {1, 60.0})->web.candela_at(45, 30), 4.0 * 0.7);
    }
}

TEST(Resolve, TakesTheTableOfAProfileThatIsGivenAway) {
    for (const int symmetry : {0, 1, 2, 3, 4}) {
        Profile given = ldt(symmetry);
        const Web kept = resolve_web(given)->web;
        EXPECT_FALSE(std::get<LdtFile>(given.file).candela_per_klm.empty());
        const Web taken = resolve_web(std::move(given))->web;
        ASSERT_EQ(taken.horizontal_deg().size(), kept.horizontal_deg().size());
        for (std::size_t i = 0; i < kept.horizontal_deg().size(); ++i)
            EXPECT_TRUE(std::equal(kept.column(i).begin(), kept.column(i).end(), taken.column(i).begin())) << symmetry;
    }
    Profile given = ies(IesVersion::lm63_2002, {0, 90}, {100, 50, 80, 40});
    const double* const table = std::get<IesFile>(given.file).candela.data();
    EXPECT_EQ(resolve_web(std::move(given))->web.column(0).data(), table); // no second copy
}

} // namespace
} // namespace gonio
