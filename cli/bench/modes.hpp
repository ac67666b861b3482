// The modes of `gonio bench` other than its tables.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"
#include "../console.hpp"

#include <span>
#include <string_view>

namespace gonio::cli {

// --stress: returns the exit status.
Result<int> bench_stress(const Arguments& arguments, Console& console);

// --scaling: returns the exit status.
Result<int> bench_scaling(const Arguments& arguments, Console& console);

// --profile: returns the exit status.
Result<int> bench_time_map(const Arguments& arguments, Console& console);

// Fails (usage) if one of `options` is given together with `mode`, which does not use it.
Result<void> refuse_beside(std::string_view mode, std::span<const std::string_view> options,
                           const Arguments& arguments);

} // namespace gonio::cli
