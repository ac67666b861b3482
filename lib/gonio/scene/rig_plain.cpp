#include <gonio/base/charconv.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/spectrum.hpp>
#include <gonio/light/light_color.hpp>
#include <gonio/scene/detail/rig_plain.hpp>
#include <gonio/scene/detail/rig_values.hpp>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace gonio::detail {

namespace {

constexpr std::string_view json_blanks = " \t\r\n";

// A place in the text. Where a function returns false or nothing, the text is not plain there.
class Cursor {
public:
    Cursor(std::string_view text, std::size_t at)
        : begin_(text.data()), at_(text.data() + at), end_(text.data() + text.size()) {}

    std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
    std::string_view since(std::size_t offset) const { return {begin_ + offset, this->offset() - offset}; }
    bool is_at(char c) const { return at_ < end_ && *at_ == c; }

    bool take(char c) {
        if (!is_at(c)) return false;
        ++at_;
        return true;
    }

    // Blanks and comments, as the reader of values skips them.
    bool skip_blanks() {
        while (at_ < end_) {
            if (*at_ == ' ' || *at_ == '\n' || *at_ == '\t' || *at_ == '\r')
                ++at_;
            else if (*at_ != '/')
                return true;
            else if (!skip_comment())
                return false;
        }
        return true;
    }

    // What stands between quotes: printable ASCII without escapes.
    std::optional<std::string_view> text() {
        if (!take('"')) return std::nullopt;
        const char* const first = at_;
        while (at_ < end_ && *at_ != '"') {
            if (*at_ < ' ' || *at_ > '~' || *at_ == '\\') return std::nullopt;
            ++at_;
        }
        if (at_ == end_) return std::nullopt;
        return std::string_view(first, static_cast<std::size_t>(at_++ - first));
    }

    std::optional<double> number() {
        const char* const first = at_;
        bool is_whole = true;
        if (is_at('-')) ++at_;
        if (!(is_at('0') ? take('0') : skip_digits())) return std::nullopt;
        if (take('.')) {
            is_whole = false;
            if (!skip_digits()) return std::nullopt;
        }
        if (is_at('e') || is_at('E')) {
            is_whole = false;
            ++at_;
            if (is_at('+') || is_at('-')) ++at_;
            if (!skip_digits()) return std::nullopt;
        }
        double value = 0.0;
        const auto [stop, error] = from_chars(first, at_, value);
        if (error != std::errc() || stop != at_) return std::nullopt;
        return is_whole && value == 0.0 ? 0.0 : value; // a whole number has no negative zero
    }

    // Three numbers in brackets.
    std::optional<glm::dvec3> vector() {
        if (!take('[')) return std::nullopt;
        glm::dvec3 vector(0.0);
        for (int i = 0; i < 3; ++i) {
            if (!skip_blanks() || (i > 0 && !(take(',') && skip_blanks()))) return std::nullopt;
            const std::optional<double> value = number();
            if (!value) return std::nullopt;
            vector[i] = *value;
        }
        if (!skip_blanks() || !take(']')) return std::nullopt;
        return vector;
    }

    // An object or an array with everything in it, whatever that is.
    bool skip_nested() {
        std::size_t depth = 0;
        do {
            if (!skip_blanks() || at_ == end_) return false;
            const char c = *at_++;
            if (c == '"' && !skip_string()) return false;
            if (c == '{' || c == '[') ++depth;
            if (c == '}' || c == ']') --depth;
        } while (depth > 0);
        return true;
    }

private:
    bool skip_digits() {
        const char* const first = at_;
        while (at_ < end_ && *at_ >= '0' && *at_ <= '9')
            ++at_;
        return at_ != first;
    }

    bool skip_comment() {
        const std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
        if (rest.starts_with("//")) {
            const std::size_t line_end = std::min(rest.find_first_of("\r\n"), rest.size());
            at_ += line_end;
            return !has_null(rest.substr(0, line_end));
        }
        const std::size_t close = rest.starts_with("/*") ? rest.find("*/", 2) : std::string_view::npos;
        if (close == std::string_view::npos) return false;
        at_ += close + 2;
        return !has_null(rest.substr(0, close));
    }

    // A null character ends a comment for the reader of values.
    static bool has_null(std::string_view comment) { return comment.find('\0') != std::string_view::npos; }

    // After its opening quote.
    bool skip_string() {
        for (; at_ < end_; ++at_) {
            if (*at_ == '\\') {
                if (++at_ == end_) return false;
            } else if (*at_ == '"') {
                ++at_;
                return true;
            }
        }
        return false;
    }

