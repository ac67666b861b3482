#include <gonio/base/charconv.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/interchange/detail/reading.hpp>
#include <gonio/interchange/detail/usda.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <utility>

namespace gonio::interchange_detail {

namespace {

enum class Kind { end, word, number, text, asset, path, sign };

struct Token {
    Kind kind = Kind::end;
    std::string_view text; // without quotes
    double number = 0.0;
    std::size_t offset = 0;

    bool is(char sign) const { return kind == Kind::sign && text.size() == 1 && text[0] == sign; }
    bool is(std::string_view word) const { return kind == Kind::word && text == word; }
};

bool is_word_character(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == ':' ||
           c == '!' || static_cast<unsigned char>(c) >= 0x80;
}

// Names of lights before 21.02, which an override may have without the type.
bool is_old_name(std::string_view attribute) {
    constexpr std::array<std::string_view, 11> names{
        "intensity", "exposure", "color",  "normalize", "colorTemperature", "enableColorTemperature", "radius",
        "width",     "height",   "length", "angle"};
    return attribute.starts_with("shaping:") || std::find(names.begin(), names.end(), attribute) != names.end();
}

// Attributes of other prims are dropped, so that meshes take no memory.
bool holds_light(std::string_view type, std::string_view attribute) {
    constexpr std::array<std::string_view, 6> of_any{
        "visibility", "xformOp", "inputs:", "!resetXformStack!", "light:", "treatAs"};
    if (type.ends_with("Light") || type.ends_with("Light_1")) return true;
    return std::any_of(of_any.begin(), of_any.end(),
                       [&](std::string_view start) { return attribute.starts_with(start); }) ||
           attribute == "xformOpOrder" || (type.empty() && is_old_name(attribute));
}

// Types of floating numbers change on a line, all others jump (OpenUSD, "Value Resolution").
UsdBetween between_samples_of(std::string_view type) {
    if (type.starts_with("quat")) return UsdBetween::turned;
    constexpr std::array<std::string_view, 10> linear{"half",   "float",   "double", "color",    "point",
                                                      "normal", "vector3", "matrix", "texCoord", "frame4d"};
    const bool is_linear =
        std::any_of(linear.begin(), linear.end(), [&](std::string_view start) { return type.starts_with(start); });
    return is_linear ? UsdBetween::linear : UsdBetween::held;
}

class UsdaParser {
public:
    UsdaParser(std::string_view text, const std::string& source) : text_(text), places_(text, source) {}

    Result<UsdLayer> parse() {
        at_ = std::min(text_.find('\n'), text_.size()); // behind "#usda 1.0"
        if (Result<void> read = advance(); !read) return pass_on(read);
        if (token_.is('(')) {
            if (Result<void> read = layer_metadata(); !read) return pass_on(read);
        }
        while (token_.kind != Kind::end || !open_.empty())
            if (Result<void> read = statement(); !read) return pass_on(read);
        return std::move(layer_);
    }

private:
    Unexpected wrong(SceneCode code, std::size_t offset, std::string message) {
        return scene_error(code, places_.at(offset), std::move(message));
    }
    Unexpected wrong(std::string message) { return wrong("SCN0102", token_.offset, std::move(message)); }

    // Composition compares paths and keeps them often.
    static constexpr std::size_t longest_path = 4096;
    Unexpected too_long(std::size_t at) {
        return wrong("SCN0108", at, fmt::format("a path of more than {} bytes", longest_path));
    }

