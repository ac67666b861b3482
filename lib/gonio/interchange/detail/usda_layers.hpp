// The layers that a scene of USD is composed of: its files and archives are opened once each, by the names in other
// layers, and stacked with their sublayers.
#pragma once

#include <gonio/base/result.hpp>
#include <gonio/interchange/detail/reading.hpp>
#include <gonio/interchange/detail/usda.hpp>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio::interchange_detail {

// Of an arc in times that are themselves nested.
UsdTimes nested(UsdTimes in, UsdTimes of);
bool is_finite(UsdTimes times);

// A layer with its sublayers, the strongest first.
struct LayerOfStack {
    std::uint32_t layer = 0;
    UsdTimes times;
};

struct IndexedLayer {
    UsdLayer layer;
    // By parent and name; variants are left out, and are listed by the prim that they are of.
    std::map<std::pair<std::uint32_t, std::string_view>, std::uint32_t> prims;
    std::map<std::uint32_t, std::vector<std::uint32_t>> children;
    struct Variants {
        std::string_view set;
        std::map<std::string_view, std::vector<std::uint32_t>> by_name;
    };
    std::map<std::uint32_t, std::vector<Variants>> variants; // sets in their order
    bool is_indexed = false;
};

class UsdLayers {
public:
    // Both outlive this. Sources, texts, archives and diagnostics become those of the stage.
    UsdLayers(UsdStage& stage, const SceneReadOptions& options) : stage_(stage), options_(options) {}

    // The root layer, of a file's bytes: a layer as text, or an archive that begins with one. `source` names it.
    Result<std::uint32_t> open_root(std::string_view bytes, const std::string& source);

    IndexedLayer& operator[](std::uint32_t layer) { return layers_[layer]; }
    const IndexedLayer& operator[](std::uint32_t layer) const { return layers_[layer]; }

    // The file that an arc names, as a number. Files of the same name in other folders have others.
    std::size_t file_of(std::uint32_t from, const UsdArc& arc);
    // A layer that another one names; nothing if it is missing, which is said.
    Result<std::optional<std::uint32_t>> layer_of(std::uint32_t from, const UsdArc& arc);

    // The number of the layer's stack: the layer with its sublayers. It is the first of its stack.
    Result<std::uint32_t> stack_of(std::uint32_t root);
    const std::vector<LayerOfStack>& stack(std::uint32_t number) const { return stacks_[number]; }

    // `at` in the text of `layer`.
    void warn(SceneCode code, std::uint32_t layer, std::size_t at, const std::string& message, std::string hint = {});
    Unexpected beyond_numbers(std::uint32_t layer, const UsdArc& arc);

    // Moves the layers to the stage, where they stay; says how many warnings were left out.
    void close();

private:
    Result<std::uint32_t> open_archive_root(std::string_view bytes, const std::string& source);
    // The text of the first file of an archive, which is its scene. Another one is an error, or a warning at `arc`, a
    // layer and a place in it.
    Result<std::optional<std::string_view>> first_layer(int archive, const Location& at,
                                                        const std::pair<std::uint32_t, std::size_t>* arc);
    // `text` outlives the stage; `source` names it in messages.
    Result<std::uint32_t> add_layer(std::string_view text, const std::string& source, UsdSource about);
    Result<std::optional<std::uint32_t>> find_layer(std::uint32_t from, const UsdArc& arc);
    Result<void> add_sublayers(std::uint32_t layer, UsdTimes times, std::vector<LayerOfStack>& stack,
                               std::vector<std::uint32_t>& active);

    UsdStage& stage_;
    const SceneReadOptions& options_;
    std::deque<IndexedLayer> layers_;                                             // as UsdStage::sources
    std::map<std::pair<int, std::string>, std::optional<std::uint32_t>> by_name_; // nothing: missing
    std::vector<std::vector<LayerOfStack>> stacks_;
    std::map<std::uint32_t, std::uint32_t> stack_by_layer_;
    // By the layer and the place in it.
    std::map<std::pair<std::uint32_t, std::size_t>, std::optional<std::uint32_t>> layer_by_arc_; // nothing: missing
    std::map<std::pair<std::uint32_t, std::size_t>, std::size_t> file_by_arc_;
    std::map<std::pair<int, std::string>, std::size_t> files_; // by archive and name

    // Warnings of a code: the first ones, and in how many further places there would be more.
    struct Said {
        std::set<std::string, std::less<>> messages;
        std::set<std::pair<std::uint32_t, std::size_t>> more;
        std::size_t last = 0; // of the stage's diagnostics
    };
    std::map<std::string_view, Said> said_; // by code
};

} // namespace gonio::interchange_detail