    const char* begin_;
    const char* at_;
    const char* end_;
};

// As written.
struct Values {
    std::optional<std::string_view> name, shape, luminaire, intensity, color, rotate, range;
    std::optional<glm::dvec3> position, direction, target, up;
    std::optional<double> dimming, maintenance;
};

struct TextKey {
    std::string_view name;
    std::optional<std::string_view> Values::*value;
};
struct VectorKey {
    std::string_view name;
    std::optional<glm::dvec3> Values::*value;
};
struct NumberKey {
    std::string_view name;
    std::optional<double> Values::*value;
};
constexpr std::array text_keys{TextKey{"shape", &Values::shape},         TextKey{"intensity", &Values::intensity},
                               TextKey{"name", &Values::name},           TextKey{"color", &Values::color},
                               TextKey{"luminaire", &Values::luminaire}, TextKey{"rotate", &Values::rotate},
                               TextKey{"range", &Values::range}};
constexpr std::array vector_keys{VectorKey{"position", &Values::position}, VectorKey{"direction", &Values::direction},
                                 VectorKey{"target", &Values::target}, VectorKey{"up", &Values::up}};
constexpr std::array number_keys{NumberKey{"dimming", &Values::dimming},
                                 NumberKey{"maintenance", &Values::maintenance}};

// Whether a key of this kind is there, and is read; nothing if it is of another kind.
template<class Keys, class Read>
std::optional<bool> read_one(const Keys& keys, std::string_view name, Values& values, const Read& read) {
    for (const auto& key : keys) {
        if (key.name != name) continue;
        auto& value = values.*key.value;
        if (value) return false;
        value = read();
        return value.has_value();
    }
    return std::nullopt;
}

bool read_value(Cursor& at, std::string_view name, Values& values) {
    if (const auto read = read_one(text_keys, name, values, [&] { return at.text(); })) return *read;
    if (const auto read = read_one(vector_keys, name, values, [&] { return at.vector(); })) return *read;
    return read_one(number_keys, name, values, [&] { return at.number(); }).value_or(false);
}

std::optional<Values> read_values(Cursor& at) {
    Values values;
    if (!at.take('{') || !at.skip_blanks()) return std::nullopt;
    do {
        if (!at.skip_blanks()) return std::nullopt;
        const std::optional<std::string_view> name = at.text();
        if (!name || !at.skip_blanks() || !at.take(':') || !at.skip_blanks()) return std::nullopt;
        if (!read_value(at, *name, values) || !at.skip_blanks()) return std::nullopt;
    } while (at.take(','));
    if (!at.take('}')) return std::nullopt;
    return values;
}

bool is_near(const std::optional<glm::dvec3>& position) {
    return !position || glm::all(glm::lessThanEqual(glm::abs(*position), glm::dvec3(farthest_m)));
}

bool is_zero(const std::optional<glm::dvec3>& vector) {
    return vector && *vector == glm::dvec3(0.0);
}

bool names_spectrum(std::string_view text) {
    return text.find(spectrum_prefix) != std::string_view::npos;
}

class Reader {
public:
    Reader(const KnownTexts& known, PlainPiece& piece) : known_(known), piece_(piece) {}

    // Whether the element that begins there is plain; the cursor is behind it.
    bool read(Cursor& at, PlainLight& target) {
        const std::optional<Values> values = read_values(at);
        if (!values) return false;
        const bool is_sound = values->shape.has_value() != values->luminaire.has_value() && is_near(values->position) &&
                              is_near(values->target) && !(values->direction && values->target) &&
                              !is_zero(values->direction) && !is_zero(values->up);
        return is_sound && describe(*values, target) && place(*values, target);
    }

private:
    // The keys that do not place the light.
    bool describe(const Values& values, PlainLight& target) {
        LightDescription& light = target.light;
        if (values.luminaire) {
            const auto described = known_.luminaires.find(*values.luminaire);
            if (described == known_.luminaires.end()) return false;
            light = described->second;
            target.luminaire = &known_.written_luminaires->find(*values.luminaire)->second;
        } else if (!set_shape(*values.shape, light.shape)) {
            return false;
        }
        if (values.intensity) {
            if (names_spectrum(*values.intensity)) return false;
            Result<PhotometricValue> intensity = parse_photometric_value(*values.intensity);
            if (!intensity) return false;
            light.intensity = std::move(*intensity);
        }
        if (values.color && !set_color(*values.color, light.color)) return false;
        if (values.rotate) {
            const Result<double> turn = parse_amount(*values.rotate, Dimension::angle, "it");
            if (!turn) return false;
            light.rotation = Radians(*turn);
        }
        if (values.range) {
            const Result<double> range = parse_amount(*values.range, Dimension::length, "it");
            if (!range || !(*range > 0.0)) return false;
            light.range = Meters(*range);
        }
        return true;
    }

