// Prints the front of the tables of `gonio bake --table`: bytes against the error of a lookup, with the tables of
// three.js where a folder holds them (tests/tables/published.mjs writes it).
//
//     gonio-table-front [FOLDER]          tables in Markdown
//     gonio-table-front FOLDER --chart    a chart of dfg and ltc-ggx, an SVG on stdout
#include <gonio/base/file.hpp>
#include <gonio/measure/pareto.hpp>
#include <gonio/plot/log_log.hpp>
#include <gonio/table/stored_table.hpp>
#include <gonio/table/table_error.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace gonio;

struct Row {
    std::string series; // "root, half"
    std::string size;
    std::size_t bytes;
    TableError error;
};

// Halves of a file, as numbers.
std::vector<double> halves(const std::string& file) {
    std::vector<double> values;
    const Result<std::string> bytes = read_file(file, limit("output-bytes"));
    if (!bytes) return values;
    for (std::size_t i = 0; i + 1 < bytes->size(); i += 2)
        values.push_back(half_value(static_cast<unsigned char>((*bytes)[i]) |
                                    (static_cast<std::uint32_t>(static_cast<unsigned char>((*bytes)[i + 1])) << 8U)));
    return values;
}

// Bilinear between the middles of texels, held at the edge: u and v as a texture unit takes them.
std::array<double, 4> sample(const std::vector<double>& texels, std::size_t channels, std::size_t size, double u,
                             double v) {
    const auto last = static_cast<double>(size - 1);
    const double x = std::fmin(std::fmax(u * static_cast<double>(size) - 0.5, 0.0), last);
    const double y = std::fmin(std::fmax(v * static_cast<double>(size) - 0.5, 0.0), last);
    const auto left = static_cast<std::size_t>(x);
    const auto top = static_cast<std::size_t>(y);
    const std::size_t right = std::min(left + 1, size - 1);
    const std::size_t bottom = std::min(top + 1, size - 1);
    std::array<double, 4> result{};
    for (std::size_t c = 0; c < channels; ++c) {
        const auto at = [&](std::size_t column, std::size_t row) {
            return texels[(row * size + column) * channels + c];
        };
        const auto mixed = [](double a, double b, double share) { return a + share * (b - a); };
        result[c] = mixed(mixed(at(left, top), at(right, top), x - static_cast<double>(left)),
                          mixed(at(left, bottom), at(right, bottom), x - static_cast<double>(left)),
                          y - static_cast<double>(top));
    }
    return result;
}

constexpr std::size_t heitz_size = 64;

// Heitz and others' table as three.js has it, 64 x 64: two layers of four halves in the axes and channels of ltc-heitz.
ShadingTable three_ltc(const std::string& folder) {
    ShadingTable table{TableKind::ltc_heitz, TableAxes::heitz, TableForm::bilinear, heitz_size, heitz_size, {}};
    const std::vector<double> first = halves(folder + "/ltc_1.half");
    const std::vector<double> second = halves(folder + "/ltc_2.half");
    if (first.size() != heitz_size * heitz_size * 4 || second.size() != first.size()) return table;
    for (std::size_t texel = 0; texel < heitz_size * heitz_size; ++texel)
        for (const std::vector<double>* const layer : {&first, &second})
            for (std::size_t c = 0; c < 4; ++c)
                table.values.push_back(static_cast<float>((*layer)[texel * 4 + c]));
    return table;
}

void add_three_ltc(const ShadingTable& three, const TableTruth& truth, std::vector<Row>& rows) {
    if (three.values.empty()) return;
    const TableError error = truth.error_of_lobes([&](double mu, double roughness) {
        return lobe_of(TableKind::ltc_heitz, three.lookup(mu, roughness), mu, roughness);
    });
    rows.push_back({"three.js (Heitz et al.)", "64 x 64", three.values.size() * 2, error});
}

// The greatest differences of ltc-heitz to three.js' table where both must agree: everywhere for what is an integral of
// GGX or of a sphere; at n.v = 1 for the matrix, where the lobe is round and its fit has one number. false if they do
// not.
bool compare_to_three(const ShadingTable& three) {
    const Result<ShadingTable> made =
        make_shading_table(TableKind::ltc_heitz, TableForm::bilinear, TableAxes::heitz, heitz_size, heitz_size);
    if (!made) return false;
    std::array<double, 8> greatest{};
    std::array<double, 8> least_cosines{}; // of rows: theirs are by random directions in the last ones
    least_cosines[4] = least_cosines[5] = 0.1;
    for (std::size_t row = 0; row < heitz_size; ++row)
        for (std::size_t column = 0; column < heitz_size; ++column)
            for (std::size_t c = 0; c < 8; ++c) {
                const double down = static_cast<double>(row) / (heitz_size - 1.0);
                const bool counts = c < 4 ? row == 0 : 1.0 - down * down >= least_cosines[c];
                const std::size_t at = (row * heitz_size + column) * 8 + c;
                if (counts)
                    greatest[c] = std::max(greatest[c], std::fabs(static_cast<double>(made->values[at]) -
                                                                  static_cast<double>(three.values[at])));
            }
    (void)std::printf(
        "Greatest differences to the numbers of three.js, of matrices at n·v = 1 and of integrals at n·v from "
        "0.1: m00 %.1e, m20 %.1e, m02 %.1e, m22 %.1e, magnitude %.1e, fresnel %.1e, sphere %.1e.\n\n",
        greatest[0], greatest[1], greatest[2], greatest[3], greatest[4], greatest[5], greatest[7]);
    return greatest[5] < 2e-3 && greatest[7] < 1e-3;
}

