// Shared by the tests of lights: shapes from text, and a conversion in one call.
#pragma once

#include <gonio/light/photometry.hpp>
#include <gonio/light/shape.hpp>

#include "../web/webs.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace gonio::test {

inline Shape shape(const std::string& text) {
    const Result<Shape> parsed = parse_shape(text);
    if (parsed) return *parsed;
    ADD_FAILURE() << text << ": " << parsed.error().diagnostics.back().message;
    return PointShape{};
}

inline Shape measured() {
    return ProfileShape{
        "test.ies", std::make_shared<const Web>(random_web(Symmetry::quadrant, steps(0, 90, 7), steps(0, 90, 19), 5))};
}

// The shape with a mask that was not read from a file.
inline Shape masked(Shape shape, Web web) {
    const auto mask = std::make_shared<const Web>(std::move(web));
    if (auto* point = std::get_if<PointShape>(&shape)) point->mask = mask;
    if (auto* spot = std::get_if<SpotShape>(&shape)) spot->mask = mask;
    if (auto* frustum = std::get_if<FrustumShape>(&shape)) frustum->mask = mask;
    return shape;
}

// NaN, and a failure of the test, if the conversion is refused.
inline double convert(const Shape& shape, const std::string& from, const std::string& to) {
    const Result<PhotometricValue> value = parse_photometric_value(from);
    const Result<PhotometricUnit> unit = parse_photometric_unit(to);
    if (value && unit) {
        const Result<Emission> emission = emission_of(shape, *value);
        if (emission)
            if (const Result<double> number = express(shape, *emission, *unit)) return *number;
    }
    ADD_FAILURE() << kind_of(shape) << ": " << from << " to " << to << " is refused";
    return std::nan("");
}

// The message that refuses a conversion, empty if it is not refused.
inline std::string refusal(const Shape& shape, const std::string& from, const std::string& to) {
    const Result<PhotometricValue> value = parse_photometric_value(from);
    if (!value) return value.error().diagnostics.back().message;
    const Result<Emission> emission = emission_of(shape, *value);
    if (!emission) return emission.error().diagnostics.back().message;
    const Result<PhotometricUnit> unit = parse_photometric_unit(to);
    if (!unit) return unit.error().diagnostics.back().message;
    const Result<double> number = express(shape, *emission, *unit);
    return number ? std::string() : number.error().diagnostics.back().message;
}

} // namespace gonio::test
