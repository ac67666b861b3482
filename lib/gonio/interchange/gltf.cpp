// glTF 2.0, as text and as GLB.
//
// KHR_lights_punctual: candela, lux of a sun; the linear Rec.709 colour multiplies, so that the photometric amount is
// the intensity times the colour's luminance; light goes along −Z; cones are half angles; the scale of a node moves
// positions only. EXT_lights_ies: the profile's candela × multiplier × colour. EXT_lights_area (a proposal): nits, the
// size times the node's scale, one side. Its draft and KHR_materials_emissive_strength leave open whether meshes glow
// in nits: they are listed only.
#include <gonio/base/json_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/interchange/detail/gltf_document.hpp>
#include <gonio/interchange/detail/gltf_index.hpp>
#include <gonio/interchange/detail/reading.hpp>

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>

namespace gonio::interchange_detail {

namespace {

using detail::Json;
using std::numbers::pi;

constexpr std::string_view glb_magic = "glTF";

std::uint32_t u32_at(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8U * i);
    return value;
}

Unexpected glb_error(const std::string& source, std::size_t byte, std::string_view what) {
    return scene_error("SCN0102", {source, 0, 0}, fmt::format("byte {} of the GLB: {}", byte, what));
}

// Standard base64 with padding, as data URIs have it.
std::optional<std::string> from_base64(std::string_view text) {
    std::string bytes;
    std::uint32_t bits = 0;
    unsigned count = 0;
    while (text.ends_with('='))
        text.remove_suffix(1);
    for (const char c : text) {
        unsigned value = 0;
        if (c >= 'A' && c <= 'Z')
            value = static_cast<unsigned>(c - 'A');
        else if (c >= 'a' && c <= 'z')
            value = static_cast<unsigned>(c - 'a') + 26;
        else if (c >= '0' && c <= '9')
            value = static_cast<unsigned>(c - '0') + 52;
        else if (c == '+')
            value = 62;
        else if (c == '/')
            value = 63;
        else
            return std::nullopt;
        bits = (bits << 6U) | value;
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes += static_cast<char>((bits >> count) & 0xffU);
        }
    }
    return bytes;
}

