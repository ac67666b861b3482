// The cells of a sweep: the inputs of each, and its picture.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/light/light.hpp>
#include <gonio/preview/render.hpp>

#include "../arguments.hpp"
#include "../console.hpp"
#include "../json_text.hpp"
#include "request.hpp"
#include "sweep_axis.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gonio::cli {

struct Sweep {
    std::vector<SweepAxis> axes; // the first runs across, the second down

    std::size_t cells() const;
    // The index of the value that a cell has on an axis.
    std::size_t value_of(std::size_t cell, std::size_t axis) const;
    std::string label(std::size_t cell) const;
};

// One or two axes, with at most 1024 cells.
Result<Sweep> read_sweep(const Arguments& arguments);

struct Cell {
    PreviewRequest request;
    std::vector<Light> lights;
    Rendering rendering;
};

double mean_nt(const Rendering& rendering);

class Sweeper {
public:
    Sweeper(PreviewRequest request, Sweep sweep, Console& console);

    // Reads every profile once, and tries every value, so that a mistake is reported before anything is rendered.
    Result<void> prepare();

    // Hands over the cells one by one; a shared exposure is that of the first cell.
    Result<void> render_all(int width, int height, const std::function<Result<void>(Cell, std::size_t)>& use);

    const PreviewRequest& request() const { return request_; }
    const Sweep& sweep() const { return sweep_; }
    Json& cells_json() { return cells_; }
    std::optional<Ev100> shared_exposure() const { return shared_exposure_; }
    const Diagnostics& diagnostics() const { return diagnostics_; }

private:
    // A picture from which others follow that differ from it in amounts and colours of lights alone.
    struct Kept {
        std::size_t cell = 0;
        std::vector<Light> lights;
        Rendering rendering;
    };

    Result<Cell> render_cell(std::size_t index, int width, int height);
    Result<Rendering> picture_of(std::size_t index, const PreviewRequest& request, const std::vector<Light>& lights);
    bool follows(std::size_t cell, std::size_t from) const;
    bool is_followed(std::size_t cell) const;
    void note(const Cell& cell, std::size_t index, Ev100 exposure);

    PreviewRequest request_;
    Sweep sweep_;
    Console& console_;
    bool exposure_changes_ = false;
    std::optional<Ev100> shared_exposure_;
    std::shared_ptr<const Interreflection> known_; // of the last cell that was rendered
    std::optional<Kept> kept_;
    Json cells_ = Json::array();
    Diagnostics diagnostics_;
};

} // namespace gonio::cli
