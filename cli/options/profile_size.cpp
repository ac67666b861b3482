#include "profile_size.hpp"

#include <gonio/light/opening.hpp>

#include <memory>
#include <variant>

namespace gonio::cli {

Result<void> set_profile_sizes(const Arguments& arguments, ProfileSize usual, std::span<LightDescription> lights) {
    const auto text = arguments.value("--profile-size");
    ProfileSize size = usual;
    std::shared_ptr<const Opening> given;
    if (text) {
        size = ProfileSize::opening;
        if (*text == "off" || *text == "point") {
            size = ProfileSize::point;
        } else if (*text != "opening" && *text != "on") {
            Result<Opening> opening = parse_opening(*text);
            if (!opening) {
                if (text->find(':') == std::string::npos)
                    error_hint(opening.error(), "write opening, off, or one of: " + opening_kinds());
                return pass_on(opening);
            }
            given = std::make_shared<const Opening>(*opening);
        }
    }
    for (LightDescription& light : lights) {
        auto* const profile = std::get_if<ProfileShape>(&light.shape);
        if (profile == nullptr || (!text && profile->size != ProfileSize::unsaid)) continue;
        profile->size = size;
        if (text) profile->given = given;
    }
    return {};
}

} // namespace gonio::cli
