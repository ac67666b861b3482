// The output of `gonio probe`: a line or an object for each point as soon as it is computed, and a summary.
#pragma once

#include <gonio/figures/glare.hpp>
#include <gonio/scene/probe.hpp>

#include "../console.hpp"
#include "../json_writer.hpp"
#include "request.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::cli {

// The results for a run of points by every method.
struct ProbeStretch {
    std::size_t first = 0;
    std::span<const Receiver> receivers;
    std::vector<ProbeResult> by_method;
    std::vector<double> direct_lx; // of lights; like the next, with --indirect or --sky, else empty
    std::vector<double> sky_lx;
    std::vector<double> indirect_lx;
    std::vector<double> horizontal_lx; // of the modelling index, else empty
    std::vector<GlareRating> glare;    // with --glare, else empty
};

class ProbeReport {
public:
    ProbeReport(const ProbeRequest& request, Console& console);

    // Whether the contribution of each light is printed.
    bool wants_parts() const;

    // Call begin() once before the first stretch, add() for each stretch in order, and end() once after the last;
    // `diagnostics` gets the remarks.
    void begin();
    void add(const ProbeStretch& stretch);
    void end(Diagnostics& diagnostics);

    // Whether the grid misses a requirement of the task; call after end().
    bool has_failed() const { return verdict_ && verdict_->has_failed(); }

    // Writes the drawing of the grid; call after end().
    Result<void> draw(Diagnostics& diagnostics) const;

private:
    bool listed() const; // a line for each point, not a summary
    bool lights_listed_too() const;

    // Keeps the largest error estimate of the quadrature, relative to its value.
    void note_error(const ProbeResult& result);

    bool estimated() const;

    void print_csv_heading();
    void csv_row(const ProbeStretch& stretch, std::size_t i);
    void text_lines(const ProbeStretch& stretch, std::size_t i);

    std::string_view compared_unit() const; // empty: a ratio
    std::string with_unit(std::string_view key) const;
    Json spread_json(const Spread& s) const;
    Json grid_json() const;

    void judge();

    struct Worst {
        double error = 0.0; // the largest absolute error, with its sign
        std::size_t point = 0;
    };

    Worst worst(std::size_t m) const;

    void summary_text();

    const ProbeRequest& request_;
    Console& console_;
    std::optional<JsonWriter> json_;
    std::optional<TaskInput> verdict_;
    bool lacks_rating_ = false;
    bool has_too_large_ = false;
    std::vector<std::vector<double>> values_; // of each method, for the summary
    std::vector<double> indirect_lx_;
    double largest_error_ = 0.0; // relative, of the method reference
    ProbeRemarks remarks_;
};

} // namespace gonio::cli