// 16 x 16, two halves; u = roughness, v = n·v, at the middles of texels.
void add_three_dfg(const std::string& folder, const TableTruth& truth, std::vector<Row>& rows) {
    constexpr std::size_t size = 16;
    const std::vector<double> texels = halves(folder + "/dfg.half");
    if (texels.size() != size * size * 2) return;
    const TableError error = truth.error_of_values([&](double mu, double roughness) {
        const std::array found = sample(texels, 2, size, roughness, mu);
        return TableValues{found[0], found[1]};
    });
    rows.push_back({"three.js", "16 x 16", texels.size() * 2, error});
}

std::vector<Row> rows_of(TableKind kind, const std::string& folder) {
    const TableTruth truth(kind);
    const TableInfo& info = info_of(kind);
    std::vector<Row> rows;
    const auto add = [&](TableForm form, TableAxes axes, int size, TablePixel pixel, const std::string& series) {
        Result<ShadingTable> table = make_shading_table(kind, form, axes, size, size);
        if (!table) return;
        const Result<StoredTable> stored = store_table(std::move(*table), pixel);
        if (!stored) return;
        rows.push_back({series, std::to_string(size) + " x " + std::to_string(size), raw_bytes(*stored).size(),
                        truth.error_of(stored->table)});
    };
    constexpr std::array pixels{TablePixel::float32, TablePixel::half, TablePixel::rgb9e5, TablePixel::uint16,
                                TablePixel::uint8};
    for (const TableAxes axes : info.axes)
        for (const TablePixel pixel : pixels)
            for (const int size : {8, 16, 32, 64})
                add(TableForm::bilinear, axes, size, pixel,
                    std::string(to_text(axes)) + ", " + std::string(info_of(pixel).name));
    for (const int terms : {4, 6, 8, 10, 12, 16})
        add(TableForm::chebyshev, TableAxes::root, terms, TablePixel::float32, "chebyshev, float");
    if (!folder.empty() && (kind == TableKind::ltc_ggx || kind == TableKind::ltc_heitz))
        add_three_ltc(three_ltc(folder), truth, rows);
    if (!folder.empty() && kind == TableKind::dfg) add_three_dfg(folder, truth, rows);
    return rows;
}

// Which rows no other beats: as good in bytes and in the error of 95 %, and better in one of them.
std::vector<bool> front_of(const std::vector<Row>& rows) {
    std::vector<measure::ErrorAndTime> points;
    for (const Row& row : rows)
        points.push_back({row.error.p95, static_cast<double>(row.bytes)});
    return measure::pareto_front(points);
}

void print(TableKind kind, const std::vector<Row>& rows) {
    const std::string_view of = info_of(kind).error;
    (void)std::printf("**%s**: %.*s\n\n", std::string(info_of(kind).name).c_str(), static_cast<int>(of.size()),
                      of.data());
    (void)std::printf("| table | size | bytes | median | 95 %% | max | front |\n|---|---|---:|---:|---:|---:|---|\n");
    const std::vector<bool> front = front_of(rows);
    for (std::size_t i = 0; i < rows.size(); ++i)
        (void)std::printf("| %s | %s | %zu | %.1e | %.1e | %.1e | %s |\n", rows[i].series.c_str(), rows[i].size.c_str(),
                          rows[i].bytes, rows[i].error.median, rows[i].error.p95, rows[i].error.max,
                          front[i] ? "★" : "");
    (void)std::printf("\n");
}

// Those of all rows that a chart has room for.
std::vector<Row> drawn(const std::vector<Row>& rows) {
    std::vector<Row> kept;
    for (const Row& row : rows)
        for (const std::string_view series :
             {"linear, half", "root, half", "root, uint8", "chebyshev, float", "three.js", "three.js (Heitz et al.)"})
            if (row.series == series) kept.push_back(row);
    return kept;
}

LogLogPanel panel_of(TableKind kind, const std::vector<Row>& all) {
    const std::vector<Row> rows = drawn(all);
    LogLogPanel panel{std::string(info_of(kind).name), "bytes", "error of a lookup, 95 %", {}};
    const std::vector<bool> front = front_of(rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool is_ours = !rows[i].series.starts_with("three");
        if (panel.series.empty() || panel.series.back().name != rows[i].series)
            panel.series.push_back({rows[i].series, {}, is_ours});
        MarkedPoint point{static_cast<double>(rows[i].bytes), rows[i].error.p95};
        point.mark = is_ours ? Mark::circle : Mark::diamond;
        point.filled = front[i] || !is_ours;
        panel.series.back().points.push_back(point);
        if (front[i]) panel.front.push_back(point);
    }
    std::sort(panel.front.begin(), panel.front.end(),
              [](const MarkedPoint& a, const MarkedPoint& b) { return a.x < b.x; });
    return panel;
}

} // namespace

int main(int count, char** arguments) {
    const std::string folder = count > 1 ? arguments[1] : "";
    const bool draws = count > 2 && std::string_view(arguments[2]) == "--chart";
    std::vector<LogLogPanel> panels;
    for (const TableInfo& info : table_infos()) {
        const std::vector<Row> rows = rows_of(info.kind, folder);
        if (!draws)
            print(info.kind, rows);
        else if (info.kind == TableKind::dfg || info.kind == TableKind::ltc_ggx)
            panels.push_back(panel_of(info.kind, rows));
    }
    if (!draws) {
        const ShadingTable three = three_ltc(folder);
        return three.values.empty() || compare_to_three(three) ? 0 : 1;
    }
    LogLogOptions options;
    options.title = "Tables: bytes against the error of a lookup";
    options.note = "Filled and joined in grey: what no other table here beats in both. Diamond: three.js. 512 poses.";
    const Result<std::string> chart = log_log_panels(panels, options);
    if (!chart) return 1;
    (void)std::fwrite(chart->data(), 1, chart->size(), stdout);
    return 0;
}
