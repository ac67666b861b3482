// What `gonio probe` prints: a line or an object for each point as it is computed, and what sums them up.
#pragma once

#include <gonio/scene/probe.hpp>

#include "../console.hpp"
#include "../json_writer.hpp"
#include "request.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace gonio::cli {

// Results of a stretch of the points by every method.
struct ProbeStretch {
    std::size_t first = 0;
    std::span<const Receiver> receivers;
    std::vector<ProbeResult> by_method;
};

class ProbeReport {
public:
    ProbeReport(const ProbeRequest& request, Console& console);

    // Whether the share of each light is told.
    bool wants_parts() const;

    // Once before the first stretch, for each in order, and once after the last; `diagnostics` gets what was odd.
    void begin();
    void add(const ProbeStretch& stretch);
    void end(Diagnostics& diagnostics);

private:
    bool listed() const; // a line for each point, not a summary
    bool lights_listed_too() const;

    // The largest error that the quadrature leaves open, relative to its value.
    void note_error(const ProbeResult& result);

    bool estimated() const;

    void print_csv_heading();
    void csv_row(const ProbeStretch& stretch, std::size_t i);
    void text_lines(const ProbeStretch& stretch, std::size_t i);

    std::string_view compared_unit() const;
    Json spread_json(const Spread& s) const;
    Json grid_json() const;

    struct Worst {
        double error = 0.0; // the largest in size, signed
        std::size_t point = 0;
    };

    Worst worst(std::size_t m) const;

    void summary_text();

    const ProbeRequest& request_;
    Console& console_;
    std::optional<JsonWriter> json_;
    std::vector<std::vector<double>> values_; // of each method, for the summary
    double largest_error_ = 0.0;              // relative, of `reference`
    ProbeRemarks remarks_;
};

} // namespace gonio::cli
