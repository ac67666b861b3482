// Prints the table of specular methods in the README of shading/, measured now, in Markdown: error against quadrature
// and time, per shape and method; a star marks what no other row of the shape beats in both (the Pareto front).
//
//   gonio-specular-table [CASES [SEED]]
//
// Relative errors are of the cases whose luminance is above 1e-3 of the light's.
#include <gonio/measure/specular_methods.hpp>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

int main(int argc, char** argv) {
    using namespace gonio;
    using Kind = shading::LightConstants::Kind;
    measure::ComparisonOptions options;
    options.cases = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 4096;
    options.seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
    options.relative_floor = 1e-3;
    options.timing.samples = 21;
    options.timing.sample_seconds = 0.002;
    (void)std::printf("| shape | method | code | median error | 95 %% below | worst | ns each | front |\n"
                      "|---|---|---|---|---|---|---|---|\n");
    const std::pair<const char*, Kind> shapes[] = {
        {"sphere", Kind::sphere}, {"disk", Kind::disk}, {"rectangle", Kind::rectangle}, {"tube", Kind::tube}};
    for (const auto& [name, kind] : shapes) {
        const auto rows = measure::compare_specular_methods(kind, options);
        if (!rows) {
            (void)std::fprintf(stderr, "%s\n", to_text(rows.error().diagnostics.back()).c_str());
            return 1;
        }
        const std::vector<bool> front = measure::pareto_front(*rows);
        for (std::size_t i = 0; i < rows->size(); ++i) {
            const measure::MethodMeasurement& row = (*rows)[i];
            (void)std::printf("| %s | %s | %s | %.3f | %.2f | %.1e | %.1f | %s |\n", name, row.name.c_str(),
                              row.precision.c_str(), row.error.relative.median, row.error.relative.p95,
                              row.error.relative.max, row.timing.lowest_ns, front[i] ? "*" : "");
        }
        (void)std::fflush(stdout);
    }
    return 0;
}
