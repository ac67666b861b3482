#include <gonio/base/codes/archive.hpp>
#include <gonio/base/codes/failure.hpp>
#include <gonio/base/codes/profile.hpp>
#include <gonio/base/codes/result.hpp>
#include <gonio/base/codes/rig.hpp>
#include <gonio/base/codes/scene.hpp>
#include <gonio/base/codes/web.hpp>
#include <gonio/base/diagnostic_codes.hpp>

#include <algorithm>
#include <array>

namespace gonio {

namespace {

template<std::size_t... Sizes>
constexpr auto joined(const std::array<DiagnosticCode, Sizes>&... tables) {
    std::array<DiagnosticCode, (Sizes + ...)> all{};
    auto at = all.begin();
    ((at = std::copy(tables.begin(), tables.end(), at)), ...);
    return all;
}

constexpr auto all_codes =
    joined(profile_codes, archive_codes, web_codes, rig_codes, scene_codes, result_codes, failure_codes);
static_assert(in_order(all_codes));

constexpr std::array groups{
    DiagnosticGroup{"PRF01", "Any photometric file"},
    DiagnosticGroup{"IES01", "IES: the text"},
    DiagnosticGroup{"IES02", "IES: numbers and counts"},
    DiagnosticGroup{"IES03", "IES: angles"},
    DiagnosticGroup{"IES04", "IES: the table"},
    DiagnosticGroup{"LDT01", "EULUMDAT: the text"},
    DiagnosticGroup{"LDT02", "EULUMDAT: numbers and counts"},
    DiagnosticGroup{"LDT03", "EULUMDAT: angles"},
    DiagnosticGroup{"LDT04", "EULUMDAT: the table"},
    DiagnosticGroup{"TM301", "TM-33: the document"},
    DiagnosticGroup{"TM302", "TM-33: numbers and counts"},
    DiagnosticGroup{"TM303", "TM-33: angles"},
    DiagnosticGroup{"TM304", "TM-33: the table"},
    DiagnosticGroup{"ARC01", "Archives: the container"},
    DiagnosticGroup{"ARC02", "Archives: the XML in them"},
    DiagnosticGroup{"GLD01", "GLDF: the luminaire"},
    DiagnosticGroup{"GLD02", "GLDF: what it states"},
    DiagnosticGroup{"GLD03", "GLDF: writing"},
    DiagnosticGroup{"WEB01", "What a file means"},
    DiagnosticGroup{"WEB02", "What is lost or changed in another format"},
    DiagnosticGroup{"WEB03", "Whether such a light can be"},
    DiagnosticGroup{"RIG01", "Rigs"},
    DiagnosticGroup{"SCN01", "Scenes of other programs: the file"},
    DiagnosticGroup{"SCN02", "Scenes of other programs: what becomes of a light"},
    DiagnosticGroup{"SCN03", "Scenes of other programs: the audit"},
    DiagnosticGroup{"RES01", "Results: colours"},
    DiagnosticGroup{"RES02", "Results: files and pictures"},
    DiagnosticGroup{"RES03", "Results: units"},
    DiagnosticGroup{"RES04", "Results: points"},
    DiagnosticGroup{"RES05", "Results: images of environments"},
    DiagnosticGroup{"RES06", "Results: rooms"},
    DiagnosticGroup{"USE01", "Usage: exit status 2"},
    DiagnosticGroup{"FIL01", "Files and folders: exit status 3"},
    DiagnosticGroup{"INP01", "Other inputs: exit status 4"},
    DiagnosticGroup{"UNS01", "What gonio cannot do: exit status 5"},
    DiagnosticGroup{"INT01", "Internal errors: exit status 70"},
};

// Whether the groups match the codes, in the same order.
constexpr bool groups_fit() {
    std::size_t group = 0;
    for (std::size_t i = 0; i < all_codes.size(); ++i) {
        if (i > 0 && all_codes[i].code.starts_with(groups[group].prefix)) continue;
        if (i > 0) ++group;
        if (group == groups.size() || !all_codes[i].code.starts_with(groups[group].prefix)) return false;
    }
    return group + 1 == groups.size();
}
static_assert(groups_fit());

} // namespace

std::span<const DiagnosticCode> diagnostic_codes() {
    return all_codes;
}

std::span<const DiagnosticGroup> diagnostic_groups() {
    return groups;
}

const DiagnosticCode* find_diagnostic_code(std::string_view code) {
    const auto found =
        std::find_if(all_codes.begin(), all_codes.end(), [&](const DiagnosticCode& row) { return row.code == code; });
    return found == all_codes.end() ? nullptr : &*found;
}

} // namespace gonio
