// How programs prefilter an environment and look it up: each row is a whole convention.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/ibl/roughness_mapping.hpp>
#include <gonio/ibl/split_sum.hpp>

#include <span>
#include <string_view>

#pragma GCC visibility push(default)
namespace gonio {

// How a program prefilters, by its name in text.
struct PrefilterVariant {
    std::string_view name; // "filament"
    std::string_view summary;
    RoughnessMapping mapping;
    SplitSumModel split_sum;
    MultipleScattering multiple_scattering; // that the program adds to a lookup of the table
    int side;                               // of a face of level 0
    int levels;                             // 0: down to faces of one texel
    std::string_view lookup;                // the direction that the program looks up
};

// The first is for your own programs.
std::span<const PrefilterVariant> prefilter_variants();

// Fails (usage) on an unknown name.
Result<const PrefilterVariant*> parse_prefilter_variant(std::string_view text);

// Of a size: as many as halve `side` down to `least`, at most the variant's own number.
int levels_of(const PrefilterVariant& variant, int side, int least);

} // namespace gonio
#pragma GCC visibility pop
