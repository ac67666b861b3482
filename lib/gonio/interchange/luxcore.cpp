// LuxCore scenes: properties, "scene.lights.NAME.KEY = VALUE". A light with `power` W and `efficency` (LuxCore's
// spelling) lm/W emits their product in lumens; without them `gain` times the colour is a number of LuxCore's own. A
// material glows by emission times its gain, or by its power. Transformations list columns. LuxCore states neither a
// unit of length nor an upward axis; both are metres and Z in its own scenes.
#include <gonio/base/limits.hpp>
#include <gonio/base/text.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/interchange/detail/reading.hpp>
#include <gonio/light/light_color.hpp>

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

namespace gonio::interchange_detail {

namespace {

// The properties of one light, material, shape or object.
struct Item {
    std::size_t offset = 0;
    std::map<std::string, std::string_view, std::less<>> values;

    std::string_view text(std::string_view key) const {
        const auto found = values.find(key);
        if (found == values.end()) return {};
        std::string_view value = found->second;
        if (value.size() >= 2 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
        return value;
    }
};

using Items = std::vector<std::pair<std::string, Item>>; // in the order of the file

class LuxCoreReader {
public:
    LuxCoreReader(std::string_view text, const std::string& source, const SceneReadOptions& options)
        : text_(text), options_(options), source_(source), places_(text, source) {}

    Result<FoundScene> read() {
        scene_.meters_per_unit = options_.unit.value_or(Meters(1.0)).value;
        up_ = options_.up.value_or('z');
        if (Result<void> read = lines(); !read) return pass_on(read);
        for (const auto& [name, item] : groups_["lights"]) {
            FoundLight light = light_at(name, item);
            light.kind = item.text("type");
            if (Result<void> read = take_light(light, item); !read) return pass_on(read);
            scene_.lights.push_back(std::move(light));
        }
        for (const auto& [name, item] : groups_["objects"]) {
            const Item* const material = find("materials", item.text("material"));
            if (material == nullptr || material->text("emission").empty()) continue;
            FoundLight light = light_at(name, item);
            light.kind = "mesh";
            if (Result<void> read = take_mesh_light(light, item, *material); !read) return pass_on(read);
            scene_.lights.push_back(std::move(light));
        }
        if (!scene_.lights.empty() && (!options_.unit || !options_.up))
            warn(scene_, "SCN0201", {source_, 0, 0},
                 "LuxCore states neither a unit of length nor an upward axis: metres and Z up are assumed where no "
                 "option "
                 "says it",
                 "--unit-scale and --up say what they are");
        return std::move(scene_);
    }

private:
    Unexpected wrong(SceneCode code, std::size_t offset, std::string message) {
        return scene_error(code, places_.at(offset), std::move(message));
    }

    FoundLight light_at(const std::string& name, const Item& item) {
        FoundLight light;
        light.name = name;
        light.location = places_.at(item.offset);
        light.place = fmt::format("line {}", light.location.line);
        return light;
    }

    Result<void> lines() {
        std::map<std::string, std::size_t, std::less<>> known; // "lights.key": index in its group
        for (std::size_t at = 0; at < text_.size();) {
            const std::size_t end = std::min(text_.find('\n', at), text_.size());
            const std::string_view line = trimmed(text_.substr(at, end - at));
            const std::size_t offset = at;
            at = end + 1;
            if (line.empty() || line.starts_with('#')) continue;
            const std::size_t equals = line.find('=');
            if (equals == std::string_view::npos)
                return wrong("SCN0102", offset, "a property is expected: KEY = VALUE");
            std::string_view key = trimmed(line.substr(0, equals));
            constexpr std::string_view prefix = "scene.";
            if (!key.starts_with(prefix)) continue;
            key.remove_prefix(prefix.size());
            const std::size_t group_end = key.find('.');
            if (group_end == std::string_view::npos) continue;
            const std::string_view group = key.substr(0, group_end);
            if (group != "lights" && group != "materials" && group != "objects" && group != "shapes") continue;
            const std::size_t name_end = key.find('.', group_end + 1);
            if (name_end == std::string_view::npos) continue;
            const std::string_view whole = key.substr(0, name_end);
            Items& items = groups_[std::string(group)];
            auto found = known.find(whole);
            if (found == known.end()) {
                if (known.size() >= limit("scene-lights").value)
                    return wrong("SCN0108", offset, fmt::format("more than {}", to_text(limit("scene-lights"))));
                found = known.emplace(whole, items.size()).first;
                items.emplace_back(key.substr(group_end + 1, name_end - group_end - 1), Item{offset, {}});
            }
            items[found->second].second.values[std::string(key.substr(name_end + 1))] =
                trimmed(line.substr(equals + 1));
        }
        return {};
    }

