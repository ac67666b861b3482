#include <gonio/base/json_events.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/interchange/detail/gltf_index.hpp>
#include <gonio/interchange/detail/reading.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gonio::interchange_detail {

namespace {

using detail::Json;

// Extensions that a document may require although gonio does not read them: they change no light.
constexpr std::array<std::string_view, 9> harmless_starts{
    "KHR_materials_", "KHR_texture_", "EXT_texture_", "EXT_materials_", "KHR_draco_mesh_compression",
    "KHR_mesh_",      "EXT_meshopt_", "KHR_meshopt_", "KHR_xmp"};

bool is_known(std::string_view extension) {
    const auto is_one = [&](std::string_view known) { return extension == known; };
    const auto begins = [&](std::string_view start) { return extension.starts_with(start); };
    return std::any_of(gltf_light_extensions.begin(), gltf_light_extensions.end(), is_one) ||
           std::any_of(harmless_starts.begin(), harmless_starts.end(), begins);
}

// Follows the text by a path of keys: containers of arrays and objects that are open. Of arrays and objects that the
// index does not need, only the brackets are counted.
class Indexer final : public detail::JsonHandler {
public:
    Indexer(GltfIndex& index, const std::string& source) : index_(index), source_(source) {}

    std::optional<Error> error;

    bool key(std::string name) override {
        const std::size_t depth = open_.size();
        if (depth <= kept) keys_[depth - 1] = std::move(name);
        if (depth == 1) {
            const auto is_seen = std::find(seen_.begin(), seen_.end(), keys_[0]);
            if (is_seen != seen_.end()) return refuse("SCN0102", fmt::format("'{}' is given twice", keys_[0]));
            constexpr std::size_t most = 1024;
            if (seen_.size() == most) return refuse("SCN0108", fmt::format("more than {} members", most));
            seen_.push_back(keys_[0]);
        }
        if (node_ && depth == 4 && keys_[2] == "extensions")
            for (std::size_t i = 0; i < gltf_light_extensions.size(); ++i)
                if (keys_[3] == gltf_light_extensions[i])
                    index_.nodes.back().lights |= static_cast<std::uint8_t>(1U << i);
        if (element_ && depth == 3 && keys_[0] == "materials" && keys_[2] == "emissiveFactor")
            index_.any_emission = true;
        return true;
    }

    bool scalar(Json value) override {
        const std::size_t depth = open_.size();
        if (depth == 0) return refuse("SCN0102", "a glTF document is a JSON object");
        if (depth == 1) {
            if (keys_[0] == "scene") return take_index(value, shown_);
            if (is_array_key(keys_[0])) return refuse("SCN0105", fmt::format("'{}' must be an array", keys_[0]));
            return true;
        }
        if (depth == 2) {
            if (keys_[0] == "asset" && value.is_string()) {
                if (keys_[1] == "version") version_ = value.as_string();
                if (keys_[1] == "generator") index_.generator = value.as_string().substr(0, 200);
            }
            if (keys_[0] == "extensionsRequired") {
                if (!value.is_string()) return refuse("SCN0105", "'extensionsRequired' must hold strings");
                if (!is_known(value.as_string()))
                    return refuse("SCN0106",
                                  fmt::format("the scene requires the extension '{}'", value.as_string().substr(0, 80)),
                                  "export it without that extension");
            }
            if (open_.back() == '[' && is_array_key(keys_[0]))
                return refuse("SCN0105", fmt::format("'{}' must hold objects", keys_[0]));
            return true;
        }
        if (node_ && depth == 3 && keys_[2] == "mesh") return take_index(value, index_.nodes.back().mesh);
        if (depth == 4 && open_.back() == '[') {
            if (node_ && keys_[2] == "children") {
                std::uint32_t child = nothing;
                if (!take_index(value, child)) return false;
                edges_.emplace_back(child, static_cast<std::uint32_t>(index_.nodes.size() - 1));
            }
            if (keys_[0] == "scenes" && keys_[2] == "nodes") {
                std::uint32_t root = nothing;
                if (!take_index(value, root)) return false;
                roots_.emplace_back(scenes_ - 1, root);
            }
        }
        return true;
    }

