#include <gonio/base/kind_text.hpp>

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

constexpr std::array groups{json_group, common_group};
constexpr std::array examples{Example{"gonio list shapes", "the shapes that --shape takes"}};

int run(const Arguments& arguments, Console& console) {
    if (arguments.positional().empty()) {
        for (const NamedList& list : named_lists())
            console.print(fmt::format("{:<16}{}\n", list.name, list.summary));
        return 0;
    }
    const std::string& name = arguments.positional().front();
    const NamedList* list = find_list(name);
    if (list == nullptr) {
        std::vector<std::string_view> names;
        for (const NamedList& known : named_lists())
            names.push_back(known.name);
        return console.fail(unknown_name("list", name, names).value());
    }
    const std::vector<ListEntry> entries = list->entries();
    if (arguments.has("--json") || arguments.has("--jsonl")) {
        Json json{{"schema", "gonio.list/1"}, {"list", list->name}, {"entries", Json::array()}};
        for (const ListEntry& entry : entries)
            json["entries"].push_back({{"name", entry.name}, {"summary", entry.says}});
        json["diagnostics"] = Json::array();
        console.print(dump(json, arguments.has("--jsonl") ? -1 : 2));
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
const Command list_command{"list", "what there is: shapes, units, layouts, stages, …", "[LIST]", "", groups, examples,
                           run};

} // namespace gonio::cli
