// The traits of a measured luminaire: see description.hpp. The rest comes from its web.
#pragma once

#include <gonio/base/kind_text.hpp>
#include <gonio/light/shapes/description.hpp>

namespace gonio {

template<>
struct ShapeTraits<ProfileShape> {
    static constexpr ShapeClass shape_class = ShapeClass::punctual;
    static constexpr std::string_view kind = "ies";
    static constexpr std::string_view summary = "a measured luminaire: an IES or EULUMDAT profile";
    static constexpr std::string_view grammar = "ies:FILE[,opening[=OPENING]]";
    static constexpr std::tuple<> keys{};

    // Called for "ies" without a colon; with a colon, the rest is the file (parse_shape).
    static Result<ProfileShape> parse(const KindText&) {
        return fail("USE0104", "'ies' needs a file", "write ies:lamp.ies");
    }

    static double largest(const ProfileShape&) { return 0.0; }
    static double radius(const ProfileShape&) { return 0.0; }
    static Radians half_cone(const ProfileShape&) { return shape_detail::all_round; }
    static double shown(const ProfileShape&, const glm::dvec3&) { return 1.0; }
};

} // namespace gonio
