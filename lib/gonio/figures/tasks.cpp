#include <gonio/base/nearest.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/figures/tasks.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace gonio {

namespace {

constexpr const char* en_12464_2021 = "EN 12464-1:2021";
constexpr const char* en_12464_2011 = "EN 12464-1:2011";
constexpr const char* en_12193_2007 = "EN 12193:2007";
constexpr const char* en_13201_2015 = "EN 13201-2:2015";

Task indoor(const char* name, const char* title, double mean_lx, double raised_lx, double uniformity, double ra,
            double ugr, double cylindrical_lx, double wall_lx, double ceiling_lx) {
    return {name, title, en_12464_2021,  mean_lx, raised_lx, {}, uniformity,
            ugr,  ra,    cylindrical_lx, wall_lx, ceiling_lx};
}

Task indoor_2011(const char* name, const char* title, double mean_lx, double ugr, double uniformity, double ra) {
    return {name, title, en_12464_2011, mean_lx, {}, {}, uniformity, ugr, ra};
}

Task road_m(const char* name, double mean_nt, double uniformity, double longitudinal, double ti_percent,
            double edge_ratio) {
    Task task{name, "motorised traffic", en_13201_2015};
    task.mean_nt = mean_nt;
    task.luminance_uniformity = uniformity;
    task.longitudinal_uniformity = longitudinal;
    task.ti_percent = ti_percent;
    task.edge_ratio = edge_ratio;
    return task;
}

Task road_c(const char* name, double mean_lx, double ti_percent) {
    Task task{name, "conflict area of motorised traffic", en_13201_2015, mean_lx, {}, {}, 0.4};
    task.ti_percent = ti_percent;
    return task;
}

Task road_p(const char* name, double mean_lx, double least_lx, double ti_percent) {
    Task task{name, "pedestrians and slow traffic", en_13201_2015, mean_lx, {}, least_lx};
    task.greatest_mean_lx = 1.5 * mean_lx;
    task.ti_percent = ti_percent;
    return task;
}

Task sport(const char* name, const char* title, double mean_lx, double uniformity, double ra,
           std::optional<double> gr = {}) {
    Task task{name, title, en_12193_2007, mean_lx, {}, {}, uniformity, {}, ra};
    task.gr = gr;
    return task;
}

const std::array known{
    indoor("office.filing", "filing, copying", 300, 500, 0.4, 80, 19, 100, 100, 75),
    indoor("office.writing", "writing, reading, data processing", 500, 1000, 0.6, 80, 19, 150, 150, 100),
    indoor("office.drawing", "technical drawing", 750, 1500, 0.7, 80, 16, 150, 150, 100),
    indoor("office.meeting", "conference and meeting rooms", 500, 1000, 0.6, 80, 19, 150, 150, 100),
    indoor("office.reception", "reception desk", 300, 750, 0.6, 80, 22, 100, 100, 75),
    indoor("office.archive", "archives", 200, 300, 0.4, 80, 25, 75, 75, 50),
    indoor_2011("traffic.corridor", "corridors", 100, 28, 0.4, 40),
    indoor_2011("traffic.stairs", "stairs, escalators", 100, 25, 0.4, 40),
    indoor_2011("school.classroom", "classrooms", 300, 19, 0.6, 80),
    indoor_2011("school.lecture-hall", "lecture halls", 500, 19, 0.6, 80),
    road_m("road.m1", 2.0, 0.4, 0.7, 10, 0.35),
    road_m("road.m2", 1.5, 0.4, 0.7, 10, 0.35),
    road_m("road.m3", 1.0, 0.4, 0.6, 15, 0.3),
    road_m("road.m4", 0.75, 0.4, 0.6, 15, 0.3),
    road_m("road.m5", 0.5, 0.35, 0.4, 15, 0.3),
    road_m("road.m6", 0.3, 0.35, 0.4, 20, 0.3),
    road_c("road.c0", 50, 10),
    road_c("road.c1", 30, 10),
    road_c("road.c2", 20, 15),
    road_c("road.c3", 15, 15),
    road_c("road.c4", 10, 15),
    road_c("road.c5", 7.5, 20),
    road_p("road.p1", 15, 3, 20),
    road_p("road.p2", 10, 2, 25),
    road_p("road.p3", 7.5, 1.5, 25),
    road_p("road.p4", 5, 1, 30),
    road_p("road.p5", 3, 0.6, 30),
    road_p("road.p6", 2, 0.4, 35),
    sport("sports.football.i", "football outdoors, international and national matches", 500, 0.7, 60, 50),
    sport("sports.football.ii", "football outdoors, regional and local matches", 200, 0.6, 60, 50),
    sport("sports.football.iii", "football outdoors, training, school, leisure", 75, 0.5, 20, 55),
    sport("sports.tennis.i", "tennis outdoors, international and national matches", 500, 0.7, 60, 50),
    sport("sports.tennis.ii", "tennis outdoors, regional and local matches", 300, 0.7, 60, 50),
    sport("sports.tennis.iii", "tennis outdoors, training, school, leisure", 200, 0.6, 20, 55),
    sport("sports.hall-ball.i", "ball games in halls, international and national matches", 750, 0.7, 60),
    sport("sports.hall-ball.ii", "ball games in halls, regional and local matches", 500, 0.7, 60),
    sport("sports.hall-ball.iii", "ball games in halls, training, school, leisure", 200, 0.5, 20),
};

// The numbers of a task, and what is said of each.
struct Requirement {
    std::string_view key;
    std::string_view what;
    std::string_view unit;
    int decimals; // of lux below 10 one more
    std::optional<double> Task::*required;
    std::optional<double> ReachedLight::*reached; // nullptr: compared under another name
    bool is_limit;
};

using R = ReachedLight;
constexpr std::array requirements{
    Requirement{"mean_lx", "mean illuminance", "lx", 0, &Task::mean_lx, &R::mean_lx, false},
    Requirement{"raised_mean_lx", "raised mean illuminance", "lx", 0, &Task::raised_mean_lx, nullptr, false},
    Requirement{"greatest_mean_lx", "mean illuminance", "lx", 0, &Task::greatest_mean_lx, &R::mean_lx, true},
    Requirement{"least_lx", "least illuminance", "lx", 0, &Task::least_lx, &R::least_lx, false},
    Requirement{"uniformity", "uniformity U0", "", 2, &Task::uniformity, &R::uniformity, false},
    Requirement{"mean_nt", "mean luminance", "cd/m²", 2, &Task::mean_nt, &R::mean_nt, false},
    Requirement{"luminance_uniformity", "uniformity U0 of luminance", "", 2, &Task::luminance_uniformity,
                &R::luminance_uniformity, false},
    Requirement{"longitudinal_uniformity", "longitudinal uniformity Ul", "", 2, &Task::longitudinal_uniformity,
                &R::longitudinal_uniformity, false},
    Requirement{"ti_percent", "threshold increment TI", "%", 0, &Task::ti_percent, &R::ti_percent, true},
    Requirement{"edge_ratio", "edge illuminance ratio", "", 2, &Task::edge_ratio, &R::edge_ratio, false},
    Requirement{"gr", "glare rating GR", "", 1, &Task::gr, &R::gr, true},
    Requirement{"ugr", "UGR", "", 1, &Task::ugr, &R::ugr, true},
    Requirement{"ra", "colour rendering Ra", "", 0, &Task::ra, &R::ra, false},
    Requirement{"cylindrical_lx", "cylindrical illuminance", "lx", 0, &Task::cylindrical_lx, &R::cylindrical_lx, false},
    Requirement{"wall_lx", "illuminance of the walls", "lx", 0, &Task::wall_lx, &R::wall_lx, false},
    Requirement{"ceiling_lx", "illuminance of the ceiling", "lx", 0, &Task::ceiling_lx, &R::ceiling_lx, false},
};

// Texts of a task.
constexpr std::array<std::pair<std::string_view, std::string Task::*>, 3> texts{
    {{"name", &Task::name}, {"title", &Task::title}, {"rule", &Task::rule}}};

// One field of a line, without spaces around it; quotes allow commas.
struct Field {
    std::string text;
    std::uint32_t column = 1;
};

std::vector<Field> fields_of(std::string_view line) {
    std::vector<Field> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (c == '"') {
            if (quoted && i + 1 < line.size() && line[i + 1] == '"') {
                fields.back().text += c;
                ++i;
            } else {
                quoted = !quoted;
            }
        } else if (c == ',' && !quoted) {
            fields.push_back({{}, static_cast<std::uint32_t>(i) + 2});
        } else {
            fields.back().text += c;
        }
    }
    for (Field& field : fields) {
        const std::size_t first = field.text.find_first_not_of(" \t\r");
        const std::size_t last = field.text.find_last_not_of(" \t\r");
        field.text = first == std::string::npos ? std::string() : field.text.substr(first, last - first + 1);
    }
    return fields;
}

