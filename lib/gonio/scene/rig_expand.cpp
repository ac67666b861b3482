#include <gonio/base/frame.hpp>
#include <gonio/base/kind_text.hpp>
#include <gonio/base/limits.hpp>
#include <gonio/base/nearest.hpp>
#include <gonio/base/unit_text.hpp>
#include <gonio/scene/detail/rig_expand.hpp>
#include <gonio/scene/detail/rig_values.hpp>
#include <gonio/scene/rig.hpp>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace gonio::detail {

namespace {

constexpr std::array<std::string_view, 8> luminaire_keys{"shape",  "intensity", "color",   "rotate",
                                                         "smooth", "range",     "dimming", "maintenance"};
constexpr std::array<std::string_view, 9> group_keys{"name",   "lights", "position", "positions",  "up",
                                                     "rotate", "array",  "dimming",  "maintenance"};
constexpr std::array<std::string_view, 3> array_keys{"count", "spacing", "room"};
constexpr std::array<std::string_view, 7> placing_keys{"name",   "luminaire", "position", "positions",
                                                       "target", "direction", "up"};

Result<void> check_keys(const Json& json, std::span<const std::string_view> known) {
    for (const auto& [key, value] : json.items())
        if (std::find(known.begin(), known.end(), key) == known.end()) return unknown_name("key", key, known);
    return {};
}

// Saturates: three counts within their limits are too many for 32 bits.
std::size_t product(std::size_t a, std::size_t b) {
    return a != 0 && b > SIZE_MAX / a ? SIZE_MAX : a * b;
}

// Copies along X, Y and Z, centred.
struct Array {
    std::array<std::size_t, 3> count{1, 1, 1};
    glm::dvec3 spacing{0.0}; // [m]

    std::size_t size() const { return product(count[0], product(count[1], count[2])); }
    glm::dvec3 offset(const std::array<std::size_t, 3>& at) const {
        glm::dvec3 offset(0.0);
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (count[axis] > 1)
                offset[static_cast<int>(axis)] =
                    (static_cast<double>(at[axis]) - 0.5 * static_cast<double>(count[axis] - 1)) *
                    spacing[static_cast<int>(axis)];
        return offset;
    }
};

// A light or a group, its values read.
struct Node {
    WrittenLight written;    // of a light; its path is that of a group, too
    std::vector<Node> nodes; // of a group, at least one
    std::string name;
    bool is_named = false;
    glm::dvec3 position{0.0};
    std::vector<glm::dvec3> positions; // instead, if not empty
    std::optional<Array> array;
    std::optional<glm::dvec3> direction;
    std::optional<glm::dvec3> target;
    std::optional<glm::dvec3> up;
    double turn = 0.0; // of a group [rad]
    double dimming = 1.0;
    double maintenance = 1.0;
    std::size_t lights = 1; // that it makes

    bool is_group() const { return !nodes.empty(); }
    bool makes_lights() const { return is_group() || array || !positions.empty(); }
};

class NodeReader {
public:
    NodeReader(const std::string& source, const Luminaires& luminaires) : source_(source), luminaires_(luminaires) {}

