// Closed sets as tables: rows are found by their names, and unknown names are refused.
#include <gonio/base/named.hpp>

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace gonio;

enum class Fruit { apple, pear, plum };

struct Row {
    Fruit fruit;
    std::string_view name;
};

constexpr std::array rows{Row{Fruit::apple, "apple"}, Row{Fruit::pear, "pear"}, Row{Fruit::plum, "plum"}};
static_assert(in_enum_order(rows, &Row::fruit, Fruit::plum));
static_assert(!in_enum_order(rows, &Row::fruit, Fruit::pear), "a row too many");
constexpr std::array swapped{rows[0], rows[2], rows[1]};
static_assert(!in_enum_order(swapped, &Row::fruit, Fruit::plum));

template<class T>
std::string refusal(const Result<T>& result) {
    return result ? "no failure" : to_text(result.error().diagnostics.back());
}

TEST(Named, RowsAreFoundByTheirNames) {
    EXPECT_EQ(*find_named("fruit", "pear", rows), &rows[1]);
    EXPECT_EQ(refusal(find_named("fruit", "paer", rows)),
              "error[USE0103]: unknown fruit 'paer'\nhint: did you mean 'pear'? there are: apple, pear, plum");
    EXPECT_EQ(refusal(find_named("fruit", "x", rows, "a basket")),
              "error[USE0103]: unknown fruit 'x' of 'a basket'\nhint: there are: apple, pear, plum");
    EXPECT_EQ(names_of(rows), (std::vector<std::string_view>{"apple", "pear", "plum"}));
}

TEST(Named, RowsMayBePointersOrTheNamesThemselves) {
    const std::array<const Row*, 2> pointers{&rows[2], &rows[0]};
    EXPECT_EQ(*find_named("fruit", "apple", pointers), &pointers[1]);
    const std::vector<std::string> names{"apple", "plum"};
    EXPECT_EQ(*find_named("fruit", "plum", names), &names[1]);
    EXPECT_FALSE(find_named("fruit", "pear", names));
}

TEST(Named, ListsNameEachRowOnce) {
    const auto found = [](std::string_view list) {
        std::string text;
        const Result<std::vector<const Row*>> named = find_all_named("fruit", list, rows, "all");
        for (const Row* const row : named.value())
            text += std::string(row->name) + " ";
        return text;
    };
    EXPECT_EQ(found("plum,apple"), "plum apple ");
    EXPECT_EQ(found("plum,plum"), "plum ");
    EXPECT_EQ(found("pear,all"), "pear apple plum ");
    EXPECT_EQ(refusal(find_all_named("fruit", "plum,", rows, "all")),
              "error[USE0103]: unknown fruit ''\nhint: there are: apple, pear, plum, all");
    EXPECT_FALSE(find_all_named("fruit", "all", rows)) << "a name like any other where it was not asked for";
}

TEST(Named, NamesStandForValues) {
    constexpr std::array values{Named{"one", 1}, Named{"two", 2}};
    EXPECT_EQ(find_value("number", "two", values).value(), 2);
    EXPECT_EQ(refusal(find_value("number", "three", values)),
              "error[USE0103]: unknown number 'three'\nhint: there are: one, two");
}

} // namespace
