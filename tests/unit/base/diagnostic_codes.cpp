// The registry of diagnostic codes: every error has a code from it.
#include <gonio/base/codes/archive.hpp>
#include <gonio/base/codes/failure.hpp>
#include <gonio/base/codes/profile.hpp>
#include <gonio/base/codes/result.hpp>
#include <gonio/base/codes/rig.hpp>
#include <gonio/base/codes/scene.hpp>
#include <gonio/base/codes/web.hpp>
#include <gonio/base/diagnostic_codes.hpp>
#include <gonio/base/file.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/result.hpp>
#include <gonio/base/unit_text.hpp>

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <type_traits>

namespace {

using namespace gonio;

constexpr DiagnosticCode row(std::string_view code) {
    return {code, Severity::error, Strict::same, "title", "A sentence."};
}

TEST(DiagnosticCodes, AreFoundByTheirName) {
    for (const DiagnosticCode& code : diagnostic_codes())
        EXPECT_EQ(find_diagnostic_code(code.code), &code);
    EXPECT_EQ(diagnostic_codes().size(), profile_codes.size() + web_codes.size() + rig_codes.size() +
                                             scene_codes.size() + result_codes.size() + failure_codes.size() +
                                             archive_codes.size());
    for (const std::string_view none : {"", "IES9999", "ies0204", "IES020", "IES02040"})
        EXPECT_EQ(find_diagnostic_code(none), nullptr) << none;
}

// The order that the tables are checked for at compile time.
TEST(DiagnosticCodes, TablesOutOfOrderAreRefused) {
    const auto kept = [](auto... codes) { return in_order(std::array{row(codes)...}); };
    EXPECT_TRUE(kept("AAA0101", "AAA0102", "AAA0201", "BB30101", "AAB0101"));
    EXPECT_FALSE(kept("AAA0101", "AAA0101")) << "twice";
    EXPECT_FALSE(kept("AAA0102", "AAA0101")) << "descending";
    EXPECT_FALSE(kept("AAA0101", "BBB0101", "AAA0102")) << "a family in two places";
    for (const std::string_view code : {"AAA010", "AAA01011", "AaA0101", "3AA0101", "AAA01O1", "AAA-101"})
        EXPECT_FALSE(kept(code)) << code;
    DiagnosticCode told = row("AAA0101");
    told.title = "Title.";
    EXPECT_FALSE(is_complete(told));
    told = row("AAA0101");
    told.explanation = "No sentence";
    EXPECT_FALSE(is_complete(told));
    told.explanation = "";
    EXPECT_FALSE(is_complete(told));
}

TEST(DiagnosticCodes, StrictReadingNeverLowersASeverity) {
    for (const DiagnosticCode& code : diagnostic_codes())
        EXPECT_GE(code.strict_severity(), code.severity) << code.code;
}

TEST(DiagnosticCodes, AFailureHasTheGeneralCodeOfItsFamily) {
    const auto code = [](Cause cause) { return std::string(cause.code()); };
    EXPECT_EQ(code(Failure::usage), "USE0101");
    EXPECT_EQ(code(Failure::io), "FIL0101");
    EXPECT_EQ(code(Failure::malformed), "INP0101");
    EXPECT_EQ(code(Failure::unsupported), "UNS0101");
    EXPECT_EQ(code(Failure::internal), "INT0101");
    const Error chosen = fail("FIL0104", "too large", "a hint", "big.ies").value();
    EXPECT_EQ(chosen.failure, Failure::io);
    EXPECT_EQ(to_text(chosen.diagnostics.back()), "big.ies: error[FIL0104]: too large\nhint: a hint");
    // Every row of the table has a failure, otherwise fail() could not know the exit status.
    for (const DiagnosticCode& failing : failure_codes) {
        bool known = false;
        for (const FailureFamily& of : failure_families)
            known = known || of.family == code_family(failing.code);
        EXPECT_TRUE(known) << failing.code;
        EXPECT_EQ(failing.severity, Severity::error) << failing.code;
    }
    static_assert(!std::is_convertible_v<std::string, Cause>, "a code is known when the source is compiled");
}

TEST(DiagnosticCodes, TellClassesOfUsageApart) {
    const auto code = [](const auto& result) {
        return result ? std::string("no failure") : result.error().diagnostics.back().code;
    };
    const std::array<std::string_view, 2> known{"albedo", "base"};
    EXPECT_EQ(code(Result<void>(unknown_name("key", "albdo", known))), "USE0103");
    EXPECT_EQ(code(parse_kind_text(":r=1")), "USE0105");
    EXPECT_EQ(code(parse_kind_text("disk:r=1,r=2")), "USE0107");
    EXPECT_EQ(code(parse_kind_text("disk:" + std::string(20000, 'x'))), "USE0106");
    EXPECT_EQ(code(parse_amount("800")), "USE0105");
    EXPECT_EQ(code(parse_amount("800lmm")), "USE0103");
    EXPECT_EQ(code(parse_amount("1e999lm")), "USE0106");
    EXPECT_EQ(code(read_file("/nonexistent/lamp.ies", limit("record-bytes"))), "FIL0102");
    EXPECT_EQ(code(read_file("/", limit("record-bytes"))), "FIL0101");
}

} // namespace
