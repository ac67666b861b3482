#include "points_input.hpp"

#include <gonio/base/file.hpp>
#include <gonio/base/unit_text.hpp>

#include "values.hpp"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace gonio::cli {

namespace {

constexpr std::array<std::string_view, 6> column_names{"x", "y", "z", "nx", "ny", "nz"};
constexpr std::size_t absent = static_cast<std::size_t>(-1);

struct Field {
    std::string_view text; // without blanks around it
    std::uint32_t column;  // of its first character, from 1
};

bool blank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

std::vector<Field> fields_of(std::string_view line) {
    std::vector<Field> fields;
    std::size_t start = 0;
    for (;;) {
        const std::size_t comma = std::min(line.find(',', start), line.size());
        std::size_t first = start;
        std::size_t last = comma;
        while (first < last && blank(line[first]))
            ++first;
        while (last > first && blank(line[last - 1]))
            --last;
        fields.push_back({line.substr(first, last - first), static_cast<std::uint32_t>(first + 1)});
        if (comma == line.size()) return fields;
        start = comma + 1;
    }
}

Unexpected malformed(const std::string& source, std::uint32_t line, std::uint32_t column, std::string message,
                     std::string hint = {}) {
    return Unexpected(error_at(Failure::malformed, {source, line, column}, std::move(message), std::move(hint)));
}

// Which field of a line is x, y, z, nx, ny, nz.
struct Columns {
    std::array<std::size_t, 6> at{0, 1, 2, 3, 4, 5};
    bool named = false;

