// Values that several commands read from options: sizes, counts, vectors.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/simd/dispatch.hpp>

#include "../arguments.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>
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

// In metres, or with a unit: "2.8", "280cm". `what` names the value in the message.
Result<double> parse_length(std::string_view text, std::string_view what);

// The length of a unit, in metres: "cm", or "2.5cm". `what` names the option.
Result<Meters> parse_length_unit(const std::string& text, std::string_view what);

// A share: "0.8", "80%".
Result<double> parse_factor(std::string_view text, std::string_view what);

// "1000", "1e8": a whole number from 0 to 2⁵³, or any 64-bit number if it is written with digits only.
Result<std::uint64_t> whole_number(std::string_view text, std::string_view what);

// -j N: 0 = all processors; the default is 0 too.
Result<unsigned> thread_count(const Arguments& arguments);

// --simd NAME; the best available set by default. Fails (unsupported) on a set that this machine does not have.
Result<simd::InstructionSet> instruction_set(const Arguments& arguments);

// --error E of the method reference, empty if not given. Fails (usage) without that method.
Result<std::optional<double>> reference_error(const Arguments& arguments, bool by_reference);

} // namespace gonio::cli