    // The element with this index in its list.
    Result<Node> read(const Json& json, std::string path, std::size_t index) {
        Node node;
        node.written.path = std::move(path);
        const std::string& place = node.written.path;
        if (!json.is_object())
            return at(place, rig_value_error("RIG0105", fmt::format("must be an object, not {}", type_of(json))));
        const bool is_group = json.contains("lights");
        const std::span<const std::string_view> known =
            is_group ? std::span<const std::string_view>(group_keys) : rig_light_keys();
        if (is_group)
            if (Result<void> keys = check_group(json); !keys) return at(place, keys);
        if (Result<void> keys = check_keys(json, known); !keys) return at(place, keys);
        for (const auto& [one, other] : excluding)
            if (json.contains(other) && json.contains(one))
                return at(place, rig_value_error("RIG0107", fmt::format("has both '{}' and '{}'", one, other),
                                                 fmt::format("leave one of them out")));
        for (const auto& [key, value] : json.items())
            if (Result<void> read = read_value(key, value, node); !read)
                return at(fmt::format("{}.{}", place, key), read);
        if (const Json* const array = json.find("array"))
            if (Result<void> read = read_array(*array, node); !read) return pass_on(read);
        if (const Json* const lights = json.find("lights"))
            if (Result<void> read = read_lights(*lights, node); !read) return pass_on(read);
        if (!is_group) {
            node.written.keys = &json;
            node.written.number = written_++;
        }
        if (!node.is_named)
            node.name = is_group ? fmt::format("group {}", index + 1) : usual_name(node.written.luminaire, index);
        node.lights = product(
            node.lights, product(std::max<std::size_t>(node.positions.size(), 1), node.array ? node.array->size() : 1));
        return node;
    }

private:
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 3> excluding{
        {{"position", "positions"}, {"direction", "target"}, {"shape", "luminaire"}}};

    Unexpected at(const std::string& path, const Unexpected& reason) const {
        return placed(reason.value(), source_, path);
    }
    Unexpected at(const std::string& path, const Result<void>& failed) const {
        return placed(failed.error(), source_, path);
    }

    // A key of a light in a group is not a typo.
    static Result<void> check_group(const Json& json) {
        for (const auto& [key, value] : json.items())
            if (std::find(group_keys.begin(), group_keys.end(), key) == group_keys.end() &&
                std::find(rig_light_keys().begin(), rig_light_keys().end(), key) != rig_light_keys().end())
                return rig_value_error("RIG0107", fmt::format("has both 'lights' and '{}'", key),
                                       fmt::format("a group has lights: give '{}' to each of them", key));
        return {};
    }

    Result<void> read_value(const std::string& key, const Json& value, Node& node) {
        if (key == "name") {
            node.is_named = true;
            return keep(name_of(value), node.name);
        }
        if (key == "luminaire") return read_luminaire(value, node);
        if (key == "position") return keep(position_of(value), node.position);
        if (key == "positions") return read_positions(value, node);
        if (key == "direction") return keep(nonzero_vector_of(value), node.direction);
        if (key == "target") return keep(position_of(value), node.target);
        if (key == "up") return keep(nonzero_vector_of(value), node.up);
        if (key == "rotate") return keep(angle_of(value), node.turn);
        if (key == "dimming") return keep(share_of(value), node.dimming);
        if (key == "maintenance") return keep(maintenance_of(value), node.maintenance);
        return {};
    }

    Result<void> read_luminaire(const Json& json, Node& node) const {
        Result<std::string> name = text_of(json, R"(for example "A", a name of the rig's "luminaires")");
        if (!name) return pass_on(name);
        if (const auto found = luminaires_.find(*name); found != luminaires_.end()) {
            node.written.luminaire = &found->second;
            return {};
        }
        if (luminaires_.empty())
            return rig_value_error("RIG0103", fmt::format("unknown luminaire '{}'", *name),
                                   R"(the rig has no "luminaires": write "luminaires": { "A": { "shape": … } })");
        std::vector<std::string_view> names;
        for (const auto& [known, luminaire] : luminaires_)
            names.push_back(known);
        constexpr std::size_t most_listed = 40;
        if (names.size() <= most_listed) return unknown_name("luminaire", *name, names);
        const std::string_view near = nearest(*name, names);
        return rig_value_error("RIG0103", fmt::format("unknown luminaire '{}'", *name),
                               near.empty() ? fmt::format("the rig has {} others", names.size())
                                            : fmt::format("did you mean '{}'?", near));
    }

