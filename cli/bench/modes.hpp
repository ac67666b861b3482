// What `gonio bench` does beside its tables.
#pragma once

#include <gonio/base/result.hpp>

#include "../arguments.hpp"
#include "../console.hpp"

#include <span>
#include <string_view>

namespace gonio::cli {

// --stress: returns the exit status.
Result<int> bench_stress(const Arguments& arguments, Console& console);

// Fails (usage) where one of `options` is given beside `mode`, which has no use for it.
Result<void> refuse_beside(std::string_view mode, std::span<const std::string_view> options,
                           const Arguments& arguments);

} // namespace gonio::cli