// Relative URIs escape bytes with '%'.
std::string unescaped(std::string_view uri) {
    std::string text;
    const auto digit = [](char c) {
        return c >= '0' && c <= '9' ? c - '0' : to_lower(c) >= 'a' && to_lower(c) <= 'f' ? to_lower(c) - 'a' + 10 : -1;
    };
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0) {
            text += static_cast<char>(16 * digit(uri[i + 1]) + digit(uri[i + 2]));
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

std::string file_stem(std::string_view name) {
    return plain_name(name.substr(0, 60));
}

class GltfReader {
public:
    GltfReader(const GltfDocument& document, GltfIndex& index, const std::string& source,
               const SceneReadOptions& options)
        : document_(document), index_(index), options_(options), places_(document.json, source) {}

    Result<FoundScene> read() {
        scene_.generator = index_.generator;
        scene_.meters_per_unit = options_.unit.value_or(Meters(1.0)).value;
        up_ = options_.up.value_or('y');
        if (Result<void> read = read_glowing(); !read) return pass_on(read);
        for (std::uint32_t i = 0; i < index_.nodes.size(); ++i) {
            const GltfNode& node = index_.nodes[i];
            if (node.lights == 0 && (node.mesh == nothing || !index_.any_emission)) continue;
            if (Result<void> read = read_node(i); !read) return pass_on(read);
            if (scene_.lights.size() > limit("scene-lights").value)
                return wrong("SCN0108", i, fmt::format("more than {}", to_text(limit("scene-lights"))));
        }
        return std::move(scene_);
    }

private:
    Unexpected wrong(SceneCode code, std::uint32_t node, std::string_view message) {
        return scene_error(code, places_.at(index_.nodes[node].element.offset),
                           fmt::format("nodes[{}]: {}", node, message));
    }
    Unexpected wrong_in(SceneCode code, GltfElement element, std::string message) {
        return scene_error(code, places_.at(element.offset), std::move(message));
    }

    Result<Json> parsed(GltfElement element) {
        Result<Json> json = detail::parse_json(std::string_view(document_.json).substr(element.offset, element.length));
        if (!json)
            return wrong_in("SCN0108", element,
                            "this element is too large: " + json.error().diagnostics.back().message);
        return json;
    }

    // A number of an element, or a default. Fails on another type.
    Result<double> number(const Json& json, std::string_view key, double otherwise, GltfElement element) {
        const Json* const value = json.find(key);
        if (value == nullptr) return otherwise;
        if (!value->is_number()) return wrong_in("SCN0105", element, fmt::format("'{}' must be a number", key));
        return value->as_double();
    }

    Result<void> numbers(const Json& json, std::string_view key, std::size_t count, double* into, GltfElement element) {
        const Json* const value = json.find(key);
        if (value == nullptr) return {};
        bool fits = value->is_array() && value->size() == count;
        for (std::size_t i = 0; fits && i < count; ++i) {
            fits = (*value)[i].is_number();
            if (fits) into[i] = (*value)[i].as_double();
        }
        if (!fits) return wrong_in("SCN0105", element, fmt::format("'{}' must be an array of {} numbers", key, count));
        return {};
    }

    Result<glm::dvec3> color_of(const Json& json, GltfElement element) {
        std::array<double, 3> rgb{1.0, 1.0, 1.0};
        if (Result<void> read = numbers(json, "color", 3, rgb.data(), element); !read) return pass_on(read);
        return glm::dvec3(rgb[0], rgb[1], rgb[2]);
    }

    Result<glm::dmat4> local(const Json& json, GltfElement element) {
        std::array<double, 16> m{};
        if (json.contains("matrix")) {
            if (Result<void> read = numbers(json, "matrix", 16, m.data(), element); !read) return pass_on(read);
            glm::dmat4 matrix;
            for (int i = 0; i < 16; ++i)
                matrix[i / 4][i % 4] = m[static_cast<std::size_t>(i)];
            return matrix;
        }
        std::array<double, 3> t{};
        std::array<double, 4> r{0.0, 0.0, 0.0, 1.0};
        std::array<double, 3> s{1.0, 1.0, 1.0};
        if (Result<void> read = numbers(json, "translation", 3, t.data(), element); !read) return pass_on(read);
        if (Result<void> read = numbers(json, "rotation", 4, r.data(), element); !read) return pass_on(read);
        if (Result<void> read = numbers(json, "scale", 3, s.data(), element); !read) return pass_on(read);
        const double length = std::sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3]);
        if (!(length > 0.0) || !std::isfinite(length))
            return wrong_in("SCN0105", element, "'rotation' must be a unit quaternion");
        glm::dmat4 matrix = glm::mat4_cast(glm::dquat(r[3] / length, r[0] / length, r[1] / length, r[2] / length));
        for (int i = 0; i < 3; ++i)
            matrix[i] *= s[static_cast<std::size_t>(i)];
        matrix[3] = glm::dvec4(t[0], t[1], t[2], 1.0);
        return matrix;
    }

    // The world matrix of a node's parents; those of nodes above lights are kept.
    Result<glm::dmat4> world_of(std::uint32_t node) {
        std::vector<std::uint32_t> above;
        glm::dmat4 world(1.0);
        std::uint32_t at = node;
        for (; at != nothing; at = index_.nodes[at].parent) {
            if (const auto known = worlds_.find(at); known != worlds_.end()) {
                world = known->second;
                break;
            }
            above.push_back(at);
        }
        for (std::size_t i = above.size(); i-- > 0;) { // from the root down
            const GltfElement element = index_.nodes[above[i]].element;
            Result<Json> json = parsed(element);
            if (!json) return pass_on(json);
            Result<glm::dmat4> own = local(*json, element);
            if (!own) return own;
            world = world * *own;
            if (above[i] != node) worlds_.emplace(above[i], world);
        }
        return world;
    }

    // Whether the scene that the file shows reaches the node; each node is asked for once.
    bool is_shown(std::uint32_t node) {
        if (!index_.has_scenes) return true;
        shown_.resize(index_.nodes.size(), unknown);
        std::uint32_t at = node;
        while (shown_[at] == unknown && !index_.nodes[at].is_root && index_.nodes[at].parent != nothing)
            at = index_.nodes[at].parent;
        const char answer = shown_[at] != unknown ? shown_[at] : index_.nodes[at].is_root ? yes : no;
        for (std::uint32_t below = node; below != at; below = index_.nodes[below].parent)
            shown_[below] = answer;
        shown_[at] = answer;
        return answer == yes;
    }

    Result<void> read_node(std::uint32_t at) {
        const GltfNode& node = index_.nodes[at];
        Result<Json> json = parsed(node.element);
        if (!json) return pass_on(json);
        FoundLight base;
        if (const Json* const name = json->find("name"); name != nullptr && name->is_string())
            base.name = name->as_string();
        base.place = fmt::format("nodes[{}]", at);
        const std::size_t first = scene_.lights.size();
        const Json* const extensions = json->find("extensions");
        const auto extension = [&](GltfLights which) {
            return extensions != nullptr && extensions->is_object()
                       ? extensions->find(gltf_light_extensions[static_cast<std::size_t>(which)])
                       : nullptr;
        };
        // Profiles and areas have a punctual light beside them for programs without them.
        const bool has_better = extension(GltfLights::ies) != nullptr || extension(GltfLights::area) != nullptr;
        for (const GltfLights which : {GltfLights::punctual, GltfLights::ies, GltfLights::area}) {
            const Json* const value = extension(which);
            if (value == nullptr || (which == GltfLights::punctual && has_better)) continue;
            const Json* const light = value->find("light");
            if (light == nullptr || !light->is_unsigned())
                return wrong("SCN0105", at,
                             fmt::format("{}: 'light' must be the index of a light",
                                         gltf_light_extensions[static_cast<std::size_t>(which)]));
            const auto& lights = index_.lights[static_cast<std::size_t>(which)];
            if (light->as_uint64() >= lights.size())
                return wrong("SCN0103", at,
                             fmt::format("{}: there is no light {}, only {}",
                                         gltf_light_extensions[static_cast<std::size_t>(which)], light->as_uint64(),
                                         lights.size()));
            const auto index = static_cast<std::size_t>(light->as_uint64());
            FoundLight found = base;
            found.index = index;
            Result<void> read = which == GltfLights::punctual ? read_punctual(found, lights[index])
                                : which == GltfLights::ies
                                    ? read_profile_light(found, lights[index], index, *value, node)
                                    : read_area(found, lights[index]);
            if (!read) return read;
            scene_.lights.push_back(std::move(found));
        }
        if (node.mesh != nothing && index_.any_emission)
            if (Result<void> read = read_mesh(base, at); !read) return read;
        if (scene_.lights.size() == first) return {};
        Result<glm::dmat4> world = world_of(at);
        if (!world) return pass_on(world);
        const Location location = places_.at(node.element.offset);
        for (std::size_t i = first; i < scene_.lights.size(); ++i) {
            FoundLight& light = scene_.lights[i];
            light.location = location;
            if (!is_shown(at)) {
                light.shape.reset();
                remark(light, "SCN0204", "its node is not in the scene that the file shows");
            }
            if (!place_light(light, *world, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, up_, scene_.meters_per_unit)) continue;
            scale_shape(light, *world);
            if (light.range) light.range->value *= scene_.meters_per_unit;
            if (light.shape && std::holds_alternative<ProfileShape>(*light.shape) && glm::determinant(*world) < 0.0)
                remark(light, "SCN0202", "its node mirrors it; the azimuths of a profile are not mirrored");
        }
        return {};
    }

    // Areas are as large as their node's scale makes them; the draft takes the largest.
    void scale_shape(FoundLight& light, const glm::dmat4& world) const {
        if (!light.shape) return;
        const glm::dvec3 lengths = axis_lengths(world);
        const double scale = std::max({lengths.x, lengths.y, lengths.z}) * scene_.meters_per_unit;
        if (auto* const rect = std::get_if<RectShape>(&*light.shape)) {
            rect->width.value *= scale;
            rect->height.value *= scale;
        }
        if (auto* const disk = std::get_if<DiskShape>(&*light.shape)) disk->radius.value *= scale;
    }

    Result<void> take_name(FoundLight& light, const Json& json) {
        const Json* const name = json.find("name");
        if (light.name.empty() && name != nullptr && name->is_string()) light.name = name->as_string();
        return {};
    }

    Result<void> read_punctual(FoundLight& light, GltfElement element) {
        Result<Json> json = parsed(element);
        if (!json) return pass_on(json);
        static_cast<void>(take_name(light, *json));
        const Json* const type = json->find("type");
        if (type == nullptr || !type->is_string()) return wrong_in("SCN0105", element, "the light has no type");
        light.kind = type->as_string().substr(0, 40);
        Result<double> intensity = number(*json, "intensity", 1.0, element);
        if (!intensity) return pass_on(intensity);
        Result<glm::dvec3> color = color_of(*json, element);
        if (!color) return pass_on(color);
        light.stated_amount = *intensity;
        light.stated = fmt::format("intensity {}", rounded(*intensity));
        if (*color != glm::dvec3(1.0)) light.stated += fmt::format(", color {}", numbers_text(*color));
        const double shining = *intensity * take_color(light, *color);
        if (json->contains("range")) {
            Result<double> range = number(*json, "range", 0.0, element);
            if (!range) return pass_on(range);
            if (*range > 0.0) {
                light.range = Meters(*range);
                remark(light, "SCN0202", "glTF recommends a window of 1 − (d/range)⁴, which a rig has squared");
            } else {
                remark(light, "SCN0308", "its range is not above 0: none is taken");
            }
        }
        if (light.kind == "directional") {
            light.range.reset();
            light.shape = SunShape{degrees(0.53)};
            light.intensity = amount(shining, "lx");
            remark(light, "SCN0201", "glTF states no angular diameter: 0.53° is assumed");
            return {};
        }
        light.intensity = amount(shining, "cd");
        if (light.kind == "point") {
            light.shape = PointShape{};
            return {};
        }
        if (light.kind != "spot") {
            only_list(light, fmt::format("KHR_lights_punctual has no light '{}'", light.kind));
            return {};
        }
        const Json none = Json::object();
        const Json* spot = json->find("spot");
        if (spot == nullptr) {
            spot = &none;
            remark(light, "SCN0201", "the spot states no cone: an outer half angle of 45° is assumed, as in glTF");
        }
        if (!spot->is_object()) return wrong_in("SCN0105", element, "'spot' must be an object");
        Result<double> inner = number(*spot, "innerConeAngle", 0.0, element);
        if (!inner) return pass_on(inner);
        Result<double> outer = number(*spot, "outerConeAngle", 0.25 * pi, element);
        if (!outer) return pass_on(outer);
        light.stated_outer = *outer;
        light.stated_inner = *inner;
        constexpr double rounding = 1e-6;
        if (!(*inner >= 0.0) || !(*outer > 0.0) || *inner > *outer || *outer > 0.5 * pi + rounding) {
            only_list(
                light,
                fmt::format("its cone is impossible: half angles of {} and {} rad", rounded(*inner), rounded(*outer)),
                "glTF needs 0 ≤ innerConeAngle < outerConeAngle ≤ π/2, half angles in radians; see --audit");
            return {};
        }
        light.shape = SpotShape{Radians(std::min(*outer, 0.5 * pi)),
                                Radians(std::min({*inner, *outer, 0.5 * pi})),
                                Falloff::frostbite,
                                {},
                                {}};
        return {};
    }

    Result<void> read_profile_light(FoundLight& light, GltfElement element, std::size_t index, const Json& use,
                                    const GltfNode& node) {
        Result<Json> json = parsed(element);
        if (!json) return pass_on(json);
        static_cast<void>(take_name(light, *json));
        light.kind = "ies";
        Result<double> multiplier = number(use, "multiplier", 1.0, node.element);
        if (!multiplier) return pass_on(multiplier);
        Result<glm::dvec3> color = color_of(use, node.element);
        if (!color) return pass_on(color);
        light.stated_amount = *multiplier;
        light.stated = fmt::format("multiplier {}", rounded(*multiplier));
        if (*color != glm::dvec3(1.0)) light.stated += fmt::format(", color {}", numbers_text(*color));
        light.profile_scale = *multiplier * take_color(light, *color);
        if (nearly(light.profile_scale, 1.0)) light.profile_scale = 1.0;
        light.shape = ProfileShape{};
        if (!(light.profile_scale >= 0.0)) only_list(light, "its multiplier is below 0");
        return take_profile(light, *json, element, index);
    }

    Result<void> take_profile(FoundLight& light, const Json& json, GltfElement element, std::size_t index) {
        if (!light.shape) return {};
        auto& shape = std::get<ProfileShape>(*light.shape);
        if (const Json* const uri = json.find("uri"); uri != nullptr) {
            if (!uri->is_string()) return wrong_in("SCN0105", element, "'uri' must be a string");
            constexpr std::string_view data = "data:";
            if (!uri->as_string().starts_with(data)) {
                shape.file = unescaped(uri->as_string());
                return {};
            }
            const std::size_t comma = uri->as_string().find(";base64,");
            std::optional<std::string> bytes;
            if (comma != std::string::npos) bytes = from_base64(std::string_view(uri->as_string()).substr(comma + 8));
            if (!bytes) {
                light.shape.reset();
                remark(light, "SCN0107", "the data URI of its profile is not base64");
                return {};
            }
            return keep_profile(light, index, json, std::move(*bytes));
        }
        const Json* const view = json.find("bufferView");
        if (view == nullptr || !view->is_unsigned())
            return wrong_in("SCN0105", element, "the profile has neither a uri nor a bufferView");
        if (view->as_uint64() >= index_.buffer_views.size())
            return wrong_in(
                "SCN0103", element,
                fmt::format("there is no bufferView {}, only {}", view->as_uint64(), index_.buffer_views.size()));
        if (inside_.contains(index)) {
            light.profile = inside_[index];
            return {};
        }
        Result<std::string> bytes =
            bytes_of_view(index_.buffer_views[static_cast<std::size_t>(view->as_uint64())], light);
        if (!bytes) return pass_on(bytes);
        if (!light.shape) return {};
        return keep_profile(light, index, json, std::move(*bytes));
    }

    Result<void> keep_profile(FoundLight& light, std::size_t index, const Json& json, std::string bytes) {
        if (!inside_.contains(index)) {
            inside_[index] = scene_.profiles.size();
            const Json* const name = json.find("name");
            std::string stem = name != nullptr && name->is_string() ? file_stem(name->as_string()) : std::string();
            if (stem.empty()) stem = "profile";
            const auto is_taken = [&](const std::string& wanted) {
                return std::any_of(scene_.profiles.begin(), scene_.profiles.end(),
                                   [&](const FoundProfile& other) { return other.name == wanted; });
            };
            std::string free = stem;
            for (int number = 2; is_taken(free); ++number)
                free = fmt::format("{}_{}", stem, number);
            scene_.profiles.push_back({std::move(free), std::move(bytes)});
        }
        light.profile = inside_[index];
        return {};
    }

    // A missing buffer is a remark of the light; a range outside of one is a failure.
    Result<std::string> bytes_of_view(GltfElement element, FoundLight& light) {
        Result<Json> view = parsed(element);
        if (!view) return pass_on(view);
        const auto whole = [&](std::string_view key, bool needed) -> Result<std::size_t> {
            const Json* const value = view->find(key);
            if (value == nullptr && !needed) return std::size_t{0};
            if (value == nullptr || !value->is_unsigned())
                return wrong_in("SCN0105", element, fmt::format("'{}' of a bufferView must be a whole number", key));
            return static_cast<std::size_t>(value->as_uint64());
        };
        Result<std::size_t> buffer = whole("buffer", true);
        if (!buffer) return pass_on(buffer);
        Result<std::size_t> offset = whole("byteOffset", false);
        if (!offset) return pass_on(offset);
        Result<std::size_t> length = whole("byteLength", true);
        if (!length) return pass_on(length);
        if (*buffer >= index_.buffers.size())
            return wrong_in("SCN0103", element,
                            fmt::format("there is no buffer {}, only {}", *buffer, index_.buffers.size()));
        Result<Json> described = parsed(index_.buffers[*buffer]);
        if (!described) return pass_on(described);
        const auto missing = [&](const std::string& why) {
            light.shape.reset();
            remark(light, "SCN0107", "the buffer of its profile is not usable: " + why);
            return std::string();
        };
        std::string held;
        std::string_view bytes;
        if (const Json* const uri = described->find("uri"); uri != nullptr && uri->is_string()) {
            const std::size_t comma = uri->as_string().find(";base64,");
            if (uri->as_string().starts_with("data:")) {
                std::optional<std::string> decoded;
                if (comma != std::string::npos)
                    decoded = from_base64(std::string_view(uri->as_string()).substr(comma + 8));
                if (!decoded) return missing("its data URI is not base64");
                held = std::move(*decoded);
            } else {
                if (!options_.read_beside) return missing("files beside the scene are not read");
                Result<std::string> read = options_.read_beside(unescaped(uri->as_string()));
                if (!read)
                    return missing(read.error().diagnostics.empty() ? "" : read.error().diagnostics.back().message);
                held = std::move(*read);
            }
            bytes = held;
        } else {
            if (!document_.is_binary || document_.binary.empty()) return missing("the file has no binary chunk");
            bytes = document_.binary;
        }
        if (*offset > bytes.size() || *length > bytes.size() - *offset)
            return wrong_in("SCN0103", element,
                            fmt::format("bytes {} to {} of a buffer of {}", *offset, *offset + *length, bytes.size()));
        return std::string(bytes.substr(*offset, *length));
    }

    Result<void> read_area(FoundLight& light, GltfElement element) {
        Result<Json> json = parsed(element);
        if (!json) return pass_on(json);
        static_cast<void>(take_name(light, *json));
        const Json* const type = json->find("type");
        light.kind = type != nullptr && type->is_string() ? type->as_string().substr(0, 40) : "rect";
        Result<double> nits = number(*json, json->contains("luminance") ? "luminance" : "intensity", 1000.0, element);
        if (!nits) return pass_on(nits);
        Result<glm::dvec3> color = color_of(*json, element);
        if (!color) return pass_on(color);
        Result<double> size = number(*json, "size", 1.0, element);
        if (!size) return pass_on(size);
        double aspect = 1.0;
        if (const Json* const rect = json->find("rect"); rect != nullptr && rect->is_object()) {
            Result<double> read = number(*rect, "aspect", 1.0, element);
            if (!read) return pass_on(read);
            aspect = *read;
        }
        light.stated_amount = *nits;
        light.stated = fmt::format("intensity {}", rounded(*nits));
        if (*color != glm::dvec3(1.0)) light.stated += fmt::format(", color {}", numbers_text(*color));
        light.intensity = amount(*nits * take_color(light, *color), "nt");
        if (!(*size > 0.0) || !(aspect > 0.0)) {
            only_list(light, "its size is not above 0");
            return {};
        }
        if (light.kind == "rect")
            light.shape = RectShape{Meters(*size * aspect), Meters(*size)};
        else if (light.kind == "disk")
            light.shape = DiskShape{Meters(0.5 * *size)};
        else
            only_list(light, fmt::format("EXT_lights_area has no light '{}'", light.kind));
        return {};
    }

    // Which materials glow, and how.
    Result<void> read_glowing() {
        if (!index_.any_emission) return {};
        for (const GltfElement element : index_.materials) {
            Result<Json> json = parsed(element);
            if (!json) return pass_on(json);
            std::array<double, 3> factor{};
            if (Result<void> read = numbers(*json, "emissiveFactor", 3, factor.data(), element); !read) return read;
            double strength = 1.0;
            const Json* const extensions = json->find("extensions");
            if (extensions != nullptr && extensions->is_object())
                if (const Json* const own = extensions->find("KHR_materials_emissive_strength"); own != nullptr) {
                    Result<double> read = number(*own, "emissiveStrength", 1.0, element);
                    if (!read) return pass_on(read);
                    strength = *read;
                }
            glowing_.push_back(strength * glm::dvec3(factor[0], factor[1], factor[2]));
        }
        index_.any_emission =
            std::any_of(glowing_.begin(), glowing_.end(), [](const glm::dvec3& rgb) { return rgb != glm::dvec3(0.0); });
        return {};
    }

    Result<void> read_mesh(const FoundLight& base, std::uint32_t at) {
        const std::uint32_t mesh = index_.nodes[at].mesh;
        if (mesh >= index_.meshes.size()) return wrong("SCN0103", at, fmt::format("there is no mesh {}", mesh));
        glows_.resize(index_.meshes.size(), unknown);
        if (glows_[mesh] == no) return {};
        glows_[mesh] = no;
        const GltfElement element = index_.meshes[mesh];
        Result<Json> json = parsed(element);
        if (!json) return pass_on(json);
        const Json* const primitives = json->find("primitives");
        if (primitives == nullptr || !primitives->is_array()) return {};
        for (const Json& primitive : *primitives) {
            const Json* const material = primitive.find("material");
            if (material == nullptr || !material->is_unsigned()) continue;
            if (material->as_uint64() >= glowing_.size())
                return wrong_in(
                    "SCN0103", element,
                    fmt::format("there is no material {}, only {}", material->as_uint64(), glowing_.size()));
            const glm::dvec3 rgb = glowing_[static_cast<std::size_t>(material->as_uint64())];
            if (rgb == glm::dvec3(0.0)) continue;
            glows_[mesh] = yes;
            FoundLight light = base;
            light.kind = "mesh";
            light.index = mesh;
            light.stated = fmt::format("emission {}", numbers_text(rgb));
            light.stated_amount = std::max({rgb.x, rgb.y, rgb.z});
            take_color(light, rgb);
            const Json* const attributes = primitive.find("attributes");
            const Json* const position = attributes != nullptr ? attributes->find("POSITION") : nullptr;
            if (position != nullptr && (!position->is_unsigned() || position->as_uint64() >= index_.accessors.size()))
                return wrong_in(
                    "SCN0103", element,
                    fmt::format("there is no accessor {}, only {}", position->dump(), index_.accessors.size()));
            only_list(light, "a mesh that glows: glTF says nits, but most files have numbers without a unit",
                      "emissiveFactor × emissiveStrength is listed as stated");
            scene_.lights.push_back(std::move(light));
        }
        return {};
    }

    const GltfDocument& document_;
    GltfIndex& index_;
    const SceneReadOptions& options_;
    LinePlaces places_;
    FoundScene scene_;
    char up_ = 'y';
    static constexpr char unknown = 0;
    static constexpr char yes = 1;
    static constexpr char no = 2;
    std::vector<char> shown_;         // by node
    std::vector<char> glows_;         // by mesh
    std::vector<glm::dvec3> glowing_; // by material
    std::unordered_map<std::uint32_t, glm::dmat4> worlds_;
    std::unordered_map<std::size_t, std::size_t> inside_; // profiles by the index of EXT_lights_ies
};

} // namespace

