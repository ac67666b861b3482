#include "reference_rows.hpp"

#include <gonio/base/charconv.hpp>

#include "folders.hpp"

#include <fstream>
#include <stdexcept>

namespace gonio::test {

namespace {

std::vector<ReferenceRow> rows_of(const std::string& name, std::size_t count, const std::string& kind) {
    const std::string path = std::string(source_folder) + "/tests/reference/" + name;
    std::ifstream file(path);
    if (!file) throw std::runtime_error("cannot read " + path);
    std::vector<ReferenceRow> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.front() == '#' || line.starts_with("kind,")) continue;
        ReferenceRow row{line.substr(0, line.find(',')), std::vector<double>(count)};
        const char* at = line.data() + row.kind.size();
        const char* const end = line.data() + line.size();
        for (double& value : row.values) {
            const bool more = at != end && *at == ',';
            const auto [next, error] = from_chars(more ? at + 1 : end, end, value);
            if (error != std::errc()) throw std::runtime_error(path + ": " + line);
            at = next;
        }
        if (at != end) throw std::runtime_error(path + ": " + line);
        if (kind.empty() || row.kind == kind) rows.push_back(std::move(row));
    }
    if (rows.empty()) throw std::runtime_error("no rows in " + path);
    return rows;
}

} // namespace

std::vector<ReferenceRow> irradiance_rows(const std::string& kind) {
    return rows_of("irradiance.csv", 15, kind);
}

std::vector<ReferenceRow> specular_rows(const std::string& kind) {
    return rows_of("specular.csv", 20, kind);
}

} // namespace gonio::test
