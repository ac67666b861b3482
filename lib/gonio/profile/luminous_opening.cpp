#include <gonio/profile/luminous_opening.hpp>

#include <algorithm>
#include <cmath>

namespace gonio {

namespace {

constexpr double meters_per_foot = 0.3048;
constexpr double meters_per_millimeter = 1e-3;

// LM-63-2002 and -2019: both horizontal signs negative make the outline round.
OpeningShape shape_of_2002(double w, double l, double h) {
    if (w == 0.0 && l == 0.0 && h == 0.0) return OpeningShape::point;
    if (w >= 0.0 && l >= 0.0 && h >= 0.0) return h == 0.0 ? OpeningShape::rectangle : OpeningShape::box;
    if (w < 0.0 && l < 0.0 && h == 0.0) return w == l ? OpeningShape::disk : OpeningShape::ellipse;
    if (w < 0.0 && l < 0.0 && h > 0.0) return OpeningShape::vertical_cylinder;
    if (w < 0.0 && l < 0.0 && h < 0.0) return OpeningShape::sphere;
    if (h < 0.0 && ((w < 0.0 && l > 0.0) || (w > 0.0 && l < 0.0))) return OpeningShape::horizontal_cylinder;
    if (h < 0.0 && ((w < 0.0 && l == 0.0) || (w == 0.0 && l < 0.0))) return OpeningShape::disk; // upright
    return OpeningShape::unknown;
}

// LM-63-1995: a negative width alone makes the outline round, its length is 0.
OpeningShape shape_of_1995(double w, double l, double h) {
    if (w == 0.0 && l == 0.0 && h == 0.0) return OpeningShape::point;
    if (w >= 0.0 && l >= 0.0 && h >= 0.0) return h == 0.0 ? OpeningShape::rectangle : OpeningShape::box;
    if (w < 0.0 && l == 0.0 && h == 0.0) return OpeningShape::disk;
    if (w < 0.0 && l == 0.0 && h > 0.0) return OpeningShape::vertical_cylinder;
    if (w < 0.0 && l == 0.0 && h < 0.0) return OpeningShape::sphere;
    if (w == 0.0 && l != 0.0 && h < 0.0) return OpeningShape::horizontal_cylinder;
    if (w < 0.0 && l != 0.0) return h == 0.0 ? OpeningShape::ellipse : OpeningShape::vertical_cylinder;
    return OpeningShape::unknown;
}

LuminousOpening opening_of(const IesFile& file) {
    const double unit = file.feet ? meters_per_foot : 1.0;
    LuminousOpening opening;
    const bool since_2002 = file.version == IesVersion::lm63_2002 || file.version == IesVersion::lm63_2019;
    opening.shape = since_2002 ? shape_of_2002(file.width, file.length, file.height)
                               : shape_of_1995(file.width, file.length, file.height);
    opening.width_m = std::abs(file.width) * unit;
    opening.length_m = std::abs(file.length) * unit;
    opening.height_m = std::abs(file.height) * unit;
    return opening;
}

LuminousOpening opening_of(const LdtFile& file) {
    LuminousOpening opening;
    opening.length_m = file.luminous_length_mm * meters_per_millimeter;
    opening.width_m = file.luminous_width_mm * meters_per_millimeter;
    opening.height_m = std::max({file.luminous_height_c0_mm, file.luminous_height_c90_mm, file.luminous_height_c180_mm,
                                 file.luminous_height_c270_mm}) *
                       meters_per_millimeter;
    // A width of 0 says that the length is a diameter.
    if (opening.length_m > 0.0 && opening.width_m == 0.0) {
        opening.width_m = opening.length_m;
        opening.shape = opening.height_m > 0.0 ? OpeningShape::vertical_cylinder : OpeningShape::disk;
    } else if (opening.length_m > 0.0 || opening.width_m > 0.0) {
        opening.shape = opening.height_m > 0.0 ? OpeningShape::box : OpeningShape::rectangle;
    }
    return opening;
}

} // namespace

const char* to_text(OpeningShape shape) {
    switch (shape) {
    case OpeningShape::point:
        return "point";
    case OpeningShape::rectangle:
        return "rectangle";
    case OpeningShape::box:
        return "box";
    case OpeningShape::disk:
        return "disk";
    case OpeningShape::ellipse:
        return "ellipse";
    case OpeningShape::vertical_cylinder:
        return "vertical-cylinder";
    case OpeningShape::horizontal_cylinder:
        return "horizontal-cylinder";
    case OpeningShape::sphere:
        return "sphere";
    case OpeningShape::unknown:
        break;
    }
    return "unknown";
}

LuminousOpening luminous_opening(const Profile& profile) {
    return std::visit([](const auto& file) { return opening_of(file); }, profile.file);
}

} // namespace gonio
