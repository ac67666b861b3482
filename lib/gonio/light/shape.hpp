// Shape: what emits. The grammar of "sphere:r=3cm" and what each shape needs to be known.
#pragma once

#include <gonio/base/quantity.hpp>
#include <gonio/base/result.hpp>
#include <gonio/web/web.hpp>

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace gonio {

// Emits the same intensity in every direction; has no size, so no luminance.
struct PointShape {};

// A Lambertian sphere: the same luminance from everywhere and in every direction.
struct SphereShape {
    Meters radius; // > 0
};

// A measured luminaire: a point that emits by its web.
struct ProfileShape {
    std::string file;
    std::shared_ptr<const Web> web; // nullptr until load_profile() has read the file
};

using Shape = std::variant<PointShape, SphereShape, ProfileShape>;

// A kind of shape, as `gonio list shapes` shows it.
struct ShapeKind {
    std::string_view kind;    // "sphere"
    std::string_view grammar; // "sphere:r=LENGTH"
    std::string_view summary;
};

std::span<const ShapeKind> shape_kinds();

// Fails (usage) on an unknown kind or key, a missing one, a length that is not greater than 0. Reads no file.
Result<Shape> parse_shape(std::string_view text);

// Reads the file of a ProfileShape and resolves its web; other shapes are left alone. What was noticed is appended to
// `diagnostics`.
Result<void> load_profile(Shape& shape, Diagnostics& diagnostics);

const char* kind_of(const Shape& shape); // "sphere"

} // namespace gonio