    const Item* find(const std::string& group, std::string_view name) {
        auto& index = indices_[group];
        const Items& items = groups_[group];
        if (index.empty())
            for (std::size_t i = 0; i < items.size(); ++i)
                index[items[i].first] = i;
        const auto found = index.find(name);
        return found == index.end() ? nullptr : &items[found->second].second;
    }

    Result<std::vector<double>> numbers(const Item& item, std::string_view key, std::size_t count) {
        std::vector<double> values;
        std::string_view rest = item.text(key);
        while (!(rest = trimmed(rest)).empty()) {
            const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
            const std::optional<double> value = parse_number(rest.substr(0, end));
            if (!value)
                return wrong("SCN0105", item.offset,
                             fmt::format("'{}': '{}' is not a finite number", key,
                                         rest.substr(0, std::min<std::size_t>(end, 40))));
            values.push_back(*value);
            rest.remove_prefix(end);
        }
        if (count > 0 && !values.empty() && values.size() != count)
            return wrong("SCN0105", item.offset, fmt::format("'{}' must have {} numbers", key, count));
        return values;
    }

    Result<double> number(const Item& item, std::string_view key, double otherwise) {
        Result<std::vector<double>> values = numbers(item, key, 1);
        if (!values) return pass_on(values);
        return values->empty() ? otherwise : values->front();
    }

    Result<glm::dvec3> vector(const Item& item, std::string_view key, const glm::dvec3& otherwise) {
        Result<std::vector<double>> values = numbers(item, key, 3);
        if (!values) return pass_on(values);
        return values->empty() ? otherwise : glm::dvec3((*values)[0], (*values)[1], (*values)[2]);
    }

