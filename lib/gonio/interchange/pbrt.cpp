// pbrt-v4. Every scale is divided by the luminance of its spectrum, so that numbers are photometric: points and spots
// in candela, distant lights in lux, areas in nits, `power` in lumens. Of an RGB only the illuminant is divided out, so
// that the amount is multiplied by the colour's luminance. Spots fall as smoothstep over the cosine, along +Z or from
// `from` to `to`. pbrt states neither a unit of length nor an upward axis.
#include <gonio/base/charconv.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/interchange/detail/reading.hpp>
#include <gonio/light/light_color.hpp>

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <numbers>
#include <optional>

namespace gonio::interchange_detail {

namespace {

using std::numbers::pi;

enum class Word { end, directive, text, number, open, close };

struct Token {
    Word word = Word::end;
    std::string_view text; // of a string without its quotes
    double number = 0.0;
    std::size_t offset = 0;
};

// A file of the scene that is being read.
struct OpenFile {
    std::string name;
    std::string held; // of an included file
    std::string_view text;
    std::size_t at = 0;
};

struct Parameter {
    std::string type, name;
    std::vector<double> numbers;
    std::vector<std::string> texts;
};
using Parameters = std::vector<Parameter>;

const Parameter* find(const Parameters& parameters, std::string_view name) {
    for (const Parameter& one : parameters)
        if (one.name == name) return &one;
    return nullptr;
}

double number(const Parameters& parameters, std::string_view name, double otherwise) {
    const Parameter* const found = find(parameters, name);
    return found != nullptr && !found->numbers.empty() ? found->numbers.front() : otherwise;
}

glm::dvec3 point(const Parameters& parameters, std::string_view name, const glm::dvec3& otherwise) {
    const Parameter* const found = find(parameters, name);
    if (found == nullptr || found->numbers.size() != 3) return otherwise;
    return {found->numbers[0], found->numbers[1], found->numbers[2]};
}

struct State {
    glm::dmat4 world{1.0};
    bool is_reversed = false;
    std::shared_ptr<const Parameters> area; // of AreaLightSource; shared because states are copied
    std::string area_kind;
    std::string name; // the comment behind AttributeBegin
    const RgbSpace* space = nullptr;
};

class PbrtReader {
public:
    PbrtReader(std::string_view text, const std::string& source, const SceneReadOptions& options)
        : options_(options), file_name_(source), places_(text, source) {
        files_.push_back({source, {}, text, 0});
        state_.space = find_rgb_space("rec709");
    }

    Result<FoundScene> read() {
        scene_.meters_per_unit = options_.unit.value_or(Meters(1.0)).value;
        up_ = options_.up.value_or('z');
        while (!files_.empty()) {
            Result<Token> token = next();
            if (!token) return pass_on(token);
            if (token->word == Word::end) {
                files_.pop_back();
                continue;
            }
            if (token->word != Word::directive)
                return wrong("SCN0102", token->offset, "a directive is expected here, such as LightSource");
            if (Result<void> done = take(*token); !done) return pass_on(done);
            if (scene_.lights.size() > limit("scene-lights").value)
                return wrong("SCN0108", token->offset, fmt::format("more than {}", to_text(limit("scene-lights"))));
        }
        join_capsules(scene_.lights);
        if (!scene_.lights.empty() && (!options_.unit || !options_.up)) {
            warn(scene_, "SCN0201", {file_name_, 0, 0},
                 "pbrt states neither a unit of length nor an upward axis: "
                 "metres and Z up are assumed where no option says it",
                 "--unit-scale and --up say what they are");
        }
        return std::move(scene_);
    }

private:
    OpenFile& file() { return files_.back(); }

    Location place(std::size_t offset) {
        if (files_.size() == 1) return places_.at(offset);
        LinePlaces places(file().text, file().name);
        return places.at(offset);
    }

    Unexpected wrong(SceneCode code, std::size_t offset, std::string message) {
        return scene_error(code, place(offset), std::move(message));
    }