    // As rig_expand places a light that is in no group.
    static bool place(const Values& values, PlainLight& target) {
        LightDescription& light = target.light;
        const glm::dvec3 written = values.position.value_or(glm::dvec3(0.0));
        if (values.target && *values.target == written) return false;
        const auto in_rig = [](const glm::dvec3& position) { return glm::dvec3(0.0) + position; };
        light.position = in_rig(written);
        if (values.target)
            light.direction = in_rig(*values.target) - light.position;
        else if (values.direction)
            light.direction = *values.direction;
        if (values.up) light.up = *values.up;
        const double dimming = values.dimming.value_or(1.0);
        const double maintenance = values.maintenance.value_or(1.0);
        if (!(dimming >= 0.0 && dimming <= 1.0 && maintenance > 0.0 && maintenance <= 1.0)) return false;
        const Luminaire* const luminaire = target.luminaire;
        light.level = dimming * (luminaire != nullptr ? luminaire->dimming : 1.0) *
                      (maintenance * (luminaire != nullptr ? luminaire->maintenance : 1.0));
        target.is_named = values.name.has_value();
        if (values.name) light.name = *values.name;
        return true;
    }

    // What a text means, if an earlier one of the rig or of the piece was the same.
    template<class Value>
    static bool is_known(const std::map<std::string, Value, std::less<>>& of_rig,
                         const std::map<std::string_view, Value>& of_piece, std::string_view text, Value& target) {
        const auto take = [&](const auto& texts) {
            const auto known = texts.find(text);
            if (known != texts.end()) target = known->second;
            return known != texts.end();
        };
        return take(of_rig) || take(of_piece);
    }

    bool set_color(std::string_view text, glm::dvec3& target) {
        if (is_known(known_.colors, piece_.colors, text, target)) return true;
        if (names_spectrum(text)) return false;
        Diagnostics said;
        const Result<glm::dvec3> color = parse_light_color(text, &said);
        if (!color || !said.empty()) return false;
        target = *color;
        piece_.colors.emplace(text, target);
        return true;
    }

    bool set_shape(std::string_view text, Shape& target) {
        if (is_known(known_.shapes, piece_.shapes, text, target)) return true;
        Result<Shape> shape = parse_shape(text);
        if (!shape) return false;
        if (const std::string* const file = file_of(*shape); file != nullptr && !file->empty()) return false;
        target = *shape;
        piece_.shapes.emplace(text, std::move(*shape));
        return true;
    }

    const KnownTexts& known_;
    PlainPiece& piece_;
};

} // namespace

std::optional<std::size_t> first_element(std::string_view rig, std::size_t bracket) {
    Cursor at(rig, bracket);
    if (!at.take('[') || !at.skip_blanks() || !at.is_at('{')) return std::nullopt;
    return at.offset();
}

std::size_t likely_element(std::string_view rig, std::size_t from, std::size_t end) {
    end = std::min(end, rig.size());
    constexpr std::size_t usual_gap = 64; // the element before may have ended in front of `from`
    for (std::size_t at = from - std::min(from, usual_gap); at < end; ++at) {
        if (rig[at] != '}') continue;
        // Without comments: looking for the end of each would take too long where there are many that have none.
        const std::size_t comma = std::min(rig.find_first_not_of(json_blanks, at + 1), rig.size());
        if (comma == rig.size() || rig[comma] != ',') continue;
        const std::size_t next = std::min(rig.find_first_not_of(json_blanks, comma + 1), rig.size());
        if (next < rig.size() && rig[next] == '{' && next >= from) return std::min(next, end);
    }
    return end;
}

PlainPiece read_plain(std::string_view rig, std::size_t begin, std::size_t end, const KnownTexts& known) {
    PlainPiece piece;
    piece.begin = begin;
    Reader reader(known, piece);
    Cursor at(rig, begin);
    while (at.offset() < end) {
        const std::size_t element = at.offset();
        PlainLight& light = piece.lights.emplace_back();
        if (!reader.read(at, light)) {
            at = Cursor(rig, element);
            piece.is_broken = !at.is_at('{') || !at.skip_nested();
            if (piece.is_broken) return piece;
            piece.lights.pop_back();
            piece.others.push_back({piece.lights.size(), at.since(element)});
        }
        piece.is_broken = !at.skip_blanks();
        piece.is_closed = at.is_at(']');
        if (piece.is_broken || piece.is_closed) break;
        piece.is_broken = !at.take(',') || !at.skip_blanks() || !at.is_at('{');
        if (piece.is_broken) break;
    }
    piece.end = at.offset();
    return piece;
}

} // namespace gonio::detail
