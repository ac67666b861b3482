// The stored values of tests/reference/: rows of a name and numbers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gonio::test {

struct ReferenceRow {
    std::string kind; // "sphere", "disk", "rect", "tube"
    std::vector<double> values;
};

// The rows of irradiance.csv: centre, axis, width direction (x, y, z each), two sizes, normal, E/L. Those of `kind`
// alone where it is not empty.
std::vector<ReferenceRow> irradiance_rows(const std::string& kind = {});

// The rows of specular.csv: the same up to the normal, then the view, alpha, the luminance and its error.
std::vector<ReferenceRow> specular_rows(const std::string& kind = {});

// Both throw where the file is missing or a row is not of that form, which fails the test.

} // namespace gonio::test
