// What `gonio units` is asked: one value and shape, and the units that are wanted.
#pragma once

#include <gonio/light/photometry.hpp>
#include <gonio/light/policy.hpp>

#include "../arguments.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

// What all rows of a batch share.
struct UnitsRequest {
    std::string shape = "point"; // of rows that name none
    std::vector<std::string> wanted;
    const Policy* policy = nullptr; // nullptr: all of them, as a table
    std::optional<Shape> assumed;   // for luminances of what has no area
    std::optional<PhotometricValue> solve;
    bool explain = false;
};

Result<UnitsRequest> units_request(const Arguments& arguments);

struct Answer {
    PhotometricUnit unit;
    double number = 0.0;
};

// What a row came to.
struct UnitsAnswer {
    std::string value_text;
    std::string shape_text;
    PhotometricValue value;
    Shape shape;
    const Policy* policy = nullptr;
    std::vector<Answer> answers;
    ConversionSteps steps;
    Diagnostics diagnostics;

    // --solve
    std::optional<Meters> distance;      // at which the light gives the illuminance
    std::optional<double> needed_lumens; // that give it at the distance that was named
    std::optional<double> needed_factor; // on the value
};

// "800lm" or "800lm,sphere:r=3cm".
Result<UnitsAnswer> answer(std::string_view row, const UnitsRequest& request);

// What one program makes of the value.
struct PolicyRow {
    const Policy* policy = nullptr;
    std::string lacks; // why there is no such light; empty: there is one
    PolicyMeaning meaning;
    std::vector<Answer> answers; // physical
};

struct PolicyTable {
    UnitsAnswer question;
    std::vector<PolicyRow> rows;
};

Result<PolicyTable> policy_table(std::string_view row, const UnitsRequest& request);

} // namespace gonio::cli
