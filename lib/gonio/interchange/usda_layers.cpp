#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/interchange/detail/usda_layers.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gonio::interchange_detail {

namespace {

// Without ".", and without ".." where a folder is left that was entered.
std::string normalised(std::string_view path) {
    std::vector<std::string_view> parts;
    const bool is_absolute = path.starts_with('/');
    while (!path.empty()) {
        const std::size_t end = std::min(path.find_first_of("/\\"), path.size());
        const std::string_view part = path.substr(0, end);
        path.remove_prefix(std::min(end + 1, path.size()));
        if (part.empty() || part == ".") continue;
        if (part == ".." && !parts.empty() && parts.back() != "..")
            parts.pop_back();
        else
            parts.push_back(part);
    }
    std::string made = is_absolute ? "/" : "";
    for (std::size_t i = 0; i < parts.size(); ++i)
        made.append(i == 0 ? "" : "/").append(parts[i]);
    return made;
}

void index_layer(IndexedLayer& of) {
    if (std::exchange(of.is_indexed, true)) return;
    std::map<std::pair<std::uint32_t, std::string_view>, std::size_t> sets;
    for (std::uint32_t i = 0; i < of.layer.prims.size(); ++i) {
        const UsdPrim& prim = of.layer.prims[i];
        if (prim.is_variant) {
            const std::string_view set = of.layer.compositions.at(i).variant_set;
            std::vector<IndexedLayer::Variants>& all = of.variants[prim.parent];
            const auto [at, is_new] = sets.try_emplace({prim.parent, set}, all.size());
            if (is_new) all.push_back({set, {}});
            all[at->second].by_name[prim.name].push_back(i);
        } else if (of.prims.try_emplace({prim.parent, prim.name}, i).second) {
            of.children[prim.parent].push_back(i);
        }
    }
}

} // namespace

std::string usd_file_name(const UsdSource& from, std::string_view asset) {
    if (asset.starts_with('/')) return normalised(asset);
    const std::size_t slash = from.name.rfind('/');
    return normalised(slash == std::string::npos ? std::string(asset)
                                                 : from.name.substr(0, slash + 1) + std::string(asset));
}

// Of an arc in times that are themselves nested.
UsdTimes nested(UsdTimes in, UsdTimes of) {
    return {in.offset + in.scale * of.offset, in.scale * of.scale};
}

bool is_finite(UsdTimes times) {
    return std::isfinite(times.offset) && std::isfinite(times.scale);
}

Result<std::uint32_t> UsdLayers::open_root(std::string_view bytes, const std::string& source) {
    if (is_archive(bytes)) return open_archive_root(bytes, source);
    UsdSource root;
    root.name = source.substr(source.find_last_of("/\\") + 1);
    return add_layer(bytes, source, std::move(root));
}

Result<std::uint32_t> UsdLayers::open_archive_root(std::string_view bytes, const std::string& source) {
    Result<Archive> archive = Archive::open(bytes, source);
    if (!archive) return pass_on(archive);
    stage_.archives.push_back(std::move(*archive));
    Result<std::optional<std::string_view>> text = first_layer(0, {source, 0, 0}, nullptr);
    if (!text) return pass_on(text);
    UsdSource root;
    root.archive = 0;
    const ArchiveEntry& entry = stage_.archives.front().entries().front();
    root.name = entry.name;
    return add_layer(**text, stage_.archives.front().name_of(entry), std::move(root));
}

Result<std::optional<std::string_view>> UsdLayers::first_layer(int archive, const Location& at,
                                                               const std::pair<std::uint32_t, std::size_t>* arc) {
    const Archive& of = stage_.archives[static_cast<std::size_t>(archive)];
    const std::string why = "the first file of a USDZ archive must be a layer of USD as text";
    const std::string hint = "convert it first: usdcat scene.usdz -o scene.usda";
    if (of.entries().empty() || !is_usd_name(of.entries().front().name)) {
        if (arc == nullptr) return scene_error("SCN0101", at, why, hint);
        warn("SCN0107", arc->first, arc->second, why, hint);
        return std::optional<std::string_view>();
    }
    Result<std::string> bytes = of.read(of.entries().front());
    if (!bytes) return pass_on(bytes);
    if (!is_usda(*bytes)) {
        if (arc == nullptr)
            return scene_error("SCN0101", {of.name_of(of.entries().front()), 0, 0},
                               "this layer is binary USD (USDC), which gonio does not read", hint);
        warn("SCN0107", arc->first, arc->second, why, hint);
        return std::optional<std::string_view>();
    }
    stage_.texts.push_back(std::move(*bytes));
    return std::optional<std::string_view>(stage_.texts.back());
}

