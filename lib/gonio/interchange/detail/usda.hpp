// The text form of USD, parsed to what lights need: prims with their attributes. Composition is not done: references,
// variants and sublayers are noted by their place.
#pragma once

#include <gonio/base/result.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::interchange_detail {

// A value of an attribute: its numbers in their order, whatever they are nested in, or its text.
struct UsdValue {
    std::vector<double> numbers;
    std::vector<std::string> texts; // strings, tokens, asset paths
    bool is_set = false;            // false: None, or only declared
    std::size_t offset = 0;
};

// A value at a time.
struct UsdSample {
    double time = 0.0;
    UsdValue value;
};

// What lies between two samples.
enum class UsdBetween : std::uint8_t { held, linear, turned }; // the former; numbers on a line; quaternions on an arc

struct UsdAttribute {
    std::string name; // "inputs:intensity"
    UsdValue value;   // the default
    std::vector<UsdSample> samples;
    UsdBetween between = UsdBetween::held;
    bool is_connected = false; // by .connect
};

struct UsdPrim {
    std::string type; // "SphereLight"; empty
    std::string name;
    std::uint32_t parent = 0xffffffff; // index of an earlier prim
    std::size_t offset = 0;            // of the specifier
    bool is_class = false;             // or an over: not shown by itself
    bool is_active = true;
    std::vector<std::string> schemas; // apiSchemas
    std::vector<UsdAttribute> attributes;

    const UsdAttribute* find(std::string_view wanted) const;
};

struct UsdLayer {
    double meters_per_unit = 0.01; // as USD has it where the layer says nothing
    bool states_unit = false;
    char up = 'y';
    bool states_up = false;
    std::string doc;
    std::vector<UsdPrim> prims;          // parents first; only prims that may hold lights keep attributes
    std::vector<std::size_t> unresolved; // places of references, payloads, variants, inherits, sublayers
};

// Fails (malformed) with the place on text that breaks the grammar, on numbers that are not finite where they are
// kept, and beyond the limits scene-depth and scene-nodes.
Result<UsdLayer> parse_usda(std::string_view text, const std::string& source);

} // namespace gonio::interchange_detail
