// One picture by the method reference: passes are added until the error is reached, the time is over or Ctrl-C is
// pressed.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/preview/render.hpp>

#include "../arguments.hpp"
#include "../console.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace gonio::cli {

struct PreviewRequest;

struct ReferenceBudget {
    std::optional<double> relative_error; // of the picture
    std::optional<double> milliseconds;
};

// --error and --time; an error of 1 % if neither is given. Fails (usage) on a budget of zero and without the method
// reference.
Result<ReferenceBudget> reference_budget(const Arguments& arguments, bool by_reference);

struct RefinedPicture {
    Rendering rendering;
    std::size_t passes = 0;
    double error_estimate = 1.0; // relative
    bool interrupted = false;
};

// Fails as render(). Shows a progress bar on a terminal; prints one line if the budget's error was not reached.
Result<RefinedPicture> refine(const PreviewRequest& request, std::span<const Light> lights, const Console& console);

} // namespace gonio::cli