    static Result<void> read_positions(const Json& json, Node& node) {
        if (!json.is_array() || json.empty())
            return rig_value_error("RIG0105", "must be an array of at least one position",
                                   "for example [[0, 0, 2.5], [1, 0, 2.5]]");
        for (const Json& each : json) {
            Result<glm::dvec3> position = position_of(each);
            if (!position) {
                Diagnostic& reason = position.error().diagnostics.back();
                reason.message = fmt::format("position {} {}", node.positions.size() + 1, reason.message);
                return pass_on(position);
            }
            node.positions.push_back(*position);
        }
        return {};
    }

    Result<void> read_array(const Json& json, Node& node) const {
        const std::string path = node.written.path + ".array";
        const auto refuse = [&](std::string_view key, RigCode code, std::string message, std::string hint = {}) {
            return rig_error(code, source_, fmt::format("{}{}", path, key), std::move(message), std::move(hint));
        };
        constexpr std::string_view example = R"(for example { "count": [3, 4], "spacing": [2.4, 1.8] })";
        if (!json.is_object())
            return refuse("", "RIG0105", fmt::format("must be an object, not {}", type_of(json)), std::string(example));
        if (Result<void> keys = check_keys(json, array_keys); !keys) return at(path, keys);
        const Json* const count = json.find("count");
        const Json* const spacing = json.find("spacing");
        const Json* const room = json.find("room");
        if (count == nullptr) return refuse("", "RIG0104", "the key 'count' is missing", std::string(example));
        if (spacing != nullptr && room != nullptr)
            return refuse("", "RIG0107", "has both 'spacing' and 'room'",
                          "the room divided by the count is the spacing");
        Array array;
        if (!count->is_array() || count->size() < 2 || count->size() > 3)
            return refuse(
                ".count", "RIG0105",
                fmt::format("must be an array of two or three whole numbers, not {}",
                            count->is_array() ? fmt::format("of {}", count->size()) : std::string(type_of(*count))),
                "along X, Y and Z, for example [3, 4] or [3, 4, 1]");
        for (std::size_t axis = 0; axis < count->size(); ++axis) {
            const Json& number = (*count)[axis];
            const bool is_whole =
                number.is_number() && number.as_double() >= 1.0 && number.as_double() == std::floor(number.as_double());
            if (!is_whole)
                return refuse(fmt::format(".count[{}]", axis), number.is_number() ? RigCode("RIG0106") : "RIG0105",
                              fmt::format("must be a whole number from 1, not {}",
                                          number.is_number() ? number.dump() : std::string(type_of(number))));
            if (number.as_double() > static_cast<double>(limit("rig-array").value))
                return refuse(fmt::format(".count[{}]", axis), "RIG0108",
                              fmt::format("makes more than {}", to_text(limit("rig-array"))), std::string(limits_hint));
            array.count[axis] = static_cast<std::size_t>(number.as_double());
        }
        if (room != nullptr) {
            Result<glm::dvec3> size = lengths_of(*room, 2);
            if (!size) return at(path + ".room", Unexpected(size.error()));
            for (int axis = 0; axis < 2; ++axis)
                if (!((*size)[axis] > 0.0))
                    return refuse(fmt::format(".room[{}]", axis), "RIG0106", "must be greater than 0");
            if (array.count[2] > 1)
                return refuse(".count[2]", "RIG0106", "must be 1 with 'room', which has no height",
                              "use 'spacing' for several levels");
            for (int axis = 0; axis < 2; ++axis)
                array.spacing[axis] = (*size)[axis] / static_cast<double>(array.count[static_cast<std::size_t>(axis)]);
        } else if (spacing != nullptr) {
            Result<glm::dvec3> distances = lengths_of(*spacing, 3);
            if (!distances) return at(path + ".spacing", Unexpected(distances.error()));
            array.spacing = *distances;
            for (std::size_t axis = 0; axis < spacing->size(); ++axis)
                if (array.count[axis] > 1 && !(array.spacing[static_cast<int>(axis)] > 0.0))
                    return refuse(fmt::format(".spacing[{}]", axis), "RIG0106",
                                  fmt::format("must be greater than 0 where the count is {}", array.count[axis]));
            if (spacing->size() < 3 && array.count[2] > 1)
                return refuse(".spacing", "RIG0104",
                              fmt::format("has no number along Z, where the count is {}", array.count[2]),
                              "for example [2.4, 1.8, 0.5]");
        } else if (array.size() > 1) {
            return refuse("", "RIG0104", "the key 'spacing' is missing",
                          R"(metres from centre to centre, for example "spacing": [2.4, 1.8], or "room": [7.2, 7.2])");
        }
        node.array = array;
        return {};
    }