// Reads a table, line by line.
class TableReader {
public:
    explicit TableReader(const std::string& source) : source_(source) {}

    Result<void> line(std::string_view text) {
        ++line_;
        const std::size_t visible = text.find_first_not_of(" \t\r");
        if (visible == std::string_view::npos || text[visible] == '#') return {};
        const std::vector<Field> fields = fields_of(text);
        return columns_.empty() ? heading(fields) : task(fields);
    }

    Result<std::vector<Task>> take() {
        if (columns_.empty())
            return fail("INP0101", fmt::format("{}: the table has no line of column names", source_),
                        "the first line names the columns: name,mean_lx,uniformity,ugr,ra");
        return std::move(tasks_);
    }

private:
    Unexpected bad(std::uint32_t column, std::string message, std::string hint) const {
        return Unexpected(error_at("INP0101", {source_, line_, column}, std::move(message), std::move(hint)));
    }

    Result<void> heading(const std::vector<Field>& fields) {
        std::vector<std::string_view> names;
        for (const auto& [name, member] : texts)
            names.push_back(name);
        for (const Requirement& requirement : requirements)
            names.push_back(requirement.key);
        for (const Field& field : fields) {
            if (std::find(names.begin(), names.end(), field.text) == names.end()) {
                const std::string_view guess = nearest(field.text, names);
                return bad(field.column, fmt::format("unknown column '{}'", field.text),
                           guess.empty() ? fmt::format("columns are {}", fmt::join(names, ", "))
                                         : fmt::format("did you mean '{}'?", guess));
            }
            if (std::find(columns_.begin(), columns_.end(), field.text) != columns_.end())
                return bad(field.column, fmt::format("the column '{}' is there twice", field.text), "leave one out");
            columns_.push_back(field.text);
        }
        if (std::find(columns_.begin(), columns_.end(), "name") == columns_.end())
            return bad(1, "the table has no column 'name'", "--task finds a task by its name");
        return {};
    }

