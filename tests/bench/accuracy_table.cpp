// Prints the README's tables, measured now, in Markdown: relative error and time of every method of every shape on all
// poses mixed, and its rate in each stratum with the ratio to the packed Frostbite rectangle of the same width.
//
//   gonio-accuracy-table
#include <gonio/measure/area_methods.hpp>
#include <gonio/measure/sphere_methods.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using namespace gonio;
using measure::MethodMeasurement;
using measure::Stratum;

struct Shape {
    std::string name;
    std::vector<MethodMeasurement> rows;
};

bool measured(std::string name, Result<std::vector<MethodMeasurement>> rows, std::vector<Shape>& shapes) {
    if (!rows) {
        (void)std::fprintf(stderr, "%s\n", to_text(rows.error().diagnostics.back()).c_str());
        return false;
    }
    shapes.push_back({std::move(name), *std::move(rows)});
    return true;
}

// Million per second in the fastest sample: other programs of the machine only ever take time away.
double rate(const measure::Timing& timing) {
    return 1e3 / timing.lowest_ns;
}

const MethodMeasurement* find(const Shape& shape, const std::string& name, const std::string& precision) {
    for (const MethodMeasurement& row : shape.rows)
        if (row.name == name && row.precision == precision) return &row;
    return nullptr;
}

} // namespace

int main() {
    using Kind = shading::LightConstants::Kind;
    measure::ComparisonOptions options;
    options.cases_by_stratum = 4096; // stays in the second-level cache
    options.timing.samples = 41;
    options.timing.sample_seconds = 0.002;
    std::vector<Shape> shapes;
    if (!measured("sphere", measure::compare_sphere_methods(options), shapes) ||
        !measured("disk", measure::compare_area_methods(Kind::disk, options), shapes) ||
        !measured("rectangle", measure::compare_area_methods(Kind::rectangle, options), shapes) ||
        !measured("tube", measure::compare_area_methods(Kind::tube, options), shapes))
        return 1;

    (void)std::printf("| shape | method | code | median error | 95 %% below | worst | ns each | M/s |\n"
                      "|---|---|---|---|---|---|---|---|\n");
    for (const Shape& shape : shapes)
        for (const MethodMeasurement& row : shape.rows)
            (void)std::printf("| %s | %s | %s | %.1e | %.1e | %.1e | %.1f | %.0f |\n", shape.name.c_str(),
                              row.name.c_str(), row.precision.c_str(), row.error.relative.median,
                              row.error.relative.p95, row.error.relative.max, row.timing.lowest_ns, rate(row.timing));

    // To the frostbite rectangle of the same code (its rate hardly depends on the pose), and to the shape's own float.
    (void)std::printf("\nM/s (ratio to the frostbite rectangle of the same code) [ratio to the same method in plain "
                      "float]\n\n| shape | method | code | above | straddling | near | far | mixed |\n"
                      "|---|---|---|---|---|---|---|---|\n");
    for (const Shape& shape : shapes)
        for (const MethodMeasurement& row : shape.rows) {
            const MethodMeasurement* const base = find(shapes[2], "frostbite", row.precision);
            const MethodMeasurement* const plain = find(shape, row.name, "float");
            (void)std::printf("| %s | %s | %s ", shape.name.c_str(), row.name.c_str(), row.precision.c_str());
            const auto cell = [&](auto timing_of) {
                (void)std::printf("| %.0f", rate(timing_of(row)));
                if (base != nullptr) (void)std::printf(" (%.2f)", rate(timing_of(row)) / rate(timing_of(*base)));
                if (plain != nullptr && plain != &row && row.precision != "double")
                    (void)std::printf(" [%.1f]", rate(timing_of(row)) / rate(timing_of(*plain)));
                (void)std::printf(" ");
            };
            for (const Stratum stratum : {Stratum::above, Stratum::straddling, Stratum::near, Stratum::far})
                cell(
                    [&](const MethodMeasurement& m) { return m.timing_by_stratum[static_cast<std::size_t>(stratum)]; });
            cell([](const MethodMeasurement& m) { return m.timing; });
            (void)std::printf("|\n");
        }
    return 0;
}
