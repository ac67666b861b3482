#include <gonio/base/kind_text.hpp>
#include <gonio/base/text.hpp>
#include <gonio/profile/codes.hpp>
#include <gonio/web/codes.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../options/common.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace gonio::cli {

namespace {

constexpr std::array explain_options{
    Option{"--markdown", "", "print all codes as a Markdown page"},
};
constexpr std::array groups{OptionGroup{"output", explain_options}, json_group, common_group};
constexpr std::array examples{Example{"gonio explain IES0204", "what this diagnostic means and what to do"},
                              Example{"gonio explain --markdown > CODES.md", "all codes, as a page"}};

struct Explained {
    std::string_view code;
    const char* severity;
    std::string_view strictness; // "error with --strict", "only with --strict"; empty: the same
    std::string_view title;
    std::string_view explanation;
};

std::vector<Explained> all_codes() {
    std::vector<Explained> all;
    for (const ProfileCode& entry : profile_codes)
        all.push_back({entry.code, to_text(entry.severity),
                       entry.strict_only                         ? "only with --strict"
                       : entry.strict_severity != entry.severity ? "error with --strict"
                                                                 : "",
                       entry.title, entry.explanation});
    for (const WebCode& entry : web_codes)
        all.push_back({entry.code, to_text(entry.severity), "", entry.title, entry.explanation});
    return all;
}

Json to_json(const Explained& entry) {
    return {
        {"code", entry.code}, {"severity", entry.severity}, {"title", entry.title}, {"explanation", entry.explanation}};
}

// The heading above the codes with this prefix.
struct Group {
    std::string_view prefix;
    std::string_view title;
};

constexpr std::array page_groups{
    Group{"PRF01", "Any photometric file"},
    Group{"IES01", "IES: the text"},
    Group{"IES02", "IES: numbers and counts"},
    Group{"IES03", "IES: angles"},
    Group{"IES04", "IES: the table"},
    Group{"LDT01", "EULUMDAT: the text"},
    Group{"LDT02", "EULUMDAT: numbers and counts"},
    Group{"LDT03", "EULUMDAT: angles"},
    Group{"LDT04", "EULUMDAT: the table"},
    Group{"TM301", "TM-33: the document"},
    Group{"TM302", "TM-33: numbers and counts"},
    Group{"TM303", "TM-33: angles"},
    Group{"TM304", "TM-33: the table"},
    Group{"WEB01", "What a file means"},
    Group{"WEB02", "What is lost or changed in another format"},
    Group{"WEB03", "Plausibility"},
};

std::string_view title_of(std::string_view prefix) {
    for (const Group& group : page_groups)
        if (group.prefix == prefix) return group.title;
    return prefix;
}

std::string markdown(const std::vector<Explained>& codes) {
    std::string page =
        "# Diagnostic codes\n\nPrinted by `gonio explain --markdown`; a test compares. A code never changes its "
        "meaning. `gonio check` reports\nthese codes. It exits with 1 on an error, and with `--strict` on a "
        "warning too.\n";
    std::string_view group;
    for (const Explained& entry : codes) {
        const std::string_view prefix = entry.code.substr(0, 5);
        if (prefix != group) page += fmt::format("\n## {}\n", title_of(prefix));
        group = prefix;
        page += fmt::format("\n**{}** {} ({}{}{})  \n{}\n", entry.code, entry.title, entry.severity,
                            entry.strictness.empty() ? "" : ", ", entry.strictness, entry.explanation);
    }
    return page;
}

int run(const Arguments& arguments, Console& console) {
    const std::vector<Explained> all = all_codes();
    const bool json = arguments.has("--json") || arguments.has("--jsonl");
    if (arguments.has("--markdown")) {
        if (json || !arguments.positional().empty())
            return console.fail(
                fail(Failure::usage, "--markdown prints all codes; it takes neither CODE nor --json").value());
        console.print(markdown(all));
        return 0;
    }
    Json report{{"schema", "gonio.explain/1"}, {"codes", Json::array()}, {"diagnostics", Json::array()}};
    if (arguments.positional().empty()) {
        for (const Explained& entry : all) {
            report["codes"].push_back(to_json(entry));
            if (!json) console.print(fmt::format("{}  {:<8} {}\n", entry.code, entry.severity, entry.title));
        }
    }
    for (const std::string& named : arguments.positional()) {
        const std::string code = to_upper(named);
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const Explained& entry) { return entry.code == code; });
        if (found == all.end())
            return console.fail(fail(Failure::usage, fmt::format("unknown diagnostic code '{}'", code),
                                     "'gonio explain' lists them all")
                                    .value());
        report["codes"].push_back(to_json(*found));
        if (!json)
            console.print(
                fmt::format("{} ({}): {}\n\n{}\n", found->code, found->severity, found->title, found->explanation));
    }
    if (json) console.print(dump(report, arguments.has("--jsonl") ? -1 : 2));
    return 0;
}

} // namespace

extern const Command explain_command;
const Command explain_command{
    "explain", "describe a diagnostic code and what to do about it", "[CODE…]", "", groups, examples, run};

} // namespace gonio::cli
