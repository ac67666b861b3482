// The names that `gonio list` shows; completion offers the same.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

struct ListEntry {
    std::string name;
    std::string says;
};

struct NamedList {
    std::string_view name;
    std::string_view summary;
    std::vector<ListEntry> (*entries)();
};

std::span<const NamedList> named_lists();

// nullptr if there is no list of that name.
const NamedList* find_list(std::string_view name);

} // namespace gonio::cli
