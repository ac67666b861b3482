// The registry of diagnostic codes: what `gonio explain CODE` prints, and the only codes that the source may use.
//
// A code is three characters that name a family and four digits: "IES0204". The first two digits group the codes of a
// family. A code is stable: it never gets another meaning, and a retired code is never used again.
//
// The rows are in tables under codes/, one for each kind of input; a file includes the table of the codes that it
// emits. A code that is not in its table does not compile, and neither does a table that is out of order. CODES.md
// beside this file is generated from all of them.
#pragma once

#include <gonio/base/diagnostics.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// How strict reading of an input treats a diagnostic.
enum class Strict : std::uint8_t {
    same,  // it keeps its severity
    error, // it is an error
    only   // it is reported only then
};

#ifdef GONIO_NO_EXPLANATIONS // for a module that nobody asks for them: their text is not compiled
struct Explanation {
    constexpr Explanation() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): rows are written as their text
    constexpr Explanation(const char* /*text*/) {}
    // NOLINTNEXTLINE(google-explicit-constructor)
    constexpr operator std::string_view() const { return {}; }
};
#else
using Explanation = std::string_view; // the sentences of a code, which some modules leave out
#endif

// A row of the tables that `gonio explain` prints.
struct DiagnosticCode {
    std::string_view code;
    Severity severity; // in tolerant reading, the default
    Strict strict;
    std::string_view title;  // without a full stop
    Explanation explanation; // sentences

    constexpr Severity strict_severity() const { return strict == Strict::error ? Severity::error : severity; }
};

// The codes that begin with `prefix`, and their subject.
struct DiagnosticGroup {
    std::string_view prefix; // "IES02"
    std::string_view title;
};

// All of them, by group.
std::span<const DiagnosticCode> diagnostic_codes();
std::span<const DiagnosticGroup> diagnostic_groups();

// nullptr when there is no such code.
const DiagnosticCode* find_diagnostic_code(std::string_view code);

// Letters and digits of a code, and letters of its family.
inline constexpr std::size_t code_length = 7;
inline constexpr std::size_t code_family_length = 3;

// "IES" of "IES0204".
constexpr std::string_view code_family(std::string_view code) {
    return code.substr(0, code_family_length);
}

// Whether a row has a code of the right form, a title and an explanation in sentences.
constexpr bool is_complete(const DiagnosticCode& row) {
    if (row.code.size() != code_length) return false;
    for (std::size_t i = 0; i < code_length; ++i) {
        const char c = row.code[i];
        const bool digit = c >= '0' && c <= '9';
        const bool capital = c >= 'A' && c <= 'Z';
        if (i < code_family_length ? !(capital || (digit && i > 0)) : !digit) return false;
    }
    if (row.title.empty() || row.title.back() == '.') return false;
#ifdef GONIO_NO_EXPLANATIONS
    return true;
#else
    return !row.explanation.empty() && row.explanation.back() == '.';
#endif
}

// Whether every row is complete, each family is contiguous, and its codes ascend, so that no code appears twice.
constexpr bool in_order(std::span<const DiagnosticCode> rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!is_complete(rows[i])) return false;
        const std::string_view family = code_family(rows[i].code);
        if (i > 0 && code_family(rows[i - 1].code) == family) {
            if (!(rows[i - 1].code < rows[i].code)) return false;
            continue;
        }
        for (std::size_t earlier = 0; earlier < i; ++earlier)
            if (code_family(rows[earlier].code) == family) return false;
    }
    return true;
}

// A code of one table, written as its text: CodeOf<web_codes> code = "WEB0101". The compiler rejects codes that are not
// in the table.
template<const auto& rows>
class CodeOf {
public:
    // NOLINTNEXTLINE(google-explicit-constructor): a code is written as its text
    consteval CodeOf(const char* text) {
        for (const DiagnosticCode& row : rows)
            if (row.code == text) row_ = &row;
        if (row_ == nullptr) throw "no such diagnostic code"; // not a constant expression
    }

    constexpr const DiagnosticCode* operator->() const { return row_; }
    constexpr const DiagnosticCode& operator*() const { return *row_; }

private:
    const DiagnosticCode* row_ = nullptr;
};

} // namespace gonio
#pragma GCC visibility pop
