// Tasks: the table, tables of others, and verdicts at their limits.
#include <gonio/figures/tasks.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace gonio {
namespace {

const Task& task_named(std::string_view name) {
    const auto tasks = known_tasks();
    return *std::find_if(tasks.begin(), tasks.end(), [name](const Task& task) { return task.name == name; });
}

TEST(Tasks, HaveNamesAndStandards) {
    std::set<std::string> names;
    for (const Task& task : known_tasks()) {
        EXPECT_TRUE(names.insert(task.name).second) << task.name;
        EXPECT_FALSE(task.title.empty());
        EXPECT_EQ(task.rule.substr(0, 3), "EN ");
        EXPECT_FALSE(verdicts(task, {}).empty());
    }
}

TEST(Tasks, AreJudgedByWhatIsStated) {
    ReachedLight reached;
    reached.mean_lx = 499.6;
    reached.uniformity = 0.594;
    reached.ugr = 19.04;
    reached.wall_lx = 149.4;
    const std::vector<Verdict> all = verdicts(task_named("office.writing"), reached);
    ASSERT_EQ(all.size(), 7);
    EXPECT_EQ(all[0].key, "mean_lx");
    EXPECT_EQ(all[0].passes(), true); // 500
    EXPECT_EQ(all[1].key, "uniformity");
    EXPECT_EQ(all[1].passes(), false); // 0.59
    EXPECT_TRUE(all[2].is_limit);
    EXPECT_EQ(all[2].passes(), true); // 19.0
    EXPECT_EQ(all[3].passes(), std::nullopt);
    EXPECT_EQ(all[5].key, "wall_lx");
    EXPECT_EQ(all[5].passes(), false);
    reached.ugr = 19.06;
    EXPECT_EQ(verdicts(task_named("office.writing"), reached)[2].passes(), false);
    EXPECT_EQ(verdicts(task_named("office.writing"), reached, true)[0].required, 1000.0);
}

TEST(Tasks, OfRoadsHaveALeastIlluminance) {
    ReachedLight reached;
    reached.mean_lx = 7.5;
    reached.least_lx = 1.44;
    const std::vector<Verdict> all = verdicts(task_named("road.p3"), reached);
    ASSERT_EQ(all.size(), 4);
    EXPECT_EQ(all[0].passes(), true);
    EXPECT_TRUE(all[1].is_limit); // a mean of more than 1.5 times is another class
    EXPECT_EQ(all[1].passes(), true);
    EXPECT_EQ(all[2].passes(), false);
    EXPECT_EQ(all[3].passes(), std::nullopt);
    reached.mean_lx = 11.6;
    EXPECT_EQ(verdicts(task_named("road.p3"), reached)[1].passes(), false);
    reached.ti_percent = 25.4;
    EXPECT_EQ(verdicts(task_named("road.p3"), reached)[3].passes(), true);
    reached.mean_nt = 0.744;
    EXPECT_EQ(verdicts(task_named("road.m4"), reached)[0].passes(), false);
    reached.mean_nt = 0.746;
    EXPECT_EQ(verdicts(task_named("road.m4"), reached)[0].passes(), true);
}

TEST(Tasks, AreReadFromATable) {
    const std::vector<Task> tasks =
        parse_tasks("# ours\nname,title,mean_lx,ugr,uniformity\r\n a ,\"bench, fine\",750,16,\n\nb,,,22,0.5", "t.csv")
            .value();
    ASSERT_EQ(tasks.size(), 2);
    EXPECT_EQ(tasks[0].name, "a");
    EXPECT_EQ(tasks[0].title, "bench, fine");
    EXPECT_EQ(tasks[0].mean_lx, 750.0);
    EXPECT_FALSE(tasks[0].uniformity);
    EXPECT_EQ(tasks[1].uniformity, 0.5);
    EXPECT_FALSE(tasks[1].mean_lx);
}

TEST(Tasks, RefuseBadTables) {
    const auto said = [](std::string_view text) {
        const auto tasks = parse_tasks(text, "t.csv");
        return tasks ? std::string("read") : to_text(tasks.error().diagnostics.back());
    };
    EXPECT_NE(said("").find("no line of column names"), std::string::npos);
    EXPECT_NE(said("name,mean\n").find("t.csv:1:6: error[INP0101]: unknown column 'mean'"), std::string::npos);
    EXPECT_NE(said("mean_lx\n5\n").find("no column 'name'"), std::string::npos);
    EXPECT_NE(said("name,name\n").find("there twice"), std::string::npos);
    EXPECT_NE(said("name,mean_lx\na,500lx\n").find("t.csv:2:3: error[INP0101]: '500lx' is not a number above 0"),
              std::string::npos);
    EXPECT_NE(said("name,mean_lx\na,-1\n").find("above 0"), std::string::npos);
    EXPECT_NE(said("name,mean_lx\na\n").find("1 fields under 2 columns"), std::string::npos);
    EXPECT_NE(said("name,mean_lx\n,5\n").find("without a name"), std::string::npos);
    EXPECT_NE(said("name\na\na\n").find("'a' is there twice"), std::string::npos);
}

} // namespace
} // namespace gonio
