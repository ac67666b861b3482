// What is said about a profile: by its format, its options and its units.
#include <gonio/asset/facts_record.hpp>
#include <gonio/light/profile_facts.hpp>
#include <gonio/profile/read.hpp>
#include <gonio/web/integrate.hpp>

#include "../folders.hpp"

#include <gtest/gtest.h>

#include <string>

namespace gonio {
namespace {

Profile profile_named(const std::string& name) {
    return read_profile_file(std::string(test::source_folder) + "/profiles/" + name).value();
}

ProfileFacts facts_of(const Profile& profile, const ResolveOptions& options = {}, bool all = true) {
    return profile_facts(profile, resolve_web(profile, options).value().web, options,
                         all ? FactsExtent::all : FactsExtent::report);
}

TEST(ProfileFacts, AreTheSameInEveryFormat) {
    const ProfileFacts ies = facts_of(profile_named("wall-washer.ies"));
    const ProfileFacts ldt = facts_of(profile_named("wall-washer.ldt"));
    EXPECT_EQ(ies.format, "IES");
    EXPECT_EQ(ldt.format, "LDT");
    EXPECT_NEAR(ies.flux_lm, ldt.flux_lm, 1e-9 * ies.flux_lm);
    EXPECT_EQ(ies.declared_flux_lm, 2500.0);
    EXPECT_EQ(ies.lamps.front().flux_lm, 2500.0);
    EXPECT_NEAR(ies.efficacy_lm_per_w().value(), 2500.0 / 24.0, 0.01);
    EXPECT_NEAR(ies.zone_lm(0, 90) + ies.zone_lm(90, 180), ies.flux_lm, 1e-9 * ies.flux_lm);
    EXPECT_EQ(ies.opening.shape, OpeningShape::rectangle);
    EXPECT_TRUE(ies.point_distance_m);
}

TEST(ProfileFacts, LeaveOutWhatIsNotAskedFor) {
    const Profile profile = profile_named("downlight.ies");
    EXPECT_TRUE(facts_of(profile).cie_beam_deg);
    EXPECT_FALSE(facts_of(profile, {}, false).cie_beam_deg);
}

TEST(ProfileFacts, KeepTheUnitsOfARadiometricProfile) {
    const std::string text = "IESNA:LM-63-2002\n[TEST] x\n[_INTENSITYUNITS] mW/sr\nTILT=NONE\n"
                             "1 -1 1 2 1 1 2 0 0 0 1 1 10\n0 90\n0\n5 1\n";
    const Profile profile = read_profile(text, "uv.ies").value();
    const ProfileFacts facts = facts_of(profile);
    EXPECT_EQ(facts.intensity_unit, "mW/sr");
    EXPECT_EQ(facts.flux_unit, "mW");
    EXPECT_FALSE(facts.efficacy_lm_per_w());
    ResolveOptions as_candela;
    as_candela.as_candela = true;
    EXPECT_EQ(facts_of(profile, as_candela).flux_unit, "lm");
    EXPECT_TRUE(facts_of(profile, as_candela).efficacy_lm_per_w());
}

TEST(FactsRecord, HasTheNameAndTheNumbers) {
    const Profile profile = profile_named("downlight.ies");
    const ProfileFacts facts = facts_of(profile);
    const detail::Json json = detail::facts_json("a/b.ies", facts, {});
    EXPECT_EQ(json.find("schema")->as_string(), "gonio.info/1");
    EXPECT_EQ(json.find("file")->as_string(), "a/b.ies");
    EXPECT_EQ(json.find("flux_lm")->as_double(), facts.flux_lm);
    EXPECT_EQ(facts_record("a/b.ies", facts, {}), json.dump(2) + "\n");
}

} // namespace
} // namespace gonio
