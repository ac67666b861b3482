#include <gonio/base/kind_text.hpp>
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
#include <cctype>

namespace gonio::cli {

namespace {

constexpr std::array groups{json_group, common_group};
constexpr std::array examples{Example{"gonio explain IES0204", "what a diagnostic means and what to do"}};

struct Explained {
    std::string_view code;
    const char* severity;
    std::string_view title;
    std::string_view explanation;
};

std::vector<Explained> all_codes() {
    std::vector<Explained> all;
    for (const ProfileCode& entry : profile_codes)
        all.push_back({entry.code, to_text(entry.severity), entry.title, entry.explanation});
    for (const WebCode& entry : web_codes)
        all.push_back({entry.code, to_text(Severity::warning), entry.title, entry.explanation});
    return all;
}

Json to_json(const Explained& entry) {
    return {
        {"code", entry.code}, {"severity", entry.severity}, {"title", entry.title}, {"explanation", entry.explanation}};
}

int run(const Arguments& arguments, Console& console) {
    const std::vector<Explained> all = all_codes();
    const bool json = arguments.has("--json") || arguments.has("--jsonl");
    Json report{{"schema", "gonio.explain/1"}, {"codes", Json::array()}, {"diagnostics", Json::array()}};
    if (arguments.positional().empty()) {
        for (const Explained& entry : all) {
            report["codes"].push_back(to_json(entry));
            if (!json) console.print(fmt::format("{}  {:<8} {}\n", entry.code, entry.severity, entry.title));
        }
    }
    for (std::string code : arguments.positional()) {
        std::transform(code.begin(), code.end(), code.begin(), [](unsigned char c) { return std::toupper(c); });
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const Explained& entry) { return entry.code == code; });
        if (found == all.end())
            return console.fail(
                fail(Failure::usage, fmt::format("there is no diagnostic '{}'", code), "'gonio explain' lists them all")
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
    "explain", "what a diagnostic's code means and what to do", "[CODE…]", "", groups, examples, run};

} // namespace gonio::cli
