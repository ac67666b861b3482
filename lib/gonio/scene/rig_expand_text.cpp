#include <gonio/scene/detail/rig_expand.hpp>
#include <gonio/scene/detail/rig_stream.hpp>
#include <gonio/scene/rig.hpp>

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gonio {

namespace {

using detail::Json;

Json vector_json(const glm::dvec3& vector) {
    return Json::array({vector.x, vector.y, vector.z});
}

// The light with the keys that place it replaced by those of one place.
Json light_json(const detail::SingleLight& single) {
    Json light = Json::object();
    light["name"] = single.name;
    constexpr std::array<std::string_view, 2> multiplied{"dimming", "maintenance"};
    const auto copy = [&](const Json& keys) {
        for (const auto& [key, value] : keys.items())
            if (!detail::places_light(key) && key != multiplied[0] && key != multiplied[1]) light[key] = value;
    };
    if (single.written.luminaire != nullptr) copy(single.written.luminaire->keys);
    copy(*single.written.keys);
    light["position"] = vector_json(single.position);
    if (single.target)
        light["target"] = vector_json(*single.target);
    else if (single.direction)
        light["direction"] = vector_json(*single.direction);
    if (single.up) light["up"] = vector_json(*single.up);
    if (single.dimming != 1.0) light["dimming"] = single.dimming;
    if (single.maintenance != 1.0) light["maintenance"] = single.maintenance;
    return light;
}

// All newlines of a dump are between values.
std::string indented(const Json& json) {
    std::string text;
    for (const char c : json.dump(2)) {
        text += c;
        if (c == '\n') text += "  ";
    }
    return text;
}

} // namespace

Result<std::string> expand_rig(std::string_view text, const std::string& source) {
    detail::Luminaires luminaires;
    const detail::RigSink find{[](std::size_t /*index*/, const Json& /*json*/) { return Result<void>(); },
                               [&](const std::string& key, const Json& json) -> Result<void> {
                                   if (key != "luminaires") return {};
                                   Result<detail::Luminaires> read = detail::read_luminaires(json, source);
                                   if (!read) return pass_on(read);
                                   luminaires = std::move(*read);
                                   return {};
                               }};
    if (Result<void> found = detail::stream_rig(text, source, find); !found) return pass_on(found);

    detail::RigExpander expander(source, luminaires);
    std::string lights;
    std::string members;
    const detail::RigSink write{[&](std::size_t index, const Json& json) {
                                    return expander.expand(json, index, [&](const detail::SingleLight& single) {
                                        lights += fmt::format("{}\n    {}", lights.empty() ? "" : ",",
                                                              light_json(single).dump());
                                        return Result<void>();
                                    });
                                },
                                [&](const std::string& key, const Json& json) {
                                    if (key != "luminaires" && key != "schema")
                                        members += fmt::format(",\n  {}: {}", Json(key).dump(), indented(json));
                                    return Result<void>();
                                }};
    if (Result<void> written = detail::stream_rig(text, source, write); !written) return pass_on(written);
    return fmt::format("{{\n  \"schema\": \"gonio.rig/1\",\n  \"lights\": [{}{}]{}\n}}\n", lights,
                       lights.empty() ? "" : "\n  ", members);
}

} // namespace gonio
