// The stored reference values of one shape: irradiance.csv, rows of a name and 15 numbers to 17 digits.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <fstream>
#include <string>
#include <vector>

namespace reference {

// center, axis, width direction (x, y, z each), two sizes, normal, E/L.
using Row = std::array<double, 15>;

// Rows that begin with `shape` and a comma, in order; adds a failure where the file or a row cannot be read.
inline std::vector<Row> rows(const std::string& folder, const std::string& shape) {
    std::vector<Row> found;
    std::ifstream file(folder + "/irradiance.csv");
    if (!file) {
        ADD_FAILURE() << "no irradiance.csv in " << folder;
        return found;
    }
    std::string line;
    while (std::getline(file, line)) {
        if (line.rfind(shape + ",", 0) != 0) continue;
        Row row{};
        const char* at = line.data() + shape.size();
        const char* const end = line.data() + line.size();
        for (double& value : row) {
            const auto [next, error] = std::from_chars(at + 1, end, value);
            if (error != std::errc()) {
                ADD_FAILURE() << line;
                return found;
            }
            at = next;
        }
        EXPECT_EQ(at, end) << line;
        found.push_back(row);
    }
    return found;
}

} // namespace reference