    void skip_blanks(bool note_comment) {
        std::string_view text = file().text;
        std::size_t& at = file().at;
        while (at < text.size()) {
            const char c = text[at];
            if (c == '#') {
                const std::size_t end = std::min(text.find('\n', at), text.size());
                if (note_comment && comment_.empty()) comment_ = trimmed(text.substr(at + 1, end - at - 1));
                at = end;
            } else if (c == ' ' || c == '\t' || c == '\n' || c == '\r') {
                ++at;
            } else {
                return;
            }
        }
    }

    // A directive is any word that is neither a number nor true or false.
    Result<Token> next() {
        skip_blanks(false);
        const std::string_view text = file().text;
        std::size_t& at = file().at;
        Token token;
        token.offset = at;
        if (at >= text.size()) return token;
        const char c = text[at];
        if (c == '[' || c == ']') {
            token.word = c == '[' ? Word::open : Word::close;
            ++at;
            return token;
        }
        if (c == '"') {
            std::size_t end = at + 1;
            while (end < text.size() && text[end] != '"' && text[end] != '\n')
                end += text[end] == '\\' ? std::size_t{2} : std::size_t{1};
            if (end >= text.size() || text[end] != '"') return wrong("SCN0102", at, "a string is not closed");
            token.word = Word::text;
            token.text = text.substr(at + 1, end - at - 1);
            at = end + 1;
            return token;
        }
        std::size_t end = at;
        while (end < text.size() && std::string_view(" \t\r\n[]\"#").find(text[end]) == std::string_view::npos)
            ++end;
        token.text = text.substr(at, end - at);
        at = end;
        const bool is_like_number = (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.';
        if (is_like_number || token.text == "nan" || token.text == "inf") {
            std::string_view digits = token.text;
            if (digits.starts_with('+')) digits.remove_prefix(1);
            const std::optional<double> value = parse_number(digits);
            if (!value)
                return wrong("SCN0105", token.offset, fmt::format("'{}' is not a finite number", digits.substr(0, 40)));
            token.word = Word::number;
            token.number = *value;
        } else if (token.text == "true" || token.text == "false") {
            token.word = Word::number;
            token.number = token.text == "true" ? 1.0 : 0.0;
        } else {
            token.word = Word::directive;
        }
        return token;
    }

    Result<Token> peek() {
        const std::size_t before = file().at;
        Result<Token> token = next();
        file().at = before;
        return token;
    }

    Result<std::string> text_argument(const Token& directive) {
        Result<Token> token = next();
        if (!token) return pass_on(token);
        if (token->word != Word::text)
            return wrong("SCN0102", token->offset, fmt::format("{} needs a string", directive.text));
        return std::string(token->text);
    }

    // Numbers of a transformation, in brackets or not.
    Result<std::vector<double>> number_arguments(const Token& directive, std::size_t count) {
        std::vector<double> numbers;
        while (numbers.size() < count) {
            Result<Token> token = next();
            if (!token) return pass_on(token);
            if (token->word == Word::open && numbers.empty()) continue;
            if (token->word != Word::number)
                return wrong("SCN0102", token->offset, fmt::format("{} needs {} numbers", directive.text, count));
            numbers.push_back(token->number);
        }
        Result<Token> behind = peek();
        if (!behind) return pass_on(behind);
        if (behind->word == Word::close) static_cast<void>(next());
        return numbers;
    }

    Result<Parameters> parameters() {
        Parameters all;
        while (true) {
            Result<Token> token = peek();
            if (!token) return pass_on(token);
            if (token->word != Word::text) return all;
            static_cast<void>(next());
            Parameter one;
            const std::string_view declared = trimmed(token->text);
            const std::size_t blank = declared.find_first_of(" \t");
            if (blank == std::string_view::npos)
                return wrong("SCN0102", token->offset, "a parameter needs a type and a name");
            one.type = declared.substr(0, blank);
            one.name = trimmed(declared.substr(blank));
            Result<Token> value = next();
            if (!value) return pass_on(value);
            const bool is_list = value->word == Word::open;
            if (is_list) {
                value = next();
                if (!value) return pass_on(value);
            }
            while (true) {
                if (is_list && value->word == Word::close) break;
                if (value->word == Word::number)
                    one.numbers.push_back(value->number);
                else if (value->word == Word::text)
                    one.texts.emplace_back(value->text);
                else
                    return wrong("SCN0102", value->offset, fmt::format("the parameter '{}' has no value", one.name));
                if (!is_list) break;
                value = next();
                if (!value) return pass_on(value);
            }
            all.push_back(std::move(one));
        }
    }

    // Skips strings, numbers and brackets up to the next directive.
    Result<void> skip_arguments() {
        while (true) {
            const std::size_t before = file().at;
            Result<Token> token = next();
            if (!token) return pass_on(token);
            if (token->word == Word::directive || token->word == Word::end) {
                file().at = before;
                return {};
            }
        }
    }

    Result<void> push() {
        if (states_.size() >= limit("scene-depth").value)
            return wrong("SCN0108", file().at, fmt::format("nested deeper than {}", to_text(limit("scene-depth"))));
        states_.push_back(state_);
        return {};
    }

    Result<void> take(const Token& directive) {
        const std::string_view name = directive.text;
        const auto numbers = [&](std::size_t count, auto work) -> Result<void> {
            Result<std::vector<double>> read = number_arguments(directive, count);
            if (!read) return pass_on(read);
            work(*read);
            return {};
        };
        const auto matrix = [](const std::vector<double>& m) {
            glm::dmat4 to;
            for (int i = 0; i < 16; ++i)
                to[i / 4][i % 4] = m[static_cast<std::size_t>(i)];
            return to;
        };
        if (name == "AttributeBegin" || name == "TransformBegin") {
            if (Result<void> pushed = push(); !pushed) return pushed;
            if (name == "TransformBegin") return {};
            comment_.clear();
            skip_blanks(true);
            if (!comment_.empty()) state_.name = comment_.substr(0, 80);
            return {};
        }
        if (name == "AttributeEnd" || name == "TransformEnd") {
            if (states_.empty()) return wrong("SCN0102", directive.offset, fmt::format("{} without a beginning", name));
            if (name == "TransformEnd")
                state_.world = states_.back().world;
            else
                state_ = states_.back();
            states_.pop_back();
            return {};
        }
        if (name == "WorldBegin") {
            state_.world = glm::dmat4(1.0);
            named_["world"] = state_.world;
            return {};
        }
        if (name == "Identity") {
            state_.world = glm::dmat4(1.0);
            return {};
        }
        if (name == "Translate")
            return numbers(3, [&](const auto& v) { state_.world = glm::translate(state_.world, {v[0], v[1], v[2]}); });
        if (name == "Scale")
            return numbers(3, [&](const auto& v) { state_.world = glm::scale(state_.world, {v[0], v[1], v[2]}); });
        if (name == "Rotate")
            return numbers(4, [&](const auto& v) {
                const glm::dvec3 axis(v[1], v[2], v[3]);
                if (glm::length(axis) > 0.0) state_.world = glm::rotate(state_.world, v[0] * pi / 180.0, axis);
            });
        if (name == "Transform") return numbers(16, [&](const auto& v) { state_.world = matrix(v); });
        if (name == "ConcatTransform")
            return numbers(16, [&](const auto& v) { state_.world = state_.world * matrix(v); });
        if (name == "LookAt")
            return numbers(9, [&](const auto& v) {
                const glm::dvec3 eye(v[0], v[1], v[2]);
                const glm::dvec3 z = glm::normalize(glm::dvec3(v[3], v[4], v[5]) - eye);
                const glm::dvec3 x = glm::normalize(glm::cross(glm::normalize(glm::dvec3(v[6], v[7], v[8])), z));
                const glm::dmat4 from(glm::dvec4(x, 0.0), glm::dvec4(glm::cross(z, x), 0.0), glm::dvec4(z, 0.0),
                                      glm::dvec4(eye, 1.0));
                state_.world = state_.world * glm::inverse(from);
            });
        if (name == "CoordinateSystem" || name == "CoordSysTransform" || name == "ColorSpace" || name == "Include" ||
            name == "Import") {
            Result<std::string> text = text_argument(directive);
            if (!text) return pass_on(text);
            return take_named(directive, *text);
        }
        if (name == "ReverseOrientation") {
            state_.is_reversed = !state_.is_reversed;
            return {};
        }
        if (name == "ObjectBegin" || name == "ObjectEnd") {
            in_object_ = name == "ObjectBegin";
            if (in_object_) {
                if (Result<void> pushed = push(); !pushed) return pushed;
                return skip_arguments();
            }
            if (states_.empty()) return wrong("SCN0102", directive.offset, "ObjectEnd without a beginning");
            state_ = states_.back();
            states_.pop_back();
            return {};
        }
        const bool is_shape = name == "Shape";
        if (name == "LightSource" || name == "AreaLightSource" || (is_shape && state_.area && !in_object_)) {
            Result<std::string> kind = text_argument(directive);
            if (!kind) return pass_on(kind);
            Result<Parameters> all = parameters();
            if (!all) return pass_on(all);
            if (name == "AreaLightSource") {
                state_.area = std::make_shared<const Parameters>(std::move(*all));
                state_.area_kind = *kind;
                return {};
            }
            FoundLight light;
            light.name = state_.name;
            light.kind = kind->substr(0, 40);
            light.location = place(directive.offset);
            light.place = fmt::format("line {}", light.location.line);
            if (is_shape)
                take_area(light, *all);
            else
                take_light(light, *all);
            scene_.lights.push_back(std::move(light));
            return {};
        }
        return skip_arguments();
    }

    Result<void> take_named(const Token& directive, const std::string& text) {
        const std::string_view name = directive.text;
        if (name == "CoordinateSystem") {
            named_[text] = state_.world;
        } else if (name == "CoordSysTransform") {
            if (const auto known = named_.find(text); known != named_.end()) state_.world = known->second;
        } else if (name == "ColorSpace") {
            constexpr std::array<std::pair<std::string_view, std::string_view>, 4> spaces{
                {{"srgb", "rec709"}, {"rec2020", "rec2020"}, {"dci-p3", "p3-d65"}, {"aces2065-1", "aces2065-1"}}};
            for (const auto& [theirs, ours] : spaces)
                if (text == theirs) state_.space = find_rgb_space(ours);
        } else {
            return include(directive, text);
        }
        return {};
    }

    Result<void> include(const Token& directive, const std::string& name) {
        if (files_.size() >= limit("scene-depth").value ||
            std::any_of(files_.begin() + 1, files_.end(), [&](const OpenFile& open) { return open.name == name; }))
            return wrong("SCN0104", directive.offset, fmt::format("'{}' includes itself", name));
        Result<std::string> bytes = options_.read_beside ? options_.read_beside(name)
                                                         : fail(Failure::io, "files beside the scene are not read");
        if (!bytes) {
            warn(scene_, "SCN0107", place(directive.offset),
                 fmt::format("'{}' is not read, and lights in it are missing: {}", name,
                             bytes.error().diagnostics.empty() ? std::string("it cannot be opened")
                                                               : bytes.error().diagnostics.back().message));
            return {};
        }
        included_ += bytes->size();
        if (included_ > limit("scene-bytes").value)
            return wrong("SCN0108", directive.offset,
                         fmt::format("more than {} are included", to_text(limit("scene-bytes"))));
        files_.push_back({name, std::move(*bytes), {}, 0});
        files_.back().text = files_.back().held;
        return {};
    }

    // Sets the colour of a spectrum, and returns its luminance by which an amount is multiplied.
    double take_spectrum(FoundLight& light, const Parameters& all, std::string_view name) const {
        const Parameter* const spectrum = find(all, name);
        if (spectrum == nullptr) return 1.0;
        if (spectrum->type == "rgb" && spectrum->numbers.size() == 3) {
            const glm::dvec3 written(spectrum->numbers[0], spectrum->numbers[1], spectrum->numbers[2]);
            light.stated += fmt::format(", rgb {}", numbers_text(written));
            const RgbSpace& rec709 = *find_rgb_space("rec709");
            return take_color(light,
                              state_.space == &rec709 ? written : rec709.from_xyz * (state_.space->to_xyz * written));
        }
        if (spectrum->type == "blackbody" && !spectrum->numbers.empty()) {
            light.temperature = Kelvin(spectrum->numbers.front());
            light.stated += fmt::format(", blackbody {}", rounded(spectrum->numbers.front()));
            light.color = blackbody_color(light, spectrum->numbers.front());
            return 1.0;
        }
        if (!spectrum->texts.empty()) {
            std::string illuminant = spectrum->texts.front();
            constexpr std::string_view standard = "stdillum-";
            if (illuminant.starts_with(standard)) {
                illuminant.erase(0, standard.size());
                if (illuminant.starts_with('F')) illuminant.insert(1, "L");
                if (const Result<glm::dvec3> color = parse_light_color(illuminant)) {
                    light.color = *color;
                    return 1.0;
                }
            }
        }
        remark(light, "SCN0201", "its spectrum is not read: the amount keeps its meaning, the colour is white");
        return 1.0;
    }

    void take_light(FoundLight& light, const Parameters& all) {
        const double scale = number(all, "scale", 1.0);
        const double power = number(all, "power", -1.0);
        light.stated_amount = power > 0.0 ? power : scale;
        light.stated = power > 0.0 ? fmt::format("power {}", rounded(power)) : fmt::format("scale {}", rounded(scale));
        const glm::dvec3 from = point(all, "from", glm::dvec3(0.0));
        const glm::dvec3 to = point(all, "to", glm::dvec3(0.0, 0.0, 1.0));
        const bool is_distant = light.kind == "distant";
        const double luminance = take_spectrum(light, all, is_distant || light.kind == "infinite" ? "L" : "I");
        glm::dmat4 world = state_.world * glm::translate(glm::dmat4(1.0), from);
        if (light.kind == "point") {
            light.shape = PointShape{};
            light.intensity = amount(luminance * (power > 0.0 ? power / (4.0 * pi) : scale), "cd");
            place_light(light, world, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, up_, scene_.meters_per_unit);
            return;
        }
        const glm::dvec3 aim = to - from;
        const glm::dvec3 up =
            std::abs(aim.y) < 0.99 * glm::length(aim) ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
        if (light.kind == "spot") {
            const double outer = number(all, "coneangle", 30.0);
            const double delta = number(all, "conedeltaangle", 5.0);
            light.stated_outer = outer;
            light.stated_inner = outer - delta;
            if (!(outer > 0.0 && outer <= 90.0) || !(delta >= 0.0 && delta <= outer))
                return only_list(light, fmt::format("its cone is outside what a rig holds: {}° less {}°",
                                                    rounded(outer), rounded(delta)));
            light.shape = SpotShape{degrees(outer),
                                    Radians(std::max(degrees(outer).value - degrees(delta).value, 0.0)),
                                    Falloff::smoothstep_cos,
                                    {},
                                    {}};
            light.intensity = power > 0.0 ? amount(luminance * power, "lm") : amount(luminance * scale, "cd");
            place_light(light, world, aim, up, up_, scene_.meters_per_unit);
            return;
        }
        if (is_distant) {
            const double illuminance = number(all, "illuminance", -1.0);
            if (illuminance > 0.0) {
                light.stated_amount = illuminance;
                light.stated += fmt::format(", illuminance {}", rounded(illuminance));
            }
            light.shape = SunShape{degrees(0.53)};
            light.intensity = amount(luminance * scale * (illuminance > 0.0 ? illuminance : 1.0), "lx");
            remark(light, "SCN0201", "pbrt states no angular diameter: 0.53° is assumed");
            place_light(light, world, aim, up, up_, scene_.meters_per_unit);
            return;
        }
        if (light.kind == "goniometric" || light.kind == "projection") {
            place_light(light, world, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, up_, scene_.meters_per_unit);
            return only_list(light, "its intensities are a picture, which gonio does not read back");
        }
        if (light.kind == "infinite") return only_list(light, "light from all around is the sky of a rig");
        only_list(light, fmt::format("pbrt has no light '{}'", light.kind));
    }

    void take_area(FoundLight& light, const Parameters& shape) {
        const Parameters& all = *state_.area;
        const double scale = number(all, "scale", 1.0);
        const double power = number(all, "power", -1.0);
        const bool two_sided = number(all, "twosided", 0.0) != 0.0;
        light.stated_amount = power > 0.0 ? power : scale;
        light.stated = power > 0.0 ? fmt::format("power {}", rounded(power)) : fmt::format("scale {}", rounded(scale));
        if (state_.area_kind != "diffuse")
            return only_list(light, fmt::format("pbrt has no area light '{}'", state_.area_kind));
        if (find(all, "filename") != nullptr)
            return only_list(light, "its luminances are a picture, which gonio does not read back");
        const double luminance = take_spectrum(light, all, "L");
        light.intensity = amount(luminance * (power > 0.0 ? 1.0 : scale), "nt");
        const double unit = scene_.meters_per_unit;
        const glm::dmat4& world = state_.world;
        const double aim = state_.is_reversed ? -1.0 : 1.0;
        const glm::dvec3 lengths = axis_lengths(world);
        const bool is_uniform = nearly(lengths.x, lengths.y) && nearly(lengths.x, lengths.z);
        const auto is_whole = [&] { return number(shape, "phimax", 360.0) >= 360.0; };
        if (light.kind == "sphere") {
            const double radius = number(shape, "radius", 1.0);
            if (!is_whole() || number(shape, "zmin", -radius) > -radius || number(shape, "zmax", radius) < radius)
                return only_list(light, "a part of a sphere");
            if (!is_uniform) return only_list(light, "an ellipsoid");
            if (state_.is_reversed && !two_sided) return only_list(light, "a sphere that emits to its inside");
            light.shape = SphereShape{Meters(radius * lengths.x * unit)};
            place_light(light, world, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, up_, unit);
        } else if (light.kind == "disk") {
            if (!is_whole() || number(shape, "innerradius", 0.0) > 0.0) return only_list(light, "a part of a disk");
            const double radius = number(shape, "radius", 1.0);
            const glm::dmat4 placed = glm::translate(world, {0.0, 0.0, number(shape, "height", 0.0)});
            take_flat(light, glm::scale(placed, {radius, radius, 1.0}), true, aim, two_sided, up_, unit);
        } else if (light.kind == "cylinder") {
            if (!is_whole()) return only_list(light, "a part of a cylinder");
            if (!is_uniform) return only_list(light, "a cylinder that is stretched");
            if (state_.is_reversed && !two_sided) return only_list(light, "a cylinder that emits to its inside");
            const double low = number(shape, "zmin", -1.0);
            const double high = number(shape, "zmax", 1.0);
            if (!(high > low)) return only_list(light, "a cylinder without a length");
            light.shape = TubeShape{Meters(number(shape, "radius", 1.0) * lengths.x * unit),
                                    Meters((high - low) * lengths.z * unit)};
            place_light(light, glm::translate(world, {0.0, 0.0, 0.5 * (low + high)}), {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0},
                        up_, unit);
        } else if (light.kind == "trianglemesh" || light.kind == "bilinearmesh") {
            take_triangles(light, shape, two_sided);
        } else {
            return only_list(light, fmt::format("a shape '{}' that emits", light.kind));
        }
        if (!light.shape || power <= 0.0) return;
        // pbrt divides the power by the area that emits and π.
        light.intensity = amount(luminance * power, "lm");
    }

    void take_triangles(FoundLight& light, const Parameters& shape, bool two_sided) const {
        const Parameter* const written = find(shape, "P");
        if (written == nullptr || written->numbers.size() % 3 != 0) return only_list(light, "a mesh without points");
        std::vector<glm::dvec3> points;
        for (std::size_t i = 0; i + 2 < written->numbers.size(); i += 3) {
            const glm::dvec4 at(written->numbers[i], written->numbers[i + 1], written->numbers[i + 2], 1.0);
            points.push_back(glm::dvec3(state_.world * at) * scene_.meters_per_unit);
        }
        std::vector<int> indices;
        const std::size_t corners = light.kind == "trianglemesh" ? 3 : 4;
        if (const Parameter* const listed = find(shape, "indices"); listed != nullptr) {
            for (const double index : listed->numbers) {
                if (!(index >= 0.0 && index < static_cast<double>(points.size())))
                    return only_list(light, "a mesh with an index of no point");
                indices.push_back(static_cast<int>(index));
            }
        } else {
            for (std::size_t i = 0; i < std::min(points.size(), corners); ++i)
                indices.push_back(static_cast<int>(i));
        }
        std::vector<glm::ivec3> faces;
        const bool flips = state_.is_reversed != (glm::determinant(state_.world) < 0.0);
        const auto add = [&](int a, int b, int c) {
            faces.push_back(flips ? glm::ivec3(a, c, b) : glm::ivec3(a, b, c));
        };
        for (std::size_t i = 0; i + corners <= indices.size(); i += corners) {
            add(indices[i], indices[i + 1], indices[i + 2]);
            if (corners == 4) add(indices[i + 1], indices[i + 3], indices[i + 2]);
        }
        take_mesh(light, points, faces, up_);
        if (!light.shape || !two_sided) return;
        if (auto* const rect = std::get_if<RectShape>(&*light.shape)) rect->two_sided = true;
        if (auto* const disk = std::get_if<DiskShape>(&*light.shape)) disk->two_sided = true;
        if (auto* const ellipse = std::get_if<EllipseShape>(&*light.shape)) ellipse->two_sided = true;
    }

    const SceneReadOptions& options_;
    std::string file_name_;
    LinePlaces places_;
    std::deque<OpenFile> files_; // that are open, each included by the one before it
    FoundScene scene_;
    State state_;
    std::vector<State> states_;
    std::map<std::string, glm::dmat4> named_;
    std::string comment_;
    std::uint64_t included_ = 0;
    bool in_object_ = false;
    char up_ = 'z';
};

} // namespace

bool is_pbrt(std::string_view bytes) {
    // A directive at the beginning of one of the first lines.
    constexpr std::size_t looked_at = 65536;
    constexpr std::array<std::string_view, 16> directives{
        "LightSource", "AttributeBegin", "WorldBegin", "LookAt",    "Camera", "Film",    "Sampler",     "Integrator",
        "Scale",       "Rotate",         "Translate",  "Transform", "Option", "Include", "PixelFilter", "ColorSpace"};
    std::string_view rest = bytes.substr(0, looked_at);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = trimmed(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (line.empty() || line.starts_with('#')) continue;
        const std::string_view word = line.substr(0, line.find_first_of(" \t"));
        return std::find(directives.begin(), directives.end(), word) != directives.end();
    }
    return false;
}

Result<FoundScene> read_pbrt(std::string_view bytes, const std::string& source, const SceneReadOptions& options) {
    return PbrtReader(bytes, source, options).read();
}

} // namespace gonio::interchange_detail
