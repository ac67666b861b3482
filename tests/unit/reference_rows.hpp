// The stored values of tests/reference/: rows with a name and numbers.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gonio::test {

struct ReferenceRow {
    std::string kind; // "sphere", "disk", "rect", "tube"
    std::vector<double> values;
};

// The rows of irradiance.csv: centre, axis, width direction (x, y, z each), two sizes, normal, E/L. If `kind` is not
// empty, only rows of that kind.
std::vector<ReferenceRow> irradiance_rows(const std::string& kind = {});

// The rows of specular.csv: the same up to the normal, then the view, alpha, the luminance and its error.
std::vector<ReferenceRow> specular_rows(const std::string& kind = {});

// Both throw if the file is missing or a row does not have that form, which fails the test.

} // namespace gonio::test