    Result<glm::dmat4> transformation(const Item& item) {
        Result<std::vector<double>> values = numbers(item, "transformation", 16);
        if (!values) return pass_on(values);
        glm::dmat4 world(1.0);
        for (std::size_t i = 0; i < values->size(); ++i)
            world[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = (*values)[i];
        return world;
    }

    Result<void> take_light(FoundLight& light, const Item& item) {
        Result<glm::dvec3> color = vector(item, "color", glm::dvec3(1.0));
        if (!color) return pass_on(color);
        Result<glm::dvec3> gain = vector(item, "gain", glm::dvec3(1.0));
        if (!gain) return pass_on(gain);
        Result<double> power = number(item, "power", 0.0);
        if (!power) return pass_on(power);
        Result<double> efficacy = number(item, "efficency", 0.0);
        if (!efficacy) return pass_on(efficacy);
        Result<double> by_color = number(item, "normalizebycolor", 0.0);
        if (!by_color) return pass_on(by_color);
        const double lumens = *power * *efficacy;
        const bool has_lumens = lumens > 0.0;
        light.stated_amount = has_lumens ? *power : gain->x;
        light.stated = has_lumens ? fmt::format("power {} at {} lm/W", rounded(*power), rounded(*efficacy))
                                  : fmt::format("gain {}", numbers_text(*gain));
        if (*color != glm::dvec3(1.0)) light.stated += fmt::format(", color {}", numbers_text(*color));
        const double luminance = take_color(light, *color * *gain);
        light.stated_color_max = 1.0;
        const double shining = has_lumens ? lumens * (*by_color != 0.0 ? 1.0 : luminance) : luminance;
        Result<glm::dmat4> world = transformation(item);
        if (!world) return pass_on(world);
        if (light.kind == "point" || light.kind == "sphere" || light.kind == "mappoint") {
            Result<glm::dvec3> position = vector(item, "position", glm::dvec3(0.0));
            if (!position) return pass_on(position);
            if (!has_lumens) {
                only_list(light, "without power and efficency its amount has no unit");
                return {};
            }
            *world = glm::translate(*world, *position);
            light.intensity = amount(shining, "lm");
            if (light.kind == "point") light.shape = PointShape{};
            if (light.kind == "sphere") {
                Result<double> radius = number(item, "radius", 1.0);
                if (!radius) return pass_on(radius);
                if (*radius > 0.0)
                    light.shape = SphereShape{Meters(*radius * scene_.meters_per_unit)};
                else
                    only_list(light, "its radius is not above 0");
            }
            if (light.kind == "mappoint") {
                ProfileShape profile;
                profile.file = item.text("iesfile");
                if (profile.file.empty()) {
                    only_list(light, "its intensities are a picture, which gonio does not read back");
                    return {};
                }
                if (item.text("flipz") != "1")
                    remark(light, "SCN0202", "without flipz its profile shines up: it is taken to shine down its −Z");
                light.shape = profile;
            }
            place_light(light, *world, {0.0, 0.0, -1.0}, {0.0, 1.0, 0.0}, up_, scene_.meters_per_unit);
        } else if (light.kind == "distant") {
            Result<double> theta = number(item, "theta", 10.0);
            if (!theta) return pass_on(theta);
            Result<glm::dvec3> direction = vector(item, "direction", glm::dvec3(0.0, 0.0, 1.0));
            if (!direction) return pass_on(direction);
            if (!(*theta > 0.0 && *theta <= 90.0)) {
                only_list(light, "its half angle is outside what a rig holds");
                return {};
            }
            light.shape = SunShape{degrees(2.0 * *theta)};
            light.intensity = amount(luminance, "nt");
            remark(light, "SCN0201", "its gain has no unit in LuxCore: it is taken as cd/m²");
            const glm::dvec3 up = std::abs(direction->y) < 0.99 * glm::length(*direction) ? glm::dvec3(0.0, 1.0, 0.0)
                                                                                          : glm::dvec3(1.0, 0.0, 0.0);
            place_light(light, *world, *direction, up, up_, scene_.meters_per_unit);
        } else if (light.kind == "infinite" || light.kind == "constantinfinite" || light.kind == "sky2" ||
                   light.kind == "sky") {
            only_list(light, "light from all around is the sky of a rig");
        } else {
            only_list(light, fmt::format("gonio does not read LuxCore's light '{}'", light.kind.substr(0, 40)));
        }
        return {};
    }

    Result<void> take_mesh_light(FoundLight& light, const Item& object, const Item& material) {
        const std::string_view emission = material.text("emission");
        light.stated = fmt::format("emission {}", emission.substr(0, 60));
        const bool is_color =
            !emission.empty() && emission.find_first_not_of("0123456789.+-eE \t") == std::string_view::npos;
        if (!is_color) {
            only_list(light, "its luminances are a texture, which gonio does not read back");
            return {};
        }
        Result<glm::dvec3> color = vector(material, "emission", glm::dvec3(1.0));
        if (!color) return pass_on(color);
        Result<glm::dvec3> gain = vector(material, "emission.gain", glm::dvec3(1.0));
        if (!gain) return pass_on(gain);
        Result<double> power = number(material, "emission.power", 0.0);
        if (!power) return pass_on(power);
        Result<double> efficacy = number(material, "emission.efficency", 0.0);
        if (!efficacy) return pass_on(efficacy);
        Result<double> theta = number(material, "emission.theta", 90.0);
        if (!theta) return pass_on(theta);
        light.stated += fmt::format(", gain {}", numbers_text(*gain));
        light.stated_amount = gain->x;
        const double luminance = take_color(light, *color * *gain);
        light.stated_color_max = 1.0;
        light.intensity = amount(luminance, "nt");
        if (*theta < 90.0) {
            only_list(light, "its emission has a cone");
            return {};
        }
        const Item* const shape = find("shapes", object.text("shape"));
        if (shape == nullptr)
            return wrong("SCN0103", object.offset,
                         fmt::format("there is no shape '{}'", object.text("shape").substr(0, 80)));
        if (shape->text("type") != "inlinedmesh") {
            only_list(light, fmt::format("its shape is a '{}'", shape->text("type").substr(0, 40)));
            return {};
        }
        // Objects may share a mesh: the work is bounded, not only the file.
        mesh_bytes_ += shape->text("vertices").size() + shape->text("faces").size();
        if (mesh_bytes_ > limit("scene-bytes").value)
            return wrong("SCN0108", object.offset,
                         fmt::format("the meshes of its objects hold more than {}", to_text(limit("scene-bytes"))));
        Result<glm::dmat4> world = transformation(object);
        if (!world) return pass_on(world);
        Result<std::vector<double>> vertices = numbers(*shape, "vertices", 0);
        if (!vertices) return pass_on(vertices);
        Result<std::vector<double>> indices = numbers(*shape, "faces", 0);
        if (!indices) return pass_on(indices);
        std::vector<glm::dvec3> points;
        for (std::size_t i = 0; i + 2 < vertices->size(); i += 3)
            points.push_back(
                glm::dvec3(*world * glm::dvec4((*vertices)[i], (*vertices)[i + 1], (*vertices)[i + 2], 1.0)) *
                scene_.meters_per_unit);
        std::vector<glm::ivec3> faces;
        for (std::size_t i = 0; i + 2 < indices->size(); i += 3) {
            glm::ivec3 face(0);
            for (int corner = 0; corner < 3; ++corner) {
                const double index = (*indices)[i + static_cast<std::size_t>(corner)];
                if (!(index >= 0.0 && index < static_cast<double>(points.size())))
                    return wrong("SCN0103", shape->offset,
                                 fmt::format("there is no vertex {}, only {}", rounded(index), points.size()));
                face[corner] = static_cast<int>(index);
            }
            faces.push_back(face);
        }
        take_mesh(light, points, faces, up_);
        if (!light.shape) return {};
        if (*power > 0.0 && *efficacy > 0.0) {
            light.stated_amount = *power;
            light.stated = fmt::format("power {} at {} lm/W", rounded(*power), rounded(*efficacy));
            light.intensity = amount(*power * *efficacy * (gain->x != 0.0 ? luminance : 0.0), "lm");
        } else if (*gain != glm::dvec3(1.0)) {
            remark(light, "SCN0201", "its gain has no unit in LuxCore: it is taken as cd/m²");
        }
        return {};
    }

    std::string_view text_;
    const SceneReadOptions& options_;
    const std::string& source_;
    LinePlaces places_;
    FoundScene scene_;
    std::map<std::string, Items> groups_;
    std::map<std::string, std::map<std::string, std::size_t, std::less<>>> indices_;
    std::uint64_t mesh_bytes_ = 0; // of all objects that glow
    char up_ = 'z';
};

} // namespace

bool is_luxcore(std::string_view bytes) {
    constexpr std::size_t looked_at = 65536;
    std::string_view rest = bytes.substr(0, looked_at);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = trimmed(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (line.empty() || line.starts_with('#')) continue;
        return line.starts_with("scene.") && line.find('=') != std::string_view::npos;
    }
    return false;
}

Result<FoundScene> read_luxcore(std::string_view bytes, const std::string& source, const SceneReadOptions& options) {
    return LuxCoreReader(bytes, source, options).read();
}

} // namespace gonio::interchange_detail
