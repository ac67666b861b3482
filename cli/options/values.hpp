// Values that several commands read from options: sizes, counts, vectors.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/simd/dispatch.hpp>

#include "../arguments.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <string_view>
#include <utility>

namespace gonio::cli {

struct PixelSize {
    int width;
    int height;
};

// "512x256".
Result<PixelSize> parse_size(std::string_view text);

// "1,2.5,-3".
Result<glm::dvec3> parse_vector(std::string_view text, std::string_view what);

// "1000", "1e8": a whole number from 0 to 2⁵³, or any of 64 bits where only digits are written.
Result<std::uint64_t> whole_number(std::string_view text, std::string_view what);

// -j N: 0 = all processors, when not given too.
Result<unsigned> thread_count(const Arguments& arguments);

// --simd NAME; the best there is when not given. Fails (unsupported) on a set that this machine does not have.
Result<simd::InstructionSet> instruction_set(const Arguments& arguments);

} // namespace gonio::cli
