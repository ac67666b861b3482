#include <gonio/profile/luminous_opening.hpp>
#include <gonio/profile/parse.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

namespace gonio {

namespace {

constexpr double meters_per_foot = 0.3048;
constexpr double meters_per_millimeter = 1e-3;

// The shape for one combination of signs in an edition's table: '+', '-', '0' of width, length and height.
struct ShapeCode {
    std::string_view signs;
    OpeningShape shape;
};

constexpr std::array codes_of_1986{
    ShapeCode{"-00", OpeningShape::disk},
    ShapeCode{"-0+", OpeningShape::vertical_cylinder},
    ShapeCode{"-+0", OpeningShape::ellipse},
    ShapeCode{"-++", OpeningShape::ellipsoid},
};

constexpr std::array codes_of_1995{
    ShapeCode{"-00", OpeningShape::disk},
    ShapeCode{"-0-", OpeningShape::sphere},
    ShapeCode{"-0+", OpeningShape::vertical_cylinder},
    ShapeCode{"0+-", OpeningShape::horizontal_cylinder},
    ShapeCode{"+0-", OpeningShape::horizontal_cylinder_across},
    ShapeCode{"-++", OpeningShape::vertical_cylinder},
    ShapeCode{"+-+", OpeningShape::vertical_cylinder},
    ShapeCode{"-+-", OpeningShape::ellipsoid},
    ShapeCode{"+--", OpeningShape::ellipsoid},
};

constexpr std::array codes_of_2002{
    ShapeCode{"--0", OpeningShape::disk}, // or an ellipse, depending on the sizes; also below
    ShapeCode{"--+", OpeningShape::vertical_cylinder},
    ShapeCode{"---", OpeningShape::sphere},
    ShapeCode{"-+-", OpeningShape::horizontal_cylinder},
    ShapeCode{"+--", OpeningShape::horizontal_cylinder_across},
    ShapeCode{"-0-", OpeningShape::upright_disk},
    ShapeCode{"0--", OpeningShape::upright_disk},
};

std::span<const ShapeCode> codes_of(IesVersion version) {
    switch (version) {
    case IesVersion::lm63_1986:
    case IesVersion::lm63_1991:
        return codes_of_1986;
    case IesVersion::lm63_1995:
        return codes_of_1995;
    case IesVersion::lm63_2002:
    case IesVersion::lm63_2019:
        break;
    }
    return codes_of_2002;
}

std::array<char, 3> signs_of(const IesFile& file) {
    const auto sign = [](double value) { return value > 0.0 ? '+' : value < 0.0 ? '-' : '0'; };
    return {sign(file.width), sign(file.length), sign(file.height)};
}

std::optional<OpeningShape> shape_in(std::span<const ShapeCode> codes, std::string_view signs) {
    for (const ShapeCode& code : codes)
        if (code.signs == signs) return code.shape;
    return std::nullopt;
}

LuminousOpening opening_of(const IesFile& file) {
    const double unit = file.feet ? meters_per_foot : 1.0;
    LuminousOpening opening;
    opening.width_m = std::abs(file.width) * unit;
    opening.length_m = std::abs(file.length) * unit;
    opening.height_m = std::abs(file.height) * unit;
    const std::optional<OpeningShape> shape = profile_detail::ies_opening_shape(file);
    opening.shape = shape ? *shape : profile_detail::opening_shape_of_1995(file).value_or(OpeningShape::box);
    switch (opening.shape) {
    case OpeningShape::disk:
    case OpeningShape::vertical_cylinder:
        if (opening.length_m == 0.0) opening.length_m = opening.width_m;
        if (opening.shape == OpeningShape::disk && opening.width_m != opening.length_m)
            opening.shape = OpeningShape::ellipse;
        break;
    case OpeningShape::horizontal_cylinder:
        if (opening.width_m == 0.0) opening.width_m = opening.height_m;
        break;
    case OpeningShape::horizontal_cylinder_across:
        if (opening.length_m == 0.0) opening.length_m = opening.height_m;
        break;
    case OpeningShape::sphere:
        if (opening.length_m == 0.0) opening.length_m = opening.width_m;
        if (opening.width_m != opening.length_m || opening.width_m != opening.height_m)
            opening.shape = OpeningShape::ellipsoid;
        break;
    default:
        break;
    }
    return opening;
}

LuminousOpening opening_of(const LdtFile& file) {
    LuminousOpening opening;
    opening.length_m = file.luminous_length_mm * meters_per_millimeter;
    opening.width_m = file.luminous_width_mm * meters_per_millimeter;
    opening.height_m = std::max({file.luminous_height_c0_mm, file.luminous_height_c90_mm, file.luminous_height_c180_mm,
                                 file.luminous_height_c270_mm}) *
                       meters_per_millimeter;
    // A width of 0 means that the length is a diameter.
    if (opening.length_m > 0.0 && opening.width_m == 0.0) {
        opening.width_m = opening.length_m;
        opening.shape = opening.height_m > 0.0 ? OpeningShape::vertical_cylinder : OpeningShape::disk;
    } else if (opening.length_m > 0.0 || opening.width_m > 0.0) {
        opening.shape = opening.height_m > 0.0 ? OpeningShape::box : OpeningShape::rectangle;
    }
    return opening;
}

// TM-33: the bottom face of the first emitter that has exactly one area. Several areas need their offsets to give the
// size that they span together, so the luminaire's own size is used instead.
LuminousOpening opening_of(const Tm33File& file) {
    LuminousOpening opening;
    for (const Tm33Emitter& emitter : file.emitters)
        if (emitter.bottom_areas.size() == 1) {
            const Tm33Area& area = emitter.bottom_areas.front();
            opening.length_m = std::abs(area.length_m);
            opening.width_m = std::abs(area.width_m);
            opening.shape = !area.circular                        ? OpeningShape::rectangle
                            : opening.length_m == opening.width_m ? OpeningShape::disk
                                                                  : OpeningShape::ellipse;
            if (opening.length_m == 0.0 && opening.width_m == 0.0) opening.shape = OpeningShape::point;
            return opening;
        }
    opening.length_m = std::abs(file.length_m.value_or(0.0));
    opening.width_m = std::abs(file.width_m.value_or(0.0));
    opening.height_m = std::abs(file.height_m.value_or(0.0));
    if (opening.length_m > 0.0 || opening.width_m > 0.0)
        opening.shape = opening.height_m > 0.0 ? OpeningShape::box : OpeningShape::rectangle;
    return opening;
}

} // namespace

std::optional<OpeningShape> profile_detail::ies_opening_shape(const IesFile& file) {
    const std::array signs = signs_of(file);
    const std::string_view text(signs.data(), signs.size());
    if (text == "000") return OpeningShape::point;
    if (text.find('-') == std::string_view::npos)
        return file.height == 0.0 ? OpeningShape::rectangle : OpeningShape::box;
    return shape_in(codes_of(file.version), text);
}

std::optional<OpeningShape> profile_detail::opening_shape_of_1995(const IesFile& file) {
    const std::array signs = signs_of(file);
    return shape_in(codes_of_1995, {signs.data(), signs.size()});
}

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
    case OpeningShape::horizontal_cylinder_across:
        return "horizontal-cylinder-across";
    case OpeningShape::upright_disk:
        return "upright-disk";
    case OpeningShape::sphere:
        return "sphere";
    case OpeningShape::ellipsoid:
        break;
    }
    return "ellipsoid";
}

LuminousOpening luminous_opening(const Profile& profile) {
    return std::visit([](const auto& file) { return opening_of(file); }, profile.file);
}

} // namespace gonio