Result<GltfDocument> gltf_document(std::string_view bytes, const std::string& source) {
    GltfDocument document;
    if (!bytes.starts_with(glb_magic)) {
        document.json = bytes;
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (bytes.starts_with(byte_order_mark)) document.json.remove_prefix(byte_order_mark.size());
        return document;
    }
    document.is_binary = true;
    constexpr std::size_t header = 12;
    constexpr std::size_t chunk_header = 8;
    if (bytes.size() < header) return glb_error(source, bytes.size(), "the file ends within its header");
    if (u32_at(bytes, 4) != 2)
        return glb_error(source, 4, fmt::format("version {} of the container, gonio reads 2", u32_at(bytes, 4)));
    const std::size_t length = u32_at(bytes, 8);
    if (length > bytes.size())
        return glb_error(source, bytes.size(),
                         fmt::format("the file ends here, and its header announces {} bytes", length));
    bytes = bytes.substr(0, length);
    document.container = bytes;
    for (std::size_t at = header; at + chunk_header <= bytes.size();) {
        const std::size_t size = u32_at(bytes, at);
        const std::string_view type = bytes.substr(at + 4, 4);
        if (size > bytes.size() - at - chunk_header)
            return glb_error(source, at, fmt::format("a chunk of {} bytes does not fit into the file", size));
        const std::string_view data = bytes.substr(at + chunk_header, size);
        if (at == header) {
            if (type != "JSON") return glb_error(source, at, "the first chunk is not JSON");
            document.json = data;
        } else if (type == std::string_view("BIN\0", 4) && document.binary.empty()) {
            document.binary = data;
        }
        at += chunk_header + size;
    }
    if (document.json.empty()) return glb_error(source, header, "there is no JSON chunk");
    return document;
}

bool is_gltf(std::string_view bytes) {
    if (bytes.starts_with(glb_magic)) return true;
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
    const std::string_view text = trimmed(bytes);
    return text.starts_with('{') && text.find("\"asset\"") != std::string_view::npos;
}

Result<FoundScene> read_gltf(std::string_view bytes, const std::string& source, const SceneReadOptions& options) {
    Result<GltfDocument> document = gltf_document(bytes, source);
    if (!document) return pass_on(document);
    Result<GltfIndex> index = gltf_index(document->json, source);
    if (!index) return pass_on(index);
    return GltfReader(*document, *index, source, options).read();
}

} // namespace gonio::interchange_detail
