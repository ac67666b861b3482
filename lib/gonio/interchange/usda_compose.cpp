// Composition of USD: which layers say something about a prim, from the strongest to the weakest. A prim's opinions are
// in the order of OpenUSD, "LIVERPS": of its own layers, then of what it inherits, of its variants, of references,
// payloads, and of what it specializes. Arcs of a child are stronger than those that its parent brought.
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/interchange/detail/usda.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <map>
#include <set>
#include <utility>

namespace gonio::interchange_detail {

namespace {

constexpr std::uint32_t no_prim = 0xffffffff;
constexpr std::size_t no_file = std::string::npos;

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

// Of an arc in times that are themselves nested.
UsdTimes nested(UsdTimes in, UsdTimes of) {
    return {in.offset + in.scale * of.offset, in.scale * of.scale};
}

bool is_finite(UsdTimes times) {
    return std::isfinite(times.offset) && std::isfinite(times.scale);
}

// A prim or a variant in a layer; `prim` is no_prim for the layer's root.
struct Site {
    std::uint32_t stack = 0;
    std::uint32_t layer = 0;
    std::uint32_t prim = no_prim;
    UsdTimes times;
};

// A layer with its sublayers, the strongest first.
struct LayerOfStack {
    std::uint32_t layer = 0;
    UsdTimes times;
};

struct ParsedLayer {
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
        if (Result<void> flat = flatten(*stack); !flat) return flat;
        for (ParsedLayer& each : layers_) // what opinions point to stays where it is
            stage_.layers.push_back(std::move(each.layer));
        close_counts();
        return {};
    }

private:
    // Warnings of a code: the first ones, and in how many further places there would be more.
    struct Said {
        std::set<std::string, std::less<>> messages;
        std::set<std::pair<std::uint32_t, std::size_t>> more;
        std::size_t last = 0; // of the stage's diagnostics
    };