    // Two numbers, or as many as three.
    static Result<glm::dvec3> lengths_of(const Json& json, std::size_t most) {
        const bool is_size = json.is_array() && json.size() >= 2 && json.size() <= most;
        glm::dvec3 lengths(0.0);
        for (std::size_t i = 0; is_size && i < json.size(); ++i) {
            if (!json[i].is_number())
                return rig_value_error("RIG0105", fmt::format("must hold numbers, not {}", type_of(json[i])),
                                       "in metres, for example [2.4, 1.8]");
            lengths[static_cast<int>(i)] = json[i].as_double();
        }
        if (!is_size)
            return rig_value_error(
                "RIG0105",
                fmt::format("must be an array of {} numbers, not {}", most == 2 ? "two" : "two or three",
                            json.is_array() ? fmt::format("of {}", json.size()) : std::string(type_of(json))),
                "in metres, for example [2.4, 1.8]");
        if (!glm::all(glm::lessThanEqual(glm::abs(lengths), glm::dvec3(farthest_m))))
            return rig_value_error("RIG0106", fmt::format("must lie within {} m", farthest_m));
        return lengths;
    }

    Result<void> read_lights(const Json& json, Node& node) { // NOLINT(misc-no-recursion): as deep as rig-depth
        const std::string path = node.written.path + ".lights";
        if (!json.is_array() || json.empty())
            return rig_error("RIG0104", source_, path, "must be an array of at least one light",
                             R"(for example [ { "shape": "point", "intensity": "800lm" } ])");
        node.lights = 0;
        for (std::size_t i = 0; i < json.size(); ++i) {
            Result<Node> inner = read(json[i], fmt::format("{}[{}]", path, i), i);
            if (!inner) return pass_on(inner);
            node.lights = inner->lights > SIZE_MAX - node.lights ? SIZE_MAX : node.lights + inner->lights;
            node.nodes.push_back(std::move(*inner));
        }
        return {};
    }

    const std::string& source_;
    const Luminaires& luminaires_;
    std::size_t written_ = 0;
};

// A group's copy in the frame of the rig.
struct Placement {
    Frame frame;
    bool is_turned = false;
    std::string names; // of the groups around, each with a slash
    double dimming = 1.0;
    double maintenance = 1.0;

    glm::dvec3 point(const glm::dvec3& local) const {
        return is_turned ? frame.origin + frame.to_world(local) : frame.origin + local;
    }
};

class Maker {
public:
    Maker(const std::string& source, const SingleLightSink& sink, bool repeated)
        : source_(source), sink_(sink), repeated_(repeated) {}

    // The copies of a node, which number themselves where there are several.
    Result<void> make(const Node& node, const Placement& around) { // NOLINT(misc-no-recursion): as deep as rig-depth
        if (node.positions.empty()) return rows(node, around, node.position, {});
        for (std::size_t p = 0; p < node.positions.size(); ++p)
            if (Result<void> made = rows(node, around, node.positions[p], fmt::format("[{}]", p + 1)); !made)
                return made;
        return {};
    }

private:
    // The array around one position, or the one light there.
    // NOLINTNEXTLINE(misc-no-recursion): as deep as rig-depth
    Result<void> rows(const Node& node, const Placement& around, const glm::dvec3& at, const std::string& number) {
        if (!node.array) return one(node, around, at, number);
        const Array& array = *node.array;
        for (std::size_t k = 0; k < array.count[2]; ++k)
            for (std::size_t j = 0; j < array.count[1]; ++j)
                for (std::size_t i = 0; i < array.count[0]; ++i) {
                    const std::string in_rows = array.count[2] > 1
                                                    ? fmt::format("{}[{},{},{}]", number, i + 1, j + 1, k + 1)
                                                    : fmt::format("{}[{},{}]", number, i + 1, j + 1);
                    if (Result<void> made = one(node, around, at + array.offset({i, j, k}), in_rows); !made)
                        return made;
                }
        return {};
    }