    bool start_object() override {
        if (!begin_value('{')) return false;
        if (element_ == nullptr) element_ = element_at();
        return true;
    }
    bool start_array() override {
        if (open_.empty()) return refuse("SCN0102", "a glTF document is a JSON object");
        if (open_.size() == 2 && open_.back() == '[' && is_array_key(keys_[0]))
            return refuse("SCN0105", fmt::format("'{}' must hold objects", keys_[0]));
        return begin_value('[');
    }
    bool end() override {
        open_.pop_back();
        if (element_ != nullptr && open_.size() == element_depth_) {
            GltfElement& element = node_ ? index_.nodes.back().element : element_->back();
            element.length = static_cast<std::uint32_t>(bytes_read() - element.offset);
            element_ = nullptr;
            node_ = false;
        }
        return true;
    }
    void broken(Diagnostic complaint) override {
        const SceneCode code = "SCN0102";
        complaint.code = code->code;
        error = Error{Failure::malformed, {std::move(complaint)}};
    }

    Result<void> finish() {
        if (error) return Unexpected(std::move(*error));
        const auto wrong = [&](SceneCode code, std::string message, std::string hint = {}) {
            return scene_error(code, {source_, 0, 0}, std::move(message), std::move(hint));
        };
        if (version_.empty()) return wrong("SCN0102", "asset.version is missing: this is not glTF 2.0");
        if (!version_.starts_with("2."))
            return wrong("SCN0101", fmt::format("this is glTF {}; gonio reads 2.0", version_.substr(0, 20)));
        const auto nodes = static_cast<std::uint32_t>(index_.nodes.size());
        const auto in_node = [&](SceneCode code, std::uint32_t node, std::string message) {
            return scene_error(code, place_at(index_.nodes[node].element.offset), std::move(message));
        };
        for (const auto& [child, parent] : edges_) {
            if (child >= nodes)
                return in_node("SCN0103", parent,
                               fmt::format("nodes[{}].children: there is no node {}", parent, child));
            if (index_.nodes[child].parent != nothing)
                return in_node("SCN0104", parent,
                               fmt::format("nodes[{}] is a child of both nodes[{}] and nodes[{}]", child,
                                           index_.nodes[child].parent, parent));
            index_.nodes[child].parent = parent;
        }
        if (Result<void> is_tree = check_tree(); !is_tree) return is_tree;
        index_.has_scenes = scenes_ > 0;
        if (shown_ != nothing && shown_ >= scenes_)
            return wrong("SCN0103", fmt::format("scene: there is no scene {}", shown_));
        const std::uint32_t shown = shown_ == nothing ? 0 : shown_;
        for (const auto& [scene, root] : roots_) {
            if (root >= nodes)
                return wrong("SCN0103", fmt::format("scenes[{}].nodes: there is no node {}", scene, root));
            if (scene == shown) index_.nodes[root].is_root = true;
        }
        return {};
    }

private:
    static constexpr std::size_t kept = 4; // levels that have a key

    static bool is_array_key(std::string_view key) {
        return key == "nodes" || key == "meshes" || key == "materials" || key == "accessors" || key == "buffers" ||
               key == "bufferViews" || key == "scenes";
    }

    bool begin_value(char bracket) {
        if (open_.size() == 1 && is_array_key(keys_[0]) && bracket != '[')
            return refuse("SCN0105", fmt::format("'{}' must be an array", keys_[0]));
        open_ += bracket;
        if (open_.size() <= kept) keys_[open_.size() - 1].clear();
        return true;
    }

    // The array that the object which begins here is an element of.
    std::vector<GltfElement>* element_at() {
        const auto begin = [&](std::vector<GltfElement>& into) {
            element_depth_ = open_.size() - 1;
            into.push_back({static_cast<std::uint32_t>(bytes_read() - 1), 0});
            return &into;
        };
        if (open_.size() == 3 && open_[1] == '[') {
            if (keys_[0] == "nodes") {
                if (index_.nodes.size() == limit("scene-nodes").value) {
                    refuse("SCN0108", fmt::format("more than {}", to_text(limit("scene-nodes"))));
                    return nullptr;
                }
                node_ = true;
                element_depth_ = 2;
                index_.nodes.push_back({});
                index_.nodes.back().element.offset = static_cast<std::uint32_t>(bytes_read() - 1);
                return &index_.meshes; // not used: node_ is set
            }
            if (keys_[0] == "scenes") ++scenes_;
            if (keys_[0] == "meshes") return begin(index_.meshes);
            if (keys_[0] == "materials") return begin(index_.materials);
            if (keys_[0] == "accessors") return begin(index_.accessors);
            if (keys_[0] == "buffers") return begin(index_.buffers);
            if (keys_[0] == "bufferViews") return begin(index_.buffer_views);
        }
        if (open_.size() == 5 && open_[3] == '[' && keys_[0] == "extensions" && keys_[2] == "lights")
            for (std::size_t i = 0; i < gltf_light_extensions.size(); ++i)
                if (keys_[1] == gltf_light_extensions[i]) return begin(index_.lights[i]);
        return nullptr;
    }