    bool have_normal(std::size_t fields) const { return named ? at[3] != absent : fields == 6; }
};

Result<Columns> read_header(const std::vector<Field>& fields, const std::string& source, std::uint32_t line) {
    Columns columns;
    columns.named = true;
    columns.at.fill(absent);
    for (std::size_t f = 0; f < fields.size(); ++f)
        for (std::size_t c = 0; c < column_names.size(); ++c) {
            if (fields[f].text != column_names[c]) continue;
            if (columns.at[c] != absent)
                return malformed(source, line, fields[f].column,
                                 fmt::format("two columns are named '{}'", fields[f].text));
            columns.at[c] = f;
        }
    const auto normals = static_cast<std::size_t>(
        std::count_if(columns.at.begin() + 3, columns.at.end(), [](std::size_t f) { return f != absent; }));
    for (std::size_t c = 0; c < column_names.size(); ++c)
        if (columns.at[c] == absent && (c < 3 || normals > 0))
            return malformed(source, line, 1, fmt::format("the column '{}' is missing", column_names[c]),
                             "columns are x,y,z or x,y,z,nx,ny,nz");
    return columns;
}

// Unless the text is `known` to be a table of points it may be any file, and a message must not quote its contents.
Result<Receiver> read_row(const std::vector<Field>& fields, const Columns& columns, const std::string& source,
                          std::uint32_t line, const glm::dvec3& default_normal, bool known) {
    if (!columns.named && fields.size() != 3 && fields.size() != 6)
        return malformed(source, line, 1, fmt::format("{} values where 3 or 6 are expected", fields.size()),
                         "write x,y,z or x,y,z,nx,ny,nz");
    const bool with_normal = columns.have_normal(fields.size());
    std::array<double, 6> values{};
    for (std::size_t c = 0; c < (with_normal ? 6U : 3U); ++c) {
        if (columns.at[c] >= fields.size())
            return malformed(source, line, 1, fmt::format("the value for '{}' is missing", column_names[c]));
        const Field& field = fields[columns.at[c]];
        const std::optional<double> number = parse_number(field.text);
        if (!number)
            return malformed(source, line, field.column,
                             known ? fmt::format("'{}' is not a number", field.text) : "not a table of points",
                             known ? "" : "write x,y,z or x,y,z,nx,ny,nz");
        values[c] = *number;
    }
    const Receiver receiver{{values[0], values[1], values[2]},
                            with_normal ? glm::dvec3(values[3], values[4], values[5]) : default_normal};
    if (!unit_vector(receiver.normal))
        return malformed(source, line, fields[columns.at[3]].column, "the normal is zero");
    return receiver;
}

void take(ReceiverGrid grid, Points& points) {
    points.receivers = std::move(grid.receivers);
    grid.receivers.clear();
    points.grid = std::move(grid);
}

std::vector<std::string_view> split(std::string_view text, char at) {
    std::vector<std::string_view> parts;
    for (std::size_t end = text.find(at); end != std::string_view::npos; end = text.find(at)) {
        parts.push_back(text.substr(0, end));
        text.remove_prefix(end + 1);
    }
    parts.push_back(text);
    return parts;
}

// "O:U:V:NxM" or "O:U:V".
Result<Points> parse_grid(const std::string& text, const std::optional<glm::dvec3>& normal,
                          const std::optional<GridSpacing>& spacing) {
    const std::vector<std::string_view> parts = split(text, ':');
    if (parts.size() < 3 || parts.size() > 4)
        return fail("USE0105", fmt::format("--grid does not take '{}'", text),
                    "write CORNER:EDGE:EDGE:NxM, for example -2,-2,0:4,0,0:0,4,0:21x21");
    std::array<glm::dvec3, 3> vectors;
    for (std::size_t p = 0; p < vectors.size(); ++p) {
        Result<glm::dvec3> vector = parse_vector(
            parts[p], std::array{"the corner of --grid", "the edge U of --grid", "the edge V of --grid"}[p]);
        if (!vector) return pass_on(vector);
        vectors[p] = *vector;
    }
    const auto& [corner, u, v] = vectors;
    const std::optional<glm::dvec3> upright = unit_vector(glm::cross(u, v));
    const auto no_normal = [] {
        return fail(Failure::usage, "the edges of --grid span no area, so it has no normal", "add --normal X,Y,Z");
    };
    Points points;
    if (parts.size() == 3) {
        if (!normal && !upright) return no_normal();
        Result<ReceiverGrid> grid =
            parallelogram_grid(corner, u, v, spacing.value_or(GridSpacing()), normal ? *normal : *upright, max_points);
        if (!grid) return pass_on(grid);
        take(std::move(*grid), points);
        return points;
    }
    if (spacing)
        return fail("USE0107", "--spacing and a number of points in --grid are both given",
                    "leave the :NxM of --grid out");
    Result<PixelSize> size = parse_size(parts[3]);
    if (!size) {
        error_hint(size.error(), "write the number of points of --grid as NxM, for example 21x21");
        return pass_on(size);
    }
    if (size->width < 1 || size->height < 1 ||
        static_cast<std::size_t>(size->width) > max_points / static_cast<std::size_t>(size->height))
        return fail(
            "USE0106",
            fmt::format("a grid of {} points is out of range: it may have 1 to {}", parts[3], to_text(limit("points"))),
            std::string(limits_hint));
    if (!normal && !upright) return no_normal();

    ReceiverGrid grid{corner, u,  v, static_cast<std::size_t>(size->width), static_cast<std::size_t>(size->height),
                      {},     {}, {}};
    points.receivers.reserve(grid.columns * grid.rows);
    for (int j = 0; j < size->height; ++j)
        for (int i = 0; i < size->width; ++i)
            points.receivers.push_back(
                {corner + u * ((i + 0.5) / size->width) + v * ((j + 0.5) / size->height), normal ? *normal : *upright});
    points.grid = std::move(grid);
    return points;
}

// "P:P:P".
Result<Points> parse_polygon(const std::string& text, const std::optional<glm::dvec3>& normal,
                             const GridSpacing& spacing) {
    std::vector<glm::dvec3> corners;
    for (const std::string_view part : split(text, ':')) {
        Result<glm::dvec3> corner = parse_vector(part, fmt::format("corner {} of --polygon", corners.size() + 1));
        if (!corner) return pass_on(corner);
        corners.push_back(*corner);
    }
    Result<ReceiverGrid> grid = polygon_grid(corners, spacing, normal, max_points);
    if (!grid) return pass_on(grid);
    Points points;
    take(std::move(*grid), points);
    return points;
}

// A length of an option, from `least` on.
Result<std::optional<double>> length_input(const Arguments& arguments, std::string_view option, bool may_be_zero) {
    const auto text = arguments.value(option);
    if (!text) return std::optional<double>();
    Result<double> length = parse_amount(*text, Dimension::length, option);
    if (!length) return pass_on(length);
    if (*length > 0.0 || (may_be_zero && *length == 0.0)) return std::optional(*length);
    return fail("USE0106",
                fmt::format("{} must be {}, not {}", option, may_be_zero ? "0 or greater" : "greater than 0", *text));
}

// --spacing: a length, or the name of a standard; empty if it is not given.
Result<std::optional<GridSpacing>> spacing_input(const Arguments& arguments) {
    if (!arguments.has("--spacing")) return std::optional<GridSpacing>();
    const std::string text = *arguments.value("--spacing");
    if (text == "en12193") return std::optional(GridSpacing{{}, true});
    if (text == "en12464") return std::optional(GridSpacing());
    Result<std::optional<double>> length = length_input(arguments, "--spacing", false);
    if (!length) {
        error_hint(length.error(), "a length (50cm), or en12464 or en12193");
        return pass_on(length);
    }
    return std::optional(GridSpacing{*length, false});
}

Result<Workplane> read_workplane(const Arguments& arguments, const GridSpacing& spacing) {
    Workplane plane;
    plane.spacing = spacing;
    Result<double> height = parse_amount(*arguments.value("--workplane"), Dimension::length, "--workplane");
    if (!height) return pass_on(height);
    plane.height_m = *height;
    Result<std::optional<double>> zone = length_input(arguments, "--wall-zone", true);
    if (!zone) return pass_on(zone);
    plane.wall_zone_m = zone->value_or(plane.wall_zone_m);
    return plane;
}

} // namespace

