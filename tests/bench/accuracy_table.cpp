// Prints the README's table: relative error and time of every method of every shape, measured now, in Markdown.
//
//   gonio-accuracy-table
#include <gonio/measure/area_methods.hpp>
#include <gonio/measure/sphere_methods.hpp>

#include <cstdio>
#include <vector>

namespace {

using namespace gonio;
using measure::SphereMeasurement;

bool print(const char* shape, const Result<std::vector<SphereMeasurement>>& rows) {
    if (!rows) {
        (void)std::fprintf(stderr, "%s\n", to_text(rows.error().diagnostics.back()).c_str());
        return false;
    }
    for (const SphereMeasurement& row : *rows)
        (void)std::printf("| %s | %s | %s | %.1e | %.1e | %.1e | %.1f |\n", shape, row.name.c_str(),
                          row.precision.c_str(), row.error.relative.median, row.error.relative.p95,
                          row.error.relative.max, row.timing.ns_per_item);
    return true;
}

} // namespace

int main() {
    using Kind = shading::LightConstants::Kind;
    (void)std::printf("| shape | method | code | median error | 95 %% below | worst | ns each |\n"
                      "|---|---|---|---|---|---|---|\n");
    bool done = print("sphere", measure::compare_sphere_methods());
    done = done && print("disk", measure::compare_area_methods(Kind::disk));
    done = done && print("rectangle", measure::compare_area_methods(Kind::rectangle));
    done = done && print("tube", measure::compare_area_methods(Kind::tube));
    return done ? 0 : 1;
}
