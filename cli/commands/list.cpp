#include <gonio/base/named.hpp>
#include <gonio/base/text.hpp>

#include "../arguments.hpp"
#include "../command.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "../lists.hpp"
#include "../options/common.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace gonio::cli {

namespace {

constexpr std::array list_options{
    Option{"--markdown", "", "print the list as a Markdown page"},
};
constexpr std::array groups{OptionGroup{"output", list_options}, json_group, common_group};
constexpr std::array examples{Example{"gonio list shapes", "the shapes that --shape takes"},
                              Example{"gonio list limits --markdown > LIMITS.md", "a list as a page"}};

std::string in_a_cell(std::string_view text) {
    std::string cell;
    for (const char c : text)
        cell += c == '|' ? std::string("\\|") : std::string(1, c);
    return cell;
}

std::string markdown(const NamedList& list, const std::vector<ListEntry>& entries) {
    std::string title(list.summary);
    title.front() = to_upper(title.front());
    std::string page = fmt::format("# {}\n"
                                   "\n"
                                   "Printed by `gonio list {} --markdown`; a test compares.\n"
                                   "\n"
                                   "| name | what it is |\n"
                                   "|---|---|\n",
                                   title, list.name);
    for (const ListEntry& entry : entries)
        page += fmt::format("| `{}` | {} |\n", in_a_cell(entry.name), in_a_cell(entry.says));
    return page;
}

int run(const Arguments& arguments, Console& console) {
    const bool json = arguments.has("--json") || arguments.has("--jsonl");
    if (arguments.has("--markdown") && (json || arguments.positional().empty()))
        return console.fail(
            fail("USE0107", "--markdown takes one LIST and no --json", "for example: gonio list limits --markdown")
                .value());
    if (arguments.positional().empty()) {
        for (const NamedList& list : named_lists())
            console.print(fmt::format("{:<18}{}\n", list.name, list.summary));
        return 0;
    }
    const std::string& name = arguments.positional().front();
    Result<const NamedList*> found = find_named("list", name, named_lists());
    if (!found) {
        if (find_command(name) != nullptr)
            error_hint(found.error(), fmt::format("did you mean 'gonio help {}'?", name));
        return console.fail(found.error());
    }
    const NamedList* const list = *found;
    const std::vector<ListEntry> entries = list->entries();
    if (arguments.has("--markdown")) {
        console.print(markdown(*list, entries));
        return 0;
    }
    if (json) {
        Json report{{"schema", "gonio.list/1"}, {"list", list->name}, {"entries", Json::array()}};
        for (const ListEntry& entry : entries)
            report["entries"].push_back({{"name", entry.name}, {"summary", entry.says}});
        report["diagnostics"] = Json::array();
        console.print(dump(report, arguments.has("--jsonl") ? -1 : 2));
        return 0;
    }
    std::size_t width = 0;
    for (const ListEntry& entry : entries)
        width = std::max(width, entry.name.size());
    for (const ListEntry& entry : entries)
        console.print(fmt::format("{:<{}}  {}\n", entry.name, width, entry.says));
    return 0;
}

} // namespace

extern const Command list_command;
const Command list_command{
    "list", "show the names that options take: shapes, units, layouts, stages, …", "[LIST]", "", groups, examples, run};

} // namespace gonio::cli
