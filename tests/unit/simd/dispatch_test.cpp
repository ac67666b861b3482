#include <gonio/simd/array_math.hpp>
#include <gonio/simd/dispatch.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace {

using namespace gonio::simd;

TEST(Dispatch, NamesReadBack) {
    for (const std::string_view name : instruction_set_names()) {
        const auto set = parse_instruction_set(name);
        ASSERT_TRUE(set.has_value()) << name;
        EXPECT_EQ(name, to_text(*set));
    }
    EXPECT_FALSE(parse_instruction_set("AVX2").has_value());
    EXPECT_FALSE(parse_instruction_set("").has_value());
    EXPECT_FALSE(parse_instruction_set("avx").has_value());
}

TEST(Dispatch, ScalarIsAlwaysThereAndTheBestIsTheLast) {
    const auto sets = available_sets();
    ASSERT_FALSE(sets.empty());
#if !defined(__wasm_simd128__) // a module with SIMD may be without
    EXPECT_EQ(sets.front(), InstructionSet::scalar);
#endif
    EXPECT_EQ(best_available(), sets.back());
    EXPECT_TRUE(std::is_sorted(sets.begin(), sets.end()));
#if defined(__x86_64__)
    EXPECT_TRUE(available(InstructionSet::sse2));
    EXPECT_FALSE(available(InstructionSet::neon));
#elif defined(__aarch64__)
    EXPECT_EQ(best_available(), InstructionSet::neon);
#elif defined(__wasm_simd128__)
    EXPECT_EQ(best_available(), InstructionSet::wasm128);
#endif
}

TEST(Dispatch, WhatIsNotAvailableFallsBackToTheFirst) {
    for (const std::string_view name : instruction_set_names()) {
        const InstructionSet set = *parse_instruction_set(name);
        EXPECT_EQ(array_math(set).set, available(set) ? set : available_sets().front()) << name;
    }
}

} // namespace