    void skip_blanks() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '#')
                at_ = std::min(text_.find('\n', at_), text_.size());
            else if (c == ' ' || c == '\t' || c == '\n' || c == '\r')
                ++at_;
            else if (text_.substr(at_, 2) == "/*") {
                const std::size_t end = text_.find("*/", at_ + 2);
                at_ = end == std::string_view::npos ? text_.size() : end + 2;
            } else
                return;
        }
    }

    Result<void> advance() {
        skip_blanks();
        token_ = {};
        token_.offset = at_;
        if (at_ >= text_.size()) return {};
        const char c = text_[at_];
        const auto quoted = [&](std::string_view quote, Kind kind) -> Result<void> {
            const std::size_t begin = at_ + quote.size();
            std::size_t end = begin;
            while (true) {
                end = text_.find(quote[0], end);
                if (end == std::string_view::npos) return wrong("SCN0102", at_, "a string is not closed");
                std::size_t slashes = 0;
                while (end > begin + slashes && text_[end - 1 - slashes] == '\\')
                    ++slashes;
                if (slashes % 2 == 0 && text_.substr(end, quote.size()) == quote) break;
                ++end;
            }
            token_.kind = kind;
            token_.text = text_.substr(begin, end - begin);
            at_ = end + quote.size();
            return {};
        };
        if (c == '"' || c == '\'') {
            const std::string triple(3, c);
            return text_.substr(at_, 3) == triple ? quoted(triple, Kind::text) : quoted(std::string(1, c), Kind::text);
        }
        if (c == '@') return text_.substr(at_, 3) == "@@@" ? quoted("@@@", Kind::asset) : quoted("@", Kind::asset);
        if (c == '<') {
            const std::size_t end = text_.find_first_of(">\n", at_);
            if (end == std::string_view::npos || text_[end] != '>')
                return wrong("SCN0102", at_, "a path is not closed");
            token_.kind = Kind::path;
            token_.text = text_.substr(at_ + 1, end - at_ - 1);
            at_ = end + 1;
            return {};
        }
        const bool is_digit = c >= '0' && c <= '9';
        const char next = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
        if (is_digit || ((c == '-' || c == '+' || c == '.') &&
                         ((next >= '0' && next <= '9') || next == '.' || next == 'i' || next == 'n'))) {
            std::size_t end = at_ + 1;
            while (end < text_.size() &&
                   (is_word_character(text_[end]) || text_[end] == '.' ||
                    ((text_[end] == '-' || text_[end] == '+') && (text_[end - 1] == 'e' || text_[end - 1] == 'E'))) &&
                   text_[end] != ':')
                ++end;
            token_.text = text_.substr(at_, end - at_);
            at_ = end;
            token_.kind = Kind::number;
            std::string_view digits = token_.text;
            if (digits.starts_with('+')) digits.remove_prefix(1);
            const std::optional<double> value = parse_number(digits);
            token_.number = value.value_or(NAN);
            return {};
        }
        if (is_word_character(c) && c != ':') {
            std::size_t end = at_;
            while (end < text_.size() && (is_word_character(text_[end]) || text_[end] == '.'))
                ++end;
            token_.kind = Kind::word;
            token_.text = text_.substr(at_, end - at_);
            at_ = end;
            return {};
        }
        token_.kind = Kind::sign;
        token_.text = text_.substr(at_, 1);
        ++at_;
        return {};
    }

    Result<void> expect(char sign) {
        if (!token_.is(sign)) return wrong(fmt::format("'{}' is expected", sign));
        return advance();
    }

    // A value: a number, a string, a tuple, an array, a dictionary. `keep`: nullptr, it is skipped.
    Result<void> value(UsdValue* keep) { // NOLINT(misc-no-recursion): once
        const Kind first = token_.kind;
        std::size_t depth = 0;
        if (keep != nullptr) {
            keep->is_set = true;
            keep->offset = token_.offset;
        }
        do {
            if (token_.is('(') || token_.is('[') || token_.is('{')) {
                if (++depth > limit("scene-depth").value)
                    return wrong("SCN0108", token_.offset,
                                 fmt::format("nested deeper than {}", to_text(limit("scene-depth"))));
            } else if (token_.is(')') || token_.is(']') || token_.is('}')) {
                if (depth == 0) return wrong("a value is expected");
                --depth;
            } else if (token_.kind == Kind::end) {
                return wrong("the file ends within a value");
            } else if (keep != nullptr) {
                if (token_.kind == Kind::number || token_.is("nan") || token_.is("inf")) {
                    const bool is_finite = token_.kind == Kind::number && token_.number - token_.number == 0.0;
                    if (!is_finite)
                        return wrong("SCN0105", token_.offset,
                                     fmt::format("'{}' is not a finite number", token_.text.substr(0, 40)));
                    keep->numbers.push_back(token_.number);
                } else if (token_.is("None")) {
                    keep->is_set = false;
                    keep->is_blocked = true;
                } else if (token_.is("true") || token_.is("false")) {
                    keep->numbers.push_back(token_.is("true") ? 1.0 : 0.0);
                } else if (token_.kind == Kind::text || token_.kind == Kind::asset) {
                    keep->texts.emplace_back(token_.text);
                }
            }
            if (Result<void> read = advance(); !read) return read;
        } while (depth > 0);
        // A reference may have a path behind its asset, and an offset behind that.
        const bool is_target = first == Kind::asset || first == Kind::path;
        while (is_target && token_.kind == Kind::path)
            if (Result<void> read = advance(); !read) return read;
        return is_target && token_.is('(') ? value(nullptr) : Result<void>();
    }

    Result<void> layer_metadata() {
        if (Result<void> read = advance(); !read) return read;
        while (!token_.is(')')) {
            if (token_.kind == Kind::end) return wrong("the file ends within the metadata of the layer");
            if (token_.kind == Kind::text) { // documentation
                layer_.doc = token_.text.substr(0, 200);
                if (Result<void> read = advance(); !read) return read;
                continue;
            }
            const Token name = token_;
            if (Result<void> read = advance(); !read) return read;
            if (!token_.is('=')) continue; // "prepend", ";"
            if (Result<void> read = advance(); !read) return read;
            if (name.is("subLayers")) {
                if (Result<void> read = arcs(layer_.sublayers, UsdArcKind::sublayer, UsdListEdit::is_all); !read)
                    return read;
                continue;
            }
            UsdValue said;
            const bool keep = name.is("metersPerUnit") || name.is("upAxis") || name.is("doc") || name.is("defaultPrim");
            if (Result<void> read = value(keep ? &said : nullptr); !read) return read;
            if (name.is("defaultPrim") && !said.texts.empty() && said.texts[0].size() > longest_path)
                return too_long(said.offset);
            if (name.is("defaultPrim") && !said.texts.empty()) layer_.default_prim = said.texts[0];
            if (name.is("metersPerUnit")) {
                if (said.numbers.size() != 1 || !(said.numbers[0] > 0.0) || !(said.numbers[0] < 1e30))
                    return wrong("SCN0105", name.offset, "metersPerUnit must be a number above 0");
                layer_.meters_per_unit = said.numbers[0];
                layer_.states_unit = true;
            }
            if (name.is("upAxis") && !said.texts.empty()) {
                layer_.up = said.texts[0] == "Z" ? 'z' : 'y';
                layer_.states_up = true;
            }
        }
        return advance();
    }

    // One asset or path, or a list of them, each with the offset and scale of its times.
    Result<void> arcs(std::vector<UsdArc>& into, UsdArcKind kind, UsdListEdit edit) {
        layer_.is_composed_of = true;
        const bool is_list = token_.is('[');
        UsdArc none;
        none.kind = kind;
        none.edit = edit;
        none.is_none = true;
        none.at = token_.offset;
        if (token_.is("None") || is_list) {
            if (Result<void> read = advance(); !read) return read;
            if (edit == UsdListEdit::is_all) into.push_back(none);
            if (!is_list) return {};
        }
        while (!token_.is(']')) {
            UsdArc arc;
            arc.kind = kind;
            arc.edit = edit;
            arc.at = token_.offset;
            if (token_.kind != Kind::asset && token_.kind != Kind::path) return wrong("an asset or a path is expected");
            if (token_.text.size() > longest_path) return too_long(token_.offset);
            if (token_.kind == Kind::asset) {
                arc.asset = token_.text;
                if (Result<void> read = advance(); !read) return read;
            }
            if (token_.kind == Kind::path) {
                if (token_.text.size() > longest_path) return too_long(token_.offset);
                arc.path = token_.text;
                if (Result<void> read = advance(); !read) return read;
            }
            if (token_.is('('))
                if (Result<void> read = times(arc); !read) return read;
            into.push_back(std::move(arc));
            if (!is_list) return {};
            if (token_.is(','))
                if (Result<void> read = advance(); !read) return read;
        }
        return advance();
    }

    // ( offset = 10; scale = 0.5 ), and metadata of the arc, which is skipped.
    Result<void> times(UsdArc& arc) {
        if (Result<void> read = advance(); !read) return read;
        while (!token_.is(')')) {
            if (token_.kind == Kind::end) return wrong("the file ends within the offset of a layer");
            const Token name = token_;
            if (Result<void> read = advance(); !read) return read;
            if (!token_.is('=')) continue;
            if (Result<void> read = advance(); !read) return read;
            UsdValue said;
            const bool keep = name.is("offset") || name.is("scale");
            if (Result<void> read = value(keep ? &said : nullptr); !read) return read;
            if (!keep) continue;
            if (said.numbers.size() != 1 || !(std::abs(said.numbers[0]) <= 1e100))
                return wrong("SCN0105", name.offset, "the offset or scale of a layer must be a number");
            (name.is("offset") ? arc.times.offset : arc.times.scale) = said.numbers[0];
        }
        return advance();
    }

    // { string set = "variant" }
    Result<void> selections(UsdComposition& of) {
        if (!token_.is('{')) return value(nullptr);
        if (Result<void> read = advance(); !read) return read;
        std::string_view name;
        while (!token_.is('}')) {
            if (token_.kind == Kind::end) return wrong("the file ends within the variants of a prim");
            if (token_.is('=')) {
                if (Result<void> read = advance(); !read) return read;
                if (token_.kind != Kind::text) return wrong("the name of a variant is expected");
                of.selected.emplace_back(name, token_.text);
            } else {
                name = token_.text;
            }
            if (Result<void> read = advance(); !read) return read;
        }
        return advance();
    }

    Result<void> prim_metadata(UsdPrim& prim, UsdComposition& composition) {
        if (Result<void> read = advance(); !read) return read;
        UsdListEdit edit = UsdListEdit::is_all;
        while (!token_.is(')')) {
            if (token_.kind == Kind::end) return wrong("the file ends within the metadata of a prim");
            const Token name = token_;
            if (Result<void> read = advance(); !read) return read;
            if (!token_.is('=')) {
                edit = name.is("delete") || name.is("reorder") ? UsdListEdit::removes
                       : name.is("prepend")                    ? UsdListEdit::prepends
                       : name.is("append")                     ? UsdListEdit::appends
                       : name.is("add")                        ? UsdListEdit::adds
                                                               : UsdListEdit::is_all;
                if (name.is("reorder")) reorders_ = true;
                continue;
            }
            if (Result<void> read = advance(); !read) return read;
            const bool reorders = std::exchange(reorders_, false);
            const UsdListEdit how = std::exchange(edit, UsdListEdit::is_all);
            constexpr std::array kinds{
                std::pair{std::string_view("references"), UsdArcKind::reference},
                std::pair{std::string_view("payload"), UsdArcKind::payload},
                std::pair{std::string_view("inherits"), UsdArcKind::inherit},
                std::pair{std::string_view("specializes"), UsdArcKind::specialize},
            };
            const auto* const arc =
                std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return name.is(one.first); });
            if (arc != kinds.end() && !reorders) {
                if (Result<void> read = arcs(composition.arcs, arc->second, how); !read) return read;
                continue;
            }
            if (name.is("variants")) {
                if (Result<void> read = selections(composition); !read) return read;
                continue;
            }
            UsdValue said;
            const bool keep = (name.is("apiSchemas") && !reorders) || name.is("active");
            if (Result<void> read = value(keep ? &said : nullptr); !read) return read;
            if (name.is("apiSchemas")) {
                auto& into = how == UsdListEdit::removes ? composition.removed_schemas : prim.schemas;
                into.insert(into.end(), said.texts.begin(), said.texts.end());
            }
            if (name.is("active")) prim.active = said.numbers.empty() || said.numbers[0] != 0.0;
        }
        return advance();
    }

    // A prim, a variant set, or an attribute of the innermost prim.
    Result<void> statement() {
        if (token_.is('}')) {
            if (open_.empty()) return wrong("'}' without a beginning");
            open_.pop_back();
            return advance();
        }
        if (token_.is(';')) return advance();
        if (token_.kind == Kind::end) return wrong("the file ends within a prim");
        if (token_.is("def") || token_.is("over") || token_.is("class")) return prim();
        if (token_.is("variantSet")) return variants();
        if (open_.empty()) return wrong("a prim is expected");
        if (in_variants()) { // a variant by its name
            if (token_.kind != Kind::text) return wrong("a variant is expected");
            UsdPrim made;
            made.offset = token_.offset;
            made.specifier = UsdSpecifier::over;
            made.name = token_.text;
            made.is_variant = true;
            UsdComposition composition;
            composition.variant_set = open_.back().variant_set;
            return open_prim(std::move(made), std::move(composition));
        }
        if (token_.is("reorder")) {
            if (Result<void> read = advance(); !read) return read;
            if (Result<void> read = advance(); !read) return read;
            if (Result<void> read = expect('='); !read) return read;
            return value(nullptr);
        }
        return attribute();
    }

    static constexpr std::uint32_t no_parent = 0xffffffff;

    // A prim or a variant, or a set of variants of one.
    struct Block {
        std::uint32_t prim = no_parent;
        std::string_view variant_set; // empty: the prim itself
    };

    bool in_variants() const { return !open_.empty() && !open_.back().variant_set.empty(); }

    Result<void> open_block(Block block) {
        if (open_.size() >= limit("scene-depth").value)
            return wrong("SCN0108", token_.offset, fmt::format("nested deeper than {}", to_text(limit("scene-depth"))));
        open_.push_back(block);
        return expect('{');
    }

    Result<void> variants() {
        if (open_.empty()) return wrong("a prim is expected");
        layer_.is_composed_of = true;
        if (Result<void> read = advance(); !read) return read; // the name
        if (token_.kind != Kind::text || token_.text.empty()) return wrong("the name of a variant set is expected");
        const Block block{open_.back().prim, token_.text};
        if (Result<void> read = advance(); !read) return read;
        if (Result<void> read = expect('='); !read) return read;
        return open_block(block);
    }

    Result<void> prim() {
        UsdPrim made;
        made.offset = token_.offset;
        made.specifier = token_.is("def")    ? UsdSpecifier::def
                         : token_.is("over") ? UsdSpecifier::over
                                             : UsdSpecifier::is_class;
        if (Result<void> read = advance(); !read) return read;
        if (token_.kind == Kind::word) {
            made.type = token_.text;
            if (Result<void> read = advance(); !read) return read;
        }
        if (token_.kind != Kind::text) return wrong("the name of a prim is expected");
        made.name = token_.text;
        return open_prim(std::move(made), {});
    }

    // Behind its name.
    Result<void> open_prim(UsdPrim made, UsdComposition composition) {
        if (Result<void> read = advance(); !read) return read;
        if (token_.is('('))
            if (Result<void> read = prim_metadata(made, composition); !read) return read;
        if (!open_.empty()) made.parent = open_.back().prim;
        if (layer_.prims.size() >= limit("scene-nodes").value)
            return wrong("SCN0108", made.offset, fmt::format("more than {}", to_text(limit("scene-nodes"))));
        const auto index = static_cast<std::uint32_t>(layer_.prims.size());
        if (made.is_variant || !composition.arcs.empty() || !composition.selected.empty() ||
            !composition.removed_schemas.empty())
            layer_.compositions.emplace(index, std::move(composition));
        layer_.prims.push_back(std::move(made));
        return open_block({index, {}});
    }

    // Of a prim, or of the prim that a variant is of.
    std::string_view type_of(std::uint32_t at) const {
        while (layer_.prims[at].is_variant)
            at = layer_.prims[at].parent;
        return layer_.prims[at].type;
    }

    Result<void> attribute() {
        // custom uniform color3f[] name.suffix = value ( metadata )
        std::string_view name;
        std::string_view type;
        std::size_t words = 0;
        bool is_relation = false;
        while (token_.kind == Kind::word || token_.is('[') || token_.is(']')) {
            if (token_.is("rel")) is_relation = true;
            if (token_.kind == Kind::word) {
                type = name;
                name = token_.text;
                ++words;
            }
            if (Result<void> read = advance(); !read) return read;
        }
        if (words < 2 && !is_relation) return wrong("an attribute is expected");
        std::string_view suffix;
        if (const std::size_t dot = name.find('.'); dot != std::string_view::npos) {
            suffix = name.substr(dot);
            name = name.substr(0, dot);
        }
        UsdPrim* const prim = &layer_.prims[open_.back().prim];
        UsdAttribute* into = nullptr;
        if (!is_relation && holds_light(type_of(open_.back().prim), name)) {
            const auto known = std::find_if(prim->attributes.begin(), prim->attributes.end(),
                                            [&](const UsdAttribute& one) { return one.name == name; });
            if (known == prim->attributes.end()) {
                constexpr std::size_t most = 1024;
                if (prim->attributes.size() == most)
                    return wrong("SCN0108", token_.offset, fmt::format("more than {} attributes of a prim", most));
                prim->attributes.emplace_back();
                prim->attributes.back().name = name;
                prim->attributes.back().between = between_samples_of(type);
                into = &prim->attributes.back();
            } else {
                into = &*known;
            }
        }
        if (token_.is('=')) {
            if (Result<void> read = advance(); !read) return read;
            if (suffix == ".timeSamples") {
                if (Result<void> read = samples(into); !read) return read;
            } else if (suffix == ".connect") {
                if (into != nullptr) into->is_connected = true;
                if (Result<void> read = target(); !read) return read;
            } else if (is_relation || token_.kind == Kind::path) {
                if (Result<void> read = target(); !read) return read;
            } else if (Result<void> read = value(into != nullptr ? &into->value : nullptr); !read) {
                return read;
            }
        }
        if (token_.is('(')) return value(nullptr); // metadata
        return {};
    }

    Result<void> target() {
        if (token_.kind == Kind::path) return advance();
        return value(nullptr);
    }

    Result<void> samples(UsdAttribute* into) {
        if (Result<void> read = expect('{'); !read) return read;
        std::vector<UsdSample> all;
        while (!token_.is('}')) {
            if (token_.kind != Kind::number) return wrong("a time is expected");
            if (!std::isfinite(token_.number))
                return wrong("SCN0105", token_.offset,
                             fmt::format("the time '{}' is not a finite number", token_.text.substr(0, 40)));
            UsdSample sample;
            sample.time = token_.number;
            if (Result<void> read = advance(); !read) return read;
            if (Result<void> read = expect(':'); !read) return read;
            if (Result<void> read = value(into != nullptr ? &sample.value : nullptr); !read) return read;
            if (into != nullptr) all.push_back(std::move(sample));
            if (token_.is(','))
                if (Result<void> read = advance(); !read) return read;
        }
        if (into != nullptr) {
            std::stable_sort(all.begin(), all.end(),
                             [](const UsdSample& a, const UsdSample& b) { return a.time < b.time; });
            all.erase(std::unique(all.begin(), all.end(),
                                  [](const UsdSample& a, const UsdSample& b) { return a.time == b.time; }),
                      all.end());
            into->samples = std::move(all);
        }
        return advance();
    }

    std::string_view text_;
    LinePlaces places_;
    std::size_t at_ = 0;
    Token token_;
    UsdLayer layer_;
    std::vector<Block> open_;
    bool reorders_ = false; // the list that follows
};

} // namespace

std::optional<UsdOpinion> UsdPrim::find(std::string_view wanted) const {
    for (const UsdAttribute& attribute : attributes)
        if (attribute.name == wanted) return UsdOpinion{&attribute, {}, attribute.is_connected};
    for (const UsdOpinion& opinion : opinions)
        if (opinion.said->name == wanted) return opinion;
    return std::nullopt;
}

Result<UsdLayer> parse_usda(std::string_view text, const std::string& source) {
    return UsdaParser(text, source).parse();
}

} // namespace gonio::interchange_detail
