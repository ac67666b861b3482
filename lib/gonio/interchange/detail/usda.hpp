// USD: its text form, parsed to what lights need, and composition of layers to the prims of a stage.
#pragma once

#include <gonio/base/archive.hpp>
#include <gonio/base/result.hpp>
#include <gonio/base/text_places.hpp>
#include <gonio/interchange/detail/reading.hpp>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio::interchange_detail {

// A value of an attribute: its numbers in their order, whatever they are nested in, or its text.
struct UsdValue {
    std::vector<double> numbers;
    std::vector<std::string> texts; // strings, tokens, asset paths
    bool is_set = false;            // false: None, or only declared
    bool is_blocked = false;        // None: weaker layers do not count
    std::size_t offset = 0;
    std::uint32_t layer = 0; // of UsdStage
};

// A value at a time.
struct UsdSample {
    double time = 0.0;
    UsdValue value;
};

// What lies between two samples.
enum class UsdBetween : std::uint8_t { held, linear, turned }; // the former; numbers on a line; quaternions on an arc

struct UsdAttribute {
    std::string name;               // "inputs:intensity"
    UsdValue value;                 // the default
    std::vector<UsdSample> samples; // by time, each once
    UsdBetween between = UsdBetween::held;
    bool is_connected = false; // by .connect
};

// Times of a layer in those of the scene.
struct UsdTimes {
    double offset = 0.0; // behind the scale
    double scale = 1.0;
};

// The strongest opinion about an attribute, which is in a layer of the stage: prims that are composed of the same ones
// share their values.
struct UsdOpinion {
    const UsdAttribute* said = nullptr;
    UsdTimes times;            // of its samples
    bool is_connected = false; // by any layer
};

enum class UsdSpecifier : std::uint8_t { def, over, is_class };

// How a list of metadata changes those of weaker layers.
enum class UsdListEdit : std::uint8_t { is_all, prepends, appends, adds, removes };

enum class UsdArcKind : std::uint8_t { inherit, reference, payload, specialize, sublayer };

// What a prim or a layer takes opinions from.
struct UsdArc {
    UsdArcKind kind = UsdArcKind::reference;
    UsdListEdit edit = UsdListEdit::is_all;
    std::string asset; // empty: the same layers
    std::string path;  // empty: the default prim
    UsdTimes times;
    bool is_none = false; // an empty list
    std::size_t at = 0;   // in the text
};

// A prim as one layer has it, a variant of one, or a composed prim.
struct UsdPrim {
    std::string type; // "SphereLight"; empty
    std::string name;
    std::uint32_t parent = 0xffffffff; // index of an earlier prim
    std::size_t offset = 0;            // of the specifier
    std::uint32_t layer = 0;           // of UsdStage
    UsdSpecifier specifier = UsdSpecifier::def;
    std::optional<bool> active;
    bool is_variant = false;          // of its parent; the name is the variant's
    std::vector<std::string> schemas; // apiSchemas
    std::vector<UsdAttribute> attributes;
    std::vector<UsdOpinion> opinions; // of a composed prim, which has no attributes of its own

    std::optional<UsdOpinion> find(std::string_view wanted) const;
};

// What a layer says about the composition of a prim.
struct UsdComposition {
    std::vector<UsdArc> arcs;
    std::vector<std::pair<std::string, std::string>> selected; // variants by the names of their sets
    std::vector<std::string> removed_schemas;                  // from those of weaker layers
    std::string variant_set;                                   // of a variant
};

struct UsdLayer {
    double meters_per_unit = 0.01; // as USD has it where the layer says nothing
    bool states_unit = false;
    char up = 'y';
    bool states_up = false;
    std::string doc;
    std::string default_prim;
    std::vector<UsdArc> sublayers; // the strongest first
    std::vector<UsdPrim> prims;    // parents first; only prims that may hold lights keep attributes
    std::map<std::uint32_t, UsdComposition> compositions; // of the prims that have one
    bool is_composed_of = false;                          // it has arcs or variants
};

// Fails (malformed) with the place on text that breaks the grammar, on numbers that are not finite where they are
// kept, and beyond the limits scene-depth and scene-nodes.
Result<UsdLayer> parse_usda(std::string_view text, const std::string& source);

// A layer of a stage: where its text is, and where the files are that it names.
struct UsdSource {
    std::string name; // relative to the scene's folder, or in the archive
    int archive = -1; // of UsdStage; −1: a file
    TextPlaces places;
};

// Prims of a scene with all that they are composed of.
struct UsdStage {
    UsdLayer layer;              // the root layer's metadata, and the composed prims
    std::deque<UsdLayer> layers; // what composed prims share; empty where there is one layer without arcs
    std::deque<UsdSource> sources;
    std::deque<std::string> texts; // of layers, and bytes of archives
    std::deque<Archive> archives;
    Diagnostics diagnostics;

    Location place(std::uint32_t source, std::size_t offset) { return sources[source].places.at(offset); }
};

// Whether a file may be a layer, by the end of its name.
bool is_usd_name(std::string_view name);

// The file that a layer names, relative to the scene's folder or in the archive: without "." and inner "..".
std::string usd_file_name(const UsdSource& from, std::string_view asset);

// Reads a scene of USD, as text or in a USDZ archive, with the layers that it names, by options.read_beside. Opinions
// are ordered as in USD: local, inherits, variants, references, payloads, specializes. Layers that are missing or
// binary are warnings; fails (malformed) as parse_usda() does, on cycles, and beyond the limits.
Result<UsdStage> compose_usd(std::string_view bytes, const std::string& source, const SceneReadOptions& options);

} // namespace gonio::interchange_detail
