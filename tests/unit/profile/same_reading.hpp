// One text read in every way that this machine has: numbers one by one, which is the reference, and in bulk with each
// instruction set. For tests and fuzzers.
#pragma once

#include <gonio/profile/read.hpp>
#include <gonio/profile/token_kernels.hpp>

#include "../said.hpp"
#include "equal.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gonio::test {

inline const std::vector<double>& table_of(const Profile& profile) {
    static const std::vector<double> none;
    if (const auto* const ies = std::get_if<IesFile>(&profile.file)) return ies->candela;
    if (const auto* const ldt = std::get_if<LdtFile>(&profile.file)) return ldt->candela_per_klm;
    return none;
}

// What is different between two readings of a text; empty if nothing is.
inline std::string difference(const Result<Profile>& a, const Result<Profile>& b) {
    if (a.has_value() != b.has_value()) return "only one was read";
    const Diagnostics& said_of_a = a ? a->diagnostics : a.error().diagnostics;
    const Diagnostics& said_of_b = b ? b->diagnostics : b.error().diagnostics;
    if (said(said_of_a) != said(said_of_b)) return said(said_of_a) + "against\n" + said(said_of_b);
    if (!a) return a.error().failure == b.error().failure ? "" : "the kinds of failure differ";
    if (!equal(a->file, b->file)) return "the files differ";
    const std::vector<double>& table = table_of(*a);
    for (std::size_t i = 0; i < table.size(); ++i) // 0 and -0 are equal
        if (std::signbit(table[i]) != std::signbit(table_of(*b)[i])) return "the signs of value " + std::to_string(i);
    for (std::size_t i = 0; i < profile_field_count; ++i) {
        const FieldPlace x = a->places[static_cast<ProfileField>(i)];
        const FieldPlace y = b->places[static_cast<ProfileField>(i)];
        if (x.line != y.line || x.column != y.column) return "the places of field " + std::to_string(i);
    }
    return "";
}

// What is different between the reference and the other ways, with the name of the set; empty if nothing is.
inline std::string difference_of_readings(std::string_view bytes, const std::string& source,
                                          const ReadOptions& options) {
    using namespace profile_detail;
    const auto read = [&](const TokenKernels* kernels) {
        const UseTokenKernels use(kernels);
        return read_profile(bytes, source, options);
    };
    const Result<Profile> expected = read(nullptr);
    for (const simd::InstructionSet set : simd::available_sets())
        if (const std::string found = difference(expected, read(&token_kernels(set))); !found.empty())
            return std::string(simd::to_text(set)) + ": " + found;
    return "";
}

} // namespace gonio::test
