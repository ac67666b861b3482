// Groups, arrays, lists of positions and named luminaires among the lights of a rig, expanded to single lights.
//
// The order is that of the file. An array counts along X first, then along Y, then along Z; a list of positions is the
// outer loop of an array; each copy of a group gives its lights in their order.
#pragma once

#include <gonio/base/json.hpp>
#include <gonio/base/result.hpp>

#include <glm/vec3.hpp>

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gonio::detail {

// A luminaire that lights of the rig name: the keys of a light other than those that place it.
struct Luminaire {
    std::string name;
    Json keys;
    double dimming = 1.0;
    double maintenance = 1.0;
};
using Luminaires = std::map<std::string, Luminaire, std::less<>>; // by name

// Reads the value of the rig's key "luminaires": keys, dimming and maintenance; the other values are left to the
// reader of lights.
Result<Luminaires> read_luminaires(const Json& json, const std::string& source);

// The name of a light without one: "A 3", or "light 3" without a luminaire. The index counts from 0 in its list.
std::string usual_name(const Luminaire* luminaire, std::size_t index);

// A light as written.
struct WrittenLight {
    const Json* keys = nullptr;
    std::string path; // "lights[2].lights[0]"
    const Luminaire* luminaire = nullptr;
    std::size_t number = 0; // from 0, among those of one element of the rig's "lights"
};

// One of the lights that a written one stands for, in the frame of the rig.
struct SingleLight {
    const WrittenLight& written;
    bool repeated = false; // an array, a list of positions or a group has made it
    std::string name;
    glm::dvec3 position{0.0};
    std::optional<glm::dvec3> direction{}; // absent: the default, or towards the target
    std::optional<glm::dvec3> target{};    // is not at the position
    std::optional<glm::dvec3> up{};
    double dimming = 1.0; // of the light, its luminaire and its groups
    double maintenance = 1.0;
};

using SingleLightSink = std::function<Result<void>(const SingleLight& light)>;

class RigExpander {
public:
    // The arguments must outlive it.
    RigExpander(const std::string& source, const Luminaires& luminaires) : source_(source), luminaires_(luminaires) {}

    // The lights of an element of the rig's "lights", which has this index there. Fails as reading a rig does, and with
    // RIG0108, before any light is made, if the rig would have more than the limits rig-lights and rig-array.
    Result<void> expand(const Json& json, std::size_t index, const SingleLightSink& sink);

    // Counts one more light, which is not repeated. False: the rig would have more than the limit rig-lights.
    bool count_single();

private:
    const std::string& source_;
    const Luminaires& luminaires_;
    std::size_t lights_ = 0; // so far
    std::size_t made_ = 0;   // of them, by arrays, lists of positions and groups
};

// A share from 0 to 1: a number, or a percentage as text.
Result<double> share_of(const Json& json);
// The same, greater than 0.
Result<double> maintenance_of(const Json& json);

// The keys of a luminaire, a group and an array.
std::span<const std::string_view> rig_luminaire_keys();
std::span<const std::string_view> rig_group_keys();
std::span<const std::string_view> rig_array_keys();

// The keys of a light that say where it is and how often.
bool places_light(std::string_view key);

} // namespace gonio::detail
