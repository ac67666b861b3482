// Composition of USD: which layers say something about a prim, from the strongest to the weakest. A prim's opinions are
// in the order of OpenUSD, "LIVERPS": of its own layers, then of what it inherits, of its variants, of references,
// payloads, and of what it specializes. Arcs of a child are stronger than those that its parent brought.
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/interchange/detail/usda.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace gonio::interchange_detail {

namespace {

constexpr std::uint32_t no_prim = 0xffffffff;

// Paths and names of others, short and plain for messages.
std::string shown(std::string_view text) {
    constexpr std::size_t longest = 80;
    std::string plain(text.substr(0, longest));
    if (has_control_characters(plain))
        for (char& c : plain)
            if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f) c = '?';
    return plain;
}

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

bool is_layer_name(std::string_view name) {
    return ends_with_any_case(name, ".usda") || ends_with_any_case(name, ".usd") || ends_with_any_case(name, ".usdc");
}

// Times of a layer in those of the scene.
struct Times {
    double offset = 0.0;
    double scale = 1.0;

    Times of(double by_offset, double by_scale) const { return {offset + scale * by_offset, scale * by_scale}; }
};

// A prim or a variant in a layer; `prim` is no_prim for the layer's root.
struct Site {
    std::uint32_t stack = 0;
    std::uint32_t layer = 0;
    std::uint32_t prim = no_prim;
    Times times;
};

// A layer with its sublayers, the strongest first.
struct LayerOfStack {
    std::uint32_t layer = 0;
    Times times;
};

struct ParsedLayer {
    UsdLayer layer;
    // By parent and name; variants are left out, and are listed by the prim that they are of.
    std::map<std::pair<std::uint32_t, std::string_view>, std::uint32_t> prims;
    std::map<std::uint32_t, std::vector<std::uint32_t>> children;
    std::map<std::uint32_t, std::vector<std::uint32_t>> variants;
};

class Composer {
public:
    Composer(UsdStage& stage, const SceneReadOptions& options) : stage_(stage), options_(options) {}

    Result<void> compose(std::string_view bytes, const std::string& source) {
        Result<std::uint32_t> root = is_archive(bytes) ? open_archive_root(bytes, source) : add_root(bytes, source);
        if (!root) return pass_on(root);
        UsdLayer& layer = layers_.front().layer;
        if (!layer.is_composed_of) {
            stage_.layer = std::move(layer);
            return {};
        }
        std::vector<UsdPrim> prims = std::exchange(layer.prims, {});
        stage_.layer = layer; // the metadata
        stage_.layer.compositions.clear();
        layer.prims = std::move(prims);
        Result<std::uint32_t> stack = stack_of(*root);
        if (!stack) return pass_on(stack);
        return flatten(*stack);
    }

private:
    void warn(SceneCode code, Location location, std::string message, std::string hint = {}) {
        constexpr std::size_t most = 20;
        if (!said_.insert(message).second || said_.size() > most) return;
        Diagnostic said;
        said.code = code->code;
        said.severity = code->severity;
        said.location = std::move(location);
        said.message = std::move(message);
        said.hint = std::move(hint);
        stage_.diagnostics.push_back(std::move(said));
    }

    // Layers ----------------------------------------------------------------------------------------------------------

    Result<std::uint32_t> add_root(std::string_view bytes, const std::string& source) {
        UsdSource root;
        root.name = source.substr(source.find_last_of("/\\") + 1);
        return add_layer(bytes, source, std::move(root));
    }

    Result<std::uint32_t> open_archive_root(std::string_view bytes, const std::string& source) {
        Result<Archive> archive = Archive::open(bytes, source);
        if (!archive) return pass_on(archive);
        stage_.archives.push_back(std::move(*archive));
        Result<std::optional<std::string_view>> text = first_layer(0, {source, 0, 0}, true);
        if (!text) return pass_on(text);
        UsdSource root;
        root.archive = 0;
        const ArchiveEntry& entry = stage_.archives.front().entries().front();
        root.name = entry.name;
        return add_layer(**text, stage_.archives.front().name_of(entry), std::move(root));
    }

    // The text of the first file of an archive, which is its scene. Another one is an error, or a warning.
    Result<std::optional<std::string_view>> first_layer(int archive, const Location& at, bool must) {
        const Archive& of = stage_.archives[static_cast<std::size_t>(archive)];
        const std::string why = "the first file of a USDZ archive must be a layer of USD as text";
        const std::string hint = "convert it first: usdcat scene.usdz -o scene.usda";
        if (of.entries().empty() || !is_layer_name(of.entries().front().name)) {
            if (must) return scene_error("SCN0101", at, why, hint);
            warn("SCN0107", at, why, hint);
            return std::optional<std::string_view>();
        }
        Result<std::string> bytes = of.read(of.entries().front());
        if (!bytes) return pass_on(bytes);
        if (!is_usda(*bytes)) {
            if (must)
                return scene_error("SCN0101", {of.name_of(of.entries().front()), 0, 0},
                                   "this layer is binary USD (USDC), which gonio does not read", hint);
            warn("SCN0107", at, why, hint);
            return std::optional<std::string_view>();
        }
        stage_.texts.push_back(std::move(*bytes));
        return std::optional<std::string_view>(stage_.texts.back());
    }

    // `text` outlives the stage; `source` names it in messages.
    Result<std::uint32_t> add_layer(std::string_view text, const std::string& source, UsdSource about) {
        const auto index = static_cast<std::uint32_t>(layers_.size());
        Result<UsdLayer> parsed = parse_usda(text, source);
        if (!parsed) return pass_on(parsed);
        about.places = TextPlaces(text, source);
        stage_.sources.push_back(std::move(about));
        layers_.emplace_back();
        ParsedLayer& made = layers_.back();
        made.layer = std::move(*parsed);
        for (std::uint32_t i = 0; i < made.layer.prims.size(); ++i) {
            UsdPrim& prim = made.layer.prims[i];
            prim.layer = index;
            for (UsdAttribute& attribute : prim.attributes) {
                attribute.value.layer = index;
                for (UsdSample& sample : attribute.samples)
                    sample.value.layer = index;
            }
        }
        return index;
    }

    void index_layer(ParsedLayer& of) {
        if (!of.children.empty()) return;
        for (std::uint32_t i = 0; i < of.layer.prims.size(); ++i) {
            const UsdPrim& prim = of.layer.prims[i];
            if (prim.is_variant) {
                of.variants[prim.parent].push_back(i);
            } else if (of.prims.try_emplace({prim.parent, prim.name}, i).second) {
                of.children[prim.parent].push_back(i);
            }
        }
    }

    // A layer that another one names; nothing if it is missing, which is said.
    Result<std::optional<std::uint32_t>> layer_of(std::uint32_t from, const UsdArc& arc) {
        const auto place = [&] { return stage_.place(from, arc.at); };
        const std::string written = shown(arc.asset);
        const auto missing = [&](std::string why, std::string hint = {}) -> Result<std::optional<std::uint32_t>> {
            warn("SCN0107", place(), fmt::format("the layer '{}' is left out: {}", written, why), std::move(hint));
            return std::optional<std::uint32_t>();
        };
        if (arc.asset.starts_with('`')) return missing("its name is an expression");
        UsdSource about;
        about.archive = stage_.sources[from].archive;
        about.name = usd_file_name(stage_.sources[from], arc.asset);
        const auto [known, is_new] = by_name_.try_emplace({about.archive, about.name});
        if (!is_new) return known->second;
        if (about.archive == stage_.sources[0].archive && about.name == stage_.sources[0].name)
            return known->second = 0U;
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
            Result<std::optional<std::string_view>> first = first_layer(about.archive, place(), false);
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
            warn("SCN0201", place(),
                 fmt::format(
                     "the layer '{}' has another unit or axis than the scene: as in USD, its lengths and axes are "
                     "taken as those of the scene",
                     written));
        return known->second = *made;
    }

    // The layer with its sublayers. It is the first of its stack.
    Result<std::uint32_t> stack_of(std::uint32_t root) {
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

    // NOLINTNEXTLINE(misc-no-recursion): as deep as scene-depth
    Result<void> add_sublayers(std::uint32_t layer, Times times, std::vector<LayerOfStack>& stack,
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
                                   fmt::format("the layer '{}' is among its own sublayers", shown(arc.asset)));
            if (Result<void> added = add_sublayers(**below, times.of(arc.offset, arc.scale), stack, active); !added)
                return added;
        }
        active.pop_back();
        return {};
    }

    // Sites -----------------------------------------------------------------------------------------------------------

    const UsdPrim& prim_at(const Site& site) const { return layers_[site.layer].layer.prims[site.prim]; }

    const UsdComposition& composition_at(const Site& site) const {
        static const UsdComposition none;
        const auto& all = layers_[site.layer].layer.compositions;
        const auto found = all.find(site.prim);
        return found == all.end() ? none : found->second;
    }

    Location place_of(const Site& site, std::size_t at) { return stage_.place(site.layer, at); }

    std::string path_of(const Site& site) const {
        std::string path;
        for (std::uint32_t at = site.prim; at != no_prim;) {
            const UsdPrim& prim = layers_[site.layer].layer.prims[at];
            if (!prim.is_variant) path.insert(0, "/" + prim.name);
            at = prim.parent;
        }
        return path;
    }

    std::vector<Site> root_of(std::uint32_t stack) const {
        std::vector<Site> sites;
        for (const LayerOfStack& one : stacks_[stack])
            sites.push_back({stack, one.layer, no_prim, one.times});
        return sites;
    }

    void add_children_named(const std::vector<Site>& parents, std::string_view name, std::vector<Site>& sites) const {
        for (const Site& parent : parents) {
            const ParsedLayer& layer = layers_[parent.layer];
            if (const auto child = layer.prims.find({parent.prim, name}); child != layer.prims.end())
                sites.push_back({parent.stack, parent.layer, child->second, parent.times});
        }
    }

    // What is composed now, from the outside in: each once, and not too deep.
    Result<void> enter(std::uint32_t stack, const std::string& path, const Site& from, std::size_t at) {
        std::pair<std::uint32_t, std::string> key(stack, path);
        if (std::find(active_.begin(), active_.end(), key) != active_.end())
            return scene_error("SCN0104", place_of(from, at),
                               fmt::format("the prim '{}' is composed of itself", shown(path)));
        if (active_.size() > limit("scene-depth").value)
            return scene_error("SCN0108", place_of(from, at),
                               fmt::format("references nested deeper than {}", to_text(limit("scene-depth"))),
                               std::string(limits_hint));
        active_.push_back(std::move(key));
        return {};
    }

    // The sites of a path in a stack of layers, without what they are composed of: children of all that its parent is
    // composed of. NOLINTNEXTLINE(misc-no-recursion): as deep as scene-depth
    Result<std::vector<Site>> base_of(std::uint32_t stack, const std::string& path, const Site& from, std::size_t at) {
        const std::size_t slash = path.rfind('/');
        Result<const std::vector<Site>*> parents = sites_of(stack, path.substr(0, slash), from, at);
        if (!parents) return pass_on(parents);
        std::vector<Site> own;
        add_children_named(**parents, std::string_view(path).substr(slash + 1), own);
        return own;
    }

    // All sites of a path, where nothing outside selects variants.
    // NOLINTNEXTLINE(misc-no-recursion): as deep as scene-depth
    Result<const std::vector<Site>*> sites_of(std::uint32_t stack, const std::string& path, const Site& from,
                                              std::size_t at) {
        const std::pair<std::uint32_t, std::string> key(stack, path);
        if (const auto known = sites_by_path_.find(key); known != sites_by_path_.end()) return &known->second;
        std::vector<Site> sites;
        if (path.empty()) {
            sites = root_of(stack);
        } else {
            if (Result<void> entered = enter(stack, path, from, at); !entered) return pass_on(entered);
            Result<std::vector<Site>> base = base_of(stack, path, from, at);
            if (!base) return pass_on(base);
            if (Result<void> expanded = expand(*base, sites); !expanded) return pass_on(expanded);
            active_.pop_back();
        }
        return &(sites_by_path_[key] = std::move(sites));
    }

    // What the sites of a prim are composed of, each followed by its arcs.
    // NOLINTNEXTLINE(misc-no-recursion): as deep as scene-depth
    Result<void> expand(const std::vector<Site>& base, std::vector<Site>& sites) {
        for (std::size_t begin = 0; begin < base.size();) {
            std::size_t end = begin + 1;
            while (end < base.size() && base[end].stack == base[begin].stack)
                ++end;
            const std::vector<Site> group(base.begin() + static_cast<std::ptrdiff_t>(begin),
                                          base.begin() + static_cast<std::ptrdiff_t>(end));
            if (Result<void> added = expand_group(group, base, sites, 0); !added) return added;
            begin = end;
        }
        return {};
    }

    // Sites of one stack. `base`: all of the prim, which may select variants.
    // NOLINTNEXTLINE(misc-no-recursion): as deep as variants are nested
    Result<void> expand_group(const std::vector<Site>& group, const std::vector<Site>& base, std::vector<Site>& sites,
                              std::size_t depth) {
        constexpr std::size_t most = 10000;
        if (sites.size() + group.size() > most || depth > limit("scene-depth").value)
            return scene_error("SCN0108", place_of(group.front(), prim_at(group.front()).offset),
                               fmt::format("a prim is composed of more than {} others", most));
        sites.insert(sites.end(), group.begin(), group.end());
        if (Result<void> added = follow(group, UsdArcKind::inherit, sites); !added) return added;
        std::vector<Site> chosen;
        std::set<std::string, std::less<>> without;
        for (const Site& site : group) {
            const ParsedLayer& layer = layers_[site.layer];
            const auto variants = layer.variants.find(site.prim);
            if (variants == layer.variants.end()) continue;
            for (const std::uint32_t variant : variants->second) {
                const UsdPrim& prim = layer.layer.prims[variant];
                const std::string& set = layer.layer.compositions.at(variant).variant_set;
                const std::string* const selected = selection(set, sites, base);
                if (selected == nullptr && without.insert(set).second)
                    warn("SCN0201", place_of(site, prim.offset),
                         fmt::format("the variant set '{}' of '{}' has no selection: none of its variants is taken",
                                     shown(set), shown(path_of(site))));
                if (selected != nullptr && *selected == prim.name)
                    chosen.push_back({site.stack, site.layer, variant, site.times});
            }
        }
        if (!chosen.empty())
            if (Result<void> added = expand_group(chosen, base, sites, depth + 1); !added) return added;
        for (const UsdArcKind kind : {UsdArcKind::reference, UsdArcKind::payload, UsdArcKind::specialize})
            if (Result<void> added = follow(group, kind, sites); !added) return added;
        return {};
    }

    const std::string* selection(std::string_view set, const std::vector<Site>& sites,
                                 const std::vector<Site>& base) const {
        for (const std::vector<Site>* const among : {&sites, &base})
            for (const Site& site : *among)
                for (const auto& [name, variant] : composition_at(site).selected)
                    if (name == set) return &variant;
        return nullptr;
    }

    // Arcs of one kind: those that the strongest layers add, up to one that lists all.
    // NOLINTNEXTLINE(misc-no-recursion): by way of sites_of()
    Result<void> follow(const std::vector<Site>& group, UsdArcKind kind, std::vector<Site>& sites) {
        std::set<std::pair<std::string, std::string>> removed;
        std::set<std::pair<std::string, std::string>> taken;
        for (const Site& site : group) {
            bool is_all = false;
            const std::vector<UsdArc>& arcs = composition_at(site).arcs;
            for (const UsdArc& arc : arcs) {
                if (arc.kind != kind) continue;
                is_all = is_all || arc.edit == UsdListEdit::is_all;
                const std::pair<std::string, std::string> key(arc.asset, arc.path);
                if (arc.is_none || arc.edit == UsdListEdit::removes || removed.contains(key)) continue;
                // The same one twice counts once, but for files of the same name in other folders.
                if (!taken.insert(key).second) continue;
                if (Result<void> added = follow(site, arc, sites); !added) return added;
            }
            for (const UsdArc& arc : arcs)
                if (arc.kind == kind && arc.edit == UsdListEdit::removes) removed.insert({arc.asset, arc.path});
            if (is_all) break;
        }
        return {};
    }

    // NOLINTNEXTLINE(misc-no-recursion): by way of sites_of()
    Result<void> follow(const Site& site, const UsdArc& arc, std::vector<Site>& sites) {
        std::uint32_t stack = site.stack;
        std::string path = arc.path;
        if (!arc.asset.empty()) {
            Result<std::optional<std::uint32_t>> layer = layer_of(site.layer, arc);
            if (!layer) return pass_on(layer);
            if (!*layer) return {};
            Result<std::uint32_t> found = stack_of(**layer);
            if (!found) return pass_on(found);
            stack = *found;
        }
        if (path.empty()) {
            path = layers_[stacks_[stack].front().layer].layer.default_prim;
            if (path.empty()) {
                warn("SCN0107", place_of(site, arc.at),
                     fmt::format("the layer '{}' has no defaultPrim: the reference to it is left out",
                                 shown(arc.asset)));
                return {};
            }
            if (!path.starts_with('/')) path.insert(0, "/");
        }
        if (!path.starts_with('/') || path.size() < 2 || path.find_first_of(".{") != std::string::npos) {
            warn("SCN0107", place_of(site, arc.at),
                 fmt::format("'<{}>' is left out: only absolute paths of prims are followed", shown(path)));
            return {};
        }
        if (path.ends_with('/')) path.pop_back();
        const std::string own = path_of(site) + "/";
        if (stack == site.stack && own.starts_with(path + "/"))
            return scene_error(
                "SCN0104", place_of(site, arc.at),
                fmt::format("the prim '{}' is composed of itself or of a prim that it is in", shown(path_of(site))));
        if (Result<void> entered = enter(stack, path, site, arc.at); !entered) return entered;
        Result<std::vector<Site>> target = base_of(stack, path, site, arc.at);
        if (!target) return pass_on(target);
        if (target->empty() && arc.kind != UsdArcKind::inherit && arc.kind != UsdArcKind::specialize)
            warn("SCN0107", place_of(site, arc.at), fmt::format("there is no prim '{}' to refer to", shown(path)));
        const Times times = site.times.of(arc.offset, arc.scale);
        for (Site& one : *target)
            one.times = times.of(one.times.offset, one.times.scale);
        // In the same list, so that the stronger sites in it select variants.
        if (Result<void> expanded = expand(*target, sites); !expanded) return expanded;
        active_.pop_back();
        return {};
    }

    // Prims -----------------------------------------------------------------------------------------------------------

    struct Open {
        std::uint32_t prim = no_prim;
        std::vector<Site> sites;
        std::vector<std::string_view> children; // the last first
        std::size_t depth = 0;
    };

    Result<void> flatten(std::uint32_t stack) {
        std::vector<Open> open;
        open.push_back({no_prim, root_of(stack), {}, 0});
        list_children(open.back());
        while (!open.empty()) {
            if (open.back().children.empty()) {
                open.pop_back();
                continue;
            }
            const std::string_view name = open.back().children.back();
            open.back().children.pop_back();
            std::vector<Site> own;
            add_children_named(open.back().sites, name, own);
            Open child;
            child.depth = open.back().depth + 1;
            active_.clear();
            if (Result<void> expanded = expand(own, child.sites); !expanded) return expanded;
            const auto at = [&] { return place_of(own.front(), prim_at(own.front()).offset); };
            if (child.depth > limit("scene-depth").value)
                return scene_error(
                    "SCN0108", at(),
                    fmt::format("nested deeper than {}, references included", to_text(limit("scene-depth"))));
            constexpr std::size_t most_prims = 1000000;
            constexpr std::size_t most_sites = 4000000;
            composed_sites_ += child.sites.size();
            if (stage_.layer.prims.size() >= most_prims || composed_sites_ > most_sites)
                return scene_error("SCN0108", at(), fmt::format("more than {} prims, references included", most_prims));
            child.prim = static_cast<std::uint32_t>(stage_.layer.prims.size());
            stage_.layer.prims.push_back(merged(child.sites, open.back().prim));
            list_children(child);
            open.push_back(std::move(child));
        }
        return {};
    }

    void list_children(Open& of) const {
        std::set<std::string_view> known;
        for (const Site& site : of.sites) {
            const ParsedLayer& layer = layers_[site.layer];
            const auto children = layer.children.find(site.prim);
            if (children == layer.children.end()) continue;
            for (const std::uint32_t child : children->second)
                if (known.insert(layer.layer.prims[child].name).second)
                    of.children.emplace_back(layer.layer.prims[child].name);
        }
        std::reverse(of.children.begin(), of.children.end());
    }

    // The strongest opinion about everything.
    UsdPrim merged(const std::vector<Site>& sites, std::uint32_t parent) const {
        UsdPrim made;
        made.name = prim_at(sites.front()).name;
        made.offset = prim_at(sites.front()).offset;
        made.layer = sites.front().layer;
        made.parent = parent;
        made.specifier = UsdSpecifier::over;
        std::set<std::string, std::less<>> removed;
        std::map<std::string_view, std::size_t> attributes;
        for (const Site& site : sites) {
            const UsdPrim& prim = prim_at(site);
            if (made.specifier == UsdSpecifier::over) made.specifier = prim.specifier;
            if (made.type.empty()) made.type = prim.type;
            if (!made.active) made.active = prim.active;
            for (const std::string& schema : prim.schemas)
                if (!removed.contains(schema)) made.schemas.push_back(schema);
            const std::vector<std::string>& less = composition_at(site).removed_schemas;
            removed.insert(less.begin(), less.end());
            for (const UsdAttribute& attribute : prim.attributes) {
                const bool says = attribute.value.is_set || attribute.value.is_blocked || !attribute.samples.empty();
                const auto [at, is_new] = attributes.try_emplace(attribute.name, made.attributes.size());
                if (is_new) {
                    made.attributes.push_back(attribute);
                } else {
                    UsdAttribute& known = made.attributes[at->second];
                    const bool is_said = known.value.is_set || known.value.is_blocked || !known.samples.empty();
                    known.is_connected = known.is_connected || attribute.is_connected;
                    if (is_said || !says) continue;
                    const bool is_connected = known.is_connected;
                    known = attribute;
                    known.is_connected = is_connected;
                }
                for (UsdSample& sample : made.attributes[at->second].samples)
                    sample.time = site.times.offset + site.times.scale * sample.time;
            }
        }
        return made;
    }

    UsdStage& stage_;
    const SceneReadOptions& options_;
    std::deque<ParsedLayer> layers_;                                              // as UsdStage::sources
    std::map<std::pair<int, std::string>, std::optional<std::uint32_t>> by_name_; // nothing: missing
    std::vector<std::vector<LayerOfStack>> stacks_;
    std::map<std::uint32_t, std::uint32_t> stack_by_layer_;
    std::map<std::pair<std::uint32_t, std::string>, std::vector<Site>> sites_by_path_;
    std::vector<std::pair<std::uint32_t, std::string>> active_;
    std::set<std::string> said_;
    std::size_t composed_sites_ = 0;
};

} // namespace

std::string usd_file_name(const UsdSource& from, std::string_view asset) {
    if (asset.starts_with('/')) return normalised(asset);
    const std::size_t slash = from.name.rfind('/');
    return normalised(slash == std::string::npos ? std::string(asset)
                                                 : from.name.substr(0, slash + 1) + std::string(asset));
}

Result<UsdStage> compose_usd(std::string_view bytes, const std::string& source, const SceneReadOptions& options) {
    UsdStage stage;
    if (Result<void> composed = Composer(stage, options).compose(bytes, source); !composed) return pass_on(composed);
    return stage;
}

} // namespace gonio::interchange_detail
