// Composition of USD: which layers say something about a prim, from the strongest to the weakest. A prim's opinions are
// in the order of OpenUSD, "LIVERPS": of its own layers, then of what it inherits, of its variants, of references,
// payloads, and of what it specializes. Arcs of a child are stronger than those that its parent brought.
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/interchange/detail/usda_layers.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <map>
#include <set>
#include <utility>

namespace gonio::interchange_detail {

namespace {

constexpr std::uint32_t no_prim = 0xffffffff;
constexpr std::size_t no_file = std::string::npos;

// A prim or a variant in a layer; `prim` is no_prim for the layer's root.
struct Site {
    std::uint32_t stack = 0;
    std::uint32_t layer = 0;
    std::uint32_t prim = no_prim;
    UsdTimes times;
};

class Composer {
public:
    Composer(UsdStage& stage, const SceneReadOptions& options) : stage_(stage), layers_(stage, options) {}

    Result<void> compose(std::string_view bytes, const std::string& source) {
        Result<std::uint32_t> root = layers_.open_root(bytes, source);
        if (!root) return pass_on(root);
        UsdLayer& layer = layers_[*root].layer;
        if (!layer.is_composed_of) {
            stage_.layer = std::move(layer);
            return {};
        }
        std::vector<UsdPrim> prims = std::exchange(layer.prims, {});
        stage_.layer = layer; // the metadata
        stage_.layer.compositions.clear();
        layer.prims = std::move(prims);
        Result<std::uint32_t> stack = layers_.stack_of(*root);
        if (!stack) return pass_on(stack);
        if (Result<void> flat = flatten(*stack); !flat) return flat;
        layers_.close(); // what opinions point to stays where it is
        return {};
    }

private:
    // Counts what is looked at. A short file may name the same long lists again and again.
    Result<void> look(std::size_t count, const Site& from) {
        constexpr std::size_t most = 64000000;
        looked_at_ += count;
        if (looked_at_ <= most) return {};
        return scene_error("SCN0108", place_of(from), fmt::format("more than {} steps of composition", most));
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
        for (const LayerOfStack& one : layers_.stack(stack))
            sites.push_back({stack, one.layer, no_prim, one.times});
        return sites;
    }

    void add_children_named(const std::vector<Site>& parents, std::string_view name, std::vector<Site>& sites) const {
        for (const Site& parent : parents) {
            const IndexedLayer& layer = layers_[parent.layer];
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
            for (const IndexedLayer::Variants& of : variants->second) {
                const auto [choice, is_new] = selected.try_emplace(of.set);
                if (is_new) {
                    Result<const std::string*> found = selection(of.set, sites, base);
                    if (!found) return pass_on(found);
                    choice->second = {*found, chosen.size()};
                    chosen.emplace_back();
                    if (*found == nullptr)
                        layers_.warn(
                            "SCN0201", site.layer, prim_at({site.stack, site.layer, first_of(of), {}}).offset,
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
    static std::uint32_t first_of(const IndexedLayer::Variants& set) {
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
                return Key(arc.asset.empty() ? no_file : layers_.file_of(site.layer, arc), arc.path);
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
            Result<std::optional<std::uint32_t>> layer = layers_.layer_of(site.layer, arc);
            if (!layer) return pass_on(layer);
            if (!*layer) return {};
            Result<std::uint32_t> found = layers_.stack_of(**layer);
            if (!found) return pass_on(found);
            stack = *found;
        }
        if (path.empty()) {
            path = layers_[layers_.stack(stack).front().layer].layer.default_prim;
            if (path.empty()) {
                layers_.warn("SCN0107", site.layer, arc.at,
                             fmt::format("the layer '{}' has no defaultPrim: the reference to it is left out",
                                         shown_text(arc.asset)));
                return {};
            }
            if (!path.starts_with('/')) path.insert(0, "/");
        }
        if (!path.starts_with('/') || path.size() < 2 || path.find_first_of(".{") != std::string::npos) {
            layers_.warn(
                "SCN0107", site.layer, arc.at,
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
            layers_.warn("SCN0107", site.layer, arc.at,
                         fmt::format("there is no prim '{}' to refer to", shown_text(path)));
        const UsdTimes times = nested(site.times, arc.times);
        if (!is_finite(times)) return layers_.beyond_numbers(site.layer, arc);
        for (Site& one : *target) {
            one.times = nested(times, one.times);
            if (!is_finite(one.times)) return layers_.beyond_numbers(site.layer, arc);
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
            const IndexedLayer& layer = layers_[site.layer];
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
    UsdLayers layers_;
    std::map<std::pair<std::uint32_t, std::string>, std::vector<Site>> sites_by_path_;
    std::vector<std::pair<std::uint32_t, std::string>> active_;
    std::size_t composed_sites_ = 0;
    std::size_t looked_at_ = 0;
    std::size_t kept_bytes_ = 0;
};

} // namespace

Result<UsdStage> compose_usd(std::string_view bytes, const std::string& source, const SceneReadOptions& options) {
    UsdStage stage;
    if (Result<void> composed = Composer(stage, options).compose(bytes, source); !composed) return pass_on(composed);
    return stage;
}

} // namespace gonio::interchange_detail