    // `at` in the text of `layer`.
    void warn(SceneCode code, std::uint32_t layer, std::size_t at, const std::string& message, std::string hint = {}) {
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

    void close_counts() {
        for (const auto& [code, of] : said_)
            if (!of.more.empty()) stage_.diagnostics[of.last].message += fmt::format(" (and {} more)", of.more.size());
    }

    // Counts what is looked at. A short file may name the same long lists again and again.
    Result<void> look(std::size_t count, const Site& from) {
        constexpr std::size_t most = 64000000;
        looked_at_ += count;
        if (looked_at_ <= most) return {};
        return scene_error("SCN0108", place_of(from), fmt::format("more than {} steps of composition", most));
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
        Result<std::optional<std::string_view>> text = first_layer(0, {source, 0, 0}, nullptr);
        if (!text) return pass_on(text);
        UsdSource root;
        root.archive = 0;
        const ArchiveEntry& entry = stage_.archives.front().entries().front();
        root.name = entry.name;
        return add_layer(**text, stage_.archives.front().name_of(entry), std::move(root));
    }

    // The text of the first file of an archive, which is its scene. Another one is an error, or a warning at `arc`, a
    // layer and a place in it.
    Result<std::optional<std::string_view>> first_layer(int archive, const Location& at,
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

    static void index_layer(ParsedLayer& of) {
        if (std::exchange(of.is_indexed, true)) return;
        std::map<std::pair<std::uint32_t, std::string_view>, std::size_t> sets;
        for (std::uint32_t i = 0; i < of.layer.prims.size(); ++i) {
            const UsdPrim& prim = of.layer.prims[i];
            if (prim.is_variant) {
                const std::string_view set = of.layer.compositions.at(i).variant_set;
                std::vector<ParsedLayer::Variants>& all = of.variants[prim.parent];
                const auto [at, is_new] = sets.try_emplace({prim.parent, set}, all.size());
                if (is_new) all.push_back({set, {}});
                all[at->second].by_name[prim.name].push_back(i);
            } else if (of.prims.try_emplace({prim.parent, prim.name}, i).second) {
                of.children[prim.parent].push_back(i);
            }
        }
    }

    // The file that an arc names, as a number. Files of the same name in other folders have others.
    std::size_t file_of(std::uint32_t from, const UsdArc& arc) {
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
    Result<std::optional<std::uint32_t>> layer_of(std::uint32_t from, const UsdArc& arc) {
        if (const auto known = layer_by_arc_.find({from, arc.at}); known != layer_by_arc_.end()) return known->second;
        Result<std::optional<std::uint32_t>> found = find_layer(from, arc);
        if (found) layer_by_arc_[{from, arc.at}] = *found;
        return found;
    }

    // A layer that another one names; nothing if it is missing, which is said.
    Result<std::optional<std::uint32_t>> find_layer(std::uint32_t from, const UsdArc& arc) {
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

    Unexpected beyond_numbers(std::uint32_t layer, const UsdArc& arc) {
        return scene_error("SCN0105", stage_.place(layer, arc.at),
                           "with those around it, the offset or scale of the layer's times is not a finite number");
    }

    // NOLINTNEXTLINE(misc-no-recursion): as deep as scene-depth
    Result<void> add_sublayers(std::uint32_t layer, UsdTimes times, std::vector<LayerOfStack>& stack,
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

    // Sites -----------------------------------------------------------------------------------------------------------

    const UsdPrim& prim_at(const Site& site) const { return layers_[site.layer].layer.prims[site.prim]; }

    const UsdComposition& composition_at(const Site& site) const {
        static const UsdComposition none;
        const auto& all = layers_[site.layer].layer.compositions;
        const auto found = all.find(site.prim);
        return found == all.end() ? none : found->second;
    }

    Location place_of(const Site& site, std::size_t at) { return stage_.place(site.layer, at); }
    Location place_of(const Site& site) {
        return stage_.place(site.layer, site.prim == no_prim ? 0 : prim_at(site).offset);
    }

    // From the root on.
    std::vector<std::string_view> names_of(const Site& site) const {
        std::vector<std::string_view> names;
        for (std::uint32_t at = site.prim; at != no_prim;) {
            const UsdPrim& prim = layers_[site.layer].layer.prims[at];
            if (!prim.is_variant) names.emplace_back(prim.name);
            at = prim.parent;
        }
        std::reverse(names.begin(), names.end());
        return names;
    }

    // For messages.
    std::string path_of(const Site& site) const {
        std::string path;
        for (const std::string_view name : names_of(site))
            path.append("/").append(shown_text(name));
        return path;
    }

    // Whether the prim is that of the path, or within it.
    bool is_within(const Site& site, std::string_view path) const {
        for (const std::string_view name : names_of(site)) {
            if (path.empty()) return true;
            if (!path.starts_with('/') || !path.substr(1).starts_with(name)) return false;
            path.remove_prefix(1 + name.size());
        }
        return path.empty();
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
                               fmt::format("the prim '{}' is composed of itself", shown_text(path)));
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
        if (Result<void> looked = look((*parents)->size(), from); !looked) return pass_on(looked);
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
        // Those of paths that are only referred to are kept too.
        constexpr std::size_t most_of_all = 4000000;
        composed_sites_ += group.size();
        if (composed_sites_ > most_of_all)
            return scene_error("SCN0108", place_of(group.front()),
                               fmt::format("prims are composed of more than {} others together", most_of_all));
        sites.insert(sites.end(), group.begin(), group.end());
        if (Result<void> added = follow(group, UsdArcKind::inherit, sites); !added) return added;
        // Selected once for each set, before any of their variants can select.
        struct Selected {
            const std::string* variant = nullptr; // nullptr: none
            std::size_t chosen = 0;
        };
        std::map<std::string_view, Selected> selected;
        std::vector<std::vector<Site>> chosen; // of each set, which has arcs of its own
        for (const Site& site : group) {
            const auto variants = layers_[site.layer].variants.find(site.prim);
            if (variants == layers_[site.layer].variants.end()) continue;
            constexpr std::size_t steps = 16; // of each set
            if (Result<void> looked = look(steps * variants->second.size(), site); !looked) return looked;
            for (const ParsedLayer::Variants& of : variants->second) {
                const auto [choice, is_new] = selected.try_emplace(of.set);
                if (is_new) {
                    Result<const std::string*> found = selection(of.set, sites, base);
                    if (!found) return pass_on(found);
                    choice->second = {*found, chosen.size()};
                    chosen.emplace_back();
                    if (*found == nullptr)
                        warn("SCN0201", site.layer, prim_at({site.stack, site.layer, first_of(of), {}}).offset,
                             fmt::format("the variant set '{}' of '{}' has no selection: none of its variants is taken",
                                         shown_text(of.set), shown_text(path_of(site))));
                }
                const Selected& one = choice->second;
                if (one.variant == nullptr) continue;
                const auto named = of.by_name.find(*one.variant);
                if (named == of.by_name.end()) continue;
                for (const std::uint32_t variant : named->second)
                    chosen[one.chosen].push_back({site.stack, site.layer, variant, site.times});
            }
        }
        for (const std::vector<Site>& variants : chosen)
            if (!variants.empty())
                if (Result<void> added = expand_group(variants, base, sites, depth + 1); !added) return added;
        for (const UsdArcKind kind : {UsdArcKind::reference, UsdArcKind::payload, UsdArcKind::specialize})
            if (Result<void> added = follow(group, kind, sites); !added) return added;
        return {};
    }

    // In the text.
    static std::uint32_t first_of(const ParsedLayer::Variants& set) {
        std::uint32_t first = no_prim;
        for (const auto& [name, variants] : set.by_name)
            first = std::min(first, variants.front());
        return first;
    }

    // nullptr: there is none.
    Result<const std::string*> selection(std::string_view set, const std::vector<Site>& sites,
                                         const std::vector<Site>& base) {
        for (const std::vector<Site>* const among : {&sites, &base})
            for (const Site& site : *among) {
                const auto& all = composition_at(site).selected;
                if (Result<void> looked = look(1 + all.size(), site); !looked) return pass_on(looked);
                for (const auto& [name, variant] : all)
                    if (name == set) return &variant;
            }
        return nullptr;
    }

    // Arcs of one kind. Each layer edits the list of weaker ones: it replaces it, or deletes, prepends to the front,
    // appends to the back, and adds what is not in it. The first of the list is the strongest. The same one twice
    // counts once. NOLINTNEXTLINE(misc-no-recursion): by way of sites_of()
    Result<void> follow(const std::vector<Site>& group, UsdArcKind kind, std::vector<Site>& sites) {
        using Key = std::pair<std::size_t, std::string_view>; // file and path
        struct Listed {
            Key key;
            const Site* site = nullptr;
            const UsdArc* arc = nullptr;
        };
        std::list<Listed> listed;
        std::map<Key, std::list<Listed>::iterator> places;
        const auto remove = [&](const Key& key) {
            const auto known = places.find(key);
            if (known == places.end()) return;
            listed.erase(known->second);
            places.erase(known);
        };
        for (std::size_t i = group.size(); i-- > 0;) { // from the weakest on
            const Site& site = group[i];
            const std::vector<UsdArc>& arcs = composition_at(site).arcs;
            if (arcs.empty()) continue;
            if (Result<void> looked = look(arcs.size(), site); !looked) return looked;
            const auto key_of = [&](const UsdArc& arc) {
                return Key(arc.asset.empty() ? no_file : file_of(site.layer, arc), arc.path);
            };
            const auto is_said = [&](const UsdArc& arc, UsdListEdit edit) {
                return arc.kind == kind && arc.edit == edit && !arc.is_none;
            };
            if (std::any_of(arcs.begin(), arcs.end(),
                            [&](const UsdArc& arc) { return arc.kind == kind && arc.edit == UsdListEdit::is_all; })) {
                listed.clear();
                places.clear();
            }
            for (const UsdArc& arc : arcs)
                if (is_said(arc, UsdListEdit::removes)) remove(key_of(arc));
            for (const UsdArc& arc : arcs) {
                if (!is_said(arc, UsdListEdit::is_all) && !is_said(arc, UsdListEdit::adds)) continue;
                const Key key = key_of(arc);
                if (!places.contains(key)) places[key] = listed.insert(listed.end(), {key, &site, &arc});
            }
            for (std::size_t last = arcs.size(); last-- > 0;) {
                const UsdArc& arc = arcs[last];
                if (!is_said(arc, UsdListEdit::prepends)) continue;
                const Key key = key_of(arc);
                remove(key);
                places[key] = listed.insert(listed.begin(), {key, &site, &arc});
            }
            for (const UsdArc& arc : arcs) {
                if (!is_said(arc, UsdListEdit::appends)) continue;
                const Key key = key_of(arc);
                remove(key);
                places[key] = listed.insert(listed.end(), {key, &site, &arc});
            }
        }
        for (const Listed& one : listed)
            if (Result<void> added = follow(*one.site, *one.arc, sites); !added) return added;
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
                warn("SCN0107", site.layer, arc.at,
                     fmt::format("the layer '{}' has no defaultPrim: the reference to it is left out",
                                 shown_text(arc.asset)));
                return {};
            }
            if (!path.starts_with('/')) path.insert(0, "/");
        }
        if (!path.starts_with('/') || path.size() < 2 || path.find_first_of(".{") != std::string::npos) {
            warn("SCN0107", site.layer, arc.at,
                 fmt::format("'<{}>' is left out: only absolute paths of prims are followed", shown_text(path)));
            return {};
        }
        if (path.ends_with('/')) path.pop_back();
        if (stack == site.stack && is_within(site, path))
            return scene_error("SCN0104", place_of(site, arc.at),
                               fmt::format("the prim '{}' is composed of itself or of a prim that it is in",
                                           shown_text(path_of(site))));
        if (Result<void> entered = enter(stack, path, site, arc.at); !entered) return entered;
        Result<std::vector<Site>> target = base_of(stack, path, site, arc.at);
        if (!target) return pass_on(target);
        if (target->empty() && arc.kind != UsdArcKind::inherit && arc.kind != UsdArcKind::specialize)
            warn("SCN0107", site.layer, arc.at, fmt::format("there is no prim '{}' to refer to", shown_text(path)));
        const UsdTimes times = nested(site.times, arc.times);
        if (!is_finite(times)) return beyond_numbers(site.layer, arc);
        for (Site& one : *target) {
            one.times = nested(times, one.times);
            if (!is_finite(one.times)) return beyond_numbers(site.layer, arc);
        }
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
            if (Result<void> looked = look(open.back().sites.size(), open.back().sites.front()); !looked) return looked;
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
            if (stage_.layer.prims.size() >= most_prims)
                return scene_error("SCN0108", at(), fmt::format("more than {} prims, references included", most_prims));
            child.prim = static_cast<std::uint32_t>(stage_.layer.prims.size());
            Result<UsdPrim> made = merged(child.sites, open.back().prim);
            if (!made) return pass_on(made);
            stage_.layer.prims.push_back(std::move(*made));
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

    static bool says(const UsdAttribute& attribute) {
        return attribute.value.is_set || attribute.value.is_blocked || !attribute.samples.empty();
    }

    // What a composed prim does not share with others.
    Result<void> keep(std::size_t bytes, const Site& of) {
        constexpr std::size_t most = std::size_t{256} << 20U;
        kept_bytes_ += bytes;
        if (kept_bytes_ <= most) return {};
        return scene_error("SCN0108", place_of(of), "the names and lists of the composed prims are beyond 256 MiB");
    }

    // The strongest opinion about everything.
    Result<UsdPrim> merged(const std::vector<Site>& sites, std::uint32_t parent) {
        UsdPrim made;
        made.name = prim_at(sites.front()).name;
        made.offset = prim_at(sites.front()).offset;
        made.layer = sites.front().layer;
        made.parent = parent;
        made.specifier = UsdSpecifier::over;
        std::set<std::string_view> removed;
        std::map<std::string_view, std::size_t> attributes;
        std::size_t bytes = made.name.size();
        for (const Site& site : sites) {
            const UsdPrim& prim = prim_at(site);
            if (made.specifier == UsdSpecifier::over) made.specifier = prim.specifier;
            if (made.type.empty()) made.type = prim.type;
            if (!made.active) made.active = prim.active;
            const std::vector<std::string>& less = composition_at(site).removed_schemas;
            if (Result<void> looked = look(1 + prim.schemas.size() + less.size() + prim.attributes.size(), site);
                !looked)
                return pass_on(looked);
            for (const std::string& schema : prim.schemas) {
                if (removed.contains(schema)) continue;
                bytes += sizeof(std::string) + schema.size();
                made.schemas.push_back(schema);
            }
            removed.insert(less.begin(), less.end());
            for (const UsdAttribute& attribute : prim.attributes) {
                const auto [at, is_new] = attributes.try_emplace(attribute.name, made.opinions.size());
                if (is_new) {
                    made.opinions.push_back({&attribute, site.times, attribute.is_connected});
                    continue;
                }
                UsdOpinion& known = made.opinions[at->second];
                known.is_connected = known.is_connected || attribute.is_connected;
                if (says(*known.said) || !says(attribute)) continue;
                known.said = &attribute;
                known.times = site.times;
            }
            if (Result<void> kept = keep(std::exchange(bytes, 0), site); !kept) return pass_on(kept);
        }
        made.opinions.shrink_to_fit();
        bytes = made.type.size() + made.opinions.size() * sizeof(UsdOpinion);
        if (Result<void> kept = keep(bytes, sites.front()); !kept) return pass_on(kept);
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
    // By the layer and the place in it.
    std::map<std::pair<std::uint32_t, std::size_t>, std::optional<std::uint32_t>> layer_by_arc_; // nothing: missing
    std::map<std::pair<std::uint32_t, std::size_t>, std::size_t> file_by_arc_;
    std::map<std::pair<int, std::string>, std::size_t> files_; // by archive and name
    std::map<std::string_view, Said> said_;                    // by code
    std::size_t composed_sites_ = 0;
    std::size_t looked_at_ = 0;
    std::size_t kept_bytes_ = 0;
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