Result<std::vector<Receiver>> parse_points(std::string_view text, const std::string& source,
                                           const glm::dvec3& default_normal) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3); // a byte order mark
    std::vector<Receiver> receivers;
    Columns columns;
    bool first = true;
    for (std::uint32_t line = 1; !text.empty(); ++line) {
        const std::size_t end = text.find('\n');
        const std::string_view row = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        const std::vector<Field> fields = fields_of(row);
        if ((fields.size() == 1 && fields[0].text.empty()) || fields[0].text.starts_with('#')) continue;
        const bool letters = !fields[0].text.empty() && !parse_number(fields[0].text) &&
                             std::isalpha(static_cast<unsigned char>(fields[0].text.front())) != 0;
        if (std::exchange(first, false) && letters) {
            Result<Columns> header = read_header(fields, source, line);
            if (!header) return pass_on(header);
            columns = *header;
            continue;
        }
        Result<Receiver> receiver =
            read_row(fields, columns, source, line, default_normal, columns.named || !receivers.empty());
        if (!receiver) return pass_on(receiver);
        if (receivers.size() == max_points)
            return malformed(source, line, 1, fmt::format("there are more than {}", to_text(limit("points"))),
                             std::string(limits_hint));
        receivers.push_back(*receiver);
    }
    if (receivers.empty()) return malformed(source, 0, 0, "it holds no points");
    return receivers;
}

