// The request of `gonio units`: one value and shape, and the wanted units.
#pragma once

#include <gonio/light/photometry.hpp>
#include <gonio/light/policy.hpp>
#include <gonio/scene/surface_emission.hpp>

#include "../arguments.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

// Shared by all rows of a batch.
struct UnitsRequest {
    std::string shape = "point"; // for rows that name none
    std::vector<std::string> wanted;
    const Policy* policy = nullptr;      // nullptr: several, as a table
    std::vector<const Policy*> policies; // of the table
    std::vector<const Policy*> programs; // of --for: what to type there
    std::optional<Shape> assumed;        // for luminances of shapes without an area
    std::optional<PhotometricValue> solve;
    bool explain = false;
};

Result<UnitsRequest> units_request(const Arguments& arguments);

struct Answer {
    PhotometricUnit unit;
    double number = 0.0;
};

// The answer to one row.
struct UnitsAnswer {
    std::string value_text;
    std::string shape_text;
    PhotometricValue value;
    Shape shape;
    std::optional<Primitive> surface; // of a stage, instead of a shape: a box
    const Policy* policy = nullptr;
    std::vector<Answer> answers;
    ConversionSteps steps;
    Diagnostics diagnostics;

    // --solve
    std::optional<Meters> distance;      // at which the light gives the illuminance
    std::optional<double> needed_lumens; // for the illuminance at the given distance
    std::optional<double> needed_factor; // to multiply the value by
};

// What one value and shape ask for besides other units, of which a surface of a stage has none: a box is not a light of
// other programs.
Result<void> refuse_surface(const UnitsAnswer& question, std::string_view asked);

// Reads a row, "800lm" or "800lm,sphere:r=3cm", and loads the files of its shape; there are no answers yet.
Result<UnitsAnswer> read_question(std::string_view row, const UnitsRequest& request);

Result<UnitsAnswer> answer(std::string_view row, const UnitsRequest& request);

// What one program makes of the value.
struct PolicyRow {
    const Policy* policy = nullptr;
    std::string lacks; // why this program has no such light; empty: it has one
    PolicyMeaning meaning;
    std::vector<Answer> answers; // physical
};

struct PolicyTable {
    UnitsAnswer question;
    std::vector<PolicyRow> rows;
};

Result<PolicyTable> policy_table(std::string_view row, const UnitsRequest& request);

} // namespace gonio::cli
