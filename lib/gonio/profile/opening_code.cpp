#include <gonio/profile/opening_code.hpp>

#include <algorithm>
#include <cmath>

namespace gonio {

namespace {

struct Sizes {
    double width = 0.0;
    double length = 0.0;
    double height = 0.0;
};

// Both horizontal sizes of a round outline are negative.
Sizes code_of_2002(const LuminousOpening& opening) {
    const double w = opening.width_m;
    const double l = opening.length_m;
    const double h = opening.height_m;
    switch (opening.shape) {
    case OpeningShape::disk:
    case OpeningShape::ellipse:
        return {-w, -l, 0.0};
    case OpeningShape::vertical_cylinder:
        return {-w, -l, h};
    case OpeningShape::horizontal_cylinder:
        return {-w, l, -h};
    case OpeningShape::horizontal_cylinder_across:
        return {w, -l, -h};
    case OpeningShape::upright_disk:
    case OpeningShape::sphere:
    case OpeningShape::ellipsoid:
        return {-w, -l, -h};
    case OpeningShape::point:
    case OpeningShape::rectangle:
    case OpeningShape::box:
        break;
    }
    return {w, l, h};
}

// A circle has one negative size and a length of 0. There are no codes for a flat ellipse or an upright disk.
Sizes code_of_1995(const LuminousOpening& opening) {
    const double w = opening.width_m;
    const double l = opening.length_m;
    const double h = opening.height_m;
    switch (opening.shape) {
    case OpeningShape::disk:
        return {-w, 0.0, 0.0};
    case OpeningShape::vertical_cylinder:
        if (w == l) return {-w, 0.0, h};
        return {-w, l, h};
    case OpeningShape::horizontal_cylinder:
        return {0.0, l, -h};
    case OpeningShape::horizontal_cylinder_across:
        return {w, 0.0, -h};
    case OpeningShape::sphere:
        return {-w, 0.0, -h};
    case OpeningShape::ellipsoid:
        return {-w, l, -h};
    case OpeningShape::point:
    case OpeningShape::rectangle:
    case OpeningShape::box:
    case OpeningShape::ellipse:
    case OpeningShape::upright_disk:
        break;
    }
    return {w, l, h};
}

// Sizes are converted between millimetres, feet and metres: an error of a nanometre does not justify sixteen digits.
double rounded(double value) {
    return std::round(value * 1e9) / 1e9;
}

template<class File>
LuminousOpening read_back(const File& file) {
    Profile profile;
    profile.file = file;
    return luminous_opening(profile);
}

} // namespace

LuminousOpening set_opening(IesFile& file, const LuminousOpening& opening) {
    const bool of_2002 = file.version == IesVersion::lm63_2002 || file.version == IesVersion::lm63_2019;
    const Sizes sizes = of_2002 ? code_of_2002(opening) : code_of_1995(opening);
    file.feet = false;
    file.width = rounded(sizes.width);
    file.length = rounded(sizes.length);
    file.height = rounded(sizes.height);
    return read_back(file);
}

LuminousOpening set_opening(LdtFile& file, const LuminousOpening& opening) {
    const bool round = opening.shape == OpeningShape::disk || opening.shape == OpeningShape::sphere ||
                       (opening.shape == OpeningShape::vertical_cylinder && opening.width_m == opening.length_m);
    const double width = opening.width_m * 1000.0;
    const double length = opening.length_m * 1000.0;
    file.luminous_length_mm = rounded(round ? std::max(width, length) : length);
    // A width of 0 would mean that the length is a diameter: a line gets a width of a hundredth of a millimetre.
    const bool line = !round && width == 0.0 && length > 0.0;
    file.luminous_width_mm = round ? 0.0 : line ? 0.01 : rounded(width);
    for (double* const height : {&file.luminous_height_c0_mm, &file.luminous_height_c90_mm,
                                 &file.luminous_height_c180_mm, &file.luminous_height_c270_mm})
        *height = rounded(opening.height_m * 1000.0);
    return read_back(file);
}

LuminousOpening set_opening(Tm33File& file, Tm33Emitter& emitter, const LuminousOpening& opening,
                            const HousingSize& housing) {
    const bool known = housing.length_m != 0.0 || housing.width_m != 0.0 || housing.height_m != 0.0;
    const bool flat = opening.height_m == 0.0 && opening.shape != OpeningShape::upright_disk;
    const bool round = opening.shape == OpeningShape::disk || opening.shape == OpeningShape::ellipse;
    if (known || opening.shape != OpeningShape::point) {
        file.length_m = rounded(known ? housing.length_m : opening.length_m);
        file.width_m = rounded(known ? housing.width_m : opening.width_m);
        file.height_m = rounded(known ? housing.height_m : opening.height_m);
    }
    // A point in a housing is an area of size 0: without an area the housing would count as the luminous opening.
    const bool as_area = opening.shape == OpeningShape::point ? known : flat || known;
    if (as_area) emitter.bottom_areas = {{rounded(opening.length_m), rounded(opening.width_m), round}};
    Profile profile;
    Tm33File alone = file;
    alone.emitters = {emitter};
    profile.file = std::move(alone);
    return luminous_opening(profile);
}

} // namespace gonio