Result<std::uint32_t> UsdLayers::add_layer(std::string_view text, const std::string& source, UsdSource about) {
    const auto index = static_cast<std::uint32_t>(layers_.size());
    Result<UsdLayer> parsed = parse_usda(text, source);
    if (!parsed) return pass_on(parsed);
    about.places = TextPlaces(text, source);
    stage_.sources.push_back(std::move(about));
    layers_.emplace_back();
    IndexedLayer& made = layers_.back();
    made.layer = std::move(*parsed);
    for (UsdPrim& prim : made.layer.prims) {
        prim.layer = index;
        for (UsdAttribute& attribute : prim.attributes) {
            attribute.value.layer = index;
            for (UsdSample& sample : attribute.samples)
                sample.value.layer = index;
        }
    }
    return index;
}

std::size_t UsdLayers::file_of(std::uint32_t from, const UsdArc& arc) {
    const auto [known, is_new] = file_by_arc_.try_emplace({from, arc.at});
    if (is_new) {
        const UsdSource& source = stage_.sources[from];
        const auto [file, is_unknown] =
            files_.try_emplace({source.archive, usd_file_name(source, arc.asset)}, files_.size());
        known->second = file->second;
    }
    return known->second;
}

// Once for each arc: prims that are composed of the same one share its arcs.
Result<std::optional<std::uint32_t>> UsdLayers::layer_of(std::uint32_t from, const UsdArc& arc) {
    if (const auto known = layer_by_arc_.find({from, arc.at}); known != layer_by_arc_.end()) return known->second;
    Result<std::optional<std::uint32_t>> found = find_layer(from, arc);
    if (found) layer_by_arc_[{from, arc.at}] = *found;
    return found;
}

Result<std::optional<std::uint32_t>> UsdLayers::find_layer(std::uint32_t from, const UsdArc& arc) {
    const auto place = [&] { return stage_.place(from, arc.at); };
    const std::string written = shown_text(arc.asset);
    const auto missing = [&](std::string why, std::string hint = {}) -> Result<std::optional<std::uint32_t>> {
        warn("SCN0107", from, arc.at, fmt::format("the layer '{}' is left out: {}", written, why), std::move(hint));
        return std::optional<std::uint32_t>();
    };
    if (arc.asset.starts_with('`')) return missing("its name is an expression");
    UsdSource about;
    about.archive = stage_.sources[from].archive;
    about.name = usd_file_name(stage_.sources[from], arc.asset);
    const auto [known, is_new] = by_name_.try_emplace({about.archive, about.name});
    if (!is_new) return known->second;
    if (about.archive == stage_.sources[0].archive && about.name == stage_.sources[0].name) return known->second = 0U;
    if (by_name_.size() > limit("scene-layers").value)
        return scene_error("SCN0108", place(), fmt::format("more than {}", to_text(limit("scene-layers"))),
                           std::string(limits_hint));
    std::string_view text;
    std::string source;
    if (about.archive >= 0) {
        const Archive& archive = stage_.archives[static_cast<std::size_t>(about.archive)];
        const ArchiveEntry* const entry = archive.find(about.name);
        if (entry == nullptr) return missing("it is not in the archive");
        Result<std::string> bytes = archive.read(*entry);
        if (!bytes) return pass_on(bytes);
        stage_.texts.push_back(std::move(*bytes));
        source = archive.name_of(*entry);
    } else {
        if (!options_.read_beside) return missing("files beside the scene are not read");
        Result<std::string> bytes = options_.read_beside(about.name);
        if (!bytes) {
            const Diagnostics& why = bytes.error().diagnostics;
            return missing(why.empty() ? std::string("it cannot be read") : why.back().message,
                           why.empty() ? std::string() : why.back().hint);
        }
        stage_.texts.push_back(std::move(*bytes));
        source = about.name;
    }
    text = stage_.texts.back();
    if (is_archive(text)) {
        if (about.archive >= 0) return missing("it is an archive in an archive");
        Result<Archive> archive = Archive::open(text, about.name);
        if (!archive) return pass_on(archive);
        about.archive = static_cast<int>(stage_.archives.size());
        stage_.archives.push_back(std::move(*archive));
        const std::pair where(from, arc.at);
        Result<std::optional<std::string_view>> first = first_layer(about.archive, place(), &where);
        if (!first) return pass_on(first);
        if (!*first) return std::optional<std::uint32_t>();
        const ArchiveEntry& entry = stage_.archives.back().entries().front();
        about.name = entry.name;
        source = stage_.archives.back().name_of(entry);
        text = **first;
    }
    if (text.starts_with("PXR-USDC"))
        return missing("it is binary USD (USDC)", "convert it first: usdcat scene.usdc -o scene.usda");
    if (!is_usda(text)) return missing("it is not USD as text");
    Result<std::uint32_t> made = add_layer(text, source, std::move(about));
    if (!made) return pass_on(made);
    // USD converts nothing between layers.
    const UsdLayer& layer = layers_[*made].layer;
    const UsdLayer& root = layers_.front().layer;
    if (layer.meters_per_unit != root.meters_per_unit || layer.up != root.up)
        warn("SCN0201", from, arc.at,
             fmt::format("the layer '{}' has another unit or axis than the scene: as in USD, its lengths and axes are "
                         "taken as those of the scene",
                         written));
    return known->second = *made;
}

