// Mitsuba 3, XML. Its numbers are radiometric (W/sr, W/m²/sr, W/m²) and have no 683 in them. Renderings do not depend
// on that factor, so one unit is taken for one photometric unit unless --lm-per-watt states another. Spots fall
// linearly over the angle, along +Z; rectangles and disks emit along +Z. Mitsuba states neither a unit of length nor an
// upward axis.
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/base/xml_depth.hpp>
#include <gonio/color/rgb_space.hpp>
#include <gonio/interchange/detail/reading.hpp>

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

namespace gonio::interchange_detail {

namespace {

using std::numbers::pi;

// A file of the scene, parsed.
struct Document {
    std::string name;
    std::string bytes; // that pugixml works on
    pugi::xml_document xml;
};

class MitsubaReader {
public:
    MitsubaReader(std::string_view text, const std::string& source, const SceneReadOptions& options)
        : options_(options), text_(text), source_(source), places_(text, source) {}

    Result<FoundScene> read() {
        scene_.meters_per_unit = options_.unit.value_or(Meters(1.0)).value;
        up_ = options_.up.value_or('z');
        if (Result<void> opened = open(source_, std::string(text_)); !opened) return pass_on(opened);
        const pugi::xml_node root = documents_.front().xml.document_element();
        if (std::string_view(root.name()) != "scene")
            return wrong(
                "SCN0101", root,
                fmt::format("the root element is '{}', not 'scene'", std::string_view(root.name()).substr(0, 40)));
        if (Result<void> done = take_children(root, 0); !done) return pass_on(done);
        join_capsules(scene_.lights);
        if (!scene_.lights.empty()) {
            const auto say = [&](std::string message, std::string hint) {
                warn(scene_, "SCN0201", {source_, 0, 0}, std::move(message), std::move(hint));
            };
            if (!options_.unit || !options_.up)
                say("Mitsuba states neither a unit of length nor an upward axis: metres and Z up are assumed where no "
                    "option says it",
                    "--unit-scale and --up say what they are");
            if (!options_.lumens_per_watt)
                say("Mitsuba's numbers are radiometric: 1 W/sr is taken as 1 cd", "--lm-per-watt 180 multiplies");
        }
        return std::move(scene_);
    }

private:
    Result<void> open(const std::string& name, std::string bytes) {
        documents_.emplace_back();
        Document& document = documents_.back();
        document.name = name;
        document.bytes = std::move(bytes);
        constexpr unsigned how = pugi::parse_default | pugi::parse_comments;
        const pugi::xml_parse_result parsed =
            document.xml.load_buffer_inplace(document.bytes.data(), document.bytes.size(), how, pugi::encoding_utf8);
        if (parsed) return check_depth(document);
        LinePlaces places(documents_.size() == 1 ? text_ : std::string_view(), name);
        return scene_error("SCN0102", places.at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0))),
                           fmt::format("this is not well-formed XML: {}", parsed.description()));
    }

    Result<void> check_depth(const Document& document) {
        if (const pugi::xml_node deep = first_too_deep(document.xml))
            return wrong("SCN0108", deep, fmt::format("elements nested deeper than {}", to_text(limit("xml-depth"))));
        return {};
    }

    Location place(pugi::xml_node node) {
        const std::ptrdiff_t offset = node.offset_debug();
        if (documents_.size() > 1 || offset < 1) return {documents_.back().name, 0, 0};
        return places_.at(static_cast<std::size_t>(offset) - 1);
    }

    Unexpected wrong(SceneCode code, pugi::xml_node node, std::string message) {
        return scene_error(code, place(node), std::move(message));
    }

    // An attribute's text, with the names of <default> in it replaced.
    std::string text(pugi::xml_node node, const char* attribute) const {
        std::string value = node.attribute(attribute).value();
        constexpr std::size_t longest = 65536;
        if (value.size() > longest) return value;
        for (std::size_t at = value.find('$'); at != std::string::npos; at = value.find('$', at + 1))
            for (const auto& [name, replacement] : defaults_)
                if (value.compare(at + 1, name.size(), name) == 0) {
                    if (value.size() > longest) return value;
                    value.replace(at, name.size() + 1, replacement);
                    break;
                }
        return value;
    }

    Result<std::vector<double>> numbers(pugi::xml_node node, const std::string& text) {
        std::vector<double> values;
        std::string_view rest = text;
        while (true) {
            const std::size_t begin = rest.find_first_not_of(" ,\t\r\n");
            if (begin == std::string_view::npos) return values;
            rest.remove_prefix(begin);
            const std::size_t end = std::min(rest.find_first_of(" ,\t\r\n"), rest.size());
            const std::optional<double> value = parse_number(rest.substr(0, end));
            if (!value)
                return wrong(
                    "SCN0105", node,
                    fmt::format("'{}' is not a finite number", rest.substr(0, std::min<std::size_t>(end, 40))));
            values.push_back(*value);
            rest.remove_prefix(end);
        }
    }

    // The child with one of two names: Mitsuba 3's, and that of older versions.
    static pugi::xml_node named(pugi::xml_node node, std::string_view name, std::string_view old = {}) {
        for (const pugi::xml_node child : node.children()) {
            const std::string_view is = child.attribute("name").value();
            if (!is.empty() && (is == name || is == old)) return child;
        }
        return {};
    }

    Result<double> number(pugi::xml_node node, std::string_view name, double otherwise, std::string_view old = {}) {
        const pugi::xml_node child = named(node, name, old);
        if (!child) return otherwise;
        Result<std::vector<double>> values = numbers(child, text(child, "value"));
        if (!values) return pass_on(values);
        if (values->size() != 1) return wrong("SCN0105", child, fmt::format("'{}' must be a number", name));
        return values->front();
    }

    bool flag(pugi::xml_node node, std::string_view name, std::string_view old) const {
        const pugi::xml_node child = named(node, name, old);
        return child && text(child, "value") == "true";
    }

    // x, y, z of <point>, <vector>, <translate>, …; or "value".
    Result<glm::dvec3> vector(pugi::xml_node node, double otherwise) {
        if (node.attribute("value")) {
            Result<std::vector<double>> values = numbers(node, text(node, "value"));
            if (!values) return pass_on(values);
            if (values->size() == 1) return glm::dvec3(values->front());
            if (values->size() != 3)
                return wrong("SCN0105", node, fmt::format("<{}> must have three numbers", node.name()));
            return glm::dvec3((*values)[0], (*values)[1], (*values)[2]);
        }
        glm::dvec3 v(otherwise);
        constexpr std::array<const char*, 3> axes{"x", "y", "z"};
        for (int axis = 0; axis < 3; ++axis) {
            if (!node.attribute(axes[static_cast<std::size_t>(axis)])) continue;
            Result<std::vector<double>> value = numbers(node, text(node, axes[static_cast<std::size_t>(axis)]));
            if (!value) return pass_on(value);
            if (value->size() != 1) return wrong("SCN0105", node, "a coordinate must be a number");
            v[axis] = value->front();
        }
        return v;
    }

    Result<glm::dvec3> attribute_vector(pugi::xml_node node, const char* attribute) {
        Result<std::vector<double>> values = numbers(node, text(node, attribute));
        if (!values) return pass_on(values);
        if (values->size() != 3) return wrong("SCN0105", node, fmt::format("'{}' must have three numbers", attribute));
        return glm::dvec3((*values)[0], (*values)[1], (*values)[2]);
    }

    Result<glm::dmat4> to_world(pugi::xml_node node) {
        glm::dmat4 world(1.0);
        const pugi::xml_node transform = named(node, "to_world", "toWorld");
        for (const pugi::xml_node step : transform.children()) {
            const std::string_view name = step.name();
            glm::dmat4 own(1.0);
            if (name == "translate") {
                Result<glm::dvec3> by = vector(step, 0.0);
                if (!by) return pass_on(by);
                own = glm::translate(own, *by);
            } else if (name == "scale") {
                Result<glm::dvec3> by = vector(step, 1.0);
                if (!by) return pass_on(by);
                own = glm::scale(own, *by);
            } else if (name == "rotate") {
                Result<glm::dvec3> axis = vector(step, 0.0);
                if (!axis) return pass_on(axis);
                Result<std::vector<double>> angle = numbers(step, text(step, "angle"));
                if (!angle) return pass_on(angle);
                if (angle->size() != 1 || !(glm::length(*axis) > 0.0))
                    return wrong("SCN0105", step, "<rotate> needs an axis and an angle");
                own = glm::rotate(own, angle->front() * pi / 180.0, *axis);
            } else if (name == "matrix") {
                Result<std::vector<double>> m = numbers(step, text(step, "value"));
                if (!m) return pass_on(m);
                if (m->size() != 16 && m->size() != 9) return wrong("SCN0105", step, "<matrix> needs 9 or 16 numbers");
                const std::size_t size = m->size() == 16 ? 4 : 3;
                for (std::size_t i = 0; i < m->size(); ++i)
                    own[static_cast<int>(i % size)][static_cast<int>(i / size)] = (*m)[i];
            } else if (name == "lookat" || name == "lookAt") {
                Result<glm::dvec3> origin = attribute_vector(step, "origin");
                if (!origin) return pass_on(origin);
                Result<glm::dvec3> target = attribute_vector(step, "target");
                if (!target) return pass_on(target);
                glm::dvec3 up(0.0, 1.0, 0.0);
                if (step.attribute("up")) {
                    Result<glm::dvec3> given = attribute_vector(step, "up");
                    if (!given) return pass_on(given);
                    up = *given;
                }
                const glm::dvec3 z = glm::normalize(*target - *origin);
                if (glm::length(glm::cross(up, z)) < 1e-9)
                    up = std::abs(z.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
                const glm::dvec3 x = glm::normalize(glm::cross(up, z));
                own = glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(glm::cross(z, x), 0.0), glm::dvec4(z, 0.0),
                                 glm::dvec4(*origin, 1.0));
            }
            world = own * world;
        }
        return world;
    }

    // The amount of an emitter; sets its colour. Nothing: the light is only listed.
    Result<std::optional<double>> radiance(FoundLight& light, pugi::xml_node emitter, std::string_view name) {
        const double factor = options_.lumens_per_watt.value_or(1.0);
        const pugi::xml_node value = named(emitter, name);
        if (!value) {
            light.stated = fmt::format("{} 1", name);
            light.stated_amount = 1.0;
            return std::optional(factor);
        }
        const std::string_view kind = value.name();
        const std::string written = text(value, "value");
        light.stated = fmt::format("{} {} {}", name, kind, std::string_view(written).substr(0, 60));
        if (kind == "rgb" || kind == "srgb" || kind == "float" || kind == "spectrum" || kind == "color") {
            if (written.starts_with('#') || written.find(':') != std::string::npos || value.attribute("filename")) {
                only_list(light, "its spectrum is not read");
                return std::optional<double>();
            }
            Result<std::vector<double>> values = numbers(value, written);
            if (!values) return pass_on(values);
            if (values->size() == 1) {
                light.stated_amount = values->front();
                if (kind == "spectrum")
                    remark(light, "SCN0201", "a constant spectrum is taken as white of that amount");
                return std::optional(factor * values->front());
            }
            if (values->size() == 3) {
                const glm::dvec3 rgb((*values)[0], (*values)[1], (*values)[2]);
                const double luminance = take_color(light, rgb);
                light.stated_amount = luminance;
                light.stated_color_max = 1.0;
                return std::optional(factor * luminance);
            }
            return wrong("SCN0105", value, fmt::format("'{}' must have one or three numbers", name));
        }
        only_list(light, kind == "texture" ? "its amount is a picture, which gonio does not read back"
                                           : fmt::format("its amount is a <{}>, which gonio does not read", kind));
        return std::optional<double>();
    }

    // A name: the id, else the comment before it.
    static std::string name_of(pugi::xml_node node) {
        if (const char* const id = node.attribute("id").value(); *id != '\0')
            return std::string(std::string_view(id).substr(0, 200));
        const pugi::xml_node before = node.previous_sibling();
        if (before.type() != pugi::node_comment) return {};
        return std::string(trimmed(std::string_view(before.value())).substr(0, 80));
    }

    FoundLight light_at(pugi::xml_node node) {
        FoundLight light;
        light.name = name_of(node);
        light.kind = std::string(std::string_view(node.attribute("type").value()).substr(0, 40));
        light.location = place(node);
        light.place = fmt::format("line {}", light.location.line);
        return light;
    }

    Result<void> take_children(pugi::xml_node parent,
                               std::size_t includes) { // NOLINT(misc-no-recursion): as deep as scene-depth
        for (const pugi::xml_node node : parent.children()) {
            const std::string_view name = node.name();
            if (name == "default") {
                defaults_.emplace(node.attribute("name").value(), text(node, "value"));
                continue;
            }
            if (name == "include") {
                if (Result<void> done = include(node, includes); !done) return done;
                continue;
            }
            if (const char* const id = node.attribute("id").value(); name == "emitter" && *id != '\0')
                emitters_[id] = node;
            Result<void> done;
            if (name == "emitter") done = take_emitter(node);
            if (name == "shape") done = take_shape(node);
            if (!done) return done;
            if (scene_.lights.size() > limit("scene-lights").value)
                return wrong("SCN0108", node, fmt::format("more than {}", to_text(limit("scene-lights"))));
        }
        return {};
    }

    Result<void> include(pugi::xml_node node,
                         std::size_t includes) { // NOLINT(misc-no-recursion): as deep as scene-depth
        const std::string name = text(node, "filename");
        if (includes >= limit("xml-depth").value)
            return wrong("SCN0104", node, fmt::format("'{}' includes itself", name));
        Result<std::string> bytes = options_.read_beside ? options_.read_beside(name)
                                                         : fail(Failure::io, "files beside the scene are not read");
        if (!bytes) {
            warn(scene_, "SCN0107", place(node),
                 fmt::format("'{}' is not read, and lights in it are missing: {}", name,
                             bytes.error().diagnostics.empty() ? std::string("it cannot be opened")
                                                               : bytes.error().diagnostics.back().message));
            return {};
        }
        included_ += bytes->size();
        constexpr std::size_t most = 4096;
        if (included_ > limit("scene-bytes").value || documents_.size() > most)
            return wrong("SCN0108", node, "too much is included");
        if (Result<void> opened = open(name, std::move(*bytes)); !opened) return opened;
        return take_children(documents_.back().xml.document_element(), includes + 1);
    }

    Result<void> take_emitter(pugi::xml_node node) {
        FoundLight light = light_at(node);
        Result<glm::dmat4> world = to_world(node);
        if (!world) return pass_on(world);
        const double unit = scene_.meters_per_unit;
        if (light.kind == "area") return {}; // of shapes that refer to it
        if (light.kind == "point") {
            Result<std::optional<double>> intensity = radiance(light, node, "intensity");
            if (!intensity) return pass_on(intensity);
            if (const pugi::xml_node position = named(node, "position")) {
                Result<glm::dvec3> at = vector(position, 0.0);
                if (!at) return pass_on(at);
                *world = glm::translate(glm::dmat4(1.0), *at);
            }
            if (*intensity) {
                light.shape = PointShape{};
                light.intensity = amount(**intensity, "cd");
            }
            place_light(light, *world, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, up_, unit);
        } else if (light.kind == "spot") {
            if (Result<void> done = take_spot(light, node, *world); !done) return done;
        } else if (light.kind == "directional") {
            Result<std::optional<double>> irradiance = radiance(light, node, "irradiance");
            if (!irradiance) return pass_on(irradiance);
            glm::dvec3 aim(0.0, 0.0, 1.0);
            if (const pugi::xml_node direction = named(node, "direction")) {
                Result<glm::dvec3> given = vector(direction, 0.0);
                if (!given) return pass_on(given);
                aim = *given;
                *world = glm::dmat4(1.0);
            }
            if (*irradiance) {
                light.shape = SunShape{degrees(0.53)};
                light.intensity = amount(**irradiance, "lx");
                remark(light, "SCN0201", "Mitsuba's directional light has no angular diameter: 0.53° is assumed");
            }
            const glm::dvec3 up =
                std::abs(aim.y) < 0.99 * glm::length(aim) ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
            place_light(light, *world, aim, up, up_, unit);
        } else if (light.kind == "projector") {
            Result<double> scale = number(node, "scale", 1.0);
            if (!scale) return pass_on(scale);
            light.stated = fmt::format("scale {}", rounded(*scale));
            light.stated_amount = *scale;
            place_light(light, *world, {0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, up_, unit);
            only_list(light, "its intensities are a picture, which gonio does not read back");
        } else if (light.kind == "envmap" || light.kind == "constant" || light.kind == "sky" ||
                   light.kind == "sunsky") {
            only_list(light, "light from all around is the sky of a rig");
        } else {
            only_list(light, fmt::format("gonio does not read the emitter '{}'", light.kind));
        }
        scene_.lights.push_back(std::move(light));
        return {};
    }

    Result<void> take_spot(FoundLight& light, pugi::xml_node node, const glm::dmat4& world) {
        Result<std::optional<double>> intensity = radiance(light, node, "intensity");
        if (!intensity) return pass_on(intensity);
        Result<double> cutoff = number(node, "cutoff_angle", 20.0, "cutoffAngle");
        if (!cutoff) return pass_on(cutoff);
        Result<double> beam = number(node, "beam_width", 0.75 * *cutoff, "beamWidth");
        if (!beam) return pass_on(beam);
        light.stated_outer = *cutoff;
        light.stated_inner = *beam;
        if (!*intensity) return {};
        if (!(*cutoff > 0.0 && *cutoff <= 90.0) || !(*beam >= 0.0 && *beam <= *cutoff)) {
            only_list(light, fmt::format("its cone is outside what a rig holds: {}° and {}°", rounded(*beam),
                                         rounded(*cutoff)));
            return {};
        }
        light.shape = SpotShape{degrees(*cutoff), degrees(*beam), Falloff::linear_angle, {}, {}};
        light.intensity = amount(**intensity, "cd");
        if (named(node, "texture")) remark(light, "SCN0202", "its texture is left out");
        place_light(light, world, {0.0, 0.0, 1.0}, {0.0, -1.0, 0.0}, up_, scene_.meters_per_unit);
        return {};
    }

    Result<void> take_shape(pugi::xml_node node) {
        pugi::xml_node emitter = node.child("emitter");
        if (!emitter)
            for (const pugi::xml_node ref : node.children("ref"))
                if (const auto known = emitters_.find(ref.attribute("id").value()); known != emitters_.end())
                    emitter = known->second;
        if (!emitter) return {};
        FoundLight light = light_at(node);
        Result<std::optional<double>> nits = radiance(light, emitter, "radiance");
        if (!nits) return pass_on(nits);
        Result<glm::dmat4> world = to_world(node);
        if (!world) return pass_on(world);
        if (*nits) {
            light.intensity = amount(**nits, "nt");
            if (Result<void> done = take_body(light, node, *world); !done) return done;
        }
        scene_.lights.push_back(std::move(light));
        return {};
    }

    Result<void> take_body(FoundLight& light, pugi::xml_node node, const glm::dmat4& world) {
        const double unit = scene_.meters_per_unit;
        const bool flips = flag(node, "flip_normals", "flipNormals");
        const glm::dvec3 lengths = axis_lengths(world);
        const bool is_uniform = nearly(lengths.x, lengths.y) && nearly(lengths.x, lengths.z);
        Result<double> radius = number(node, "radius", 1.0);
        if (!radius) return pass_on(radius);
        const auto point = [&](std::string_view name, const glm::dvec3& otherwise) -> Result<glm::dvec3> {
            const pugi::xml_node given = named(node, name);
            if (!given) return otherwise;
            return vector(given, 0.0);
        };
        if (light.kind == "rectangle" || light.kind == "disk") {
            take_flat(light, world, light.kind == "disk", flips ? -1.0 : 1.0, false, up_, unit);
        } else if (light.kind == "sphere" || light.kind == "cylinder") {
            if (flips) {
                only_list(light, "it emits to its inside");
                return {};
            }
            if (!is_uniform) {
                only_list(light, "a shape that is stretched");
                return {};
            }
            if (!(*radius > 0.0)) {
                only_list(light, "its radius is not above 0");
                return {};
            }
            Result<glm::dvec3> first = point(light.kind == "sphere" ? "center" : "p0", glm::dvec3(0.0));
            if (!first) return pass_on(first);
            if (light.kind == "sphere") {
                light.shape = SphereShape{Meters(*radius * lengths.x * unit)};
                place_light(light, glm::translate(world, *first), {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, up_, unit);
                return {};
            }
            Result<glm::dvec3> second = point("p1", glm::dvec3(0.0, 0.0, 1.0));
            if (!second) return pass_on(second);
            const glm::dvec3 axis = *second - *first;
            const double length = glm::length(axis);
            if (!(length > 0.0)) {
                only_list(light, "a cylinder without a length");
                return {};
            }
            light.shape = TubeShape{Meters(*radius * lengths.x * unit), Meters(length * lengths.x * unit)};
            // Any direction across the axis: X = Y × Z is the axis.
            const glm::dvec3 x = axis / length;
            const glm::dvec3 aim = glm::normalize(
                glm::cross(x, std::abs(x.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0)));
            place_light(light, glm::translate(world, 0.5 * (*first + *second)), aim, glm::cross(-aim, x), up_, unit);
        } else {
            only_list(light, fmt::format("a shape '{}' that emits", light.kind));
        }
        return {};
    }

    const SceneReadOptions& options_;
    std::string_view text_;
    const std::string& source_;
    LinePlaces places_;
    FoundScene scene_;
    std::deque<Document> documents_;
    std::map<std::string, std::string, std::greater<>> defaults_; // of names that begin alike, the longest first
    std::map<std::string, pugi::xml_node, std::less<>> emitters_;
    std::uint64_t included_ = 0;
    char up_ = 'z';
};

} // namespace

bool is_mitsuba(std::string_view bytes) {
    constexpr std::size_t looked_at = 65536;
    const std::string_view start = bytes.substr(0, looked_at);
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    const std::string_view text = trimmed(start.starts_with(byte_order_mark) ? start.substr(3) : start);
    return text.starts_with('<') && text.find("<scene") != std::string_view::npos;
}

Result<FoundScene> read_mitsuba(std::string_view bytes, const std::string& source, const SceneReadOptions& options) {
    return MitsubaReader(bytes, source, options).read();
}

} // namespace gonio::interchange_detail
