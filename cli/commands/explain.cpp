#include <gonio/base/diagnostic_codes.hpp>
#include <gonio/base/text.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>

namespace gonio::cli {

namespace {

constexpr std::array explain_options{
    Option{"--markdown", "", "print all codes as a Markdown page"},
};
constexpr std::array groups{OptionGroup{"output", explain_options}, json_group, common_group};
constexpr std::array examples{Example{"gonio explain IES0204", "what this diagnostic means and what to do"},
                              Example{"gonio explain --markdown > CODES.md", "all codes, as a page"}};

// "error with --strict", "only with --strict"; empty: no difference.
std::string_view strictness(const DiagnosticCode& entry) {
    if (entry.strict == Strict::only) return "only with --strict";
    return entry.strict == Strict::error ? "error with --strict" : "";
}

Json to_json(const DiagnosticCode& entry) {
    return {{"code", entry.code},
            {"severity", to_text(entry.severity)},
            {"title", entry.title},
            {"explanation", entry.explanation}};
}

std::string markdown() {
    std::string page =
        "# Diagnostic codes\n\nPrinted by `gonio explain --markdown`; a test compares. A code never changes its "
        "meaning. `gonio check` reports\nthe codes of profiles. It exits with 1 on an error, and with "
        "`--strict` on a warning too.\n";
    for (const DiagnosticGroup& group : diagnostic_groups()) {
        page += fmt::format("\n## {}\n", group.title);
        for (const DiagnosticCode& entry : diagnostic_codes()) {
            if (!entry.code.starts_with(group.prefix)) continue;
            const std::string_view strict = strictness(entry);
            page += fmt::format("\n**{}** {} ({}{}{})  \n{}\n", entry.code, entry.title, to_text(entry.severity),
                                strict.empty() ? "" : ", ", strict, entry.explanation);
        }
    }
    return page;
}

int run(const Arguments& arguments, Console& console) {
    const bool json = arguments.has("--json") || arguments.has("--jsonl");
    if (arguments.has("--markdown")) {
        if (json || !arguments.positional().empty())
            return console.fail(
                fail("USE0107", "--markdown prints all codes; it takes neither CODE nor --json").value());
        console.print(markdown());
        return 0;
    }
    Json report{{"schema", "gonio.explain/1"}, {"codes", Json::array()}, {"diagnostics", Json::array()}};
    if (arguments.positional().empty()) {
        for (const DiagnosticCode& entry : diagnostic_codes()) {
            report["codes"].push_back(to_json(entry));
            if (!json) console.print(fmt::format("{}  {:<8} {}\n", entry.code, to_text(entry.severity), entry.title));
        }
    }
    for (const std::string& named : arguments.positional()) {
        const std::string code = to_upper(named);
        const DiagnosticCode* const found = find_diagnostic_code(code);
        if (found == nullptr)
            return console.fail(
                fail("USE0103", fmt::format("unknown diagnostic code '{}'", code), "'gonio explain' lists them all")
                    .value());
        report["codes"].push_back(to_json(*found));
        if (!json)
            console.print(fmt::format("{} ({}): {}\n\n{}\n", found->code, to_text(found->severity), found->title,
                                      found->explanation));
    }
    if (json) console.print(dump(report, arguments.has("--jsonl") ? -1 : 2));
    return 0;
}

} // namespace

extern const Command explain_command;
const Command explain_command{
    "explain", "describe a diagnostic code and what to do about it", "[CODE…]", "", groups, examples, run};

} // namespace gonio::cli