    Result<void> task(const std::vector<Field>& fields) {
        if (fields.size() != columns_.size())
            return bad(fields.back().column, fmt::format("{} fields under {} columns", fields.size(), columns_.size()),
                       "write an empty field where there is no requirement");
        Task task;
        for (std::size_t i = 0; i < fields.size(); ++i)
            if (Result<void> read = field(columns_[i], fields[i], task); !read) return read;
        if (task.name.empty()) return bad(1, "a task without a name", "fill in the column 'name'");
        if (std::any_of(tasks_.begin(), tasks_.end(), [&](const Task& other) { return other.name == task.name; }))
            return bad(1, fmt::format("the task '{}' is there twice", task.name), "leave one out");
        tasks_.push_back(std::move(task));
        return {};
    }

    Result<void> field(std::string_view column, const Field& field, Task& task) const {
        for (const auto& [name, member] : texts)
            if (name == column) task.*member = field.text;
        for (const Requirement& requirement : requirements) {
            if (requirement.key != column || field.text.empty()) continue;
            const std::optional<double> number = parse_number(field.text);
            if (!number || !(*number > 0.0))
                return bad(field.column, fmt::format("'{}' is not a number above 0", field.text),
                           "a requirement is a number without a unit; leave the field empty for none");
            task.*requirement.required = *number;
        }
        return {};
    }

    const std::string& source_;
    std::uint32_t line_ = 0;
    std::vector<std::string> columns_;
    std::vector<Task> tasks_;
};

// The decimals by which a value is stated.
int decimals_of(const Requirement& requirement, double value) {
    return requirement.decimals + (requirement.unit == "lx" && value < 10.0 ? 1 : 0);
}

} // namespace

std::span<const Task> known_tasks() {
    return known;
}

Result<std::vector<Task>> parse_tasks(std::string_view text, const std::string& source) {
    TableReader reader(source);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (Result<void> read = reader.line(text.substr(0, end)); !read) return pass_on(read);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return reader.take();
}

std::optional<bool> Verdict::passes() const {
    if (!reached) return std::nullopt;
    const double steps = std::pow(10.0, decimals);
    const double stated = std::round(*reached * steps) / steps;
    return is_limit ? stated <= required : stated >= required;
}

std::vector<Verdict> verdicts(const Task& task, const ReachedLight& reached, bool raised) {
    std::vector<Verdict> all;
    for (const Requirement& requirement : requirements) {
        if (requirement.reached == nullptr) continue;
        std::optional<double> required = task.*requirement.required;
        if (raised && requirement.required == &Task::mean_lx && task.raised_mean_lx) required = task.raised_mean_lx;
        if (!required) continue;
        all.push_back({requirement.key, requirement.what, requirement.unit, *required, requirement.is_limit,
                       reached.*requirement.reached,
                       decimals_of(requirement, (reached.*requirement.reached).value_or(*required))});
    }
    return all;
}

} // namespace gonio
