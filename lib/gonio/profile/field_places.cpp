#include <gonio/profile/profile.hpp>

namespace gonio {

Location location_of(const Profile& profile, ProfileField field) {
    const FieldPlace place = profile.places[field];
    return {profile.source, place.line, place.column};
}

Location location_of_lamps(const Profile& profile, ProfileField field, int lamp_set) {
    constexpr int lines = 6; // of a set
    Location location = location_of(profile, field);
    if (lamp_set <= 1 || location.line == 0) return location;
    location.line += static_cast<std::uint32_t>(lines * (lamp_set - 1));
    location.column = 0; // blanks before a number are not counted again
    return location;
}

} // namespace gonio