Result<std::uint32_t> UsdLayers::stack_of(std::uint32_t root) {
    const auto [known, is_new] = stack_by_layer_.try_emplace(root, static_cast<std::uint32_t>(stacks_.size()));
    if (!is_new) return known->second;
    const std::uint32_t index = known->second;
    stacks_.emplace_back();
    std::vector<LayerOfStack> stack;
    std::vector<std::uint32_t> active;
    if (Result<void> added = add_sublayers(root, {}, stack, active); !added) return pass_on(added);
    stacks_[index] = std::move(stack);
    return index;
}

Unexpected UsdLayers::beyond_numbers(std::uint32_t layer, const UsdArc& arc) {
    return scene_error("SCN0105", stage_.place(layer, arc.at),
                       "with those around it, the offset or scale of the layer's times is not a finite number");
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as scene-depth
Result<void> UsdLayers::add_sublayers(std::uint32_t layer, UsdTimes times, std::vector<LayerOfStack>& stack,
                                      std::vector<std::uint32_t>& active) {
    index_layer(layers_[layer]);
    stack.push_back({layer, times});
    if (active.size() > limit("scene-depth").value || stack.size() > limit("scene-layers").value)
        return scene_error("SCN0108", stage_.place(layer, 0),
                           fmt::format("more sublayers than {}", to_text(limit("scene-layers"))),
                           std::string(limits_hint));
    active.push_back(layer);
    const std::vector<UsdArc> arcs = layers_[layer].layer.sublayers;
    for (const UsdArc& arc : arcs) {
        if (arc.is_none) continue;
        Result<std::optional<std::uint32_t>> below = layer_of(layer, arc);
        if (!below) return pass_on(below);
        if (!*below) continue;
        if (std::find(active.begin(), active.end(), **below) != active.end())
            return scene_error("SCN0104", stage_.place(layer, arc.at),
                               fmt::format("the layer '{}' is among its own sublayers", shown_text(arc.asset)));
        const UsdTimes own = nested(times, arc.times);
        if (!is_finite(own)) return beyond_numbers(layer, arc);
        if (Result<void> added = add_sublayers(**below, own, stack, active); !added) return added;
    }
    active.pop_back();
    return {};
}

void UsdLayers::warn(SceneCode code, std::uint32_t layer, std::size_t at, const std::string& message,
                     std::string hint) {
    constexpr std::size_t most = 20;
    Said& of = said_[code->code];
    if (of.messages.contains(message)) return;
    if (of.messages.size() == most) {
        of.more.insert({layer, at});
        return;
    }
    of.messages.insert(message);
    Diagnostic said;
    said.code = code->code;
    said.severity = code->severity;
    said.location = stage_.place(layer, at);
    said.message = message;
    said.hint = std::move(hint);
    of.last = stage_.diagnostics.size();
    stage_.diagnostics.push_back(std::move(said));
}

void UsdLayers::close() {
    for (IndexedLayer& each : layers_)
        stage_.layers.push_back(std::move(each.layer));
    for (const auto& [code, of] : said_)
        if (!of.more.empty()) stage_.diagnostics[of.last].message += fmt::format(" (and {} more)", of.more.size());
}

} // namespace gonio::interchange_detail