Result<Points> points_input(const Arguments& arguments) {
    const std::vector<std::string> at = arguments.values("--at");
    const auto file = arguments.value("--points");
    const auto grid = arguments.value("--grid");
    const auto polygon = arguments.value("--polygon");
    const bool has_workplane = arguments.has("--workplane");
    const int ways =
        (at.empty() ? 0 : 1) + (file ? 1 : 0) + (grid ? 1 : 0) + (polygon ? 1 : 0) + (has_workplane ? 1 : 0);
    if (ways != 1)
        return fail(ways == 0 ? Cause("USE0104") : Cause("USE0107"),
                    ways == 0 ? "no point is given"
                              : "more than one of --at, --points, --grid, --polygon and --workplane is given",
                    "use --at X,Y,Z, --points FILE.csv, --grid O:U:V:NxM, --polygon P:P:P or --workplane 75cm");
    if (arguments.has("--wall-zone") && !has_workplane)
        return fail("USE0104", "--wall-zone needs --workplane", "only a working plane has walls");
    if (arguments.has("--spacing") && !grid && !polygon && !has_workplane)
        return fail("USE0104", "--spacing needs --grid, --polygon or --workplane", "points by name have no spacing");
    Result<std::optional<GridSpacing>> spacing = spacing_input(arguments);
    if (!spacing) return pass_on(spacing);

    std::vector<glm::dvec3> normals;
    for (const std::string& text : arguments.values("--normal")) {
        Result<glm::dvec3> normal = parse_vector(text, "--normal");
        if (!normal) return pass_on(normal);
        if (!unit_vector(*normal))
            return fail("USE0106", "--normal is zero", "it is the direction that the surface faces");
        normals.push_back(*normal);
    }
    if (normals.size() > 1 && normals.size() != at.size())
        return fail("USE0107",
                    fmt::format("--normal is given {} times, --at {}", normals.size(),
                                at.empty() ? std::string("never") : fmt::format("{} times", at.size())),
                    "give one normal for all, or one for each --at");
    const glm::dvec3 default_normal = normals.empty() ? Receiver().normal : normals.front();
    const auto given_normal = normals.empty() ? std::nullopt : std::optional(normals.front());
    if (grid || polygon) {
        Result<Points> of_area = grid ? parse_grid(*grid, given_normal, *spacing)
                                      : parse_polygon(*polygon, given_normal, spacing->value_or(GridSpacing()));
        if (of_area) of_area->has_normals = !normals.empty();
        return of_area;
    }

    Points points;
    points.has_normals = !normals.empty();
    if (has_workplane) {
        Result<Workplane> plane = read_workplane(arguments, spacing->value_or(GridSpacing()));
        if (!plane) return pass_on(plane);
        points.workplane = *plane;
        points.receivers.push_back({glm::dvec3(0.0), default_normal}); // its normal
        return points;
    }
    if (file) {
        Result<std::string> text =
            *file == "-" ? read_standard_input(limit("table-bytes")) : read_file(*file, limit("table-bytes"));
        if (!text) return pass_on(text);
        Result<std::vector<Receiver>> receivers = parse_points(*text, *file, default_normal);
        if (!receivers) return pass_on(receivers);
        points.receivers = std::move(*receivers);
        return points;
    }
    for (std::size_t i = 0; i < at.size(); ++i) {
        Result<glm::dvec3> position = parse_vector(at[i], "--at");
        if (!position) return pass_on(position);
        points.receivers.push_back({*position, normals.size() > 1 ? normals[i] : default_normal});
    }
    return points;
}

Result<void> place_on(const Stage& stage, Points& points) {
    const Workplane& plane = *points.workplane;
    if (const Surface* const beyond = beyond_height(stage, plane.height_m))
        return fail("USE0106",
                    fmt::format("a working plane at {} m is behind '{}' of the stage '{}'", rounded(plane.height_m),
                                beyond->name, stage.name),
                    "it lies between the floor and the ceiling");
    const std::optional<FloorArea> area = area_between_walls(stage, plane.height_m);
    if (!area)
        return fail("USE0106",
                    fmt::format("the stage '{}' has no walls on four sides at a height of {} m", stage.name,
                                rounded(plane.height_m)),
                    "use --stage room, planes in the rig's stage that face along X and Y, --grid, or --polygon");
    const glm::dvec3 zone(plane.wall_zone_m, plane.wall_zone_m, 0.0);
    const glm::dvec3 size = area->high - area->low - 2.0 * zone;
    if (!(size.x > 0.0 && size.y > 0.0))
        return fail("USE0106",
                    fmt::format("a wall zone of {} m leaves nothing of {} by {} m", rounded(plane.wall_zone_m),
                                rounded(area->high.x - area->low.x), rounded(area->high.y - area->low.y)),
                    "use a smaller --wall-zone");
    Result<ReceiverGrid> grid = parallelogram_grid(area->low + zone, {size.x, 0.0, 0.0}, {0.0, size.y, 0.0},
                                                   plane.spacing, points.receivers.front().normal, max_points);
    if (!grid) return pass_on(grid);
    take(std::move(*grid), points);
    return {};
}

} // namespace gonio::cli