    bool take_index(const Json& value, std::uint32_t& into) {
        if (!value.is_unsigned() || value.as_uint64() >= nothing)
            return refuse("SCN0105", "an index must be a whole number from 0");
        into = static_cast<std::uint32_t>(value.as_uint64());
        return true;
    }

    bool refuse(SceneCode code, std::string message, std::string hint = {}) {
        error = std::move(scene_error(code, place(), std::move(message), std::move(hint)).value());
        return false;
    }

    // Each node has one parent at most; whether following them ends.
    Result<void> check_tree() const {
        std::vector<std::uint32_t> walk(index_.nodes.size(), nothing); // the walk that met the node
        for (std::uint32_t start = 0; start < index_.nodes.size(); ++start)
            for (std::uint32_t at = start; at != nothing && walk[at] != start; at = index_.nodes[at].parent) {
                if (walk[at] != nothing) break;
                walk[at] = start;
                if (index_.nodes[at].parent != nothing && walk[index_.nodes[at].parent] == start)
                    return scene_error("SCN0104", place_at(index_.nodes[at].element.offset),
                                       fmt::format("nodes[{}] is among its own ancestors", at));
            }
        return {};
    }

    GltfIndex& index_;
    const std::string& source_;
    std::string open_; // brackets
    std::array<std::string, kept> keys_;
    std::vector<std::string> seen_;
    std::vector<GltfElement>* element_ = nullptr; // that is being read
    std::size_t element_depth_ = 0;
    bool node_ = false;
    std::string version_;
    std::uint32_t shown_ = nothing;
    std::uint32_t scenes_ = 0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_; // child, parent
    std::vector<std::pair<std::uint32_t, std::uint32_t>> roots_; // scene, node
};

// Finds the range of one value.
class Finder final : public detail::JsonHandler {
public:
    explicit Finder(const std::vector<std::string>& path) : path_(path) {}

    std::size_t begin = 0;
    std::size_t end_of_value = 0;

    bool key(std::string name) override {
        steps_.back() = std::move(name);
        after_key_ = bytes_read();
        return true;
    }
    bool scalar(Json value) override {
        step();
        const bool found = steps_ == path_;
        if (found) {
            end_of_value = bytes_read() - (value.is_number() ? 1 : 0);
            begin = text().find_first_not_of(": \t\r\n,[", after_key_);
        }
        after_key_ = bytes_read();
        return !found;
    }
    bool start_object() override { return open(false); }
    bool start_array() override { return open(true); }
    bool end() override {
        steps_.pop_back();
        arrays_.pop_back();
        after_key_ = bytes_read();
        return true;
    }
    void broken(Diagnostic /*complaint*/) override {}

private:
    void step() {
        if (!arrays_.empty() && arrays_.back()) steps_.back() = std::to_string(count_.back()++);
    }
    bool open(bool array) {
        step();
        steps_.emplace_back();
        arrays_.push_back(array);
        count_.resize(arrays_.size());
        count_.back() = 0;
        after_key_ = bytes_read();
        return true;
    }

    const std::vector<std::string>& path_;
    std::vector<std::string> steps_;
    std::vector<bool> arrays_;
    std::vector<std::size_t> count_;
    std::size_t after_key_ = 0;
};

} // namespace

Result<GltfIndex> gltf_index(std::string_view text, const std::string& source) {
    GltfIndex index;
    Indexer indexer(index, source);
    constexpr bool comments = false;
    detail::read_json(text, source, comments, indexer);
    if (Result<void> finished = indexer.finish(); !finished) return pass_on(finished);
    return index;
}

GltfElement gltf_value_place(std::string_view text, GltfElement element, const std::vector<std::string>& path) {
    Finder finder(path);
    detail::read_json(text.substr(element.offset, element.length), {}, false, finder);
    if (finder.end_of_value <= finder.begin) return {};
    return {static_cast<std::uint32_t>(element.offset + finder.begin),
            static_cast<std::uint32_t>(finder.end_of_value - finder.begin)};
}

} // namespace gonio::interchange_detail