    // NOLINTNEXTLINE(misc-no-recursion): as deep as rig-depth
    Result<void> one(const Node& node, const Placement& around, const glm::dvec3& at, const std::string& number) {
        if (!node.is_group()) return light(node, around, at, number);
        Placement inner = around;
        inner.frame.origin = around.point(at);
        if (node.up || node.turn != 0.0) {
            // As a box: its Z axis along `up`, turned about that.
            const Frame upright = aimed_frame({}, -node.up.value_or(glm::dvec3(0.0, 0.0, 1.0)), {0.0, 1.0, 0.0});
            // Of a quarter turn exactly, so that positions stay round numbers.
            const auto round = [](double value) { return std::abs(value) < 1e-15 ? 0.0 : value; };
            const double c = round(std::cos(node.turn));
            const double s = round(std::sin(node.turn));
            inner.frame.x = around.frame.to_world(c * upright.x + s * upright.y);
            inner.frame.y = around.frame.to_world(c * upright.y - s * upright.x);
            inner.frame.z = around.frame.to_world(upright.z);
            inner.is_turned = true;
        }
        if (node.is_named || !number.empty()) inner.names += fmt::format("{}{}/", node.name, number);
        inner.dimming *= node.dimming;
        inner.maintenance *= node.maintenance;
        for (const Node& each : node.nodes)
            if (Result<void> made = make(each, inner); !made) return made;
        return {};
    }

    Result<void> light(const Node& node, const Placement& around, const glm::dvec3& at, const std::string& number) {
        SingleLight light{node.written, repeated_,
                          around.names.empty() && number.empty() ? node.name : around.names + node.name + number};
        light.position = around.point(at);
        if (!glm::all(glm::lessThanEqual(glm::abs(light.position), glm::dvec3(farthest_m))))
            return rig_error("RIG0106", source_, node.written.path,
                             fmt::format("places '{}' farther away than {} m", light.name, farthest_m));
        if (node.target && *node.target == at)
            return rig_error("RIG0106", source_, node.written.path + ".target",
                             fmt::format("is at the position of '{}', so there is no direction to it", light.name),
                             "move one of them, or give a direction");
        light.direction = node.direction;
        light.up = node.up;
        if (node.target) light.target = around.point(*node.target);
        if (around.is_turned) {
            const glm::dvec3 direction =
                node.target ? *node.target - at : node.direction.value_or(LightDescription().direction);
            const Frame local = aimed_frame({}, direction, node.up.value_or(LightDescription().up));
            if (!node.target) light.direction = -around.frame.to_world(local.z);
            light.up = around.frame.to_world(local.y);
        }
        const Luminaire* const luminaire = node.written.luminaire;
        light.dimming = around.dimming * node.dimming * (luminaire != nullptr ? luminaire->dimming : 1.0);
        light.maintenance =
            around.maintenance * node.maintenance * (luminaire != nullptr ? luminaire->maintenance : 1.0);
        return sink_(light);
    }

    const std::string& source_;
    const SingleLightSink& sink_;
    bool repeated_;
};

} // namespace

Result<double> share_of(const Json& json) {
    constexpr std::string_view hint = R"(write 0.8 or "80%")";
    double share = 0.0;
    if (json.is_number()) {
        share = json.as_double();
    } else {
        Result<std::string> text = text_of(json, std::string(hint));
        if (!text) return pass_on(text);
        const std::optional<double> percent =
            text->ends_with('%') ? parse_number(std::string_view(*text).substr(0, text->size() - 1)) : std::nullopt;
        if (!percent) return rig_value_error("RIG0106", fmt::format("does not take '{}'", *text), std::string(hint));
        share = *percent / 100.0;
    }
    if (share >= 0.0 && share <= 1.0) return share;
    return rig_value_error(
        "RIG0106",
        fmt::format("must lie in 0 to 1, or 0% to 100%, not {}", json.is_number() ? json.dump() : json.as_string()),
        json.is_number() && share > 1.0 && share <= 100.0 ? fmt::format("write {} or \"{}%\"", share / 100.0, share)
                                                          : std::string());
}

Result<double> maintenance_of(const Json& json) {
    Result<double> share = share_of(json);
    if (share && !(*share > 0.0))
        return rig_value_error("RIG0106", "must be greater than 0", "dimming switches lights off");
    return share;
}

std::string usual_name(const Luminaire* luminaire, std::size_t index) {
    return fmt::format("{} {}", luminaire != nullptr ? std::string_view(luminaire->name) : "light", index + 1);
}

Result<Luminaires> read_luminaires(const Json& json, const std::string& source) {
    if (!json.is_object())
        return rig_error("RIG0105", source, "luminaires", fmt::format("must be an object, not {}", type_of(json)),
                         R"(for example { "A": { "shape": "ies:lamp.ies" } })");
    Luminaires luminaires;
    for (const auto& [name, keys] : json.items()) {
        Luminaire luminaire{name, keys};
        const std::string path = fmt::format("luminaires.{}", name);
        const Result<std::string> sound = name_of(name);
        if (!sound) return placed(sound.error(), source, "luminaires");
        if (!keys.is_object())
            return rig_error("RIG0105", source, path, fmt::format("must be an object, not {}", type_of(keys)));
        for (const auto& [key, value] : keys.items())
            if (places_light(key))
                return rig_error("RIG0106", source, path, fmt::format("'{}' is for a light", key),
                                 "a luminaire has no place: the lights that name it have one");
        if (Result<void> known = check_keys(keys, luminaire_keys); !known) return placed(known.error(), source, path);
        if (const Json* const value = keys.find("dimming"))
            if (Result<void> read = keep(share_of(*value), luminaire.dimming); !read)
                return placed(read.error(), source, path + ".dimming");
        if (const Json* const value = keys.find("maintenance"))
            if (Result<void> read = keep(maintenance_of(*value), luminaire.maintenance); !read)
                return placed(read.error(), source, path + ".maintenance");
        luminaires.emplace(name, std::move(luminaire));
    }
    return luminaires;
}

Result<void> RigExpander::expand(const Json& json, std::size_t index, const SingleLightSink& sink) {
    Result<Node> node = NodeReader(source_, luminaires_).read(json, fmt::format("lights[{}]", index), index);
    if (!node) return pass_on(node);
    const auto beyond = [&](const Limit& limit) {
        return rig_error("RIG0108", source_, node->written.path, fmt::format("makes more than {}", to_text(limit)),
                         std::string(limits_hint));
    };
    if (node->makes_lights()) {
        if (node->lights > limit("rig-array").value - made_) return beyond(limit("rig-array"));
        made_ += node->lights;
    }
    if (node->lights > limit("rig-lights").value - lights_) return beyond(limit("rig-lights"));
    lights_ += node->lights;
    return Maker(source_, sink, node->makes_lights()).make(*node, {});
}

bool RigExpander::count_single() {
    if (lights_ >= limit("rig-lights").value) return false;
    ++lights_;
    return true;
}

std::span<const std::string_view> rig_luminaire_keys() {
    return luminaire_keys;
}
std::span<const std::string_view> rig_group_keys() {
    return group_keys;
}
std::span<const std::string_view> rig_array_keys() {
    return array_keys;
}

bool places_light(std::string_view key) {
    return key == "array" || std::find(placing_keys.begin(), placing_keys.end(), key) != placing_keys.end();
}

} // namespace gonio::detail
